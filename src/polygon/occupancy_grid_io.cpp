// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tricover {
namespace {

constexpr std::int8_t kFree = 0, kOccupied = 100, kUnknown = -1;

[[noreturn]] void refuseFile(const std::string& path, const std::string& wrong) {
  throw std::runtime_error(path + ": " + wrong);
}

/// How many bytes a file has, which a device or a pipe can't say: reading one might never end.
std::uintmax_t sizeOf(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw std::runtime_error("can't read " + path + ": " + error.message());
  return size;
}

std::string trimmed(const std::string& text) {
  const char* const kAround = " \t\r\"'";
  const std::size_t first = text.find_first_not_of(kAround), last = text.find_last_not_of(kAround);
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// The keys of a map's YAML file.
class Keys {
 public:
  explicit Keys(const std::string& path) : path_(path) {
    if (sizeOf(path) > kMostBytes) refuseFile(path, "is too long for the keys of a map");
    std::ifstream file(path);
    if (!file) throw std::runtime_error("can't read " + path);
    for (std::string line; std::getline(file, line);) {
      line = line.substr(0, line.find('#'));
      const std::size_t colon = line.find(':');
      if (colon != std::string::npos) values_[trimmed(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
    }
  }

  bool has(const std::string& key) const { return values_.count(key) > 0; }
  const std::string& text(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) refuseFile(path_, "no key '" + key + "'");
    if (found->second.empty()) refuse(key, "is empty");
    return found->second;
  }
  double number(const std::string& key) const { return numberIn(key, text(key)); }
  std::array<double, 3> triple(const std::string& key) const {
    const std::string& value = text(key);
    if (value.front() != '[' || value.back() != ']' || value.size() < 2) refuse(key, "isn't written as [x, y, yaw]");
    std::istringstream in(value.substr(1, value.size() - 2));
    std::array<double, 3> numbers;
    std::string part;
    for (double& number : numbers) {
      if (!std::getline(in, part, ',')) refuse(key, "has fewer than three numbers");
      number = numberIn(key, trimmed(part));
    }
    if (std::getline(in, part)) refuse(key, "has more than three numbers");
    return numbers;
  }
  [[noreturn]] void refuse(const std::string& key, const std::string& wrong) const {
    refuseFile(path_, key + ": '" + values_.at(key) + "' " + wrong);
  }

 private:
  static constexpr std::uintmax_t kMostBytes = 1 << 20;

  double numberIn(const std::string& key, const std::string& text) const {
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double number = 0;
    if (!(in >> number) || !(in >> std::ws).eof() || !std::isfinite(number)) refuse(key, "is not a number");
    return number;
  }

  std::string path_;
  std::map<std::string, std::string> values_;
};

/// A grey image, P2 (text) or P5 (one byte a pixel). All its pixels are there once it is made, as far as the file's
/// size can tell.
class Pgm {
 public:
  explicit Pgm(const std::string& path) : path_(path) {
    const std::uintmax_t size = sizeOf(path);
    file_.open(path, std::ios::binary);
    if (!file_) throw std::runtime_error("can't read " + path);
    file_.imbue(std::locale::classic());
    std::array<char, 2> magic{};
    file_.read(magic.data(), 2);
    is_text_ = magic[1] == '2';
    if (magic[0] != 'P' || (magic[1] != '2' && magic[1] != '5')) refuseFile(path, "is no PGM image, P2 or P5");
    width = header("width", 65535);
    height = header("height", 65535);
    white = header("white", 255);
    file_.get();  // the one white space before the pixels
    const auto at = static_cast<std::uintmax_t>(file_.tellg()), pixels = std::uintmax_t{width} * height;
    if (size - at < (is_text_ ? 2 * pixels - 1 : pixels)) refuseShort();
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
  std::size_t header(const std::string& name, std::size_t most) {
    while ((file_ >> std::ws).peek() == '#') file_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    std::size_t value = 0;
    if (!(file_ >> value) || value == 0 || value > most)
      refuseFile(path_, "has no " + name + " from 1 to " + std::to_string(most));
    return value;
  }
  std::uint8_t textPixel() {
    std::size_t value = 0;
    if (!(file_ >> value)) refuseShort();
    if (value > white) refuseAbove(value);
    return static_cast<std::uint8_t>(value);
  }
  [[noreturn]] void refuseShort() const { refuseFile(path_, "ends before its last pixel"); }
  [[noreturn]] void refuseAbove(std::size_t value) const {
    refuseFile(path_, "has a pixel above its white, " + std::to_string(value));
  }

  std::string path_;
  std::ifstream file_;
  bool is_text_ = false;
  std::vector<std::uint8_t> row_;
};

/// What each grey of the image means.
std::vector<std::int8_t> meanings(const Keys& keys, std::size_t white) {
  const std::string& negate = keys.text("negate");
  if (negate != "0" && negate != "1") keys.refuse("negate", "is neither 0 nor 1");
  const double occupied = keys.number("occupied_thresh"), free = keys.number("free_thresh");
  if (!(free <= occupied)) keys.refuse("free_thresh", "is above occupied_thresh");
  std::vector<std::int8_t> values;
  for (std::size_t pixel = 0; pixel <= white; ++pixel) {
    const double grey = static_cast<double>(pixel) / static_cast<double>(white), p = negate == "1" ? grey : 1 - grey;
    values.push_back(p > occupied ? kOccupied : p < free ? kFree : kUnknown);
  }
  return values;
}

}  // namespace

OccupancyMap readOccupancyMap(const std::string& yaml) {
  const Keys keys(yaml);
  if (keys.has("mode") && keys.text("mode") != "trinary") keys.refuse("mode", "is none that is read: trinary is");
  const auto [x, y, yaw] = keys.triple("origin");

  OccupancyMap map;
  map.pose = Pose::Identity();
  map.pose.linear() = Eigen::Rotation2Dd(yaw).toRotationMatrix();
  map.pose.translation() = Vec2(x, y);
  map.grid.resolution = keys.number("resolution");
  if (!(map.grid.resolution > 0)) keys.refuse("resolution", "is not positive");

  Pgm pgm((std::filesystem::path(yaml).parent_path() / keys.text("image")).string());
  const std::vector<std::int8_t> values = meanings(keys, pgm.white);
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

}  // namespace tricover
