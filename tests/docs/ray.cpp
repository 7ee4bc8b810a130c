// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/ray.h"

#include <gtest/gtest.h>

namespace {

TEST(Documentation, Ray) {
  //! [ray]
  const tricover::Polygon wall({{{0, 0}, {4, 0}, {4, 1}, {0, 1}}});
  tricover::Pose pose = tricover::Pose::Identity();
  pose.translation() << 10, 0;
  const std::optional<tricover::RayHit> hit = tricover::castRay(wall, pose, {6, 0.5}, {14, 0.5});
  EXPECT_EQ(hit->fraction, 0.5);
  EXPECT_EQ(hit->point, tricover::Vec2(10, 0.5));
  EXPECT_EQ(hit->normal, tricover::Vec2(-1, 0));
  EXPECT_EQ(hit->edge, 3);
  EXPECT_TRUE(tricover::castRay(wall, pose, {6, 1}, {14, 1}));  // along the upper edge
  EXPECT_FALSE(tricover::castRay(wall, pose, {6, 0.5}, {9, 0.5}));
  EXPECT_EQ(tricover::castRay(wall, pose, {12, 0.5}, {20, 9})->fraction, 0);                     // starts inside
  EXPECT_NEAR(tricover::castRay(wall, pose, {6, 0.5}, {14, 0.5}, {0.8})->fraction, 0.4, 1e-13);  // a margin
  //! [ray]
}

TEST(Documentation, RayAll) {
  //! [all]
  const tricover::Polygon frame({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});  // with a hole
  const tricover::Pose pose = tricover::Pose::Identity();
  const std::vector<tricover::RayInterval> parts = tricover::castRayAll(frame, pose, {-4, 2}, {4, 2});
  EXPECT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].begin.point, tricover::Vec2(0, 2));
  EXPECT_EQ(parts[0].end.point, tricover::Vec2(1, 2));
  EXPECT_EQ(parts[0].end.edge, 7);                                                     // the hole's left edge
  EXPECT_EQ(parts[1].end.edge, -1);                                                    // ends in the region
  EXPECT_EQ(tricover::castRayAll(frame, pose, {-1, 3}, {1, 5})[0].end.fraction, 0.5);  // grazes a corner
  //! [all]
}

}  // namespace
