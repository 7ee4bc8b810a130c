// SPDX-License-Identifier: BSD-3-Clause
// The right column of CHANGELOG's table compiles.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "tricover/occupancy_grid_io.h"
#include "tricover/tricover.h"

namespace tricover {
namespace {

const Pose kHere = Pose::Identity();

TEST(Changelog, PairsAreAskedSo) {
  const Polygon a = Polygon::box(4, 4), b = Polygon::box(2, 2);
  const Pose pose_b = poseAt(2.5, 0);
  PairCache cache;
  static_assert(sizeof(PairCache) == 184);
  EXPECT_TRUE(collide(a, kHere, b, pose_b, cache));
  EXPECT_EQ(distance(a, kHere, b, pose_b, DistanceOptions{/*margin*/ 0, /*relative*/ 0, /*absolute*/ 0}).distance, 0);
  EXPECT_FALSE(distanceWithin(a, kHere, b, poseAt(9, 0), 1));
  EXPECT_EQ(contacts(a, kHere, b, pose_b, {0, 1}).size(), 1u);
  EXPECT_EQ(contacts(a, kHere, b, pose_b, cache, {0, 1}).size(), 1u);
  const auto out = penetration(a, kHere, b, pose_b, PenetrationOptions{/*margin*/ 0, Touching::Collides});
  EXPECT_EQ(out->normal, Vec2(1, 0));
  EXPECT_LE(out->lower_bound, out->depth);
  const Motion still = Motion::still(kHere), flies = Motion::translation(poseAt(9, 0), {-12, 0});
  EXPECT_TRUE(timeOfImpact(a, still, b, flies, ImpactOptions{/*margin*/ 0, /*time_error*/ 1e-6, false}));
  EXPECT_TRUE(castRay(a, kHere, {-9, 0}, {9, 0}, RayOptions{/*margin*/ 1}));
  EXPECT_EQ(locate(a, {0, 0}), Location::Inside);
  const EdgeIndex none = -1;
  EXPECT_NE(out->edge_a, none);
}

TEST(Changelog, ShapesAreMadeSo) {
  const Polygon p({{{0, 0}, {4, 0}, {0, 4}}}), ring({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_EQ(p.rings(), ring.rings());
  EXPECT_EQ(Polygon::point({1, 2}).vertexCount() + Polygon::segment({0, 0}, {1, 0}).vertexCount(), 6u);
  EXPECT_TRUE(p.bounds().contains(p.coveringOrigin()));
  OccupancyMap map;
  map.grid = {1, 1, {100}, 1, {0, 0}};
  map.pose = poseAt(3, 0);
  EXPECT_EQ(outline(map)->bounds().min(), Vec2(3, 0));
}

TEST(Changelog, ThePaperIsIn) {
  const Polygon a = Polygon::box(4, 4), b = Polygon::box(2, 2);
  paper::MaskCache cache;
  EXPECT_TRUE(paper::collide(a, kHere, b, poseAt(2.5, 0), cache));
  const std::vector<paper::CoveringTriangle> triangles = paper::covering(a);
  EXPECT_EQ(triangles.size(), 4u);
}

TEST(Changelog, ScenesAreAskedSo) {
  Scene scene;
  const Scene::Body body = scene.add(Polygon::box(4, 4), kHere);
  const Polygon b = Polygon::box(2, 2);
  const std::vector<bool> hits = scene.collides(b, {poseAt(2.5, 0), poseAt(9, 0)}, {}, BodyFilter::allBut(kNoBody), {});
  EXPECT_EQ(hits, (std::vector<bool>{true, false}));
  EXPECT_TRUE(scene.castRay({-9, 0}, {9, 0}, RayOptions{}, BodyFilter(kEveryCategory)));
  EXPECT_FALSE(scene.nearestWithin(b, poseAt(9, 0), 1));
  EXPECT_EQ(scene.anyColliding(b, poseAt(2.5, 0)), body);
  LeastDistanceOptions options;
  options.absolute_error = 1e-9;
  EXPECT_EQ(scene.leastDistance(b, Motion::still(poseAt(4, 0)), options)->least.distance, 1);
}

}  // namespace
}  // namespace tricover
