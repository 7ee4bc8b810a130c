// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>

#include <cstddef>
#include <string>
#include <vector>

#include "map_folder.h"
#include "tricover/occupancy_grid_io.h"

namespace tricover {
namespace {

/// A PNG image as libpng writes it: samples row by row from the top, a number of `depth` bits each.
struct Image {
  png_uint_32 width = 0, height = 0;
  int depth = 8, type = PNG_COLOR_TYPE_GRAY;
  std::vector<unsigned> samples = {};
  bool is_interlaced = false;
  std::vector<png_color> palette = {};
  std::vector<png_byte> palette_alpha = {};
  std::vector<png_uint_16> transparent = {};  ///< the colour that is
  std::size_t text = 0;                       ///< the length of a comment, compressed

  std::size_t channels() const { return samples.size() / (std::size_t{width} * height); }

  /// The bytes of the file. libpng's errors end the test's process, since they aren't meant to be.
  std::string file() const {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp self, png_bytep from, std::size_t count) {
          static_cast<std::string*>(png_get_io_ptr(self))->append(reinterpret_cast<const char*>(from), count);
        },
        nullptr);
    png_set_IHDR(png, info, width, height, depth, type, is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    png_color_16 colour{};
    if (transparent.size() == 1) colour.gray = transparent[0];
    if (transparent.size() == 3)
      colour.red = transparent[0], colour.green = transparent[1], colour.blue = transparent[2];
    if (!transparent.empty() || !palette_alpha.empty())
      png_set_tRNS(png, info, palette_alpha.data(), static_cast<int>(palette_alpha.size()), &colour);
    std::string comment(text, 'x');
    png_text note{};
    note.compression = PNG_TEXT_COMPRESSION_zTXt;
    note.key = const_cast<char*>("Comment");
    note.text = comment.data();
    note.text_length = text;
    if (text > 0) png_set_text(png, info, &note, 1);
    png_write_info(png, info);
    const auto packed = rows();
    std::vector<png_bytep> pointers;
    for (const std::vector<png_byte>& row : packed) pointers.push_back(const_cast<png_bytep>(row.data()));
    png_write_image(png, pointers.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return bytes;
  }

 private:
  std::vector<std::vector<png_byte>> rows() const {
    const std::size_t per_row = width * channels(), bits = static_cast<std::size_t>(depth);
    std::vector<std::vector<png_byte>> result(height, std::vector<png_byte>((per_row * bits + 7) / 8));
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t bit = 0; bit < bits; ++bit) {
        const std::size_t at = i % per_row * bits + bit;
        const unsigned value = samples[i] >> (bits - 1 - bit) & 1;
        png_byte& byte = result[i / per_row][at / 8];
        byte = static_cast<png_byte>(byte | value << (7 - at % 8));
      }
    return result;
  }
};

class OccupancyMapPng : public MapFolder {
 protected:
  /// By thresholds of 0 and 1: in mode scale a cell is round(100 (1 - grey)).
  Cells read(const std::string& file, const std::string& mode = "scale") const {
    write("map.png", file);
    write("map.yaml",
          "image: map.png\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0\n"
          "mode: " +
              mode + "\n");
    return readOccupancyMap(path("map.yaml")).grid.cells;
  }
  Cells cells(const Image& image, const std::string& mode = "scale") const { return read(image.file(), mode); }
  std::string errorOfPng(const std::string& file) const {
    return errorOf([&] { read(file); });
  }
  std::string words() const { return "tricover: " + path("map.png") + ": is no whole PNG image: "; }
};

/// The most memory that the process has had, in bytes.
std::size_t most() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

constexpr unsigned kMost16 = 65535;

/// A chunk of a PNG file, with its checksum.
std::string chunk(const std::string& type, const std::string& data) {
  const auto number = [](png_uint_32 value) {
    png_byte bytes[4];
    png_save_uint_32(bytes, value);
    return std::string(reinterpret_cast<const char*>(bytes), 4);
  };
  png_uint_32 sum = 0xffffffff;  // ISO 3309
  for (const char byte : type + data) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum & 1 ? 0xedb88320 ^ sum >> 1 : sum >> 1;
  }
  return number(static_cast<png_uint_32>(data.size())) + type + data + number(~sum);
}

constexpr std::size_t kSignature = 8, kHeader = 25;  // bytes

std::string withSize(const std::string& file, png_uint_32 width, png_uint_32 height) {
  png_byte bytes[8];
  png_save_uint_32(bytes, width);
  png_save_uint_32(bytes + 4, height);
  return file.substr(0, kSignature) +
         chunk("IHDR", std::string(reinterpret_cast<const char*>(bytes), 8) + file.substr(kSignature + 16, 5)) +
         file.substr(kSignature + kHeader);
}

TEST_F(OccupancyMapPng, GreyOfEveryDepth) {
  for (const int depth : {1, 2, 4, 8, 16}) {
    const unsigned most = (1u << depth) - 1;
    EXPECT_EQ(cells({2, 2, depth, PNG_COLOR_TYPE_GRAY, {0, most, most, 0}}), (Cells{0, 100, 100, 0})) << depth;
    EXPECT_EQ(cells({1, 3, depth, PNG_COLOR_TYPE_GRAY, {0, most, most / 3}}),
              (Cells{static_cast<std::int8_t>(depth == 1 ? 100 : 67), 0, 100}))
        << depth << ": the first row is the map's last";
  }
  // 655 is nearer to a hundredth of white than 8 bits can be.
  EXPECT_EQ(cells({2, 1, 16, PNG_COLOR_TYPE_GRAY, {32440, 32439}}), (Cells{50, 51}));
}

TEST_F(OccupancyMapPng, TheGreyOfAColourIsTheMean) {
  for (const int depth : {8, 16}) {
    const unsigned most = depth == 8 ? 255 : kMost16, part = most / 5;
    EXPECT_EQ(cells({3, 1, depth, PNG_COLOR_TYPE_RGB, {most, 0, 0, part, 2 * part, 3 * part, 0, most, most}}),
              (Cells{67, 60, 33}))
        << depth;
  }
  const std::vector<png_color> palette = {{255, 255, 255}, {0, 0, 0}, {255, 0, 0}};
  for (const int depth : {2, 4, 8})
    EXPECT_EQ(cells({3, 1, depth, PNG_COLOR_TYPE_PALETTE, {2, 1, 0}, false, palette}), (Cells{67, 100, 0})) << depth;
}

TEST_F(OccupancyMapPng, OnlyOpaquePixelsAreKnown) {
  for (const std::string mode : {"scale", "trinary"}) {
    for (const int depth : {8, 16}) {
      const unsigned most = depth == 8 ? 255 : kMost16;
      EXPECT_EQ(cells({4, 1, depth, PNG_COLOR_TYPE_GRAY_ALPHA, {0, most, 0, most - 1, most, 0, most, most}}, mode),
                (Cells{100, -1, -1, 0}))
          << mode << depth;
      EXPECT_EQ(cells({2, 1, depth, PNG_COLOR_TYPE_RGB_ALPHA, {0, 0, 0, most, most, most, most, 1}}, mode),
                (Cells{100, -1}))
          << mode << depth;
    }
    Image keyed{3, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255, 254}};
    keyed.transparent = {255};
    EXPECT_EQ(cells(keyed, mode), (Cells{100, -1, static_cast<std::int8_t>(mode == "scale" ? 0 : -1)})) << mode;
    Image coloured{2, 1, 8, PNG_COLOR_TYPE_RGB, {0, 0, 0, 9, 9, 9}};
    coloured.transparent = {9, 9, 9};
    EXPECT_EQ(cells(coloured, mode), (Cells{100, -1})) << mode;
    Image indexed{3, 1, 8, PNG_COLOR_TYPE_PALETTE, {0, 1, 2}, false, {{0, 0, 0}, {0, 0, 0}, {255, 255, 255}}};
    indexed.palette_alpha = {255, 254};
    EXPECT_EQ(cells(indexed, mode), (Cells{100, -1, 0})) << mode;
  }
}

TEST_F(OccupancyMapPng, ModeRawTakesTheMeanForTheValueAndHasNoAlpha) {
  EXPECT_EQ(cells({3, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {7, 255, 100, 0, 101, 255}}, "raw"), (Cells{7, 100, -1}));
  EXPECT_EQ(cells({2, 1, 8, PNG_COLOR_TYPE_RGB, {1, 1, 2, 1, 2, 2}}, "raw"), (Cells{1, 2}));
  EXPECT_EQ(cells({2, 1, 16, PNG_COLOR_TYPE_GRAY, {50 * 257, 50 * 257 + 200}}, "raw"), (Cells{50, 51}));
}

TEST_F(OccupancyMapPng, InterlacedImagesAreTheSame) {
  for (png_uint_32 width = 1; width <= 10; ++width)
    for (png_uint_32 height = 1; height <= 10; ++height)
      for (const int depth : {1, 8}) {
        Image image{width, height, depth};
        for (unsigned i = 0; i < width * height; ++i) image.samples.push_back(i * 37 % (1u << depth));
        const Cells plain = cells(image);
        image.is_interlaced = true;
        ASSERT_EQ(cells(image), plain) << width << " x " << height << ", " << depth << " bits";
      }
}

TEST_F(OccupancyMapPng, AFileIsWholeOrRefused) {
  Image image{20, 9, 8, PNG_COLOR_TYPE_PALETTE, {}, false, {{0, 0, 0}, {255, 0, 0}, {255, 255, 255}}};
  for (unsigned i = 0; i < 180; ++i) image.samples.push_back(i * i % 3);
  image.palette_alpha = {255, 0};
  image.text = 100;
  for (const bool is_interlaced : {false, true}) {
    image.is_interlaced = is_interlaced;
    const std::string file = image.file();
    ASSERT_EQ(read(file).size(), 180u);
    for (std::size_t size = 0; size < file.size(); ++size)
      ASSERT_EQ(errorOfPng(file.substr(0, size)).rfind("tricover: " + path("map.png") + ": is n", 0), 0u)
          << size << " of " << file.size() << " bytes";
    EXPECT_EQ(errorOfPng(file.substr(0, file.size() - 1)), words() + "the file ends early");
    // Every byte is under a checksum.
    for (std::size_t at = 0; at < file.size(); ++at) {
      std::string changed = file;
      changed[at] = static_cast<char>(changed[at] ^ 1);
      ASSERT_EQ(errorOfPng(changed).rfind("tricover: " + path("map.png"), 0), 0u) << "byte " << at;
    }
  }
}

TEST_F(OccupancyMapPng, AnErrorNamesTheImageAndTheFault) {
  const std::string file = Image{2, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255}}.file();
  std::string changed = file;
  changed[kSignature + kHeader + 8] = static_cast<char>(changed[kSignature + kHeader + 8] ^ 1);
  EXPECT_EQ(errorOfPng(changed).rfind(words() + "IDAT: ", 0), 0u) << errorOfPng(changed);
  EXPECT_EQ(errorOfPng(withSize(file, 65536, 1)), "tricover: " + path("map.png") + ": width: isn't from 1 to 65535");
  EXPECT_EQ(errorOfPng(withSize(file, 1, 65536)), "tricover: " + path("map.png") + ": height: isn't from 1 to 65535");
  EXPECT_EQ(errorOfPng(withSize(file, 0, 1)), words() + "Invalid IHDR data (Image width is zero in IHDR)");
  EXPECT_EQ(errorOfPng(withSize(file, 2, 1) + "more"), "no error") << "what follows the image isn't read";
  EXPECT_NE(errorOfPng(withSize(file, 2, 2)), "no error");
  EXPECT_NE(errorOfPng(withSize(file, 1, 1)), "no error") << "pixels are left over";
  EXPECT_EQ(errorOfPng(file.substr(0, kSignature + kHeader) + chunk("IEND", "")).rfind(words(), 0), 0u);
  EXPECT_EQ(errorOfPng(file.substr(0, kSignature) + file.substr(kSignature + kHeader)).rfind(words(), 0), 0u);
}

// The transparent colour says which cells are unknown.
TEST_F(OccupancyMapPng, AMalformedTransparencyIsRefused) {
  const std::string file = Image{2, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255}}.file();
  const std::string header = file.substr(0, kSignature + kHeader), pixels = file.substr(kSignature + kHeader);
  EXPECT_EQ(read(header + chunk("tRNS", std::string(2, '\0')) + pixels), (Cells{-1, 0}));
  EXPECT_EQ(errorOfPng(header + chunk("tRNS", "x") + pixels).rfind(words() + "tRNS: ", 0), 0u);
  EXPECT_EQ(errorOfPng(header + chunk("tRNS", "xx") + chunk("tRNS", "xx") + pixels).rfind(words() + "tRNS: ", 0), 0u);
}

TEST_F(OccupancyMapPng, ChunksThatDoNotChangePixelsAreSkipped) {
  const std::string file = Image{2, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255}}.file();
  const std::string header = file.substr(0, kSignature + kHeader), pixels = file.substr(kSignature + kHeader);
  for (const std::string type :
       {"gAMA", "sRGB", "iCCP", "pHYs", "tEXt", "iTXt", "zTXt", "eXIf", "bKGD", "prVt", "acTL"})
    EXPECT_EQ(read(header + chunk(type, "this is none\0of these") + pixels), (Cells{100, 0})) << type;
  Image spoken{2, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255}};
  spoken.text = std::size_t{1} << 26;
  EXPECT_EQ(cells(spoken), (Cells{100, 0}));
}

TEST_F(OccupancyMapPng, PixelsThatAreMissingTakeNoMemory) {
  for (const bool is_interlaced : {false, true}) {
    Image image{500, 400, 8, PNG_COLOR_TYPE_GRAY, std::vector<unsigned>(200000, 255)};
    image.is_interlaced = is_interlaced;
    const std::size_t before = most();
    EXPECT_EQ(errorOfPng(withSize(image.file(), 16384, 16384)).rfind(words(), 0), 0u);
    EXPECT_LT(most() - before, std::size_t{64} << 20);
  }
}

// Four megabytes of PNG hold 4e9 cells of one colour.
TEST_F(OccupancyMapPng, MoreCellsThanTheMostAreRefused) {
  const std::string file = Image{2, 1, 8, PNG_COLOR_TYPE_GRAY, {0, 255}}.file(), name = path("map.png");
  EXPECT_EQ(errorOfPng(withSize(file, 65535, 65535)),
            "tricover: " + name + ": has 65535 x 65535 cells, more than 2^28 in all; cut it into several maps");
  EXPECT_NE(errorOfPng(withSize(file, 16384, 16385)).find("more than 2^28"), std::string::npos);
  EXPECT_EQ(errorOfPng(withSize(file, 16384, 16384)).rfind(words(), 0), 0u) << "only its pixels are missing";
}

}  // namespace
}  // namespace tricover
