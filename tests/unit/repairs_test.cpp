// SPDX-License-Identifier: BSD-3-Clause
// The seven places where the paper as printed goes wrong, each by a case that fails without its repair. Every question
// is put to both strategies, in both orders.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "shapes.h"
#include "strategies.h"
#include "tricover/collide.h"
#include "tricover/locate.h"
#include "tricover/paper.h"

namespace tricover::support {
namespace {

constexpr double kQuarter = 1.5707963267948966;
constexpr std::array<Strategy, 2> kStrategies = {Strategy::Hierarchy, Strategy::Paper};

const Pose kHome = Pose::Identity();

/// By all ways of asking.
void expectCollide(bool truth, const Polygon& a, const Polygon& b, const Pose& pose_b = kHome,
                   const Pose& pose_a = kHome) {
  EXPECT_EQ(exact::collide(a, pose_a, b, pose_b), truth);
  for (const Strategy strategy : kStrategies) {
    EXPECT_EQ(collide(strategy, a, pose_a, b, pose_b), truth);
    EXPECT_EQ(collide(strategy, b, pose_b, a, pose_a), truth);
  }
}

/// Of b at one pose after the other, with caches, by both strategies.
void expectCollideOnWay(const Polygon& a, const Polygon& b, const std::vector<std::pair<Pose, bool>>& way) {
  for (const Strategy strategy : kStrategies) {
    StrategyCaches caches;
    for (const auto& [at, truth] : way)
      EXPECT_EQ(collide(strategy, a, kHome, b, at, caches), truth) << at.translation().transpose();
  }
}

void expectLocation(Location truth, const Polygon& polygon, const std::vector<Vec2>& points) {
  for (const Vec2& p : points) EXPECT_EQ(locate(polygon, p), truth) << p.transpose();
}

// 1. "Mask unchanged -> OUT" is sound only if the last state was outside of every influence area.
TEST(Repair1MaskInsideAnInfluenceArea, TurningOrSlidingWithinItIntoContact) {
  const Polygon wall({rectangle(-10, -10, 10, 0)}), rod({rectangle(-4, -0.1, 4, 0.1)});
  // On the spot: the centroid hasn't moved, its mask is the same.
  expectCollideOnWay(wall, rod,
                     {{turnedAndMoved(0, 0, 1), false},
                      {turnedAndMoved(0.01, 0, 1), false},
                      {turnedAndMoved(kQuarter, 0, 1), true},
                      {turnedAndMoved(0, 0, 1), false}});
  std::vector<std::pair<Pose, bool>> down;
  for (double height = 3; height > 0; height -= 0.01) down.push_back({turnedAndMoved(0, 0, height), height - 0.1 <= 0});
  expectCollideOnWay(wall, rod, down);
}

// 2. Edge tests alone miss containment.
TEST(Repair2Containment, OfEitherInTheOther) {
  const Polygon block({rectangle(0, 0, 10, 10)}), small({rectangle(0, 0, 1, 1)}), rod({rectangle(0, 0, 9.8, 0.1)});
  expectCollide(true, block, small, turnedAndMoved(0, 4, 4));
  // Within the influence areas of several edges, and yet no edges meet.
  expectCollide(true, block, rod, turnedAndMoved(0, 0.1, 5));
  expectCollide(false, block, rod, turnedAndMoved(0, 0.1, 10.5));
  // Of one ring among several.
  const Polygon parts({rectangle(40, 0, 41, 1), rectangle(20, 0, 21, 1), rectangle(1, 1, 2, 2)});
  expectCollide(true, parts, Polygon({rectangle(0, 0, 4, 4)}));
  expectCollide(false, parts, Polygon({rectangle(0, 0, 4, 4)}), turnedAndMoved(0, 5, 5));
  const Polygon pair({rectangle(0, 0, 1, 1), rectangle(6, 0, 7, 1)});
  expectCollide(true, Polygon({rectangle(0, 0, 20, 20)}), pair, turnedAndMoved(0, -4, 5));
  // Not in a hole.
  const Polygon frame({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)});
  expectCollide(false, frame, small, turnedAndMoved(0, 4, 4));
  expectCollide(true, frame, small, turnedAndMoved(0, 0.5, 0.5));
}

// 3. The one-sided influence area is on the wrong side for edges whose triangle is negative.
TEST(Repair3NegativeTriangles, HoleEdgesHaveTheirOuterSideTowardsS) {
  const Polygon frame({rectangle(-10, -10, 10, 10), reversed(rectangle(-5, -5, 5, 5))});
  ASSERT_EQ(frame.coveringOrigin(), Vec2(0, 0));
  for (EdgeIndex edge = 4; edge < 8; ++edge) {
    ASSERT_EQ(paper::covering(frame)[static_cast<std::size_t>(edge)].sign, -1);
    const Vec2 middle = 0.5 * (frame.edgeStart(edge) + frame.edgeEnd(edge));
    EXPECT_TRUE(paper::inInfluenceArea(frame, edge, 0.9 * middle, 1, paper::InfluenceKind::OneSided))
        << "in the hole, near " << edge;
    EXPECT_FALSE(paper::inInfluenceArea(frame, edge, 1.1 * middle, 1, paper::InfluenceKind::OneSided))
        << "in the solid";
    EXPECT_TRUE(paper::inInfluenceArea(frame, edge, 1.1 * middle, 1, paper::InfluenceKind::Extended));
  }
  const Vec2 outer_middle = 0.5 * (frame.edgeStart(0) + frame.edgeEnd(0));
  EXPECT_TRUE(paper::inInfluenceArea(frame, 0, 1.05 * outer_middle, 1, paper::InfluenceKind::OneSided));
  EXPECT_FALSE(paper::inInfluenceArea(frame, 0, 0.95 * outer_middle, 1, paper::InfluenceKind::OneSided));
}

TEST(Repair3NegativeTriangles, ContactsInHolesAndConcavitiesAreFound) {
  const Polygon frame({rectangle(-10, -10, 10, 10), reversed(rectangle(-5, -5, 5, 5))});
  const Polygon notched({comb(2, 6, 2, 8)}), peg({rectangle(-1, -1, 1, 1)});
  std::vector<std::pair<Pose, bool>> in_hole, in_notch;
  for (double x = 3; x <= 5; x += 0.25) {
    in_hole.push_back({turnedAndMoved(0, x, 0), x >= 4});
    in_notch.push_back({turnedAndMoved(0, x, 4), x <= 3 || x >= 5});
  }
  expectCollideOnWay(frame, peg, in_hole);
  expectCollideOnWay(notched, peg, in_notch);
}

// 4. "sum == 2" recognises a winding of +1 only.
TEST(Repair4FillRule, ClockwiseRingsAndWindingsOfTwo) {
  const Polygon clockwise({reversed(rectangle(0, 0, 4, 4))});
  EXPECT_EQ(locate(clockwise, {1, 2}), Location::Inside);
  EXPECT_EQ(locate(clockwise, {5, 2}), Location::Outside);
  for (const bool flip : {false, true}) {
    Ring inner = rectangle(1, 1, 3, 3), outer = rectangle(0, 0, 4, 4);
    if (flip) inner = reversed(inner);
    if (flip) outer = reversed(outer);
    EXPECT_EQ(locate(Polygon({outer, inner}, FillRule::NonZero), {2, 1.5}), Location::Inside);
    EXPECT_EQ(locate(Polygon({outer, inner}, FillRule::EvenOdd), {2, 1.5}), Location::Outside);
    EXPECT_EQ(locate(Polygon({outer, reversed(inner)}, FillRule::NonZero), {2, 1.5}), Location::Outside);
    EXPECT_EQ(locate(Polygon({outer, inner, inner}, FillRule::EvenOdd), {2, 1.5}), Location::Inside);
  }
  expectCollide(true, clockwise, Polygon({rectangle(0, 0, 1, 1)}), turnedAndMoved(0, 1, 1));
}

// 5. Edges collinear with S have sign 0 and contribute nothing to the sum, yet their points are boundary points.
TEST(Repair5EdgesThroughS, TheirPointsAreOnTheBoundary) {
  const Polygon polygon({rectangle(-4, -4, 4, 4), {{1, 0}, {2, 0}, {2, 1}}, {{-1, 0}, {-2, 0}, {-2, -1}}});
  ASSERT_EQ(polygon.coveringOrigin(), Vec2(0, 0));
  ASSERT_EQ(paper::covering(polygon)[4].sign, 0);
  expectLocation(Location::Boundary, polygon, {{1, 0}, {1.5, 0}, {2, 0}, {-1.25, 0}});
  expectLocation(Location::Inside, polygon, {{0, 0}, {0.5, 0}, {3, 0}, {1.5, -1e-300}});
  expectLocation(Location::Outside, polygon, {{1.5, 1e-300}, {5, 0}});
}

// 6. The barycentric segment test is undefined for collinear segments; overlapping collinear edges must collide.
TEST(Repair6CollinearEdges, ThatOverlapOrTouchCollide) {
  const Polygon below({rectangle(0, -1, 4, 0)});
  const auto above = [](double from, double to) { return Polygon({{{from, 0}, {to, 0}, {to, 1}, {from, 1}}}); };
  for (const Pose& common : {Pose::Identity(), turnedAndMoved(0.3, 7, -5), mirrored(turnedAndMoved(1.1, 1e6, 3))}) {
    for (const double x : {-1.0, -0.5, 0.0, 1.5, 3.0, 4.0}) expectCollide(true, below, above(x, x + 1), common, common);
    expectCollide(false, below, above(-1, -5e-324), common, common);
    expectCollide(false, below, above(nudged(4, 1), 5), common, common);
  }
}

TEST(Repair6CollinearEdges, OfRegionsWithoutAnInside) {
  const Polygon segment({{{0, 0}, {2, 2}, {1, 1}}}), touching({{{2, 2}, {3, 3}, {4, 4}}});
  const Polygon apart({{{nudged(2, 1), nudged(2, 1)}, {3, 3}, {4, 4}}}), dot({{{0.7, 0.7}, {0.7, 0.7}, {0.7, 0.7}}});
  // Neither's first vertex lies on the other: only the edges know.
  const Polygon overlapping({{{3, 3}, {1.5, 1.5}, {2.5, 2.5}}}), beyond({{{3, 3}, {2.5, 2.5}, {nudged(2, 1), 2}}});
  for (const Polygon& other : {touching, overlapping, dot}) expectCollide(true, segment, other);
  for (const Polygon& other : {beyond, apart}) expectCollide(false, segment, other);
  expectCollide(false, apart, dot);
}

// 7. "In the same zone" with signs computed in rounded arithmetic is not a proof.
TEST(Repair7ExactZones, OneUlpAcrossAnEdgeIsAnotherZone) {
  const Polygon polygon({{{-12, -12}, {24, 24}, {-12, 24}}});
  const auto roundedSide = [](const Vec2& p) {
    const volatile double left = 36 * (p.y() + 12), right = 36 * (p.x() + 12);
    return (left > right) - (left < right);
  };
  int rounded_wrong = 0, counts[3] = {0, 0, 0};
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const Vec2 point(nudged(0.5, i), nudged(0.5, j));
      const Location truth = i == j ? Location::Boundary : i < j ? Location::Inside : Location::Outside;
      EXPECT_EQ(locate(polygon, point), truth);
      rounded_wrong += roundedSide(point) != (j > i) - (j < i);
      ++counts[static_cast<int>(truth)];
    }
  }
  EXPECT_GT(rounded_wrong, 100) << "the case shows nothing that rounding gets wrong";
  for (const int count : counts) EXPECT_GE(count, 32);
}

TEST(Repair7ExactZones, AJumpFromTheHoleIntoTheSolidIsAnotherZone) {
  const Polygon frame({rectangle(-10, -10, 10, 10), rectangle(-5, -5, 5, 5)}), peg({rectangle(-0.1, -0.1, 0.1, 0.1)});
  std::vector<std::pair<Pose, bool>> jumps;
  for (const double x : {0.0, 0.5, 7.5, 7.0, 0.0, -7.5, 0.25})
    jumps.push_back({turnedAndMoved(0, x, 0), std::abs(x) > 5});
  expectCollideOnWay(frame, peg, jumps);
}

}  // namespace
}  // namespace tricover::support
