// SPDX-License-Identifier: BSD-3-Clause
// Reads what ROS's map_server reads: a PGM image of grey cells, and the YAML file that says what they mean.
#pragma once

#include <tricover/outline.h>
#include <tricover/pose.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace map_server {

/// Cell values as in nav_msgs/OccupancyGrid, which tricover::outline() takes as they are.
constexpr std::int8_t kFree = 0, kOccupied = 100, kUnknown = -1;

struct Map {
  tricover::OccupancyGrid grid;  ///< in a frame of its own, its lower left corner at (0, 0)
  tricover::Pose pose;           ///< from there to the world: the file's origin, yaw included
};

/// The keys of a map's YAML file. They are `key: value` lines, and no more of YAML is read.
class Keys {
 public:
  explicit Keys(const std::string& path) : path_(path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("can't read " + path);
    for (std::string line; std::getline(file, line);) {
      line = line.substr(0, line.find('#'));
      const std::size_t colon = line.find(':');
      if (colon != std::string::npos) values_[trimmed(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
    }
  }

  bool has(const std::string& key) const { return values_.count(key) > 0; }
  std::string text(const std::string& key) const {
    if (!has(key)) throw std::runtime_error(path_ + ": no key '" + key + "'");
    return values_.at(key);
  }
  double number(const std::string& key) const { return numberIn(key, text(key)); }
  std::array<double, 3> triple(const std::string& key) const {
    const std::string value = text(key);
    const std::size_t last = value.size() - 1;
    if (value.size() < 2 || value[0] != '[' || value[last] != ']') refuse(key, "isn't written as [x, y, yaw]");
    std::istringstream in(value.substr(1, last - 1));
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
    throw std::runtime_error(path_ + ": " + key + ": '" + text(key) + "' " + wrong);
  }

 private:
  static std::string trimmed(const std::string& text) {
    const char* const kAround = " \t\r\"'";
    const std::size_t first = text.find_first_not_of(kAround), last = text.find_last_not_of(kAround);
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
  }
  double numberIn(const std::string& key, const std::string& text) const {
    std::istringstream in(text);
    double number = 0;
    if (!(in >> number) || !(in >> std::ws).eof() || !std::isfinite(number)) refuse(key, "is not a number");
    return number;
  }

  std::string path_;
  std::map<std::string, std::string> values_;
};

/// A grey image, P2 (text) or P5 (one byte a pixel).
class Pgm {
 public:
  explicit Pgm(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_) throw std::runtime_error("can't read " + path);
    std::string magic;
    file_ >> magic;
    if (magic != "P2" && magic != "P5") refuse("begins with '" + magic.substr(0, 8) + "', not with P2 or P5");
    width = header("width", 65535);
    height = header("height", 65535);
    white_ = header("white", 255);
    is_text_ = magic == "P2";
    file_.get();  // the one white space before the pixels
  }

  /// The next pixel, row by row from the top: 0 is black, 1 white.
  double next() {
    std::size_t value = 0;
    if (is_text_ ? !(file_ >> value) : (value = static_cast<std::size_t>(file_.get()), !file_)) {
      refuse("ends before its last pixel");
    }
    if (value > white_) refuse("has a pixel above its white, " + std::to_string(value));
    return static_cast<double>(value) / static_cast<double>(white_);
  }

  std::size_t width = 0, height = 0;

 private:
  std::size_t header(const std::string& name, std::size_t most) {
    while ((file_ >> std::ws).peek() == '#') file_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    std::size_t value = 0;
    if (!(file_ >> value) || value == 0 || value > most)
      refuse("has no " + name + " from 1 to " + std::to_string(most));
    return value;
  }
  [[noreturn]] void refuse(const std::string& wrong) const { throw std::runtime_error(path_ + ": " + wrong); }

  std::string path_;
  std::ifstream file_;
  std::size_t white_ = 0;
  bool is_text_ = false;
};

/// The map of a YAML file, as map_server's mode "trinary" has it: with p = 1 - grey, or grey if `negate` is 1, a cell
/// is occupied where p > occupied_thresh, free where p < free_thresh, and unknown in between. Throws
/// std::runtime_error, naming file and key, for what it can't read.
inline Map read(const std::string& yaml) {
  const Keys keys(yaml);
  if (keys.has("mode") && keys.text("mode") != "trinary") keys.refuse("mode", "is none that is read: trinary is");
  const std::string negate = keys.text("negate");
  if (negate != "0" && negate != "1") keys.refuse("negate", "is neither 0 nor 1");
  const double occupied = keys.number("occupied_thresh"), free = keys.number("free_thresh");
  if (!(free <= occupied)) keys.refuse("free_thresh", "is above occupied_thresh");
  const auto [x, y, yaw] = keys.triple("origin");

  const std::string image = keys.text("image");
  const std::size_t folder = image[0] == '/' ? std::string::npos : yaml.rfind('/');
  Pgm pgm(folder == std::string::npos ? image : yaml.substr(0, folder + 1) + image);
  Map map;
  map.grid.width = pgm.width;
  map.grid.height = pgm.height;
  map.grid.resolution = keys.number("resolution");
  map.grid.cells.resize(pgm.width * pgm.height);
  for (std::size_t row = pgm.height; row-- > 0;) {  // the image's first row is the map's last
    for (std::size_t column = 0; column < pgm.width; ++column) {
      const double grey = pgm.next(), p = negate == "1" ? grey : 1 - grey;
      map.grid.cells[row * pgm.width + column] = p > occupied ? kOccupied : p < free ? kFree : kUnknown;
    }
  }
  map.pose = tricover::Pose::Identity();
  map.pose.linear() = Eigen::Rotation2Dd(yaw).toRotationMatrix();
  map.pose.translation() = tricover::Vec2(x, y);
  return map;
}

}  // namespace map_server
