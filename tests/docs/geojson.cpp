// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/geojson.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "own_folder.h"
#include "tricover/covers.h"
#include "tricover/polygon.h"

namespace {

TEST(Documentation, GeoJsonFiles) {
  const tricover::support::OwnFolder own;
  const std::string folder = own.path();
  //! [read]
  // Two lanes that overlap, in metres of some national grid.
  std::ofstream(folder + "lanes.geojson")
      << R"({"type": "FeatureCollection", "features": [{"type": "Feature", "id": 17, "properties": {"speed": 2.5},)"
      << R"("geometry": {"type": "MultiPolygon", "coordinates": [)"
      << "[[[500000, 5400000], [500010, 5400000], [500010, 5400004], [500000, 5400004], [500000, 5400000]]],"
      << "[[[500008, 5400000], [500020, 5400000], [500020, 5400004], [500008, 5400004], [500008, 5400000]]]]}}]}";

  tricover::GeoOptions options;
  options.origin = {500000, 5400000};  // near the data, so that coordinates are small
  std::vector<tricover::GeoFeature> lanes = tricover::readGeoJson(folder + "lanes.geojson", options);
  ASSERT_EQ(lanes.size(), 1u);
  EXPECT_EQ(lanes[0].id, "17");
  EXPECT_EQ(lanes[0].properties, R"({"speed":2.5})");
  EXPECT_EQ(lanes[0].rounded_coordinates, 0u);
  const tricover::Polygon car = tricover::Polygon::box(4, 2);
  const tricover::Pose map = tricover::Pose::Identity();
  EXPECT_TRUE(tricover::covers(lanes[0].polygon, map, car, tricover::poseAt(9, 2)));  // in both lanes
  EXPECT_FALSE(tricover::covers(lanes[0].polygon, map, car, tricover::poseAt(19, 2)));

  lanes[0].polygon = car;
  tricover::writeGeoJson(folder + "car.geojson", lanes);
  EXPECT_EQ(tricover::readGeoJson(folder + "car.geojson").at(0).polygon.rings(), car.rings());
  //! [read]
}

TEST(Documentation, GeoJsonTexts) {
  //! [text]
  const std::string dock = R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,0]]]})";
  const std::vector<tricover::GeoFeature> features = tricover::parseGeoJson(dock);
  ASSERT_EQ(features.size(), 1u);
  EXPECT_EQ(features[0].polygon.area(), 6);
  EXPECT_EQ(tricover::toGeoJson(features[0].polygon), dock);

  tricover::GeoFeature named{features[0].polygon};
  named.id = "\"dock\"";  // JSON, so with quotes
  named.properties = R"({"floor":2})";
  const std::string collection = tricover::toGeoJson(std::vector<tricover::GeoFeature>{named});
  EXPECT_EQ(tricover::parseGeoJson(collection).at(0).properties, R"({"floor":2})");
  //! [text]
}

}  // namespace
