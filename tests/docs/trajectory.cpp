// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/trajectory.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

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
  //! [trajectory]
}

}  // namespace
