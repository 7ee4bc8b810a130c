// SPDX-License-Identifier: BSD-3-Clause
// The guarantee of the influence areas (every point within n of the edge is held), by exact distances at every size,
// and that the areas are not vacuous.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact_reference.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/paper.h"

namespace tricover::support {
namespace {

struct Sample {
  Polygon polygon;
  Vec2 point;
  double length;
};

/// A point near a polygon's first edge, on a scale from the smallest doubles to the largest, the edge's length and the
/// influence length being of unlike sizes; the length is often the point's distance to within an ulp.
Sample sample(Random& random, double size) {
  const double angle = random.real(0, 6.3), stretch = std::pow(10, random.integer(-3, 0));
  const Vec2 v = size * Vec2(random.real(-1, 1), random.real(-1, 1));
  const Vec2 u = random.oneIn(4) ? Vec2(random.integer(-1, 1) * size, random.integer(-1, 1) * size)
                                 : Vec2(size * stretch * std::cos(angle), size * stretch * std::sin(angle));
  const Vec2 w = v + u;
  const Vec2 across(-std::sin(angle), std::cos(angle));
  const Vec2 point = v + random.real(-0.5, 1.5) * u + size * random.real(-1, 1) * across;
  const double distance = exact::distanceBelow(exact::distanceSquared(point, v, w));
  const double length = random.coin() ? nudged(distance, random.integer(0, 2)) : distance * random.real(0.05, 3);
  return {Polygon({{v, w, size * Vec2(random.real(-1, 1), random.real(-1, 1))}}), point, length};
}

class InfluenceArea : public testing::TestWithParam<double> {};

TEST_P(InfluenceArea, HoldsEveryPointWithinItsLengthAndFewBeyond) {
  Random random(5);
  int within = 0, far = 0, bounded_far = 0, extended_far = 0, off_line = 0;
  const int samples = scaledCount(3000);
  for (int i = 0; i < samples; ++i) {
    const Sample s = sample(random, GetParam());
    const std::vector<std::uint64_t> mask = paper::influenceMask(s.polygon, s.point, s.length);
    for (EdgeIndex edge = 0; edge < 3; ++edge) {
      const Vec2 v = s.polygon.edgeStart(edge), w = s.polygon.edgeEnd(edge);
      const mpq_class squared = exact::distanceSquared(s.point, v, w);
      const bool extended = paper::inInfluenceArea(s.polygon, edge, s.point, s.length, paper::InfluenceKind::Extended);
      const bool bounded = paper::inInfluenceArea(s.polygon, edge, s.point, s.length, paper::InfluenceKind::Bounded);
      EXPECT_EQ(bounded, (mask[0] >> edge & 1) != 0);
      EXPECT_TRUE(extended || !bounded);
      if (exact::within(squared, mpq_class(s.length))) {
        ++within;
        EXPECT_TRUE(extended && bounded) << "edge " << edge << " size " << GetParam();
      } else if (!exact::within(squared, mpq_class(s.length) * mpq_class(2.25) + mpq_class(5e-322))) {
        // The bounded area's corners lie within (1 + sqrt 2) n sqrt 2 of the edge, most of it within 1.5 n.
        ++far;
        bounded_far += bounded;
        const mpq_class area = (mpq_class(w.x()) - v.x()) * (mpq_class(s.point.y()) - v.y()) -
                               (mpq_class(w.y()) - v.y()) * (mpq_class(s.point.x()) - v.x());
        const mpq_class side_squared = exact::distanceSquared(v, w, w), reach = mpq_class(s.length) * mpq_class(1.001);
        if (area * area > reach * reach * side_squared * 4) ++off_line, extended_far += extended;
      }
    }
  }
  EXPECT_GE(within, samples / 4);
  EXPECT_GE(far, samples / 4);
  EXPECT_LE(bounded_far, far / 10);
  EXPECT_GE(off_line, samples / 8);
  EXPECT_LE(extended_far, off_line / 100);
}

INSTANTIATE_TEST_SUITE_P(Sizes, InfluenceArea,
                         testing::Values(1.0, 1e-3, 1e12, 1e-150, 1e150, 1e-300, 1e300, 0x1p-1060, 4e307));

TEST(InfluenceMask, HasABitAnEdgeThroughTheRings) {
  std::vector<Ring> rings;
  for (int i = 0; i < 30; ++i) rings.push_back(rectangle(10 * i, 0, 10 * i + 4, 4));
  const Polygon polygon(rings);
  for (int i = 0; i < 30; ++i) {
    const std::vector<std::uint64_t> mask = paper::influenceMask(polygon, Vec2(10 * i + 2, -0.5), 1);
    ASSERT_EQ(mask.size(), 2u);
    for (std::size_t edge = 0; edge < 120; ++edge) {
      const bool held = mask[edge / 64] >> edge % 64 & 1;
      EXPECT_EQ(held, edge == static_cast<std::size_t>(4 * i)) << i << " " << edge;
    }
  }
}

TEST(InfluenceArea, CornersDrawnAreThoseOfTheAreaDecided) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Polygon polygon({star(random, 5, 1, 3)});
    const double length = random.real(0.1, 1);
    const std::array<Vec2, 4> corners = paper::boundedInfluenceArea(polygon, 2, length);
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : corners) middle += 0.25 * corner;
    for (const Vec2& corner : corners) {
      const Vec2 inner = middle + 0.999 * (corner - middle), outer = middle + 1.001 * (corner - middle);
      EXPECT_TRUE(paper::inInfluenceArea(polygon, 2, inner, length, paper::InfluenceKind::Bounded));
      EXPECT_FALSE(paper::inInfluenceArea(polygon, 2, outer, length, paper::InfluenceKind::Bounded));
    }
  }
}

/// A strip of half-width 1 around the line of slope 3 / 4 is 1.25 high on either side.
TEST(InfluenceArea, IsDrawnAsWideAsItIs) {
  const Polygon polygon({{{0, 0}, {4, 3}, {0, 4}}});
  const std::array<Vec2, 4> corners = paper::boundedInfluenceArea(polygon, 0, 1);
  EXPECT_EQ(corners[0], Vec2(-1, -2));
  EXPECT_EQ(corners[1], Vec2(5, 2.5));
  EXPECT_EQ(corners[2], Vec2(5, 5));
  EXPECT_EQ(corners[3], Vec2(-1, 0.5));
}

TEST(InfluenceArea, OfAnEdgeWithoutLengthIsALevelStrip) {
  const Polygon polygon({{{1, 1}, {1, 1}, {4, 3}}});
  EXPECT_TRUE(paper::inInfluenceArea(polygon, 0, {9, 2}, 1, paper::InfluenceKind::Extended));
  EXPECT_FALSE(paper::inInfluenceArea(polygon, 0, {1, 3}, 1, paper::InfluenceKind::Extended));
  EXPECT_FALSE(paper::inInfluenceArea(polygon, 0, {9, 2}, 1, paper::InfluenceKind::Bounded));
}

}  // namespace
}  // namespace tricover::support
