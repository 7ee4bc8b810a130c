// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/depth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tricover/covers.h"
#include "tricover/segment.h"

namespace {

const tricover::Pose still = tricover::Pose::Identity();

TEST(Documentation, Depth) {
  //! [depth]
  const tricover::Polygon room = tricover::box(10, 10).complement(), crate = tricover::box(2, 2);
  const tricover::Pose in_corner = tricover::pose(-4.01, -4.01);
  const tricover::Depth found = tricover::depth(room, still, crate, in_corner);
  EXPECT_NEAR(found.depth, 0.01 * std::sqrt(2), 1e-14);
  EXPECT_FALSE(found.is_point_of_a);
  EXPECT_NEAR(found.point_b.x(), -5.01, 1e-14);
  EXPECT_NEAR(found.point_b.y(), -5.01, 1e-14);

  const tricover::Polygon bar = tricover::box(8, 0.5);
  EXPECT_NEAR(tricover::depth(bar, still, bar, tricover::pose(0, 0, M_PI / 2)).depth, 0.25, 1e-14);
  EXPECT_EQ(tricover::depth(bar, still, bar, tricover::pose(0, 0.5)).depth, 0);
  //! [depth]
}

TEST(Documentation, Excess) {
  //! [excess]
  const tricover::Polygon sheet = tricover::box(10, 10), part = tricover::box(2, 2);
  EXPECT_FALSE(tricover::covers(sheet, still, part, tricover::pose(4.25, 0)));
  const tricover::Excess found = tricover::excess(part, tricover::pose(4.25, 0), sheet, still);
  EXPECT_NEAR(found.distance, 0.25, 1e-14);
  EXPECT_NEAR(found.point.x(), 5.25, 1e-14);
  EXPECT_NEAR(found.nearest.x(), 5, 1e-14);
  EXPECT_EQ(tricover::excess(part, tricover::pose(4, 0), sheet, still).distance, 0);
  //! [excess]
}

TEST(Documentation, HausdorffDistance) {
  //! [hausdorff distance]
  const tricover::Polygon square = tricover::box(2, 2), large = tricover::box(6, 6);
  EXPECT_EQ(tricover::excess(square, still, large, still).distance, 0);
  EXPECT_NEAR(tricover::hausdorffDistance(square, still, large, still), std::sqrt(8), 1e-14);
  //! [hausdorff distance]
}

}  // namespace
