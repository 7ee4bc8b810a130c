// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "io/map_image.h"

namespace tricover::detail {
namespace {

/// libpng's words for what went wrong. An error leaves libpng's functions by longjmp, so that nothing with a destructor
/// may stand between run() and them.
class PngCall {
 public:
  /// Calls steps(), which calls libpng. Returns whether there was no error.
  template <typename Steps>
  bool run(png_structp png, const Steps& steps) {
    static_assert(std::is_trivially_destructible_v<Steps>);
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    steps();
    return true;
  }
  /// The error, and the warning that says more about a header.
  std::string words() const { return warning_[0] ? std::string(error_) + " (" + warning_ + ")" : error_; }

  [[noreturn]] static void onError(png_structp png, png_const_charp words) {
    keep(self(png).error_, words);
    png_longjmp(png, 1);
  }
  static void onWarning(png_structp png, png_const_charp words) { keep(self(png).warning_, words); }

 private:
  static constexpr std::size_t kMostWords = 128;

  static PngCall& self(png_structp png) { return *static_cast<PngCall*>(png_get_error_ptr(png)); }
  static void keep(char (&text)[kMostWords], png_const_charp words) {
    std::snprintf(text, sizeof text, "%s", words ? words : "no words");
  }

  char error_[kMostWords] = "", warning_[kMostWords] = "";
};

/// Decodes a PNG image row by row.
class PngReader {
 public:
  explicit PngReader(const Input& image) : image_(image) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &call_, PngCall::onError, PngCall::onWarning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      destroy();
      throw std::bad_alloc();
    }
    const bool is_begun = call_.run(png_, [this] { begin(); });
    if (!is_begun) destroyAndRefuse(call_.words());
    if (width == 0 || width > kMostPixels) refuseSide("width");
    if (height == 0 || height > kMostPixels) refuseSide("height");
    if (!call_.run(png_, [this] { expand(); })) destroyAndRefuse(call_.words());
    row_.resize(row_bytes_);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { destroy(); }

  /// Calls visit(column, row, grey, is_opaque) for every pixel, once. The grey is from 0 to `white`.
  template <typename Visit>
  void forEachPixel(const Visit& visit) {
    // Of seven interlaced pictures, or of one.
    const int passes = is_interlaced_ ? PNG_INTERLACE_ADAM7_PASSES : 1;
    for (int pass = 0; pass < passes; ++pass) {
      const std::size_t columns = is_interlaced_ ? PNG_PASS_COLS(width, pass) : width;
      const std::size_t rows = is_interlaced_ ? PNG_PASS_ROWS(height, pass) : height;
      if (columns == 0) continue;
      for (std::size_t row = 0; row < rows; ++row) {
        if (!call_.run(png_, [this] { png_read_row(png_, row_.data(), nullptr); })) refuse(call_.words());
        for (std::size_t column = 0; column < columns; ++column)
          visit(is_interlaced_ ? PNG_COL_FROM_PASS_COL(column, pass) : column,
                is_interlaced_ ? PNG_ROW_FROM_PASS_ROW(row, pass) : row, grey(column), isOpaque(column));
      }
    }
    if (!call_.run(png_, [this] { png_read_end(png_, nullptr); })) refuse(call_.words());
  }

  std::size_t width = 0, height = 0;
  std::size_t white = 0;  ///< the sum of the colours of a white pixel

 private:
  /// Reads up to the pixels. Other chunks than these that change pixels are skipped, so that they take no memory.
  void begin() {
    png_set_read_fn(png_, this, onRead);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_benign_errors(png_, 0);
    png_read_info(png_, info_);
    width = png_get_image_width(png_, info_);
    height = png_get_image_height(png_, info_);
    is_interlaced_ = png_get_interlace_type(png_, info_) == PNG_INTERLACE_ADAM7;
  }
  /// Asks for colours of 8 or 16 bits each, without a palette, with alpha where the image has any.
  void expand() {
    png_set_expand(png_);
    png_read_update_info(png_, info_);
    channels_ = png_get_channels(png_, info_);
    has_alpha_ = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0;
    bytes_ = png_get_bit_depth(png_, info_) == 16 ? 2u : 1u;
    most_ = bytes_ == 2 ? 65535 : 255;
    white = most_ * (channels_ - (has_alpha_ ? 1 : 0));
    row_bytes_ = png_get_rowbytes(png_, info_);
  }

  std::size_t channel(std::size_t column, std::size_t number) const {
    const png_byte* at = &row_[(column * channels_ + number) * bytes_];
    return bytes_ == 2 ? std::size_t{256} * at[0] + at[1] : at[0];
  }
  std::size_t grey(std::size_t column) const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < channels_ - (has_alpha_ ? 1 : 0); ++i) sum += channel(column, i);
    return sum;
  }
  bool isOpaque(std::size_t column) const { return !has_alpha_ || channel(column, channels_ - 1) == most_; }

  static void onRead(png_structp png, png_bytep to, std::size_t count) {
    const Input& image = static_cast<PngReader*>(png_get_io_ptr(png))->image_;
    if (!image.in.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count)))
      png_error(png, "the file ends early");
  }

  void destroy() { png_destroy_read_struct(&png_, &info_, nullptr); }
  [[noreturn]] void refuse(const std::string& words) const {
    refuseFile(image_.name, "is no whole PNG image: " + words);
  }
  [[noreturn]] void destroyAndRefuse(const std::string& words) {
    destroy();
    refuse(words);
  }
  [[noreturn]] void refuseSide(const std::string& field) {
    destroy();
    refuseFile(image_.name + ": " + field, "isn't from 1 to " + std::to_string(kMostPixels));
  }

  Input image_;
  PngCall call_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  bool is_interlaced_ = false, has_alpha_ = false;
  std::size_t channels_ = 0, bytes_ = 0, most_ = 0, row_bytes_ = 0;
  std::vector<png_byte> row_;
};

}  // namespace

void readPng(const Input& image, const MapFields& fields, OccupancyGrid& grid) {
  // Decoded twice, so that pixels that the file doesn't hold take no memory.
  {
    PngReader png(image);
    checkSize(image, png.width, png.height);
    png.forEachPixel([](std::size_t, std::size_t, std::size_t, bool) {});
  }
  image.in.seekg(0);
  PngReader png(image);
  const std::vector<std::int8_t> values = valuesOfGreys(fields, png.white);
  grid.width = png.width;
  grid.height = png.height;
  grid.cells.resize(png.width * png.height);
  png.forEachPixel([&](std::size_t column, std::size_t row, std::size_t grey, bool is_opaque) {
    const bool is_known = is_opaque || fields.mode == MapMode::Raw;
    grid.cells[(png.height - 1 - row) * png.width + column] = is_known ? values[grey] : kUnknownCell;
  });
}

namespace {

/// Encodes an image of grey, or of red, green, blue and alpha: nav2's library misreads grey with alpha.
class PngWriter {
 public:
  PngWriter(const OccupancyGrid& grid, const CellGreys& greys)
      : grid_(grid), greys_(greys), row_(grid.width * (greys.is_transparent ? 4 : 1)) {}

  std::string file() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &call_, PngCall::onError, PngCall::onWarning);
    if (png_) info_ = png_create_info_struct(png_);
    // Only memory can be missing.
    const bool is_whole = info_ && call_.run(png_, [this] { write(); });
    png_destroy_write_struct(&png_, &info_);
    if (!is_whole) throw std::bad_alloc();
    return std::move(file_);
  }

 private:
  void write() {
    png_set_write_fn(png_, this, onWrite, [](png_structp) {});
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(grid_.width), static_cast<png_uint_32>(grid_.height), 8,
                 greys_.is_transparent ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png_, info_);
    for (std::size_t row = grid_.height; row-- > 0;) {
      png_byte* pixel = row_.data();
      for (std::size_t column = 0; column < grid_.width; ++column) {
        const std::int8_t value = grid_.cells[row * grid_.width + column];
        const png_byte grey = greys_.of(value);
        *pixel++ = grey;
        if (!greys_.is_transparent) continue;
        *pixel++ = grey;
        *pixel++ = grey;
        *pixel++ = value == kUnknownCell ? 0 : 255;
      }
      png_write_row(png_, row_.data());
    }
    png_write_end(png_, info_);
  }
  static void onWrite(png_structp png, png_bytep bytes, std::size_t count) {
    if (!static_cast<PngWriter*>(png_get_io_ptr(png))->append(bytes, count)) png_error(png, "no memory");
  }
  /// No exception may pass through libpng.
  bool append(png_bytep bytes, std::size_t count) {
    try {
      file_.append(reinterpret_cast<const char*>(bytes), count);
    } catch (const std::exception&) {
      return false;
    }
    return true;
  }

  const OccupancyGrid& grid_;
  CellGreys greys_;
  PngCall call_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::vector<png_byte> row_;
  std::string file_;
};

}  // namespace

std::string writePng(const OccupancyGrid& grid, const CellGreys& greys) { return PngWriter(grid, greys).file(); }

}  // namespace tricover::detail
