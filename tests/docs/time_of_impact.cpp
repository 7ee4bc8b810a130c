// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/time_of_impact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tricover/conflicts.h"
#include "tricover/least_distance.h"
#include "tricover/polygon.h"

namespace {

TEST(Documentation, TimeOfImpact) {
  //! [time of impact]
  const tricover::Polygon wall({{{0, -5}, {0.001, -5}, {0.001, 5}, {0, 5}}});
  const tricover::Polygon square({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  tricover::Pose start = tricover::Pose::Identity();
  start.translation() << -100, 0;
  const tricover::Motion still = tricover::Motion::still(tricover::Pose::Identity());

  // However fast and thin: nothing tunnels.
  const tricover::Motion fast = tricover::Motion::translation(start, {1000, 0});
  const std::optional<tricover::Impact> first = tricover::timeOfImpact(wall, still, square, fast);
  ASSERT_TRUE(first.has_value());
  EXPECT_LE(first->time, 0.099);  // never later than the first contact
  EXPECT_GE(first->time, 0.099 - 1e-6);
  EXPECT_NEAR(first->normal.x(), -1, 1e-9);  // from the wall to the square

  const tricover::Motion aside = tricover::Motion::translation(start, {0, 1000});
  EXPECT_FALSE(tricover::timeOfImpact(wall, still, square, aside).has_value());
  //! [time of impact]
}

TEST(Documentation, Conflicts) {
  //! [conflicts]
  const tricover::Polygon walls({{{0, -5}, {1, -5}, {1, 5}, {0, 5}}, {{5, -5}, {6, -5}, {6, 5}, {5, 5}}});
  const tricover::Polygon square({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  tricover::Pose start = tricover::Pose::Identity();
  const tricover::Motion still = tricover::Motion::still(start);
  start.translation() << -10, 0;
  const tricover::Motion through = tricover::Motion::translation(start, {20, 0});

  const std::vector<tricover::Conflict> all = tricover::conflicts(walls, still, square, through);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NEAR(all[0].impact.time, 0.45, 1e-5);  // into the first wall,
  EXPECT_NEAR(all[0].end, 0.6, 1e-5);           // out of it,
  EXPECT_NEAR(all[1].impact.time, 0.7, 1e-5);   // and again

  start.translation() << 0, 0;  // in the first wall: what is met there counts once it has parted
  const tricover::Motion leaves = tricover::Motion::translation(start, {20, 0});
  tricover::ImpactOptions later;
  later.ignore_initial = true;
  EXPECT_EQ(tricover::timeOfImpact(walls, still, square, leaves)->time, 0);
  EXPECT_NEAR(tricover::timeOfImpact(walls, still, square, leaves, later)->time, 0.2, 1e-5);
  //! [conflicts]
}

TEST(Documentation, LeastDistance) {
  //! [least distance]
  // A robot passes a corner of a shelf.
  const tricover::Polygon robot = tricover::Polygon::box(1, 1), shelf = tricover::Polygon::box(2, 2);
  const tricover::LeastDistance least =
      tricover::leastDistance(shelf, tricover::Motion::still(tricover::poseAt(0, 0)), robot,
                              tricover::Motion::translation(tricover::poseAt(-3, 3), {6, -1}));
  EXPECT_NEAR(least.distance, 4.5 / std::sqrt(37), 2e-6);  // of its lower left corner from the shelf's upper right one
  EXPECT_GE(least.distance, least.lower_bound);
  //! [least distance]
}

TEST(Documentation, ImpactWithAllowedOverlap) {
  //! [allowed overlap]
  // A room with a wall on the right, and a crate that slides along the floor into the wall.
  const tricover::Polygon room(tricover::Ring{{-10, -1}, {10, -1}, {10, 5}, {1.5, 5}, {1.5, 0.5}, {-10, 0.5}});
  const tricover::Polygon crate = tricover::Polygon::box(1, 1);
  const tricover::Motion still = tricover::Motion::still(tricover::Pose::Identity());
  const tricover::Motion slides = tricover::Motion::translation(tricover::poseAt(-2, 1), {4, 0});
  EXPECT_EQ(tricover::timeOfImpact(room, still, crate, slides)->time, 0);  // it touches the floor

  tricover::ImpactOptions allowed;
  allowed.margin = -1e-6;
  EXPECT_NEAR(tricover::timeOfImpact(room, still, crate, slides, allowed)->time, 0.75, 1e-6);
  //! [allowed overlap]
}

}  // namespace
