// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/geojson.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "io/input.h"
#include "io/parts.h"
#include "numbers/errors.h"
#include "numbers/whole_file.h"

namespace tricover {
namespace {

using nlohmann::json;

constexpr std::size_t kMostDepth = 64;

/// A text in JSON, its strings escaped.
std::string quoted(const std::string& text) { return json(text).dump(-1, ' ', false, json::error_handler_t::replace); }

std::string shortened(const std::string& text, std::size_t most) {
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

/// The parser takes a byte 0 for the end.
bool hasNul(const std::string& text) { return text.find('\0') != std::string::npos; }

/// The text of a JSON value, of the events that the parser finds in it.
class ValueText {
 public:
  void add(const std::string& value) {
    separate();
    text += value;
  }
  void open(char bracket) {
    separate();
    text += bracket;
    ++depth_;
    needs_comma_ = false;
  }
  void key(const std::string& name) {
    add(quoted(name) + ':');
    needs_comma_ = false;
  }
  void close(char bracket) {
    text += bracket;
    --depth_;
    needs_comma_ = true;
  }
  bool isWhole() const { return depth_ == 0; }

  std::string text;

 private:
  void separate() {
    if (needs_comma_) text += ',';
    needs_comma_ = true;
  }

  std::size_t depth_ = 0;
  bool needs_comma_ = false;
};

/// The arrays of `coordinates`, of any geometry. The first number says how deep positions are; those of polygons are
/// kept. What is wrong is said when the geometry turns out to be a polygon.
class Coordinates {
 public:
  void open() {
    ++level_;
    if (of_numbers_ == 0) return;
    count_ = 0;
    if (level_ > of_numbers_) fail("an array instead of a number");
    if (!isPolygon()) return;
    if (level_ + 2 == of_numbers_) parts.emplace_back();
    if (level_ + 1 == of_numbers_) parts.back().emplace_back();
  }
  void add(double number) {
    if (of_numbers_ == 0) {
      of_numbers_ = level_;
      if (isPolygon()) parts.push_back(detail::Part(1));
    }
    if (level_ != of_numbers_) return fail("a number where positions are expected");
    if (count_ < 2) at_[count_] = number;
    ++count_;
  }
  void addOther() { fail("a value that is no number"); }
  void close() {
    if (of_numbers_ == 0 && level_ > 1) fail("an empty array");
    if (level_ == of_numbers_) {
      if (count_ < 2) fail("a position without x and y");
      if (isPolygon()) parts.back().back().emplace_back(at_[0], at_[1]);
      count_ = 0;
    } else if (isPolygon() && level_ + 1 == of_numbers_ && parts.back().back().empty()) {
      fail("a ring without positions");
    } else if (isPolygon() && level_ + 2 == of_numbers_ && parts.back().empty()) {
      fail("a part without rings");
    }
    --level_;
  }
  bool isOpen() const { return level_ > 0; }

  /// How many arrays are around a position's numbers; 0: there is no number.
  std::size_t depth() const { return of_numbers_; }

  std::vector<detail::Part> parts;
  std::string fault;

 private:
  bool isPolygon() const { return of_numbers_ == 3 || of_numbers_ == 4; }
  void fail(const std::string& wrong) {
    if (!fault.empty()) return;
    fault = wrong;
    if (parts.empty()) return;
    fault += " at ";
    if (of_numbers_ == 4) fault += "part " + std::to_string(parts.size() - 1) + ", ";
    fault += "ring " + std::to_string(parts.back().empty() ? 0 : parts.back().size() - 1) + ", vertex " +
             std::to_string(parts.back().empty() ? 0 : parts.back().back().size());
  }

  std::size_t level_ = 0, of_numbers_ = 0, count_ = 0;
  std::array<double, 2> at_{};
};

/// Where an object stands, which says what it may be.
enum class Role { None, Root, Feature, Geometry, Member };

/// A GeoJSON object that is being read.
struct Object {
  Role role;
  std::string key = {};                ///< the member that is being read
  std::vector<std::string> keys = {};  ///< those that have been, of those that matter
  Role list = Role::None;              ///< the role of objects in the array that is being read
  std::string type = {}, id = {}, properties = {};
  std::optional<Coordinates> coordinates = {};
  std::vector<detail::Part> parts = {};  ///< of the geometries in it
  std::string other = {};                ///< a geometry in it that has no area
  std::string fault = {};                ///< of a geometry in it

  bool has(const char* name) const { return std::find(keys.begin(), keys.end(), name) != keys.end(); }
};

/// Takes the parser's events, and keeps of the text what polygons are made of.
class Reader {
 public:
  Reader(std::string text, std::string source, const GeoOptions& options)
      : text_(std::move(text)), source_(std::move(source)), options_(options) {}

  std::vector<GeoFeature> read() {
    if (hasNul(text_)) refuse("it is no JSON: it has a byte 0", "save it as UTF-8");
    json::sax_parse(text_, this);
    return std::move(features_);
  }

  bool null() { return value(Value::Other, "null"); }
  bool boolean(bool is_set) { return value(Value::Other, is_set ? "true" : "false"); }
  bool number_integer(json::number_integer_t number) {
    return value(Value::Number, std::to_string(number), static_cast<double>(number));
  }
  bool number_unsigned(json::number_unsigned_t number) {
    return value(Value::Number, std::to_string(number), static_cast<double>(number));
  }
  bool number_float(json::number_float_t number, const std::string& text) { return value(Value::Number, text, number); }
  bool string(const std::string& text) { return value(Value::String, text); }
  bool binary(const json::binary_t&) { return false; }  // JSON has none

  bool start_object(std::size_t) {
    deepen();
    if (value_) {
      value_->open('{');
    } else if (ignored_ > 0) {
      ++ignored_;
    } else if (isInCoordinates()) {
      top().coordinates->addOther();
      ++ignored_;
    } else if (objects_.empty()) {
      objects_.push_back({Role::Root});
    } else if (top().list != Role::None) {
      if (top().list == Role::Feature) ++count_;
      objects_.push_back({top().list});
    } else if (top().key == "geometry") {
      objects_.push_back({Role::Geometry});
    } else if (top().key == "properties") {
      value_.emplace().open('{');
    } else {
      requireIgnored("an object");
      ++ignored_;
    }
    return true;
  }
  bool key(const std::string& name) {
    if (value_) {
      value_->key(name);
    } else if (ignored_ == 0) {
      top().key = name;
      for (const char* known : kKeys) {
        if (name != known) continue;
        if (top().has(known)) refuse("it has '" + name + "' twice", "keep one");
        top().keys.push_back(name);
      }
    }
    return true;
  }
  bool end_object() {
    --depth_;
    if (value_) {
      value_->close('}');
      takeValue();
    } else if (ignored_ > 0) {
      --ignored_;
    } else {
      end(top());
      objects_.pop_back();
    }
    return true;
  }
  bool start_array(std::size_t) {
    deepen();
    if (value_) {
      value_->open('[');
    } else if (ignored_ > 0) {
      ++ignored_;
    } else if (objects_.empty()) {
      refuse("it is an array", "a GeoJSON text is an object");
    } else if (isInCoordinates()) {
      top().coordinates->open();
    } else if (top().list != Role::None) {
      refuse("an array stands among objects", "'" + top().key + "' is a list of objects");
    } else if (top().key == "coordinates") {
      top().coordinates.emplace().open();
    } else if (top().key == "features") {
      top().list = Role::Feature;
    } else if (top().key == "geometries") {
      top().list = Role::Member;
    } else {
      requireIgnored("an array");
      ++ignored_;
    }
    return true;
  }
  bool end_array() {
    --depth_;
    if (value_)
      value_->close(']');
    else if (ignored_ > 0)
      --ignored_;
    else if (isInCoordinates())
      top().coordinates->close();
    else
      top().list = Role::None;
    return true;
  }

  /// The exception's text is "[...] parse error at line 1, column 2: what", or "[...] what".
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    std::string what = error.what();
    what.erase(0, what.find("] ") + 2);
    if (what.rfind("parse error", 0) == 0) what.erase(0, what.find(": ") + 2);
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(position, text_.size()));
    const bool is_utf_16 = text_.rfind("\xff\xfe", 0) == 0 || text_.rfind("\xfe\xff", 0) == 0;
    detail::refuseFile(source_ + ": line " + std::to_string(std::count(text_.begin(), end, '\n') + 1),
                       "it is no JSON: " + shortened(what, 200), is_utf_16 ? "save it as UTF-8" : "");
  }

 private:
  enum class Value { Number, String, Other };
  static constexpr std::array kKeys{"type", "coordinates", "geometry", "geometries", "features", "id", "properties"};

  Object& top() { return objects_.back(); }
  bool isInCoordinates() { return !objects_.empty() && top().coordinates && top().coordinates->isOpen(); }

  /// Where the reader is, for errors.
  std::string place() const {
    std::string place = source_;
    if (count_ > 0) place += ": feature " + std::to_string(count_ - 1);
    for (const Object& object : objects_)
      if (!object.id.empty()) return place + " (id " + shortened(object.id, 60) + ")";
    return place;
  }
  [[noreturn]] void refuse(const std::string& wrong, const std::string& instead = {}) const {
    detail::refuseFile(place(), wrong, instead);
  }
  void deepen() {
    if (++depth_ > kMostDepth) refuse("arrays and objects nest more than " + std::to_string(kMostDepth) + " deep");
  }
  /// What the current member may not be.
  void requireIgnored(const std::string& what) {
    for (const char* known : kKeys)
      if (top().key == known) refuse("'" + top().key + "' is " + what, "RFC 7946 says what it has to be");
  }

  bool value(Value kind, const std::string& text, double number = 0) {
    if (value_) {
      value_->add(kind == Value::String ? quoted(text) : text);
    } else if (ignored_ > 0) {
    } else if (objects_.empty()) {
      refuse("it is a single value", "a GeoJSON text is an object");
    } else if (isInCoordinates()) {
      kind == Value::Number ? top().coordinates->add(number) : top().coordinates->addOther();
    } else if (top().list != Role::None) {
      refuse("'" + top().key + "' has a value among its objects");
    } else if (top().key == "type" && kind == Value::String) {
      top().type = text;
    } else if (top().key == "id" && kind != Value::Other) {
      top().id = kind == Value::String ? quoted(text) : text;
    } else if (kind == Value::Other && text == "null" && (top().key == "geometry" || top().key == "coordinates")) {
      top().other = "null";
    } else if (kind == Value::Other && text == "null" && (top().key == "properties" || top().key == "id")) {
      return true;
    } else {
      requireIgnored(shortened(text, 60));
    }
    return true;
  }
  void takeValue() {
    if (!value_->isWhole()) return;
    top().properties = std::move(value_->text);
    value_.reset();
  }

  void end(Object& object) {
    const std::string& type = object.type;
    if (!object.has("type")) refuse("an object has no 'type'");
    if (type == "FeatureCollection") {
      if (object.role != Role::Root) refuse("a FeatureCollection stands within another object");
      if (!object.has("features")) refuse("a FeatureCollection has no 'features'");
      return;
    }
    if (type == "Feature") {
      if (object.role != Role::Root && object.role != Role::Feature) refuse("a Feature stands in a geometry's place");
      if (!object.has("geometry")) refuse("a Feature has no 'geometry'");
      return emit(object);
    }
    if (object.role == Role::Feature) refuse("'features' has a " + shortened(quoted(type), 60), "each is a Feature");
    endGeometry(object);
    if (object.role == Role::Root) return emit(object);
    Object& outer = objects_[objects_.size() - 2];
    std::move(object.parts.begin(), object.parts.end(), std::back_inserter(outer.parts));
    if (outer.other.empty()) outer.other = object.other;
    if (outer.fault.empty()) outer.fault = object.fault;
  }

  void endGeometry(Object& object) {
    const std::string& type = object.type;
    if (type == "GeometryCollection") {
      if (!object.has("geometries")) object.fault = "a GeometryCollection has no 'geometries'";
      if (object.parts.empty() && object.other.empty()) object.other = "GeometryCollection without geometries";
      return;
    }
    if (type == "Polygon" || type == "MultiPolygon") {
      const std::size_t depth = type == "Polygon" ? 3 : 4;
      if (!object.coordinates)
        object.fault = "a " + type + " has no 'coordinates'";
      else if (!object.coordinates->fault.empty())
        object.fault = "the coordinates of a " + type + " have " + object.coordinates->fault;
      else if (object.coordinates->depth() == 0)
        object.other = type + " without coordinates";
      else if (object.coordinates->depth() != depth)
        object.fault = "the coordinates of a " + type + " have positions in " +
                       std::to_string(object.coordinates->depth()) + " arrays, not " + std::to_string(depth);
      else
        object.parts = std::move(object.coordinates->parts);
      return;
    }
    for (const char* known : {"Point", "MultiPoint", "LineString", "MultiLineString"})
      if (type == known) {
        object.other = type;
        return;
      }
    object.fault = shortened(quoted(type), 60) + " is no type of GeoJSON";
  }

  /// The last object but for a collection around it.
  void emit(Object& object) {
    if (!object.fault.empty()) refuse(object.fault);
    if (!object.other.empty() && !options_.skip_others)
      refuse("its geometry is a " + object.other + ", which has no area",
             "set GeoOptions::skip_others to leave out such geometries");
    if (object.parts.empty()) return;
    GeoFeature feature = detail::featureOf(std::move(object.parts), options_, place());
    if (object.type == "Feature") {
      feature.id = std::move(object.id);
      feature.properties = std::move(object.properties);
    }
    features_.push_back(std::move(feature));
  }

  const std::string text_, source_;
  const GeoOptions& options_;
  std::vector<GeoFeature> features_;
  std::vector<Object> objects_;     ///< from the root to the innermost one
  std::optional<ValueText> value_;  ///< of properties that are being read
  std::size_t ignored_ = 0;         ///< how many arrays and objects are open in a member that doesn't matter
  std::size_t depth_ = 0, count_ = 0;
};

void append(std::string& text, const Ring& ring) {
  text += '[';
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Vec2& vertex = ring[i < ring.size() ? i : 0];
    text += i == 0 ? "[" : ",[";
    detail::appendNumber(text, vertex.x());
    text += ',';
    detail::appendNumber(text, vertex.y());
    text += ']';
  }
  text += ']';
}

void append(std::string& text, const detail::Part& part) {
  text += '[';
  for (const Ring& ring : part) {
    if (&ring != part.data()) text += ',';
    append(text, ring);
  }
  text += ']';
}

std::string geometryText(const Polygon& polygon, const std::string& name) {
  const std::vector<detail::Part> parts = detail::partsOf(polygon, name, "GeoJSON");
  if (parts.size() == 1) {
    std::string text = R"({"type":"Polygon","coordinates":)";
    append(text, parts[0]);
    return text + '}';
  }
  std::string text = R"({"type":"MultiPolygon","coordinates":[)";
  for (const detail::Part& part : parts) {
    if (&part != parts.data()) text += ',';
    append(text, part);
  }
  return text + "]}";
}

/// Refuses what readers would: a feature is within a list within an object.
json valueOf(const std::string& text, const std::string& name) {
  using Event = json::parse_event_t;
  if (hasNul(text) || text.rfind("\xef\xbb\xbf", 0) == 0)  // the parser skips a byte order mark
    detail::refuse(name, "it is no JSON: it has a byte order mark or a byte 0");
  try {
    return json::parse(text, [&](int around, Event event, json&) {
      const bool opens = event == Event::object_start || event == Event::array_start;
      if (opens && around + 4 > static_cast<int>(kMostDepth)) detail::refuse(name, "it nests too deep");
      return true;
    });
  } catch (const json::exception& error) {
    detail::refuse(name, "it is no JSON: " + shortened(error.what(), 200));
  }
}

}  // namespace

std::vector<GeoFeature> parseGeoJson(const std::string& text, const GeoOptions& options) {
  detail::requireOrigin(options);
  return Reader(text, "GeoJSON", options).read();
}

std::vector<GeoFeature> readGeoJson(const std::string& path, const GeoOptions& options) {
  detail::requireOrigin(options);
  return Reader(detail::readText(path), path, options).read();
}

std::string toGeoJson(const Polygon& polygon) { return geometryText(polygon, "polygon"); }

std::string toGeoJson(const std::vector<GeoFeature>& features) {
  std::string text = "{\"type\":\"FeatureCollection\",\"features\":[";
  for (const GeoFeature& feature : features) {
    const std::string name = "features[" + std::to_string(&feature - features.data()) + "]";
    text += &feature == features.data() ? "\n" : ",\n";
    text += "{\"type\":\"Feature\",";
    if (!feature.id.empty()) {
      const json id = valueOf(feature.id, name + ".id");
      if (!id.is_string() && !id.is_number())
        detail::refuse(name + ".id", "it is neither a string nor a number", "write a string's quotes, too");
      text += "\"id\":" + feature.id + ',';
    }
    if (!feature.properties.empty()) {
      const json properties = valueOf(feature.properties, name + ".properties");
      if (!properties.is_object() && !properties.is_null())
        detail::refuse(name + ".properties", "it is no JSON object", "write {\"name\":value}");
    }
    text += "\"properties\":" + (feature.properties.empty() ? "null" : feature.properties);
    text += ",\"geometry\":" + geometryText(feature.polygon, name + ".polygon") + '}';
  }
  return text + "\n]}\n";
}

void writeGeoJson(const std::string& path, const std::vector<GeoFeature>& features) {
  detail::writeWhole(path, toGeoJson(features));
}

}  // namespace tricover
