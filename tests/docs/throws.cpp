// SPDX-License-Identifier: BSD-3-Clause
// A call for each \throws of the public headers, and for each of the reasons that it names. check.py looks for a THROWS
// of the same header, function and exception.
#include "throws.h"

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "own_folder.h"
#include "tricover/geojson.h"
#include "tricover/occupancy_grid_io.h"
#include "tricover/paper.h"
#include "tricover/rasterize.h"
#include "tricover/tricover.h"
#include "tricover/wkt.h"

namespace tricover {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const Pose here = Pose::Identity(), off = Pose(Eigen::Scaling(2.0)), nowhere = poseAt(kNaN, 0);
const Polygon square = Polygon::box(2, 2);
const Polygon outside = square.complement();
const Vec2 p = {0, 0}, q = {5, 0}, bad_point = {0, kInfinity};
const Touching no_touching = static_cast<Touching>(7);
const ContactDetail no_detail = static_cast<ContactDetail>(7);
const Motion still = Motion::still(here), bad_motion = {off}, fast = Motion::translation(here, {kInfinity, 0});
const Trajectory path({{0, 1, still}}), later({{2, 3, still}});

TEST(Throws, Pairs) {
  for (const Pose& bad : {off, nowhere}) {
    THROWS(collide.h, collide, std::invalid_argument, collide(square, bad, square, here));
    THROWS(contacts.h, crossings, std::invalid_argument, crossings(square, here, square, bad));
    THROWS(contacts.h, contacts, std::invalid_argument, contacts(square, here, square, bad));
    THROWS(covers.h, covers, std::invalid_argument, covers(square, here, square, bad));
    THROWS(depth.h, depth, std::invalid_argument, depth(square, bad, square, here));
    THROWS(depth.h, excess, std::invalid_argument, excess(square, here, square, bad));
    THROWS(depth.h, hausdorffDistance, std::invalid_argument, hausdorffDistance(square, here, square, bad));
    THROWS(distance.h, distance, std::invalid_argument, distance(square, here, square, bad));
    THROWS(distance.h, distanceWithin, std::invalid_argument, distanceWithin(square, here, square, bad, 1));
    THROWS(paper.h, collide, std::invalid_argument, paper::collide(square, here, square, bad));
    THROWS(penetration.h, penetration, std::invalid_argument, penetration(square, bad, square, here));
    THROWS(signed_distance.h, signedDistance, std::invalid_argument, signedDistance(square, bad, square, here));
  }
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    THROWS(collide.h, collide, std::invalid_argument, collide(square, here, square, here, {bad}));
    THROWS(covers.h, covers, std::invalid_argument, covers(square, here, square, here, {bad}));
  }
  for (const double bad : {kNaN, kInfinity, -1.0}) {
    THROWS(collide.h, collide, std::invalid_argument, collide(square, here, square, here, {0, bad}));
    THROWS(contacts.h, crossings, std::invalid_argument, crossings(square, here, square, here, {bad}));
    THROWS(contacts.h, contacts, std::invalid_argument, contacts(square, here, square, here, {bad}));
    THROWS(distance.h, distance, std::invalid_argument, distance(square, here, square, here, {bad}));
    THROWS(distance.h, distanceWithin, std::invalid_argument, distanceWithin(square, here, square, here, 1, {bad}));
    THROWS(paper.h, collide, std::invalid_argument, paper::collide(square, here, square, here, {bad}));
    THROWS(paper.h, collide, std::invalid_argument, paper::collide(square, here, square, here, {0, bad}));
    THROWS(penetration.h, penetration, std::invalid_argument, penetration(square, here, square, here, {bad}));
    THROWS(signed_distance.h, signedDistance, std::invalid_argument, signedDistance(square, here, square, here, {bad}));
  }
  for (const double bad : {kNaN, -1.0}) {
    THROWS(distance.h, distance, std::invalid_argument, distance(square, here, square, here, {0, bad}));
    THROWS(distance.h, distance, std::invalid_argument, distance(square, here, square, here, {0, 0, bad}));
    THROWS(distance.h, distanceWithin, std::invalid_argument, distanceWithin(square, here, square, here, bad));
    THROWS(signed_distance.h, signedDistance, std::invalid_argument,
           signedDistance(square, here, square, here, {0, bad}));
  }
}

TEST(Throws, PairsOfOtherValues) {
  const Pose apart = poseAt(9, 0), within = here;
  THROWS(collide.h, collide, std::invalid_argument, collide(square, here, square, here, {0, 0, no_touching}));
  THROWS(paper.h, collide, std::invalid_argument, paper::collide(square, here, square, here, {0, 0, no_touching}));
  THROWS(contacts.h, crossings, std::invalid_argument, crossings(square, here, square, here, {0, no_touching}));
  THROWS(contacts.h, contacts, std::invalid_argument, contacts(square, here, square, here, {0, 9, no_detail}));
  THROWS(contacts.h, contacts, std::invalid_argument,
         contacts(square, here, square, here, {0, 9, ContactDetail::Points, no_touching}));
  THROWS(penetration.h, penetration, std::invalid_argument, penetration(square, here, square, here, {0, no_touching}));
  for (const Pose& at : {apart, within}) {
    THROWS(contacts.h, contacts, std::invalid_argument,
           contacts(outside, here, Polygon::box(1, 1), at, {0, 9, ContactDetail::GlobalDepth}));
    THROWS(penetration.h, penetration, std::invalid_argument, penetration(Polygon::box(1, 1), here, outside, at));
  }
}

/// Polygon::complement(): "legal in all queries but ...".
TEST(Throws, NoOtherQueryOfAComplement) {
  const Polygon body = Polygon::box(1, 1);
  const Motion leaves = Motion::translation(here, {9, 0});
  for (const Pose& at : {here, poseAt(9, 0), poseAt(1, 0)}) {
    EXPECT_NO_THROW(collide(outside, here, body, at));
    EXPECT_NO_THROW(paper::collide(body, at, outside, here));
    EXPECT_NO_THROW(crossings(outside, here, body, at));
    EXPECT_NO_THROW(contacts(outside, here, body, at, {0, 9, ContactDetail::Points}));
    EXPECT_NO_THROW(contacts(body, at, outside, here, {0, 9, ContactDetail::LocalDepth}));
    EXPECT_NO_THROW(covers(outside, here, body, at));
    EXPECT_NO_THROW(covers(outside, here, outside, at, {1}));
    EXPECT_NO_THROW(distance(outside, here, body, at));
    EXPECT_NO_THROW(distanceWithin(body, at, outside, here, 1));
    EXPECT_NO_THROW(castRay(outside, at, p, q, {1}));
    EXPECT_NO_THROW(castRayAll(outside, at, p, q));
    EXPECT_NO_THROW(locate(outside, at.translation()));
  }
  EXPECT_NO_THROW(signedDistance(outside, here, body, here));
  EXPECT_NO_THROW(timeOfImpact(outside, still, body, leaves));
  EXPECT_NO_THROW(conflicts(body, leaves, outside, still, {-0.1}));
  EXPECT_NO_THROW(leastDistance(outside, still, body, leaves));
  EXPECT_NO_THROW(paper::covering(outside));
  Scene scene;
  scene.add(outside, here);
  scene.add(body, here);
  EXPECT_NO_THROW(scene.collisions());
  EXPECT_NO_THROW(scene.covers(body, poseAt(9, 0)));
  EXPECT_NO_THROW(scene.nearestK(outside, here, 2, 1));
  EXPECT_NO_THROW(scene.impacts({{1, leaves}}));
  EXPECT_NO_THROW(scene.castRayAll(p, q));
}

TEST(Throws, Motions) {
  const SplineEnd end{p, 0, p, 0}, bad_end{p, kNaN, p, 0};
  const Pose mirror(Eigen::Scaling(Vec2(-1, 1)));
  THROWS(motion.h, Motion::between, std::invalid_argument, Motion::between(here, off));
  THROWS(motion.h, Motion::between, std::invalid_argument, Motion::between(here, mirror));
  THROWS(motion.h, Motion::between, std::invalid_argument, Motion::between(here, here, bad_point));
  THROWS(motion.h, Motion::spline, std::invalid_argument, Motion::spline(end, bad_end));
  THROWS(motion.h, Motion::spline, std::invalid_argument, Motion::spline({p, p, p, bad_point}, {0, 0, 0, 0}));
  THROWS(motion.h, Motion::at, std::invalid_argument, still.at(kInfinity));
  THROWS(motion.h, Motion::part, std::invalid_argument, still.part(0, kNaN));
  for (const Motion& bad : {bad_motion, fast}) {
    THROWS(motion.h, checkMotion, std::invalid_argument, checkMotion(bad));
    THROWS(time_of_impact.h, timeOfImpact, std::invalid_argument, timeOfImpact(square, still, square, bad));
    THROWS(conflicts.h, conflicts, std::invalid_argument, conflicts(square, bad, square, still));
    THROWS(least_distance.h, leastDistance, std::invalid_argument, leastDistance(square, bad, square, still));
    THROWS(trajectory.h, Trajectory::Trajectory, std::invalid_argument, Trajectory({{0, 1, bad}}));
  }
  THROWS(trajectory.h, Trajectory::Trajectory, std::invalid_argument, Trajectory(std::vector<Leg>{}));
  THROWS(trajectory.h, Trajectory::Trajectory, std::invalid_argument, Trajectory({{1, 0, still}}));
  THROWS(trajectory.h, Trajectory::Trajectory, std::invalid_argument, Trajectory({{0, 1, still}, {2, 3, still}}));
  THROWS(trajectory.h, Trajectory::through, std::invalid_argument, Trajectory::through({{0, here}}));
  THROWS(trajectory.h, Trajectory::through, std::invalid_argument, Trajectory::through({{0, here}, {0, here}}));
  THROWS(trajectory.h, Trajectory::through, std::invalid_argument, Trajectory::through({{0, here}, {1, off}}));
  THROWS(trajectory.h, Trajectory::spline, std::invalid_argument, Trajectory::spline({{0, end}}));
  THROWS(trajectory.h, Trajectory::spline, std::invalid_argument, Trajectory::spline({{1, end}, {0, end}}));
  THROWS(trajectory.h, Trajectory::spline, std::invalid_argument, Trajectory::spline({{0, end}, {1, bad_end}}));
  THROWS(trajectory.h, Trajectory::at, std::invalid_argument, path.at(kNaN));
  THROWS(trajectory.h, Trajectory::isThere, std::invalid_argument, path.isThere(kNaN));
  THROWS(trajectory.h, Trajectory::Trajectory, std::invalid_argument, Trajectory(off));
  THROWS(trajectory.h, Trajectory::through, std::invalid_argument,
         Trajectory::through({{0, {0, 0}, 0}, {1, {0, kNaN}, 0}}));
  THROWS(trajectory.h, Trajectory::part, std::invalid_argument, path.part(1, 1));
  THROWS(trajectory.h, Trajectory::part, std::invalid_argument, path.part(0.5, 2));
}

TEST(Throws, OptionsOfMotions) {
  for (const double bad : {kNaN, kInfinity}) {
    THROWS(time_of_impact.h, timeOfImpact, std::invalid_argument, timeOfImpact(square, still, square, still, {bad}));
    THROWS(time_of_impact.h, timeOfImpact, std::invalid_argument, timeOfImpact(square, path, square, path, {bad}));
    THROWS(conflicts.h, conflicts, std::invalid_argument, conflicts(square, still, square, still, {bad}));
    THROWS(conflicts.h, conflicts, std::invalid_argument, conflicts(square, path, square, path, {bad}));
  }
  for (const double bad : {kNaN, kInfinity, -1.0}) {
    THROWS(time_of_impact.h, timeOfImpact, std::invalid_argument, timeOfImpact(square, still, square, still, {0, bad}));
    THROWS(time_of_impact.h, timeOfImpact, std::invalid_argument, timeOfImpact(square, path, square, path, {0, bad}));
    THROWS(conflicts.h, conflicts, std::invalid_argument, conflicts(square, still, square, still, {0, bad}));
    THROWS(conflicts.h, conflicts, std::invalid_argument, conflicts(square, path, square, path, {0, bad}));
    THROWS(least_distance.h, leastDistance, std::invalid_argument, leastDistance(square, still, square, still, {bad}));
    THROWS(least_distance.h, leastDistance, std::invalid_argument, leastDistance(square, path, square, path, {bad}));
  }
  for (const double bad : {kNaN, kInfinity, 0.0}) {
    THROWS(least_distance.h, leastDistance, std::invalid_argument,
           leastDistance(square, still, square, still, {0, bad}));
    THROWS(least_distance.h, leastDistance, std::invalid_argument, leastDistance(square, path, square, path, {0, bad}));
  }
  THROWS(least_distance.h, leastDistance, std::invalid_argument,
         leastDistance(square, path.vanishing(), square, later.appearing()));
}

TEST(Throws, Polygons) {
  const std::size_t too_many = (std::size_t{1} << 29) + 1;
  const Ring triangle = {{0, 0}, {1, 0}, {0, 1}}, cross = {{-3, -1}, {3, -1}, {3, 1}, {-3, 1}};
  const Ring across = {{-1, -3}, {1, -3}, {1, 3}, {-1, 3}};
  THROWS(polygon.h, Polygon::Polygon, std::invalid_argument, Polygon(std::vector<Ring>{}));
  THROWS(polygon.h, Polygon::Polygon, std::invalid_argument, Polygon({{{0, 0}, {1, 1}}}));
  THROWS(polygon.h, Polygon::Polygon, std::invalid_argument, Polygon({{{0, 0}, {1, 1}, {kNaN, 0}}}));
  THROWS(polygon.h, Polygon::Polygon, std::invalid_argument, Polygon(triangle, static_cast<FillRule>(7)));
  THROWS(polygon.h, Polygon::Polygon, std::invalid_argument, Polygon(nullptr, 3));
  THROWS(polygon.h, Polygon::Polygon, std::length_error, Polygon(triangle.data(), too_many));
  THROWS(polygon.h, Polygon::Polygon, std::length_error, Polygon(triangle.data(), too_many, FillRule::NonZero));
  THROWS(polygon.h, Polygon::edgeStart, std::out_of_range, square.edgeStart(4));
  THROWS(polygon.h, Polygon::edgeEnd, std::out_of_range, square.edgeEnd(-1));
  THROWS(polygon.h, Polygon::bounds, std::invalid_argument, square.bounds(off));
  THROWS(polygon.h, Polygon::translated, std::invalid_argument, square.translated(bad_point));
  THROWS(polygon.h, Polygon::translated, std::invalid_argument, square.scaled(1e308).translated({1e308, 0}));
  THROWS(polygon.h, Polygon::transformed, std::invalid_argument, square.transformed(off));
  THROWS(polygon.h, Polygon::transformed, std::invalid_argument, square.scaled(1e308).transformed(poseAt(1e308, 0)));
  THROWS(polygon.h, Polygon::scaled, std::invalid_argument, square.scaled(0));
  THROWS(polygon.h, Polygon::scaled, std::invalid_argument, square.scaled(1e308).scaled(2));
  THROWS(polygon.h, Polygon::simplified, std::invalid_argument, square.simplified(-1));
  THROWS(polygon.h, Polygon::simplified, std::invalid_argument, square.simplified(kInfinity));
  THROWS(polygon.h, Polygon::simplified, std::invalid_argument, outside.simplified(1, Simplify::Outwards));
  THROWS(polygon.h, Polygon::complement, std::invalid_argument, Polygon::segment(p, q).complement());
  THROWS(polygon.h, Polygon::complement, std::invalid_argument,
         Polygon({cross, across}, FillRule::NonZero).complement());
  THROWS(polygon.h, Polygon::point, std::invalid_argument, Polygon::point(bad_point));
  THROWS(polygon.h, Polygon::segment, std::invalid_argument, Polygon::segment(p, bad_point));
  for (const double bad : {kNaN, kInfinity, 0.0})
    THROWS(polygon.h, Polygon::box, std::invalid_argument, Polygon::box(1, bad));
}

TEST(Throws, PosesAndMaps) {
  const OccupancyGrid too_few{2, 2, {0, 0, 0}}, flat{1, 1, {1}, 0}, far{1, 1, {1}, 1, {kInfinity, 0}};
  const OccupancyGrid too_fine{1, 1, {1}, 1e-9, {1e9, 0}}, fits{1, 1, {1}};
  THROWS(pose.h, checkPose, std::invalid_argument, checkPose(off));
  THROWS(pose.h, checkPose, std::invalid_argument, checkPose(nowhere));
  THROWS(pose.h, nearestRigid, std::invalid_argument, nearestRigid(nowhere));
  THROWS(pose.h, nearestRigid, std::invalid_argument, nearestRigid(Pose(Eigen::Scaling(Vec2(1, 0)))));
  for (const OccupancyGrid& bad : {too_few, flat, far, too_fine}) {
    THROWS(outline.h, outline, std::invalid_argument, outline(bad));
    THROWS(occupancy_grid_io.h, outline, std::invalid_argument, outline(OccupancyMap{bad, here}));
  }
  THROWS(outline.h, outline, std::invalid_argument, outline(fits, IsOccupied()));
  THROWS(occupancy_grid_io.h, readOccupancyMap, std::runtime_error, readOccupancyMap("none.yaml"));
  THROWS(occupancy_grid_io.h, readOccupancyMap, std::runtime_error, readOccupancyMap(__FILE__));
  OccupancyMap mirrored{fits, here}, odd{{1, 1, {101}}, here};
  mirrored.pose.linear() << 1, 0, 0, -1;
  for (const OccupancyMap& bad :
       {OccupancyMap{too_few, here}, OccupancyMap{flat, here}, OccupancyMap{fits, off}, mirrored, odd})
    THROWS(occupancy_grid_io.h, writeOccupancyMap, std::invalid_argument, writeOccupancyMap(bad, "none/map.yaml"));
  THROWS(occupancy_grid_io.h, writeOccupancyMap, std::invalid_argument,
         writeOccupancyMap({fits, here}, "none/map.yaml", "map.bmp"));
  THROWS(occupancy_grid_io.h, writeOccupancyMap, std::runtime_error, writeOccupancyMap({fits, here}, "none/map.yaml"));
  for (const OccupancyGrid& bad : {too_few, flat, far, too_fine}) {
    THROWS(rasterize.h, rasterize, std::invalid_argument, rasterize(square, here, bad));
    THROWS(rasterize.h, rasterize, std::invalid_argument, rasterize(square, here, OccupancyMap{bad, here}));
  }
  THROWS(rasterize.h, rasterize, std::invalid_argument, rasterize(square, off, fits));
  THROWS(rasterize.h, rasterize, std::invalid_argument, rasterize(square, here, fits, {kNaN}));
  THROWS(rasterize.h, rasterize, std::invalid_argument, rasterize(square, here, OccupancyMap{fits, off}));
}

TEST(Throws, PointsAndRays) {
  THROWS(locate.h, locate, std::invalid_argument, locate(square, bad_point));
  THROWS(locate.h, locate, std::invalid_argument, locate(square, off, p));
  THROWS(ray.h, castRay, std::invalid_argument, castRay(square, here, p, bad_point));
  THROWS(ray.h, castRay, std::invalid_argument, castRay(square, off, p, q));
  THROWS(ray.h, castRayAll, std::invalid_argument, castRayAll(square, here, bad_point, q));
  THROWS(ray.h, castRayAll, std::invalid_argument, castRayAll(square, off, p, q));
  for (const double bad : {kNaN, kInfinity, -1.0}) {
    THROWS(ray.h, castRay, std::invalid_argument, castRay(square, here, p, q, {bad}));
    THROWS(ray.h, castRayAll, std::invalid_argument, castRayAll(square, here, p, q, {bad}));
  }
  const auto bounded = paper::InfluenceKind::Bounded, no_kind = static_cast<paper::InfluenceKind>(7);
  for (const double bad : {kNaN, -1.0}) {
    THROWS(paper.h, inInfluenceArea, std::invalid_argument, paper::inInfluenceArea(square, 0, p, bad, bounded));
    THROWS(paper.h, influenceMask, std::invalid_argument, paper::influenceMask(square, p, bad));
    THROWS(paper.h, boundedInfluenceArea, std::invalid_argument, paper::boundedInfluenceArea(square, 0, bad));
  }
  THROWS(paper.h, inInfluenceArea, std::invalid_argument, paper::inInfluenceArea(square, 0, bad_point, 1, bounded));
  THROWS(paper.h, inInfluenceArea, std::invalid_argument, paper::inInfluenceArea(square, 0, p, 1, no_kind));
  THROWS(paper.h, influenceMask, std::invalid_argument, paper::influenceMask(square, bad_point, 1));
  THROWS(paper.h, inInfluenceArea, std::out_of_range, paper::inInfluenceArea(square, 4, p, 1, bounded));
  THROWS(paper.h, boundedInfluenceArea, std::out_of_range, paper::boundedInfluenceArea(square, -1, 1));
}

TEST(Throws, Drawings) {
  SvgDrawing drawing;
  const Impact nowhere_at{0, bad_point, {1, 0}, 0, 0};
  for (const double bad : {kNaN, 0.0, kInfinity})
    THROWS(svg.h, SvgDrawing::SvgDrawing, std::invalid_argument, SvgDrawing(bad));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.polygon(square, off, "none"));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.polygon(square, here, "none", "none", -1));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.polyline({p, bad_point}, "none"));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.text(bad_point, "none"));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.covering(square, off));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.innerDiscs(square, off));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.influenceAreas(square, off, 1));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.hits(square, off, square, here));
  THROWS(svg.h, SvgDrawing, std::invalid_argument, drawing.impact(nowhere_at));
  THROWS(svg.h, SvgDrawing::boxes, std::invalid_argument, drawing.boxes(square, here, -1));
  THROWS(svg.h, SvgDrawing::str, std::logic_error, drawing.str());
  THROWS(svg.h, SvgDrawing::save, std::logic_error, drawing.save("none/drawing.svg"));
  drawing.text(p, "some");
  THROWS(svg.h, SvgDrawing::save, std::runtime_error, drawing.save("none/drawing.svg"));
}

TEST(Throws, GeoJsonAndWkt) {
  const std::string geojson = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})";
  const std::string wkt = "POLYGON ((0 0, 1 0, 1 1, 0 0))";
  const support::OwnFolder folder;
  const std::string file = folder.path() + "throws.geojson";
  std::ofstream(file) << geojson;
  const GeoOptions nowhere_near{bad_point};
  THROWS(geojson.h, readGeoJson, std::invalid_argument, readGeoJson(file, nowhere_near));
  THROWS(geojson.h, parseGeoJson, std::invalid_argument, parseGeoJson(geojson, nowhere_near));
  THROWS(wkt.h, parseWkt, std::invalid_argument, parseWkt(wkt, nowhere_near));
  for (const char* bad : {"none.geojson", "/", __FILE__})
    THROWS(geojson.h, readGeoJson, std::runtime_error, readGeoJson(bad));
  for (const char* bad : {"", "{}", R"({"type":"Point","coordinates":[0,0]})"})
    THROWS(geojson.h, parseGeoJson, std::runtime_error, parseGeoJson(bad));
  for (const char* bad : {"", "POLYGON EMPTY", "POINT (0 0)", "POLYGON ((0 0, 1 0, 0 0))"})
    THROWS(wkt.h, parseWkt, std::runtime_error, parseWkt(bad));

  const Polygon bow_tie({Ring{{0, 0}, {2, 2}, {2, 0}, {0, 1}}});
  for (const Polygon& bad : {outside, bow_tie}) {
    THROWS(geojson.h, toGeoJson, std::invalid_argument, toGeoJson(bad));
    THROWS(wkt.h, toWkt, std::invalid_argument, toWkt(bad));
  }
  for (const GeoFeature& bad : {GeoFeature{bow_tie}, GeoFeature{square, "[]"}, GeoFeature{square, "", "7"}}) {
    THROWS(geojson.h, toGeoJson, std::invalid_argument, toGeoJson(std::vector<GeoFeature>{bad}));
    THROWS(geojson.h, writeGeoJson, std::invalid_argument, writeGeoJson(file, {bad}));
  }
  THROWS(geojson.h, writeGeoJson, std::runtime_error, writeGeoJson("none/some.geojson", {}));
}

TEST(Throws, Bodies) {
  Scene scene;
  const Scene::Body body = scene.add(square, here), none = body + 1;
  BodyOptions endless, untouchable;
  endless.margin = kInfinity;
  untouchable.touching = no_touching;
  for (const BodyOptions& bad : {endless, untouchable}) {
    THROWS(scene.h, Scene::add, std::invalid_argument, scene.add(square, here, bad));
    THROWS(scene.h, Scene::add, std::invalid_argument, scene.add({{square, here, bad}}));
    THROWS(scene.h, Scene::setOptions, std::invalid_argument, scene.setOptions(body, bad));
  }
  for (const Pose& bad : {off, nowhere}) {
    THROWS(scene.h, Scene::add, std::invalid_argument, scene.add(square, bad));
    THROWS(scene.h, Scene::add, std::invalid_argument, scene.add({{square, bad, {}}}));
    THROWS(scene.h, Scene::move, std::invalid_argument, scene.move(body, bad));
    THROWS(scene.h, Scene::move, std::invalid_argument, scene.move({{body, bad}}));
  }
  THROWS(scene.h, Scene::move, std::out_of_range, scene.move(none, here));
  THROWS(scene.h, Scene::move, std::out_of_range, scene.move({{none, here}}));
  THROWS(scene.h, Scene::remove, std::out_of_range, scene.remove(none));
  THROWS(scene.h, Scene::setOptions, std::out_of_range, scene.setOptions(none, {}));
  THROWS(scene.h, Scene::polygon, std::out_of_range, scene.polygon(none));
  THROWS(scene.h, Scene::pose, std::out_of_range, scene.pose(none));
  THROWS(scene.h, Scene::options, std::out_of_range, scene.options(none));
  THROWS(scene.h, Scene::setIgnored, std::out_of_range, scene.setIgnored(body, none));
  THROWS(scene.h, Scene::setIgnored, std::invalid_argument, scene.setIgnored(body, body));
  THROWS(scene.h, Scene::isIgnored, std::out_of_range, scene.isIgnored(none, body));
  scene.add(square, here);
  THROWS(scene.h, Scene::contacts, std::invalid_argument, scene.contacts(no_detail));
}

TEST(Throws, SceneQueries) {
  Scene scene;
  const auto goes_on = [](Scene::Body) { return true; };
  const Scene::Body body = scene.add(square, here), none = body + 1;
  for (const Pose& bad : {off, nowhere}) {
    THROWS(scene.h, Scene::collides, std::invalid_argument, scene.collides(square, bad));
    THROWS(scene.h, Scene::collides, std::invalid_argument, scene.collides(square, std::vector<Pose>{here, bad}));
    THROWS(scene.h, Scene::anyColliding, std::invalid_argument, scene.anyColliding(square, bad));
    THROWS(scene.h, Scene::colliding, std::invalid_argument, scene.colliding(square, bad));
    THROWS(scene.h, Scene::visitColliding, std::invalid_argument, scene.visitColliding(square, bad, goes_on));
    THROWS(scene.h, Scene::covers, std::invalid_argument, scene.covers(square, bad));
    THROWS(scene.h, Scene::nearest, std::invalid_argument, scene.nearest(square, bad));
    THROWS(scene.h, Scene::nearest, std::invalid_argument, scene.nearest(square, std::vector<Pose>{here, bad}));
    THROWS(scene.h, Scene::nearestWithin, std::invalid_argument, scene.nearestWithin(square, bad, 1));
    THROWS(scene.h, Scene::nearestK, std::invalid_argument, scene.nearestK(square, bad, 1, 1));
  }
  THROWS(scene.h, Scene::collides, std::invalid_argument, scene.collides(square, here, {0, 0, no_touching}));
  for (const double bad : {kNaN, kInfinity}) {
    THROWS(scene.h, Scene::collides, std::invalid_argument, scene.collides(square, here, {bad}));
    THROWS(scene.h, Scene::anyColliding, std::invalid_argument, scene.anyColliding(square, here, {0, bad}));
    THROWS(scene.h, Scene::colliding, std::invalid_argument, scene.colliding(square, here, {bad}));
    THROWS(scene.h, Scene::covers, std::invalid_argument, scene.covers(square, here, {bad}));
    THROWS(scene.h, Scene::firstExit, std::invalid_argument, scene.firstExit(square, Motion::still(here), {bad}));
    THROWS(scene.h, Scene::nearest, std::invalid_argument, scene.nearest(square, here, {bad}));
    THROWS(scene.h, Scene::castRay, std::invalid_argument, scene.castRay(p, q, {bad}));
    THROWS(scene.h, Scene::castRayAll, std::invalid_argument, scene.castRayAll(p, q, {bad}));
  }
  THROWS(scene.h, Scene::nearestWithin, std::invalid_argument, scene.nearestWithin(square, here, kNaN));
  THROWS(scene.h, Scene::nearestK, std::invalid_argument, scene.nearestK(square, here, 1, -1));
  THROWS(scene.h, Scene::castRay, std::invalid_argument, scene.castRay(p, bad_point));
  THROWS(scene.h, Scene::castRayAll, std::invalid_argument, scene.castRayAll(bad_point, q));
  THROWS(scene.h, BodyFilter, std::out_of_range, scene.collides(square, here, {}, BodyFilter::allBut(none)));
  THROWS(scene.h, BodyFilter, std::out_of_range, scene.castRay(p, q, {}, BodyFilter::allBut(none)));
  BodyOptions inflated;
  inflated.margin = 1;
  scene.setOptions(body, inflated);
  THROWS(scene.h, Scene::covers, std::invalid_argument, scene.covers(square, here));
}

TEST(Throws, SceneMotions) {
  Scene scene;
  const Scene::Body body = scene.add(square, here), none = body + 1;
  const std::vector<BodyMotion> twice(2, {body, still});
  const std::vector<BodyTrajectory> twice_on(2, {body, path});
  for (const double bad : {kNaN, kInfinity}) {
    THROWS(scene.h, Scene::firstImpact, std::invalid_argument, scene.firstImpact(square, still, {bad}));
    THROWS(scene.h, Scene::firstImpact, std::invalid_argument, scene.firstImpact(square, path, {0, bad}));
    THROWS(scene.h, Scene::firstExit, std::invalid_argument, scene.firstExit(square, path, {bad}));
    THROWS(scene.h, Scene::impacts, std::invalid_argument, scene.impacts({{body, still}}, {bad}));
    THROWS(scene.h, Scene::impacts, std::invalid_argument, scene.impacts({{body, path}}, {0, bad}));
    THROWS(scene.h, Scene::conflicts, std::invalid_argument, scene.conflicts({{body, path}}, {bad}));
    THROWS(scene.h, Scene::conflicts, std::invalid_argument, scene.conflicts({{body, still}}, {bad}));
    THROWS(scene.h, Scene::leastDistance, std::invalid_argument, scene.leastDistance(square, still, {bad}));
    THROWS(scene.h, Scene::leastDistance, std::invalid_argument, scene.leastDistance(square, path, {bad}));
  }
  THROWS(scene.h, Scene::firstImpact, std::invalid_argument, scene.firstImpact(square, bad_motion));
  THROWS(scene.h, Scene::impacts, std::invalid_argument, scene.impacts({{body, bad_motion}}));
  THROWS(scene.h, Scene::impacts, std::invalid_argument, scene.impacts(twice));
  THROWS(scene.h, Scene::impacts, std::invalid_argument, scene.impacts(twice_on));
  THROWS(scene.h, Scene::conflicts, std::invalid_argument, scene.conflicts(twice_on));
  THROWS(scene.h, Scene::conflicts, std::invalid_argument, scene.conflicts(twice));
  THROWS(scene.h, Scene::leastDistance, std::invalid_argument, scene.leastDistance(square, bad_motion));
  THROWS(scene.h, Scene::impacts, std::out_of_range, scene.impacts(std::vector<BodyMotion>{{none, still}}));
  THROWS(scene.h, Scene::impacts, std::out_of_range, scene.impacts(std::vector<BodyTrajectory>{{none, path}}));
  THROWS(scene.h, Scene::conflicts, std::out_of_range, scene.conflicts(std::vector<BodyMotion>{{none, still}}));
  THROWS(scene.h, Scene::conflicts, std::out_of_range, scene.conflicts(std::vector<BodyTrajectory>{{none, path}}));
}

TEST(Throws, Recordings) {
  Scene scene, other;
  const Scene::Body body = scene.add(square, here);
  other.add(Polygon::box(1, 1), here);
  SceneRecording recording;
  THROWS(recording.h, SceneRecording::str, std::logic_error, recording.str());
  THROWS(recording.h, SceneRecording::save, std::logic_error, recording.save("nowhere.html"));
  THROWS(recording.h, SceneRecording, std::invalid_argument, recording.text(p, "no frame yet"));
  THROWS(recording.h, SceneRecording::frame, std::out_of_range, recording.frame(0, scene, {{body, body + 9}}));
  recording.frame(0, scene);
  THROWS(recording.h, SceneRecording, std::invalid_argument, recording.frame(kNaN, scene));
  THROWS(recording.h, SceneRecording, std::invalid_argument, recording.ray(p, bad_point));
  THROWS(recording.h, SceneRecording, std::invalid_argument, recording.text(p, "", TimeInterval{2, 1}));
  THROWS(recording.h, SceneRecording, std::invalid_argument, recording.nearest(DistanceResult{kInfinity, p, q, 0, 0}));
  THROWS(recording.h, SceneRecording::frame, std::invalid_argument, recording.frame(0, scene));
  THROWS(recording.h, SceneRecording::frame, std::invalid_argument, recording.frame(1, other));
  THROWS(recording.h, SceneRecording::trajectories, std::invalid_argument, recording.trajectories(other, {}));
  THROWS(recording.h, SceneRecording::trajectories, std::invalid_argument,
         recording.trajectories(scene, {{body, path}, {body, path}}));
  THROWS(recording.h, SceneRecording::trajectories, std::out_of_range,
         recording.trajectories(scene, {{body + 9, path}}));
  THROWS(recording.h, SceneRecording::name, std::out_of_range, recording.name(body + 9, "none"));
  THROWS(recording.h, SceneRecording::conflicts, std::out_of_range, recording.conflicts({{{body, body + 9}, {}}}));
  THROWS(recording.h, SceneRecording::impacts, std::out_of_range, recording.impacts({{{body, body + 9}, {}}}));
  THROWS(recording.h, SceneRecording::save, std::runtime_error, recording.save("/no/such/folder/page.html"));
}

}  // namespace
}  // namespace tricover
