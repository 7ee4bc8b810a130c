// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "io/map_image.h"

namespace tricover::detail {
namespace {

/// A grey image, P2 (text) or P5 (one byte a pixel). All its pixels are there once it is made, as far as the file's
/// size can tell.
class Pgm {
 public:
  explicit Pgm(const Input& image) : name_(image.name), in_(image.in) {
    std::array<char, 2> magic{};
    in_.read(magic.data(), 2);
    is_text_ = magic[1] == '2';
    if (magic[0] != 'P' || (magic[1] != '2' && magic[1] != '5'))
      refuseFile(name_, "is neither a PGM image (P2 or P5) nor a PNG image", "convert it to PNG");
    width = header("width", kMostPixels);
    height = header("height", kMostPixels);
    white = header("maximum grey", 255);
    const int separator = in_.get();
    const auto at = static_cast<std::uintmax_t>(in_.tellg()), pixels = std::uintmax_t{width} * height;
    const std::uintmax_t least = is_text_ ? 2 * pixels - 1 : pixels;
    if (!in_ || image.size - at < least) refuseShort();
    if (!is_text_ && separator == '\r' && in_.peek() == '\n') skipLineFeed(image.size - at - pixels);
  }

  /// The next row from the top, from 0 (black) to `white`.
  const std::vector<std::uint8_t>& next() {
    row_.resize(width);
    if (is_text_)
      for (std::uint8_t& pixel : row_) pixel = textPixel();
    else if (!in_.read(reinterpret_cast<char*>(row_.data()), static_cast<std::streamsize>(width)))
      refuseShort();
    for (const std::uint8_t pixel : row_)
      if (pixel > white) refuseAbove(pixel);
    return row_;
  }

  std::size_t width = 0, height = 0, white = 0;

 private:
  std::size_t header(const std::string& field, std::size_t most) {
    while ((in_ >> std::ws).peek() == '#') in_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    std::size_t value = 0;
    if (!(in_ >> value) || value == 0 || value > most)
      refuseFile(name_ + ": " + field, "isn't from 1 to " + std::to_string(most));
    return value;
  }
  /// One white space ends the header. After CR, LF is the first pixel, unless the file is one byte longer.
  void skipLineFeed(std::uintmax_t too_long) {
    if (too_long > 1)
      refuseFile(name_,
                 "its header ends in CR LF and " + std::to_string(too_long) + " bytes are left after the pixels, not 1",
                 "end the header in LF");
    if (too_long == 1) in_.get();
  }
  std::uint8_t textPixel() {
    std::size_t value = 0;
    if (!(in_ >> value)) refuseShort();
    if (value > white) refuseAbove(value);
    return static_cast<std::uint8_t>(value);
  }
  [[noreturn]] void refuseShort() const {
    refuseFile(name_,
               "ends before the last of its " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
  }
  [[noreturn]] void refuseAbove(std::size_t value) const {
    refuseFile(name_, "a pixel is " + std::to_string(value) + ", above the maximum grey, " + std::to_string(white));
  }

  std::string name_;
  std::istream& in_;
  bool is_text_ = false;
  std::vector<std::uint8_t> row_;
};

}  // namespace

void readPgm(const Input& image, const MapFields& fields, OccupancyGrid& grid) {
  Pgm pgm(image);
  checkSize(image, pgm.width, pgm.height);
  const std::vector<std::int8_t> values = valuesOfGreys(fields, pgm.white);
  grid.width = pgm.width;
  grid.height = pgm.height;
  grid.cells.resize(pgm.width * pgm.height);
  for (std::size_t row = pgm.height; row-- > 0;) {
    const std::vector<std::uint8_t>& pixels = pgm.next();
    for (std::size_t column = 0; column < pgm.width; ++column)
      grid.cells[row * pgm.width + column] = values[pixels[column]];
  }
}

std::string writePgm(const OccupancyGrid& grid, const CellGreys& greys) {
  std::string text = "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  text.reserve(text.size() + grid.cells.size());
  for (std::size_t row = grid.height; row-- > 0;)
    for (std::size_t column = 0; column < grid.width; ++column)
      text += static_cast<char>(greys.of(grid.cells[row * grid.width + column]));
  return text;
}

}  // namespace tricover::detail
