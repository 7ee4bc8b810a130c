// SPDX-License-Identifier: BSD-3-Clause
// GeoJSON and WKT as tuples and texts, of which tricover._geo makes what users see; and what such files need of
// polygons.
#include <pybind11/stl.h>
#include <tricover/geojson.h>
#include <tricover/wkt.h>

#include <utility>

#include "python/module.h"

namespace tricover_python {
namespace {

/// In the order of tricover._geo.GeoFeature.
using FeatureTuple = std::tuple<tricover::Polygon, std::string, std::string, std::size_t, std::size_t>;

FeatureTuple tupleOf(const tricover::GeoFeature& feature) {
  return {feature.polygon, feature.id, feature.properties, feature.rounded_crossings, feature.rounded_coordinates};
}

std::vector<FeatureTuple> tuplesOf(const std::vector<tricover::GeoFeature>& features) {
  std::vector<FeatureTuple> tuples;
  for (const tricover::GeoFeature& feature : features) tuples.push_back(tupleOf(feature));
  return tuples;
}

std::vector<tricover::GeoFeature> featuresFrom(const std::vector<FeatureTuple>& tuples) {
  std::vector<tricover::GeoFeature> features;
  for (const auto& [polygon, id, properties, crossings, coordinates] : tuples)
    features.push_back({polygon, id, properties, crossings, coordinates});
  return features;
}

}  // namespace

tricover::Polygon polygonFromGeo(const py::object& given) {
  return py::module_::import("tricover._geo").attr("polygon_from")(given).cast<tricover::Polygon>();
}

py::object geoOf(const tricover::Polygon& polygon) {
  return py::module_::import("tricover._geo").attr("geometry_of")(polygon);
}

void defineGeo(py::module_& m) {
  m.def("_read_geo_json", [](const std::string& path, const py::object& origin, bool skip_others) {
    return tuplesOf(tricover::readGeoJson(path, {pointFrom(origin, "origin"), skip_others}));
  });
  m.def("_parse_geo_json", [](const std::string& text, const py::object& origin, bool skip_others) {
    return tuplesOf(tricover::parseGeoJson(text, {pointFrom(origin, "origin"), skip_others}));
  });
  m.def("_parse_wkt", [](const std::string& text, const py::object& origin) {
    return tupleOf(tricover::parseWkt(text, {pointFrom(origin, "origin"), false}));
  });
  m.def("_polygon_to_geo_json", [](const Shape& polygon) { return tricover::toGeoJson(polygon); });
  m.def("_features_to_geo_json",
        [](const std::vector<FeatureTuple>& features) { return tricover::toGeoJson(featuresFrom(features)); });
  m.def("_write_geo_json", [](const std::string& path, const std::vector<FeatureTuple>& features) {
    tricover::writeGeoJson(path, featuresFrom(features));
  });
  m.def(
      "to_wkt", [](const Shape& polygon) { return tricover::toWkt(polygon); }, py::arg("polygon"), doc("to_wkt"));
  m.def(
      "self_crossings",
      [](const Shape& polygon, std::size_t most) { return one(tricover::selfCrossings(polygon, most)); },
      py::arg("polygon"), py::arg("most") = std::numeric_limits<std::size_t>::max(), doc("self_crossings"));
}

}  // namespace tricover_python
