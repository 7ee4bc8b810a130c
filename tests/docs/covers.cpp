// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/covers.h"

#include <gtest/gtest.h>

#include "tricover/polygon.h"
#include "tricover/scene.h"

namespace {

TEST(Documentation, Covers) {
  //! [covers]
  const tricover::Polygon lot = tricover::Polygon::box(10, 6), car = tricover::Polygon::box(4, 2);
  const tricover::Pose here = tricover::Pose::Identity();
  EXPECT_TRUE(tricover::covers(lot, here, car, tricover::poseAt(3, 2, 0)));  // in the corner, along both borders
  EXPECT_FALSE(tricover::covers(lot, here, car, tricover::poseAt(3, 2, 0.01)));
  EXPECT_TRUE(tricover::covers(lot, here, car, tricover::poseAt(2.5, 1.5, 0), {0.5}));  // half a metre to both borders
  //! [covers]
}

TEST(Documentation, SceneCovers) {
  //! [scene covers]
  tricover::Scene lanes;
  lanes.add(tricover::Polygon::box(100, 3), tricover::poseAt(0, 0, 0));
  lanes.add(tricover::Polygon::box(60, 3), tricover::poseAt(20, 3, 0));  // beside it, from x = -10 on
  const tricover::Polygon car = tricover::Polygon::box(4, 2);
  EXPECT_TRUE(lanes.covers(car, tricover::poseAt(5, 1.5, 0.3), {0.2}));  // it changes lanes
  EXPECT_FALSE(lanes.covers(car, tricover::poseAt(-12, 1.5, 0.3)));
  //! [scene covers]
}

TEST(Documentation, FirstExit) {
  //! [first exit]
  tricover::Scene lanes;
  lanes.add(tricover::Polygon::box(100, 3), tricover::poseAt(0, 0));
  const tricover::Polygon car = tricover::Polygon::box(4, 2);
  // From (40, 0) ten metres ahead: its front leaves the lane after eight.
  const auto exit = lanes.firstExit(car, tricover::Motion::translation(tricover::poseAt(40, 0), {10, 0}));
  ASSERT_TRUE(exit);
  EXPECT_NEAR(exit->time, 0.8, 1e-9);
  EXPECT_NEAR(exit->point.x(), 50, 1e-6);
  //! [first exit]
}

}  // namespace
