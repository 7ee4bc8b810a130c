// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "numbers/errors.h"

namespace tricover {
namespace {

constexpr std::int8_t kFree = 0, kOccupied = 100, kUnknown = -1;

/// "tricover: <file>[: <field>]: <what is wrong>[; <what to do instead>]".
[[noreturn]] void refuse(const std::string& file, const std::string& wrong, const std::string& instead = {}) {
  throw std::runtime_error(detail::refusal(file, wrong, instead));
}

/// Opens a plain file and returns its size. A device or a pipe has none, and reading one might never end.
std::uintmax_t open(std::ifstream& file, const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuse(path, "can't be read: " + error.message());
  file.open(path, std::ios::binary);
  if (!file) refuse(path, "can't be opened", "check its permissions");
  file.imbue(std::locale::classic());
  return size;
}

/// The fields of a map's YAML file.
class Fields {
 public:
  explicit Fields(const std::string& path) : path_(path) {
    std::ifstream file;
    const std::uintmax_t size = open(file, path);
    if (size > kMostBytes)
      refuse(path, "has " + std::to_string(size) + " bytes, more than " + std::to_string(kMostBytes),
             "name the YAML file, not the image");
    try {
      map_ = YAML::Load(std::string(std::istreambuf_iterator<char>(file), {}));
    } catch (const YAML::Exception& error) {
      refuse(path, "is no YAML: line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
    }
    if (!map_.IsMap()) refuse(path, "has no fields", "name a map's YAML file");
  }

  std::string text(const std::string& field) const { return scalar(field, required(field)); }
  double number(const std::string& field) const { return numberIn(field, required(field)); }
  std::array<double, 3> triple(const std::string& field) const {
    const YAML::Node node = required(field);
    const std::string how = "write [x, y, yaw]";
    if (!node.IsSequence()) refuseField(field, "isn't a list", how);
    if (node.size() != 3) refuseField(field, "has " + std::to_string(node.size()) + " values, not 3", how);
    return {numberIn(field, node[0]), numberIn(field, node[1]), numberIn(field, node[2])};
  }
  bool flag(const std::string& field) const {
    const YAML::Node node = required(field);
    const std::string value = scalar(field, node);
    bool is_set = value == "1";
    if (value != "0" && value != "1" && !YAML::convert<bool>::decode(node, is_set))
      refuseValue(field, value, "is neither true nor false", "write 1 or 0");
    return is_set;
  }
  bool has(const std::string& field) const { return find(field).IsDefined(); }

  [[noreturn]] void refuseValue(const std::string& field, const std::string& value, const std::string& wrong,
                                const std::string& instead) const {
    refuseField(field, "'" + value + "' " + wrong, instead);
  }

 private:
  static constexpr std::uintmax_t kMostBytes = 1 << 20;

  /// Readers differ in which of two values they take.
  YAML::Node find(const std::string& field) const {
    YAML::Node found(YAML::NodeType::Undefined);
    for (const auto& entry : map_) {
      if (!entry.first.IsScalar() || entry.first.Scalar() != field) continue;
      if (found.IsDefined()) refuseField(field, "is there twice", "keep one");
      found.reset(entry.second);
    }
    return found;
  }
  YAML::Node required(const std::string& field) const {
    const YAML::Node node = find(field);
    if (!node.IsDefined()) refuseField(field, "is missing", "add it");
    return node;
  }
  std::string scalar(const std::string& field, const YAML::Node& node) const {
    if (node.IsNull() || (node.IsScalar() && node.Scalar().empty())) refuseField(field, "has no value", "add one");
    if (!node.IsScalar()) refuseField(field, "has several values", "keep one");
    return node.Scalar();
  }
  /// yaml-cpp reads numbers by the global locale.
  double numberIn(const std::string& field, const YAML::Node& node) const {
    const std::string text = scalar(field, node);
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double number = 0;
    if (!(in >> number) || !(in >> std::ws).eof() || !std::isfinite(number))
      refuseValue(field, text, "is not a finite number", "write it as 0.05 or 5e-2");
    return number;
  }
  [[noreturn]] void refuseField(const std::string& field, const std::string& wrong, const std::string& instead) const {
    refuse(path_ + ": " + field, wrong, instead);
  }

  std::string path_;
  YAML::Node map_;
};

/// A grey image, P2 (text) or P5 (one byte a pixel). All its pixels are there once it is made, as far as the file's
/// size can tell.
class Pgm {
 public:
  explicit Pgm(const std::string& path) : path_(path) {
    const std::uintmax_t size = open(file_, path);
    std::array<char, 2> magic{};
    file_.read(magic.data(), 2);
    is_text_ = magic[1] == '2';
    if (magic[0] != 'P' || (magic[1] != '2' && magic[1] != '5'))
      refuse(path, "is no PGM image (P2 or P5)", "convert it to PGM");
    width = header("width", 65535);
    height = header("height", 65535);
    white = header("maximum grey", 255);
    const int separator = file_.get();
    const auto at = static_cast<std::uintmax_t>(file_.tellg()), pixels = std::uintmax_t{width} * height;
    const std::uintmax_t least = is_text_ ? 2 * pixels - 1 : pixels;
    if (!file_ || size - at < least) refuseShort();
    if (!is_text_ && separator == '\r' && file_.peek() == '\n') skipLineFeed(size - at - pixels);
  }

  /// The next row from the top, from 0 (black) to `white`.
  const std::vector<std::uint8_t>& next() {
    row_.resize(width);
    if (is_text_)
      for (std::uint8_t& pixel : row_) pixel = textPixel();
    else if (!file_.read(reinterpret_cast<char*>(row_.data()), static_cast<std::streamsize>(width)))
      refuseShort();
    for (const std::uint8_t pixel : row_)
      if (pixel > white) refuseAbove(pixel);
    return row_;
  }

  std::size_t width = 0, height = 0, white = 0;

 private:
  std::size_t header(const std::string& field, std::size_t most) {
    while ((file_ >> std::ws).peek() == '#') file_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    std::size_t value = 0;
    if (!(file_ >> value) || value == 0 || value > most)
      refuse(path_ + ": " + field, "isn't from 1 to " + std::to_string(most));
    return value;
  }
  /// One white space ends the header. After CR, LF is the first pixel, unless the file is one byte longer.
  void skipLineFeed(std::uintmax_t too_long) {
    if (too_long > 1)
      refuse(path_,
             "its header ends in CR LF and " + std::to_string(too_long) + " bytes are left after the pixels, not 1",
             "end the header in LF");
    if (too_long == 1) file_.get();
  }
  std::uint8_t textPixel() {
    std::size_t value = 0;
    if (!(file_ >> value)) refuseShort();
    if (value > white) refuseAbove(value);
    return static_cast<std::uint8_t>(value);
  }
  [[noreturn]] void refuseShort() const {
    refuse(path_, "ends before the last of its " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
  }
  [[noreturn]] void refuseAbove(std::size_t value) const {
    refuse(path_, "a pixel is " + std::to_string(value) + ", above the maximum grey, " + std::to_string(white));
  }

  std::string path_;
  std::ifstream file_;
  bool is_text_ = false;
  std::vector<std::uint8_t> row_;
};

void requireTrinary(const Fields& fields) {
  const std::string instead = "save the map in mode trinary";
  if (fields.has("mode")) {
    const std::string mode = fields.text("mode");
    std::string lower = mode;
    std::transform(mode.begin(), mode.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    if (lower != "trinary") fields.refuseValue("mode", mode, "is not read", instead);
  }
  // The field of map_server before it had modes.
  if (fields.has("trinary") && !fields.flag("trinary"))
    fields.refuseValue("trinary", "false", "means mode scale, which is not read", instead);
}

/// The cell's value for each grey of the image.
std::vector<std::int8_t> valuesOfGreys(const Fields& fields, std::size_t white) {
  const bool negate = fields.flag("negate");
  const auto threshold = [&](const char* field) {
    const double value = fields.number(field);
    if (!(value >= 0 && value <= 1))
      fields.refuseValue(field, fields.text(field), "is not from 0 to 1", "write a share");
    return value;
  };
  const double occupied = threshold("occupied_thresh"), free = threshold("free_thresh");
  if (!(free <= occupied))
    fields.refuseValue("free_thresh", fields.text("free_thresh"), "is above occupied_thresh", "lower it");
  std::vector<std::int8_t> values;
  for (std::size_t pixel = 0; pixel <= white; ++pixel) {
    const double grey = static_cast<double>(pixel) / static_cast<double>(white), p = negate ? grey : 1 - grey;
    values.push_back(p >= occupied ? kOccupied : p <= free ? kFree : kUnknown);
  }
  return values;
}

}  // namespace

OccupancyMap readOccupancyMap(const std::string& yaml) {
  const Fields fields(yaml);
  requireTrinary(fields);
  const auto [x, y, yaw] = fields.triple("origin");

  OccupancyMap map;
  map.pose = poseAt(x, y, yaw);
  map.grid.resolution = fields.number("resolution");
  if (!(map.grid.resolution > 0))
    fields.refuseValue("resolution", fields.text("resolution"), "is not positive", "write metres a cell");

  Pgm pgm((std::filesystem::path(yaml).parent_path() / fields.text("image")).string());
  const std::vector<std::int8_t> values = valuesOfGreys(fields, pgm.white);
  map.grid.width = pgm.width;
  map.grid.height = pgm.height;
  map.grid.cells.resize(pgm.width * pgm.height);
  for (std::size_t row = pgm.height; row-- > 0;) {
    const std::vector<std::uint8_t>& pixels = pgm.next();
    for (std::size_t column = 0; column < pgm.width; ++column)
      map.grid.cells[row * pgm.width + column] = values[pixels[column]];
  }
  return map;
}

std::optional<Polygon> outline(const OccupancyMap& map, const IsOccupied& is_occupied) {
  const std::optional<Polygon> in_grid = outline(map.grid, is_occupied);
  if (!in_grid) return std::nullopt;
  return in_grid->transformed(map.pose);
}

}  // namespace tricover
