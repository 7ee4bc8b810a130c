// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <gtest/gtest.h>

#include "tricover/polygon.h"

namespace {

TEST(Documentation, Collide) {
  //! [collide]
  const tricover::Polygon room({{{0, 0}, {9, 0}, {9, 7}, {0, 7}}, {{1, 1}, {8, 1}, {8, 6}, {1, 6}}});  // ring in ring
  const tricover::Polygon robot({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});                   // an L
  const tricover::Pose still = tricover::Pose::Identity();
  tricover::Pose pose = still;
  pose.translation() << 5, 3;
  EXPECT_FALSE(tricover::collide(room, still, robot, pose));
  EXPECT_TRUE(tricover::collide(room, still, robot, pose, {/*margin*/ 1}));  // the wall is 1 away

  pose.translation() << 6, 3;
  EXPECT_TRUE(tricover::collide(room, still, robot, pose));  // touching is colliding
  //! [collide]
}

TEST(Documentation, CollideWithCache) {
  //! [collide with cache]
  const tricover::Polygon room({{{0, 0}, {9, 0}, {9, 7}, {0, 7}}, {{1, 1}, {8, 1}, {8, 6}, {1, 6}}});
  const tricover::Polygon robot({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  const tricover::Pose still = tricover::Pose::Identity();
  tricover::Pose pose = still;
  tricover::PairCache cache;  // one a pair
  double x = 2;
  for (;; x += 0.125) {
    pose.translation() << x, 3;
    if (tricover::collide(room, still, robot, pose, cache)) break;
  }
  EXPECT_EQ(x, 6);
  //! [collide with cache]
}

TEST(Documentation, Touching) {
  //! [touching]
  const tricover::Polygon plate({{{0, 0}, {9, 0}, {9, 5}, {0, 5}}, {{3, 2}, {6, 2}, {6, 3}, {3, 3}}});  // with a slot
  const tricover::Polygon peg({{{3, 2}, {6, 2}, {6, 3}, {3, 3}}});                                      // that fits
  const tricover::Pose here = tricover::Pose::Identity();
  tricover::CollideOptions parts;
  parts.touching = tricover::Touching::Allowed;
  EXPECT_TRUE(tricover::collide(plate, here, peg, here));
  EXPECT_FALSE(tricover::collide(plate, here, peg, here, parts));  // they share edges, and nothing inside

  tricover::Pose pose = here;
  pose.translation().x() = 1e-300;  // adds up to nothing in doubles, but poses are taken as they are
  EXPECT_TRUE(tricover::collide(plate, here, peg, pose, parts));
  //! [touching]
}

TEST(Documentation, AllowedOverlap) {
  //! [allowed overlap]
  const tricover::Polygon floor = tricover::Polygon::box(20, 1), crate = tricover::Polygon::box(1, 1);
  tricover::CollideOptions allowed;
  allowed.margin = -1e-6;
  const tricover::Pose here = tricover::Pose::Identity(), rests = tricover::poseAt(3, 1 - 1e-9);
  EXPECT_TRUE(tricover::collide(floor, here, crate, rests));
  EXPECT_FALSE(tricover::collide(floor, here, crate, rests, allowed));
  EXPECT_TRUE(tricover::collide(floor, here, crate, tricover::poseAt(3, 0.9), allowed));
  //! [allowed overlap]
}

}  // namespace
