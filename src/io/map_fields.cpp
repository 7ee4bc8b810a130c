// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_fields.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "numbers/errors.h"
#include "numbers/shortest.h"

namespace tricover::detail {
namespace {

/// The fields of a map's YAML file.
class Fields {
 public:
  explicit Fields(const Input& yaml) : name_(yaml.name) {
    if (yaml.size > kMostBytes)
      refuseFile(name_, "has " + std::to_string(yaml.size) + " bytes, more than " + std::to_string(kMostBytes),
                 "name the YAML file, not the image");
    try {
      map_ = YAML::Load(std::string(std::istreambuf_iterator<char>(yaml.in), {}));
    } catch (const YAML::Exception& error) {
      refuseFile(name_, "is no YAML: line " + std::to_string(error.mark.line + 1) + ": " + error.msg);
    }
    if (!map_.IsMap()) refuseFile(name_, "has no fields", "name a map's YAML file");
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
    refuseFile(name_ + ": " + field, wrong, instead);
  }

  std::string name_;
  YAML::Node map_;
};

MapMode modeOf(const Fields& fields) {
  MapMode mode = MapMode::Trinary;
  if (fields.has("mode")) {
    const std::string text = fields.text("mode");
    const std::string lower = lowered(text);
    if (lower == "scale")
      mode = MapMode::Scale;
    else if (lower == "raw")
      mode = MapMode::Raw;
    else if (lower != "trinary")
      fields.refuseValue("mode", text, "is not a mode", "write trinary, scale or raw");
  }
  // The field of map_server before it had modes.
  if (fields.has("trinary") && !fields.flag("trinary")) {
    if (fields.has("mode") && mode != MapMode::Scale)
      fields.refuseValue("trinary", "false", "means mode scale, and mode is " + fields.text("mode"), "keep one");
    mode = MapMode::Scale;
  }
  return mode;
}

/// The shortest text that reads as this double, with a point, without which some readers of YAML see a text.
std::string textOf(double number) {
  std::string result = shortest(number);
  if (result.find('.') == std::string::npos) result.insert(std::min(result.find('e'), result.size()), ".0");
  return result;
}

}  // namespace

MapFields readMapFields(const Input& yaml) {
  const Fields fields(yaml);
  MapFields map;
  map.mode = modeOf(fields);
  const auto [x, y, yaw] = fields.triple("origin");
  map.pose = poseAt(x, y, yaw);
  map.resolution = fields.number("resolution");
  if (!(map.resolution > 0))
    fields.refuseValue("resolution", fields.text("resolution"), "is not positive", "write metres a cell");
  map.image = fields.text("image");
  map.negate = fields.flag("negate");
  const auto threshold = [&](const char* field) {
    const double value = fields.number(field);
    if (!(value >= 0 && value <= 1))
      fields.refuseValue(field, fields.text(field), "is not from 0 to 1", "write a share");
    return value;
  };
  map.occupied_thresh = threshold("occupied_thresh");
  map.free_thresh = threshold("free_thresh");
  if (!(map.free_thresh <= map.occupied_thresh))
    fields.refuseValue("free_thresh", fields.text("free_thresh"), "is above occupied_thresh", "lower it");
  return map;
}

std::vector<std::int8_t> valuesOfGreys(const MapFields& fields, std::size_t white) {
  std::vector<std::int8_t> values;
  values.reserve(white + 1);
  for (std::size_t i = 0; i <= white; ++i) {
    const double grey = static_cast<double>(i) / static_cast<double>(white), p = fields.negate ? grey : 1 - grey;
    if (fields.mode == MapMode::Raw) {
      const double value = std::round(255 * grey);
      values.push_back(value <= kOccupiedCell ? static_cast<std::int8_t>(value) : kUnknownCell);
    } else if (p >= fields.occupied_thresh) {
      values.push_back(kOccupiedCell);
    } else if (p <= fields.free_thresh) {
      values.push_back(kFreeCell);
    } else if (fields.mode == MapMode::Trinary) {
      values.push_back(kUnknownCell);
    } else {
      const double share = (p - fields.free_thresh) / (fields.occupied_thresh - fields.free_thresh);
      values.push_back(static_cast<std::int8_t>(std::round(100 * share)));
    }
  }
  return values;
}

std::string writeMapFields(const MapFields& fields, double yaw) {
  YAML::Emitter image;
  image << YAML::DoubleQuoted << fields.image;
  const std::string modes[] = {"trinary", "scale", "raw"};
  const std::string text =
      "image: " + std::string(image.c_str()) + "\nmode: " + modes[static_cast<std::size_t>(fields.mode)] +
      "\nresolution: " + textOf(fields.resolution) + "\norigin: [" + textOf(fields.pose.translation().x()) + ", " +
      textOf(fields.pose.translation().y()) + ", " + textOf(yaw) + "]\nnegate: " + (fields.negate ? "1" : "0") +
      "\noccupied_thresh: " + textOf(fields.occupied_thresh) + "\nfree_thresh: " + textOf(fields.free_thresh) + "\n";
  // YAML has no bytes that aren't UTF-8.
  std::istringstream in(text);
  if (!image.good() || Fields({in, text.size(), "image"}).text("image") != fields.image)
    refuse("image", "YAML does not keep the name '" + fields.image + "'", "take another one");
  return text;
}

}  // namespace tricover::detail
