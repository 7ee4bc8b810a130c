// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/pose.h"

#include <gtest/gtest.h>

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
  //! [pose]
}

}  // namespace
