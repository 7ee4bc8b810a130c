// SPDX-License-Identifier: BSD-3-Clause
// Bytes as GeoJSON: features or std::runtime_error, never anything else. Features are written and read again to the
// same.
#include "geo_case.h"

namespace {

using namespace tricover;

constexpr std::array kTokens{"{",         "}",
                             "[",         "]",
                             ",",         ":",
                             "null",      "true",
                             "1e999",     "\"id\"",
                             "\"type\"",  "\"Feature\"",
                             "\"Point\"", "\"coordinates\"",
                             "[[[[[[",    "[]",
                             "{}",        "\\u00e4",
                             "\xff",      "\"features\"",
                             "-",         "\"a\":1,"};

std::string textOf(fuzz::GeoBytes& geo, const std::vector<Ring>& part) {
  std::string text = "[";
  const int beyond = geo.oneIn(4) ? geo.bytes.byte() % 3 : 0;
  for (const Ring& ring : part) {
    text += &ring == part.data() ? "[" : ",[";
    for (const Vec2& vertex : ring) {
      text += (&vertex == ring.data() ? "[" : ",[") + geo.number(vertex.x()) + ',' + geo.number(vertex.y());
      for (int i = 0; i < beyond; ++i) text += ",7";
      text += ']';
    }
    text += ']';
  }
  return text + ']';
}

/// Of up to three objects, each by one more call.
template <typename Make>
std::string listOf(fuzz::GeoBytes& geo, const Make& make) {
  std::string text = "[";
  const int count = geo.bytes.byte() % 4;
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ",\n") + make();
  return text + ']';
}

std::string geometry(fuzz::GeoBytes& geo, int depth) {
  const int kind = geo.bytes.byte() % 16;
  if (kind == 0) return "null";
  if (kind == 1) return R"({"type":"Point","coordinates":[1,2]})";
  if (kind == 2) return R"({"coordinates":[[1,2],[3,4]],"type":"LineString"})";
  if (kind == 3 && depth < 4)
    return R"({"type":"GeometryCollection","geometries":)" + listOf(geo, [&] { return geometry(geo, depth + 1); }) +
           '}';
  const bool is_multi = kind % 2 == 0;
  const auto parts = geo.parts(is_multi);
  std::string coordinates = is_multi ? "[" : "";
  for (const auto& part : parts) coordinates += (&part == parts.data() ? "" : ",") + textOf(geo, part);
  if (is_multi) coordinates += ']';
  const std::string type = is_multi ? R"("type":"MultiPolygon")" : R"("type":"Polygon")";
  // The type may come last.
  if (geo.oneIn(4)) return R"({"bbox":[0,{"type":[]}],"coordinates":)" + coordinates + ',' + type + '}';
  return '{' + type + R"(,"coordinates":)" + coordinates + '}';
}

std::string feature(fuzz::GeoBytes& geo) {
  constexpr std::array kIds{"", R"("id":17,)", R"("id":"do\"ck",)", R"("id":1.50,)", R"("id":null,)"};
  constexpr std::array kProperties{"null", "{}", R"({"a":1.50,"b":["\u00e4\n",null,true,{"c":-0}]})",
                                   R"({"type":"Polygon","coordinates":{}})"};
  const std::string id = geo.oneIn(32) ? R"("id":[],)" : kIds[geo.bytes.byte() % kIds.size()];
  std::string properties = geo.oneIn(32) ? "[]" : kProperties[geo.bytes.byte() % kProperties.size()];
  if (geo.oneIn(32)) {
    const auto depth = static_cast<std::size_t>(geo.bytes.integer(50, 65));
    properties = "{\"deep\":" + std::string(depth, '[') + std::string(depth, ']') + '}';
  }
  return R"({"type":"Feature",)" + id + R"("geometry":)" + geometry(geo, 0) + R"(,"properties":)" + properties + '}';
}

std::string anyText(fuzz::GeoBytes& geo) {
  const int kind = geo.bytes.byte() % 4;
  std::string text =
      kind == 0   ? geometry(geo, 0)
      : kind == 1 ? feature(geo)
                  : R"({"type":"FeatureCollection","features":)" + listOf(geo, [&] { return feature(geo); }) + '}';
  return geo.damaged(std::move(text), kTokens);
}

void checkFeatures(const std::vector<GeoFeature>& features, const std::string& reproduction) {
  bool is_writable = true;
  for (const GeoFeature& each : features) {
    fuzz::checkWritten(each.polygon, reproduction);
    is_writable = is_writable && fuzz::isWritable(each.polygon);
  }
  try {
    const std::vector<GeoFeature> again = parseGeoJson(toGeoJson(features));
    if (again.size() != features.size()) fuzz::fail("another number of features", reproduction);
    for (std::size_t i = 0; i < again.size(); ++i)
      if (again[i].id != features[i].id || again[i].properties != features[i].properties ||
          toGeoJson(again[i].polygon) != toGeoJson(features[i].polygon))
        fuzz::fail("another feature", reproduction);
  } catch (const std::invalid_argument& error) {
    // A feature that was alone is two levels deeper in the collection.
    if (is_writable && std::string(error.what()).find("nests too deep") == std::string::npos)
      fuzz::fail("features are refused", reproduction);
  }
}

/// Any id and properties are refused, or are in a text that is read again.
void checkMembers(const std::string& id, const std::string& properties) {
  std::string text;
  try {
    text = toGeoJson(std::vector<GeoFeature>{{Polygon::box(1, 1), id, properties}});
  } catch (const std::invalid_argument&) {
    return;
  }
  const std::string reproduction = "parseGeoJson(" + fuzz::quoted(text) + ");\n";
  if (parseGeoJson(text).size() != 1) fuzz::fail("members break a text", reproduction);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto [text, options] = fuzz::GeoInput(data, size, anyText);
  std::vector<GeoFeature> features;
  try {
    features = parseGeoJson(text, options);
  } catch (const std::runtime_error&) {
    checkMembers(text, text.substr(text.size() / 2));
    checkMembers("", text);
    return 0;
  }
  checkFeatures(features, "parseGeoJson(" + fuzz::quoted(text) + ");\n");
  return 0;
}
