// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "byte_reader.h"
#include "tricover/covers.h"
#include "tricover/geojson.h"
#include "tricover/validity.h"
#include "tricover/wkt.h"

namespace tricover::fuzz {

/// What GeoJSON and WKT have in common: parts that are mostly valid, numbers, damage.
class GeoBytes {
 public:
  GeoBytes(const std::uint8_t* data, std::size_t size) : bytes(data, size) {}

  bool oneIn(int n) { return bytes.byte() % n == 0; }

  std::string number(double value) {
    constexpr std::array kOdd{"-0",     "-0.0", "0.50", "1E0", "-2.5e+00", "1e999", "18446744073709551617",
                              "5e-324", "nan",  "01"};
    if (oneIn(97)) return kOdd[bytes.byte() % kOdd.size()];
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
  }

  /// Up to three parts with up to two holes, each ring closed.
  std::vector<std::vector<Ring>> parts(bool has_many) {
    std::vector<std::vector<Ring>> parts(static_cast<std::size_t>(has_many ? bytes.integer(1, 3) : 1));
    if (has_many && oneIn(8)) {
      // Each in the hole of the one before.
      double size = 16;
      for (std::vector<Ring>& part : parts)
        for (int i = 0; i < 2; ++i, --size) {
          part.push_back(ring({-size, -size}, {size, size}));
          part.back().push_back(part.back().front());
        }
      if (oneIn(2)) std::reverse(parts.begin(), parts.end());
      return parts;
    }
    for (std::vector<Ring>& part : parts) {
      const Vec2 low(bytes.integer(0, 12), bytes.integer(0, 12)), high = low + Vec2(size(), size());
      part.push_back(ring(low, high));
      const int holes = bytes.byte() % 4;
      for (int i = 1; i < holes; ++i) {
        const double x = low.x() + i - 0.5;
        part.push_back(ring({x, low.y() + 1}, {x + (oneIn(2) ? 0.5 : 1), std::max(low.y() + 1.5, high.y() - 1)}));
      }
      for (Ring& ring : part)
        if (!oneIn(61)) ring.push_back(ring.front());
    }
    return parts;
  }

  GeoOptions options() {
    GeoOptions options;
    options.skip_others = oneIn(2);
    if (oneIn(8)) options.origin = {bytes.finiteDouble(), bytes.coordinate()};
    return options;
  }

  /// Some texts are cut, or have a token put in, taken away or doubled.
  template <typename Tokens>
  std::string damaged(std::string text, const Tokens& tokens) {
    for (int times = bytes.byte() % 8 - 4; times > 0 && !text.empty(); --times) {
      const std::size_t at = (std::size_t{256} * bytes.byte() + bytes.byte()) % text.size();
      const int kind = bytes.byte() % 8;
      if (kind == 0) text.resize(at);
      if (kind == 1) text.insert(at, text.substr(at, bytes.byte()));
      if (kind == 2) text[at] = static_cast<char>(bytes.byte());
      if (kind == 3 || kind == 4) text.erase(at, 1);
      if (kind > 4) text.insert(at, tokens[bytes.byte() % tokens.size()]);
    }
    return text;
  }

  ByteReader bytes;

 private:
  double size() { return bytes.integer(1, 6); }

  /// Mostly a rectangle or a triangle in it, some anything.
  Ring ring(const Vec2& low, const Vec2& high) {
    const int kind = bytes.byte() % 16;
    Ring ring{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    if (kind > 8) ring.erase(ring.begin() + kind % 4);
    if (kind > 12)
      for (int i = 0; i < kind - 12; ++i) ring[static_cast<std::size_t>(i)] = bytes.point();
    if (oneIn(3)) std::reverse(ring.begin(), ring.end());
    if (oneIn(16)) ring.insert(ring.begin() + 1, ring[1]);
    return ring;
  }
};

/// What a target reads: after a zero the bytes are the text; otherwise make(geo) chooses one that is mostly right.
struct GeoInput {
  template <typename Make>
  GeoInput(const std::uint8_t* data, std::size_t size, const Make& make) {
    GeoBytes geo(data, size);
    const bool is_text = size > 0 && data[0] == 0;
    text = is_text ? std::string(data + 1, data + size) : make(geo);
    if (!is_text) options = geo.options();
  }

  std::string text;
  GeoOptions options;
};

/// A text as C++.
inline std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    std::array<char, 8> octal;
    std::snprintf(octal.data(), octal.size(), "\\%03o", static_cast<unsigned>(static_cast<unsigned char>(c)));
    const bool is_plain = c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '?';
    result += is_plain ? std::string(1, c) : octal.data();
  }
  return result + '"';
}

/// Rings in an order that doesn't depend on directions nor on the order that they had.
inline std::vector<std::vector<std::array<double, 2>>> sorted(const std::vector<Ring>& rings) {
  std::vector<std::vector<std::array<double, 2>>> result;
  for (const Ring& ring : rings) {
    std::vector<std::array<double, 2>> points;
    for (const Vec2& vertex : ring) points.push_back({vertex.x(), vertex.y()});
    auto reversed = points;
    std::reverse(reversed.begin() + 1, reversed.end());
    result.push_back(std::min(points, reversed));
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline bool isWritable(const Polygon& polygon) {
  for (const SelfCrossing& crossing : selfCrossings(polygon))
    if (crossing.kind != SelfCrossingKind::HoleOutside) return false;
  return true;
}

/// A polygon that was read is refused where it crosses itself. Otherwise it is written and read again to the same.
inline void checkWritten(const Polygon& polygon, const std::string& reproduction) {
  std::string json, wkt;
  const bool is_writable = isWritable(polygon);
  for (std::string* text : {&json, &wkt}) try {
      *text = text == &json ? toGeoJson(polygon) : toWkt(polygon);
      if (!is_writable) fail("a polygon that crosses itself is written", reproduction);
    } catch (const std::invalid_argument&) {
      if (is_writable) fail("a valid polygon is refused", reproduction);
    }
  if (!is_writable) return;
  // The file's directions don't matter.
  std::vector<Ring> reversed = polygon.rings();
  for (Ring& ring : reversed) std::reverse(ring.begin() + 1, ring.end());
  if (toWkt(Polygon(reversed, polygon.fillRule())) != wkt)
    fail("rings the other way are written as others", reproduction);

  const Polygon of_json = parseGeoJson(json).at(0).polygon, of_wkt = parseWkt(wkt).polygon;
  if (toGeoJson(of_json) != json || toGeoJson(of_wkt) != json || toWkt(of_json) != wkt)
    fail("what was written is read as another polygon", reproduction);
  const Pose here = Pose::Identity();
  const bool is_same = polygon.fillRule() == FillRule::EvenOdd
                           ? sorted(polygon.rings()) == sorted(of_json.rings())
                           : covers(polygon, here, of_json, here) && covers(of_json, here, polygon, here);
  if (!is_same) fail("what is written has another region", reproduction);
}

}  // namespace tricover::fuzz
