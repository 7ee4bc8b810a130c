// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"

namespace {

TEST(Documentation, Point) {
  //! [point]
  // A round robot of radius 0.5 beside a wall. Turning doesn't matter to it.
  const tricover::Polygon robot = tricover::Polygon::point({0, 0});
  const tricover::Polygon wall({{{0, 0}, {4, 0}, {4, 1}, {0, 1}}});
  tricover::Pose pose = tricover::Pose::Identity();
  pose.translation() << 2, 1.5;
  tricover::CollideOptions options;
  options.margin = 0.5;
  EXPECT_TRUE(tricover::collide(wall, tricover::Pose::Identity(), robot, pose, options));  // they touch

  // Of two discs the margin is the sum of their radii.
  tricover::Pose other = tricover::Pose::Identity();
  other.translation() << 5, 1.5;
  tricover::DistanceOptions discs;
  discs.margin = 0.5 + 0.5;
  EXPECT_EQ(tricover::distance(robot, pose, robot, other, discs).distance, 2);
  //! [point]
}

TEST(Documentation, Segment) {
  //! [segment]
  // A stadium, 4 long and 2 wide, above a post.
  const tricover::Polygon cart = tricover::Polygon::segment({-1, 0}, {1, 0});
  const tricover::Polygon post = tricover::Polygon::point({1, 4});
  tricover::DistanceOptions options;
  options.margin = 1;
  const tricover::DistanceResult gap =
      tricover::distance(cart, tricover::Pose::Identity(), post, tricover::Pose::Identity(), options);
  EXPECT_EQ(gap.distance, 3);
  EXPECT_EQ(gap.point_a, tricover::Vec2(1, 0));  // on the segment: whose the margin is isn't known
  //! [segment]
}

TEST(Documentation, Box) {
  //! [box]
  const tricover::Polygon pallet = tricover::Polygon::box(1.2, 0.8);
  EXPECT_EQ(pallet.bounds().min(), tricover::Vec2(-0.6, -0.4));
  EXPECT_TRUE(tricover::collide(pallet, tricover::poseAt(0, 0), pallet, tricover::poseAt(1.2, 0)));  // side by side
  //! [box]
}

}  // namespace
