// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace {

TEST(Documentation, Covering) {
  //! [covering]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  EXPECT_EQ(square.coveringOrigin(), tricover::Vec2(2, 2));
  double area = 0;
  for (const tricover::paper::CoveringTriangle& t : tricover::paper::covering(square)) {
    const tricover::Vec2 v = t.v - t.s, w = t.w - t.s;
    area += (v.x() * w.y() - v.y() * w.x()) / 2;
    EXPECT_EQ(t.sign, 1);
  }
  EXPECT_EQ(area, 16);
  //! [covering]
}

TEST(Documentation, InfluenceArea) {
  //! [influence]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  // Around edge 0, which runs along y = 0.
  EXPECT_TRUE(tricover::paper::inInfluenceArea(square, 0, {2, -0.5}, 1, tricover::paper::InfluenceKind::OneSided));
  EXPECT_FALSE(tricover::paper::inInfluenceArea(square, 0, {2, 0.5}, 1, tricover::paper::InfluenceKind::OneSided));
  EXPECT_TRUE(tricover::paper::inInfluenceArea(square, 0, {2, 0.5}, 1, tricover::paper::InfluenceKind::Extended));
  EXPECT_TRUE(tricover::paper::inInfluenceArea(square, 0, {9, 0.5}, 1, tricover::paper::InfluenceKind::Extended));
  EXPECT_FALSE(tricover::paper::inInfluenceArea(square, 0, {9, 0.5}, 1, tricover::paper::InfluenceKind::Bounded));
  //! [influence]
}

TEST(Documentation, InfluenceMask) {
  //! [influence mask]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  EXPECT_EQ(tricover::paper::influenceMask(square, {2, -0.5}, 1).at(0), 1u);  // near edge 0 alone
  EXPECT_EQ(tricover::paper::influenceMask(square, {8, 8}, 1).at(0), 0u);     // no edge within 1
  //! [influence mask]
}

TEST(Documentation, BoundedInfluenceArea) {
  //! [bounded influence area]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const std::array<tricover::Vec2, 4> corners = tricover::paper::boundedInfluenceArea(square, 0, 1);
  double width = 0, height = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    width = std::max(width, std::abs(corners[i].x() - corners[0].x()));
    height = std::max(height, std::abs(corners[i].y() - corners[0].y()));
  }
  EXPECT_NEAR(width, 6, 1e-9);   // the edge's 4, and 1 beyond either end
  EXPECT_NEAR(height, 2, 1e-9);  // 1 on either side
  //! [bounded influence area]
}

TEST(Documentation, PaperCollide) {
  //! [collide]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  tricover::Pose pose = tricover::Pose::Identity();
  tricover::paper::MaskCache cache;  // one a pair
  int hits = 0;
  for (int step = 0; step < 10; ++step) {
    pose.translation().x() = 10 - step;
    hits += tricover::paper::collide(square, tricover::Pose::Identity(), square, pose, cache);
  }
  EXPECT_EQ(hits, 4);  // at 4, 3, 2 and 1
  EXPECT_TRUE(tricover::paper::collide(square, tricover::Pose::Identity(), square, pose));
  //! [collide]
}

}  // namespace
