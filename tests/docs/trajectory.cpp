// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tricover/conflicts.h"
#include "tricover/least_distance.h"

namespace {

TEST(Documentation, Trajectory) {
  //! [trajectory]
  const tricover::Polygon robot({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  const auto at = [](double x, double y) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation() << x, y;
    return pose;
  };
  // Seconds: one robot waits on the crossing from 10 to 20, the other one passes there, and comes back.
  const auto waits = tricover::Trajectory::through({{0, at(-10, 0)}, {10, at(0, 0)}, {20, at(0, 0)}, {30, at(10, 0)}});
  const auto passes = tricover::Trajectory::through({{6, at(0, -10)}, {16, at(0, 10)}, {26, at(0, -10)}});
  const std::optional<tricover::Impact> first = tricover::timeOfImpact(robot, waits, robot, passes);
  ASSERT_TRUE(first.has_value());
  EXPECT_NEAR(first->time, 10, 1e-5);
  const std::vector<tricover::Conflict> all = tricover::conflicts(robot, waits, robot, passes);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NEAR(all[0].end, 12, 1e-5);
  EXPECT_NEAR(all[1].impact.time, 20, 1e-5);
  EXPECT_EQ(waits.at(15).translation(), tricover::Vec2(0, 0));

  // By knots of a spline, with rates a second, and by motions of one's own.
  const auto bends = tricover::Trajectory::spline({{0, {{0, 0}, 0, {1, 0}, 0}}, {8, {{5, 3}, 1.5, {0, 1}, 0}}});
  std::vector<tricover::Leg> legs = bends.legs();
  legs.push_back({8, 10, tricover::Motion::translation(bends.at(8), {0, 2})});  // on at a metre a second
  const tricover::Trajectory longer(legs);
  EXPECT_EQ(longer.end(), 10);
  EXPECT_TRUE(longer.part(9, 10).at(1).isApprox(longer.at(10)));
  //! [trajectory]
}

TEST(Documentation, TrajectoryThatAppears) {
  //! [appears]
  // A robot comes out of a lift after 10 s, and parks; another one leaves by the lift at 20 s; a shelf always rests.
  const tricover::Polygon robot = tricover::Polygon::box(1, 1);
  const auto comes = tricover::Trajectory::through({{10, tricover::poseAt(0, 0)}, {14, tricover::poseAt(4, 0)}});
  const auto leaves = tricover::Trajectory::through({{0, tricover::poseAt(9, 0)}, {9, tricover::poseAt(0, 0)}});
  EXPECT_EQ(tricover::conflicts(robot, comes, robot, leaves).size(), 1u);
  EXPECT_TRUE(tricover::conflicts(robot, comes.appearing(), robot, leaves.vanishing()).empty());
  EXPECT_EQ(tricover::leastDistance(robot, tricover::poseAt(4, 3), robot, comes.appearing()).distance, 2);
  //! [appears]
}

TEST(Documentation, TrajectoryOfWaypoints) {
  //! [waypoints]
  // It turns round by the left, once and a half.
  const auto turns = tricover::Trajectory::through({{0, {0, 0}, 0}, {6, {0, 0}, 3 * M_PI}});
  EXPECT_NEAR(turns.legs()[0].motion.angle, 3 * M_PI, 1e-15);
  EXPECT_EQ(turns.at(6) * tricover::Vec2(1, 0), tricover::Vec2(-1, 0));
  //! [waypoints]
}

}  // namespace
