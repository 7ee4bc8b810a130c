// SPDX-License-Identifier: BSD-3-Clause
// Bytes as WKT: a polygon or std::runtime_error, never anything else. A polygon is written and read again to the same.
#include <optional>

#include "geo_case.h"

namespace {

using namespace tricover;

constexpr std::array kTokens{"(", ")", ",",          " ",     "EMPTY", "POLYGON", "MULTI",
                             "Z", "M", "SRID=4326;", "1e999", "nan",   "\n",      "+"};

std::string textOf(fuzz::GeoBytes& geo, const std::vector<Ring>& part) {
  std::string text = "(";
  const int beyond = geo.oneIn(4) ? geo.bytes.byte() % 3 : 0;
  for (const Ring& ring : part) {
    text += &ring == part.data() ? "(" : ",(";
    for (const Vec2& vertex : ring) {
      text += (&vertex == ring.data() ? "" : ",") + geo.number(vertex.x()) + ' ' + geo.number(vertex.y());
      for (int i = 0; i < beyond; ++i) text += " 7";
    }
    text += ')';
  }
  return text + ')';
}

std::string anyText(fuzz::GeoBytes& geo) {
  constexpr std::array kWords{"POLYGON", "polygon Z ", "PolygonM", " \n POLYGON ZM", "SRID=4326; POLYGON"};
  const bool is_multi = geo.oneIn(2);
  const auto parts = geo.parts(is_multi);
  std::string text = is_multi ? "MULTIPOLYGON(" : kWords[geo.bytes.byte() % kWords.size()];
  for (const auto& part : parts) text += (&part == parts.data() ? "" : " , ") + textOf(geo, part);
  return geo.damaged(is_multi ? text + ')' : text, kTokens);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [text, options] = fuzz::GeoInput(data, size, anyText);
  std::optional<GeoFeature> feature;
  try {
    feature = parseWkt(text, options);
  } catch (const std::runtime_error&) {
    return 0;
  }
  fuzz::checkWritten(feature->polygon, "parseWkt(" + fuzz::quoted(text) + ");\n");
  return 0;
}
