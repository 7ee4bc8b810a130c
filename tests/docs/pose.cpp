// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tricover/collide.h"

namespace {

TEST(Documentation, Pose) {
  //! [pose]
  // A quarter turn counter-clockwise, then a shift.
  tricover::Pose pose = tricover::Pose::Identity();
  pose.linear() << 0, -1, 1, 0;
  pose.translation() << 5, 0;
  EXPECT_EQ(pose * tricover::Vec2(1, 0), tricover::Vec2(5, 1));
  tricover::checkPose(pose);

  pose.linear() *= 2;  // a scale is no rigid motion
  EXPECT_THROW(tricover::checkPose(pose), std::invalid_argument);

  const tricover::Pose robot = tricover::poseAt(2, 3, 0.5);  // at (2, 3), heading half a radian left of x
  EXPECT_EQ(robot.translation(), tricover::Vec2(2, 3));
  EXPECT_EQ(tricover::poseAt(5, 0, M_PI / 2) * tricover::Vec2(1, 0), tricover::Vec2(5, 1));  // no rounding
  //! [pose]
}

TEST(Documentation, NearestRigid) {
  //! [nearest]
  // A robot that adds up its turns in floats: after ten thousand of them its pose has grown.
  Eigen::Isometry2f odometry = Eigen::Isometry2f::Identity();
  for (int i = 0; i < 10000; ++i) odometry.rotate(0.01f);
  const tricover::Pose drifted(odometry.cast<double>());
  EXPECT_THROW(tricover::checkPose(drifted), std::invalid_argument);
  tricover::checkPose(tricover::nearestRigid(drifted));
  //! [nearest]
}

}  // namespace
