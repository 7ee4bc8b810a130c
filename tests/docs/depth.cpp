// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "tricover/covers.h"
#include "tricover/polygon.h"
#include "tricover/svg.h"

namespace {

const tricover::Pose still = tricover::Pose::Identity();

TEST(Documentation, Depth) {
  //! [depth]
  const tricover::Polygon room = tricover::Polygon::box(10, 10).complement(), crate = tricover::Polygon::box(2, 2);
  const tricover::Pose in_corner = tricover::poseAt(-4.01, -4.01);
  const tricover::Depth found = tricover::depth(room, still, crate, in_corner);
  EXPECT_NEAR(found.depth, 0.01 * std::sqrt(2), 1e-14);
  EXPECT_FALSE(found.is_point_of_a);
  EXPECT_NEAR(found.point_b.x(), -5.01, 1e-14);
  EXPECT_NEAR(found.point_b.y(), -5.01, 1e-14);

  const tricover::Polygon bar = tricover::Polygon::box(8, 0.5);
  EXPECT_NEAR(tricover::depth(bar, still, bar, tricover::poseAt(0, 0, M_PI / 2)).depth, 0.25, 1e-14);
  EXPECT_EQ(tricover::depth(bar, still, bar, tricover::poseAt(0, 0.5)).depth, 0);
  //! [depth]
}

/// Three pairs beside each other, with the deepest point of each and the point nearest to it outside.
std::string pictureOfDepths() {
  tricover::SvgDrawing drawing(720);
  const auto draw = [&](const tricover::Polygon& a, const tricover::Polygon& b, const tricover::Pose& pose_a,
                        const tricover::Pose& pose_b, const tricover::Depth& found, const std::string& text) {
    drawing.polygon(a, pose_a, "#d6d3d1");
    drawing.polygon(b, pose_b, "rgba(147,197,253,0.6)");
    const auto shown = [](const tricover::Vec2& p) {
      return tricover::Vec2(0 + std::round(p.x() * 1e9) / 1e9, 0 + std::round(p.y() * 1e9) / 1e9);
    };
    drawing.polyline({shown(found.point_a), shown(found.point_b)}, "#dc2626");
    drawing.text(pose_a.translation() - tricover::Vec2(0, 2.5), text);
  };
  drawing.polyline({{0, -2.8}, {0, -2.8}}, "none");  // room for the texts
  const tricover::Polygon corner({{{-2, -2}, {2, -2}, {2, -1}, {-1, -1}, {-1, 2}, {-2, 2}}});
  const tricover::Polygon area = tricover::Polygon::box(9, 9).complement(), crate = tricover::Polygon::box(2, 2);
  const tricover::Pose in_corner = tricover::poseAt(-0.2, -0.2), lot = tricover::poseAt(3.5, 3.5);
  draw(corner, crate, still, in_corner, tricover::depth(area, lot, crate, in_corner), "0.28");
  const tricover::Polygon bar = tricover::Polygon::box(4, 1), wall = tricover::Polygon::box(4, 0.2),
                          robot = tricover::Polygon::box(2, 2);
  const tricover::Pose second = tricover::poseAt(5.5, 0), across = tricover::poseAt(5.5, 0, M_PI / 2);
  draw(bar, bar, second, across, tricover::depth(bar, second, bar, across), "0.50");
  const tricover::Pose third = tricover::poseAt(11, 0);
  draw(robot, wall, third, third, tricover::depth(robot, third, wall, third), "1.00");
  return drawing.str();
}

TEST(Documentation, PictureOfDepths) {
  std::ifstream file(TRICOVER_DOCS_DIR "/depth.svg");
  const std::string shown{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(shown, pictureOfDepths());
}

TEST(Documentation, Excess) {
  //! [excess]
  const tricover::Polygon sheet = tricover::Polygon::box(10, 10), part = tricover::Polygon::box(2, 2);
  EXPECT_FALSE(tricover::covers(sheet, still, part, tricover::poseAt(4.25, 0)));
  const tricover::Excess found = tricover::excess(part, tricover::poseAt(4.25, 0), sheet, still);
  EXPECT_NEAR(found.distance, 0.25, 1e-14);
  EXPECT_NEAR(found.point.x(), 5.25, 1e-14);
  EXPECT_NEAR(found.nearest.x(), 5, 1e-14);
  EXPECT_EQ(tricover::excess(part, tricover::poseAt(4, 0), sheet, still).distance, 0);
  //! [excess]
}

TEST(Documentation, HausdorffDistance) {
  //! [hausdorff distance]
  const tricover::Polygon square = tricover::Polygon::box(2, 2), large = tricover::Polygon::box(6, 6);
  EXPECT_EQ(tricover::excess(square, still, large, still).distance, 0);
  EXPECT_NEAR(tricover::hausdorffDistance(square, still, large, still), std::sqrt(8), 1e-14);
  //! [hausdorff distance]
}

}  // namespace
