// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <gtest/gtest.h>

namespace {

TEST(Documentation, Distance) {
  //! [distance]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const tricover::Polygon wedge({{{0, 0}, {3, -1}, {3, 1}}});
  tricover::Pose pose = tricover::Pose::Identity();
  pose.translation() << 7, 2;
  const tricover::DistanceResult nearest = tricover::distance(square, tricover::Pose::Identity(), wedge, pose);
  EXPECT_EQ(nearest.distance, 3);
  EXPECT_EQ(nearest.point_a, tricover::Vec2(4, 2));
  EXPECT_EQ(nearest.point_b, tricover::Vec2(7, 2));
  //! [distance]
}

TEST(Documentation, DistanceWithin) {
  //! [distance within]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  tricover::Pose pose = tricover::Pose::Identity();
  tricover::PairCache cache;  // one a pair, if it moves step by step
  pose.translation() << 6, 1;
  const auto near = tricover::distanceWithin(square, tricover::Pose::Identity(), square, pose, 3, cache);
  EXPECT_EQ(near->distance, 2);
  pose.translation() << 8, 1;
  EXPECT_FALSE(tricover::distanceWithin(square, tricover::Pose::Identity(), square, pose, 3, cache));
  //! [distance within]
}

TEST(Documentation, DistanceWithCache) {
  //! [distance with cache]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  tricover::Pose pose = tricover::Pose::Identity();
  tricover::PairCache cache;  // one a pair
  for (double x = 12; x > 4; x -= 0.25) {
    pose.translation() << x, 1;
    EXPECT_EQ(tricover::distance(square, tricover::Pose::Identity(), square, pose, cache).distance, x - 4);
  }
  //! [distance with cache]
}

}  // namespace
