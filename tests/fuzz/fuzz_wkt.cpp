// SPDX-License-Identifier: BSD-3-Clause
// Bytes as WKT: a polygon or std::runtime_error, never anything else. A polygon is written and read again to the same.
//
// After a zero the bytes are the text. Otherwise they choose one that is mostly right.
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
  const bool is_text = size > 0 && data[0] == 0;
  fuzz::GeoBytes geo(data, size);
  const std::string text = is_text ? std::string(data + 1, data + size) : anyText(geo);
  const GeoOptions options = is_text ? GeoOptions() : geo.options();
  std::vector<GeoFeature> features;
  try {
    features.push_back(parseWkt(text, options));
  } catch (const std::runtime_error&) {
    return 0;
  }
  fuzz::checkWritten(features[0].polygon, "parseWkt(" + fuzz::quoted(text) + ");\n");
  return 0;
}
