// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

TEST(Documentation, Motion) {
  //! [motion]
  tricover::Pose start = tricover::Pose::Identity(), end = start;
  end.linear() << 0, -1, 1, 0;
  end.translation() << 10, 0;

  const tricover::Motion slide = tricover::Motion::translation(start, {10, 0});
  EXPECT_TRUE(slide.at(0.5).translation().isApprox(tricover::Vec2(5, 0)));

  // From pose to pose: the pivot, here the polygon's point (1, 0), runs straight while the polygon turns about it.
  const tricover::Motion turn = tricover::Motion::between(start, end, {1, 0});
  EXPECT_TRUE(turn.at(1).isApprox(end, 1e-12));
  EXPECT_TRUE((turn.at(0.5) * tricover::Vec2(1, 0)).isApprox(tricover::Vec2(5.5, 0.5)));

  // A quarter of a circle around a pillar at (10, 0).
  const tricover::Motion bend = tricover::Motion::arc(start, {10, 0}, M_PI / 2);
  EXPECT_TRUE(bend.at(1).isApprox(tricover::poseAt(10, -10, M_PI / 2), 1e-12));

  // A cubic spline: from rest at the origin to (10, 0) and a quarter turn, arriving at a velocity.
  const tricover::Motion swing =
      tricover::Motion::spline({{0, 0}, 0, {0, 0}, 0}, {{10, 0}, 1.5707963267948966, {0, 6}, 0});
  EXPECT_TRUE(swing.at(1).isApprox(end, 1e-12));
  EXPECT_TRUE(swing.part(0.5, 1).at(0.5).isApprox(swing.at(0.75), 1e-12));  // its second half
  //! [motion]
}

TEST(Documentation, CheckMotion) {
  //! [check motion]
  tricover::Motion motion = tricover::Motion::still(tricover::Pose::Identity());
  tricover::checkMotion(motion);
  motion.angle = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(tricover::checkMotion(motion), std::invalid_argument);
  //! [check motion]
}

}  // namespace
