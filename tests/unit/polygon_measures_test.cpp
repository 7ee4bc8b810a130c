// SPDX-License-Identifier: BSD-3-Clause
// What a polygon's area, centroid, bounds and convexity are, and polygons made of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "refusal.h"
#include "shapes.h"
#include "tricover/locate.h"
#include "tricover/polygon.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

TEST(PolygonMeasures, AreOfTheRegionWhicheverWayItsRingsRun) {
  const Ring outer = rectangle(0, 0, 10, 10), hole = rectangle(0, 0, 5, 10), island = rectangle(1, 1, 2, 2);
  for (const Ring& out : {outer, reversed(outer)})
    for (const Ring& in : {hole, reversed(hole)}) {
      const Polygon polygon({out, in, island});
      EXPECT_DOUBLE_EQ(polygon.area(), 51);
      EXPECT_NEAR(polygon.centroid().x(), (50 * 7.5 + 1.5) / 51, 1e-13);
    }
}

TEST(PolygonMeasures, FillRulesDifferWhereRingsOverlap) {
  const std::vector<Ring> crossed = {rectangle(0, 0, 4, 4), rectangle(2, 2, 6, 6)};
  EXPECT_DOUBLE_EQ(Polygon(crossed).area(), 24);
  EXPECT_DOUBLE_EQ(Polygon(crossed, FillRule::NonZero).area(), 28);
  const std::vector<Ring> twice = {rectangle(0, 0, 4, 4), rectangle(0, 0, 4, 4)};
  EXPECT_EQ(Polygon(twice).area(), 0);
  EXPECT_DOUBLE_EQ(Polygon(twice, FillRule::NonZero).area(), 16);
  // An hourglass: its signed area is 0.
  const Polygon hourglass({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
  EXPECT_DOUBLE_EQ(hourglass.area(), 2);
  EXPECT_EQ(hourglass.centroid(), Vec2(1, 1));
}

TEST(PolygonMeasures, WithoutAnAreaTheCentroidIsTheMiddle) {
  EXPECT_EQ(point({3, 4}).area(), 0);
  EXPECT_EQ(point({3, 4}).centroid(), Vec2(3, 4));
  EXPECT_EQ(segment({0, 0}, {2, 4}).area(), 0);
  EXPECT_EQ(segment({0, 0}, {2, 4}).centroid(), Vec2(1, 2));
  // Four corners on a line, of which rounding makes an area.
  EXPECT_EQ(Polygon({{{1, -5}, {4, 4}, {5, 7}, {2, -2}}}).centroid(), Vec2(3, 1));
  // There and back along two lines, with other corners on the way back.
  EXPECT_EQ(Polygon({{{0, 0}, {3, 1}, {1, 7}, {1.5, 5.5}, {3, 1}, {1.5, 0.5}}}).centroid(), Vec2(1.5, 3.5));
  // A ring upon itself, of which the even-odd rule leaves nothing, and the non-zero rule leaves all.
  const std::vector<Ring> twice(2, {{0, 0}, {3, 1}, {1, 7}});
  EXPECT_EQ(Polygon(twice).centroid(), Vec2(1.5, 3.5));
  EXPECT_TRUE(Polygon(twice, FillRule::NonZero).centroid().isApprox(Vec2(4, 8) / 3));
  // Many edges upon each other, on two lines, of which all pairs would take minutes.
  Ring on_two_lines;
  for (int i = 0; i < 15000; ++i) on_two_lines.emplace_back((i * 7919) % 15000, 0);
  for (int i = 0; i < 15000; ++i) on_two_lines.emplace_back(0, (i * 7919) % 15000);
  EXPECT_EQ(Polygon({on_two_lines}).centroid(), Vec2(7499.5, 7499.5));
}

TEST(PolygonMeasures, GoToTheEndsOfDoubles) {
  EXPECT_DOUBLE_EQ(Polygon({rectangle(0, 0, 1e150, 1e150)}).area(), 1e300);
  EXPECT_DOUBLE_EQ(Polygon({rectangle(0, 0, 1e-150, 1e-150)}).area(), 1e-300);
  const Polygon largest({rectangle(-kLargest, -kLargest, kLargest, kLargest)});
  EXPECT_EQ(largest.area(), kInfinity);
  EXPECT_EQ(largest.bounds().max(), Vec2(kLargest, kLargest));
  EXPECT_LE(largest.centroid().norm(), 1e-10 * kLargest);
  // Far from the origin.
  const Polygon far({rectangle(1e9, 1e9, 1e9 + 1, 1e9 + 1)});
  EXPECT_EQ(far.area(), 1);
  EXPECT_EQ(far.centroid(), Vec2(1e9 + 0.5, 1e9 + 0.5));
}

TEST(PolygonMeasures, ConvexIsOneRingOnceAround) {
  EXPECT_TRUE(Polygon({regular(7, 1)}).isConvex());
  EXPECT_TRUE(Polygon({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}}}).isConvex());
  EXPECT_FALSE(Polygon({{{0, 0}, {4, 0}, {4, 4}, {3, 1}}}).isConvex());
  EXPECT_FALSE(Polygon({regular(7, 1), regular(7, 0.5)}).isConvex());
  EXPECT_FALSE(point({0, 0}).isConvex());
}

TEST(PolygonMeasures, AreMovedAndScaled) {
  const Polygon polygon({rectangle(1, 2, 3, 4), {{5, 5}, {6, 5}, {5, 6}}}, FillRule::NonZero);
  const Polygon moved = polygon.translated({-1, 10});
  EXPECT_EQ(moved.rings()[1][2], Vec2(4, 16));
  EXPECT_EQ(moved.fillRule(), FillRule::NonZero);
  EXPECT_EQ(polygon.scaled(0.5).rings()[0][2], Vec2(1.5, 2));
  EXPECT_EQ(polygon.scaled(0.5).fillRule(), FillRule::NonZero);
  EXPECT_EQ(refusal([&] { polygon.translated({0, kInfinity}); }), "tricover: by: a coordinate is not finite");
  for (const double factor : {0.0, -1.0, kInfinity, std::nan("")})
    EXPECT_EQ(refusal([&] { polygon.scaled(factor); }), "tricover: factor: it must be finite and positive");
  EXPECT_EQ(refusal([&] { polygon.scaled(kLargest); }),
            "tricover: rings: ring 0, vertex 0: a coordinate is not finite");
}

TEST(PolygonSimplified, KeepsRingsAndWhatIsBeyondTheTolerance) {
  const Polygon frame({{{0, 0}, {5, 0.125}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {4.0625, 4}, {4, 4.0625}}});
  const Polygon simple = frame.simplified(0.125);
  EXPECT_EQ(simple.rings()[0], rectangle(0, 0, 10, 10));
  ASSERT_EQ(simple.rings().size(), 2u);
  EXPECT_EQ(simple.rings()[1], Ring(3, Vec2(4, 4)));
  EXPECT_EQ(frame.simplified(0.1).rings()[0], frame.rings()[0]);
  // Back and forth: within the tolerance of the line, but not of the chord.
  const Polygon spike({{{0, 0}, {9, 0}, {4, 0}, {4, 4}}});
  EXPECT_EQ(spike.simplified(0.5).vertexCount(), 4u);
  for (const double tolerance : {-1.0, kInfinity, std::nan("")})
    EXPECT_EQ(refusal([&] { frame.simplified(tolerance); }), "tricover: tolerance: it must be finite and not negative");
}

TEST(PolygonSimplified, OutwardsPocketsAreFilledAndHolesShrink) {
  const Ring outer = {{0, 0}, {5, 0.125}, {10, 0}, {10, 10}, {0, 10}};
  const Ring hole = {{3, 3}, {5, 2.875}, {7, 3}, {7, 7}, {3, 7}};  // wider by an edge's bend
  const Polygon frame({outer, hole});
  const Polygon cover = frame.simplified(0.125, Simplify::Outwards);
  EXPECT_EQ(cover.rings()[0].size(), 4u);
  ASSERT_EQ(cover.rings().size(), 2u);
  EXPECT_EQ(cover.rings()[1].size(), 4u);
  EXPECT_EQ(cover.area(), 100 - 16);
  EXPECT_EQ(frame.simplified(0.1, Simplify::Outwards).vertexCount(), 10u);
  // What bulges isn't cut off: the edges beside it are lengthened.
  const Polygon chamfered({{{0, 0}, {9, 0}, {9.5, 0.25}, {9.75, 0.5}, {9.75, 9}, {0, 9}}});
  const Polygon box = chamfered.simplified(0.5, Simplify::Outwards);
  EXPECT_EQ(box.vertexCount(), 4u);
  EXPECT_NEAR(box.area(), 9.75 * 9, 1e-12);
  EXPECT_EQ(refusal([&] { frame.simplified(-1, Simplify::Outwards); }),
            "tricover: tolerance: it must be finite and not negative");
}

TEST(PolygonSimplified, OutwardsNothingIsLost) {
  // Of a ring without an area, and of a spike.
  const Polygon bare({{{0, 0}, {4, 1}, {8, 0}, {4, 1}}});
  EXPECT_EQ(bare.simplified(2, Simplify::Outwards).rings(), bare.rings());
  const Polygon spike({{{0, 0}, {4, 0}, {4, 4}, {5, 4}, {4, 4}, {0, 4}}});
  EXPECT_EQ(locate(spike.simplified(3, Simplify::Outwards), {5, 4}), Location::Boundary);
  // A slot narrower than the tolerance: filled from both sides, it would be empty again by the even-odd rule.
  const Polygon slot({{{0, 0}, {4, 0}, {4, 4}, {2.125, 4}, {2.0625, 1}, {1.875, 4}, {0, 4}}});
  const Polygon full = slot.simplified(0.25, Simplify::Outwards);
  for (const Vec2& p : {Vec2(2, 0.5), Vec2(1, 4), Vec2(2.5, 4), Vec2(2, 1)})
    EXPECT_NE(locate(full, p), Location::Outside);
  // A ring's pocket that lies in another ring: to fill it changes what both cover.
  const std::vector<Ring> crossing = {rectangle(0, 0, 10, 10), {{8, 2}, {14, 2}, {14, 8}, {8, 8}, {8.5, 5}}};
  for (const FillRule fill : {FillRule::EvenOdd, FillRule::NonZero}) {
    const Polygon cover = Polygon(crossing, fill).simplified(1, Simplify::Outwards);
    for (const Vec2& p : {Vec2(8.25, 5), Vec2(12, 5), Vec2(1, 1)})
      EXPECT_TRUE(locate(Polygon(crossing, fill), p) == Location::Outside || locate(cover, p) != Location::Outside);
  }
}

TEST(PolygonSimplified, OutwardsDiscsTakeFewCorners) {
  const Polygon disc({regular(1000, 1)});
  const Polygon cover = disc.simplified(0.01, Simplify::Outwards);
  EXPECT_LE(cover.vertexCount(), 40u);  // the tolerance's ring holds a polygon of 23
  EXPECT_LE(cover.radius(), 1.01 + 1e-12);
  // A straight chain of any length is one edge first.
  Ring wall;
  for (int i = 0; i < 10000; ++i) wall.emplace_back(i, 0);
  wall.insert(wall.end(), {{1e4, 1}, {0, 1}});
  EXPECT_EQ(Polygon({wall}).simplified(0.5, Simplify::Outwards).vertexCount(), 4u);
}

}  // namespace
}  // namespace tricover::support
