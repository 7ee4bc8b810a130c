// SPDX-License-Identifier: BSD-3-Clause
// The seven places where the paper as printed goes wrong, each by a case that fails without its repair. Every question
// is put to both strategies, in both orders.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

/// The cold answer of all ways of asking; a disagreement between them fails.
bool collideAllWays(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const bool answer = collide(a, pose_a, b, pose_b);
  EXPECT_EQ(answer, exact::collide(a, pose_a, b, pose_b));
  for (const Strategy strategy : kStrategies) {
    EXPECT_EQ(collide(strategy, a, pose_a, b, pose_b), answer);
    EXPECT_EQ(collide(strategy, b, pose_b, a, pose_a), answer);
  }
  return answer;
}

// 1. "Mask unchanged -> OUT" is sound only if the last state was outside of every influence area.
TEST(Repair1MaskInsideAnInfluenceArea, TurningOnTheSpotIntoContact) {
  const Polygon wall({rectangle(-10, -10, 10, 0)}), rod({rectangle(-4, -0.1, 4, 0.1)});
  for (const Strategy strategy : kStrategies) {
    StrategyCaches cache;
    EXPECT_FALSE(collide(strategy, wall, Pose::Identity(), rod, turnedAndMoved(0, 0, 1), cache));
    EXPECT_FALSE(collide(strategy, wall, Pose::Identity(), rod, turnedAndMoved(0.01, 0, 1), cache));
    // The centroid hasn't moved: its mask is the same.
    EXPECT_TRUE(collide(strategy, wall, Pose::Identity(), rod, turnedAndMoved(kQuarter, 0, 1), cache));
    EXPECT_FALSE(collide(strategy, wall, Pose::Identity(), rod, turnedAndMoved(0, 0, 1), cache));
  }
}

TEST(Repair1MaskInsideAnInfluenceArea, SlidingWithinItIntoContact) {
  const Polygon wall({rectangle(-10, -10, 10, 0)}), rod({rectangle(-4, -0.1, 4, 0.1)});
  for (const Strategy strategy : kStrategies) {
    StrategyCaches cache;
    for (double height = 3; height > 0; height -= 0.01)
      EXPECT_EQ(collide(strategy, wall, Pose::Identity(), rod, turnedAndMoved(0, 0, height), cache), height - 0.1 <= 0);
  }
}

// 2. Edge tests alone miss containment.
TEST(Repair2Containment, OfEitherInTheOther) {
  const Polygon block({rectangle(0, 0, 10, 10)}), small({rectangle(0, 0, 1, 1)}), rod({rectangle(0, 0, 9.8, 0.1)});
  EXPECT_TRUE(collideAllWays(block, Pose::Identity(), small, turnedAndMoved(0, 4, 4)));
  // Within the influence areas of several edges, and yet no edges meet.
  EXPECT_TRUE(collideAllWays(block, Pose::Identity(), rod, turnedAndMoved(0, 0.1, 5)));
  EXPECT_FALSE(collideAllWays(block, Pose::Identity(), rod, turnedAndMoved(0, 0.1, 10.5)));
}

TEST(Repair2Containment, OfOneRingAmongSeveral) {
  const Polygon block({rectangle(0, 0, 4, 4)});
  const Polygon parts({rectangle(40, 0, 41, 1), rectangle(20, 0, 21, 1), rectangle(1, 1, 2, 2)});
  EXPECT_TRUE(collideAllWays(parts, Pose::Identity(), block, Pose::Identity()));
  EXPECT_FALSE(collideAllWays(parts, Pose::Identity(), block, turnedAndMoved(0, 5, 5)));
  const Polygon pair({rectangle(0, 0, 1, 1), rectangle(6, 0, 7, 1)});
  const Polygon wide({rectangle(0, 0, 20, 20)});
  EXPECT_TRUE(collideAllWays(wide, Pose::Identity(), pair, turnedAndMoved(0, -4, 5)));
}

TEST(Repair2Containment, NotInAHole) {
  const Polygon frame({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)}), small({rectangle(0, 0, 1, 1)});
  EXPECT_FALSE(collideAllWays(frame, Pose::Identity(), small, turnedAndMoved(0, 4, 4)));
  EXPECT_TRUE(collideAllWays(frame, Pose::Identity(), small, turnedAndMoved(0, 0.5, 0.5)));
}

// 3. The one-sided influence area is on the wrong side for edges whose triangle is negative.
TEST(Repair3NegativeTriangles, HoleEdgesHaveTheirOuterSideTowardsS) {
  const Polygon frame({rectangle(-10, -10, 10, 10), reversed(rectangle(-5, -5, 5, 5))});
  ASSERT_EQ(frame.origin(), Vec2(0, 0));
  std::size_t tested = 0;
  for (EdgeIndex edge = 4; edge < 8; ++edge) {
    ASSERT_EQ(paper::covering(frame)[static_cast<std::size_t>(edge)].sign, -1);
    const Vec2 middle = 0.5 * (frame.edgeStart(edge) + frame.edgeEnd(edge));
    EXPECT_TRUE(paper::inInfluenceArea(frame, edge, 0.9 * middle, 1, paper::InfluenceKind::OneSided))
        << "in the hole, near " << edge;
    EXPECT_FALSE(paper::inInfluenceArea(frame, edge, 1.1 * middle, 1, paper::InfluenceKind::OneSided))
        << "in the solid";
    EXPECT_TRUE(paper::inInfluenceArea(frame, edge, 1.1 * middle, 1, paper::InfluenceKind::Extended));
    ++tested;
  }
  EXPECT_EQ(tested, 4u);
  const Vec2 outer_middle = 0.5 * (frame.edgeStart(0) + frame.edgeEnd(0));
  EXPECT_TRUE(paper::inInfluenceArea(frame, 0, 1.05 * outer_middle, 1, paper::InfluenceKind::OneSided));
  EXPECT_FALSE(paper::inInfluenceArea(frame, 0, 0.95 * outer_middle, 1, paper::InfluenceKind::OneSided));
}

TEST(Repair3NegativeTriangles, ContactsInHolesAndConcavitiesAreFound) {
  const Polygon frame({rectangle(-10, -10, 10, 10), reversed(rectangle(-5, -5, 5, 5))});
  const Polygon notched({comb(2, 6, 2, 8)}), peg({rectangle(-1, -1, 1, 1)});
  for (const Strategy strategy : kStrategies) {
    StrategyCaches in_hole, in_notch;
    for (double x = 3; x <= 5; x += 0.25) {
      EXPECT_EQ(collide(strategy, frame, Pose::Identity(), peg, turnedAndMoved(0, x, 0), in_hole), x >= 4);
      EXPECT_EQ(collide(strategy, notched, Pose::Identity(), peg, turnedAndMoved(0, x, 4), in_notch), x <= 3 || x >= 5);
    }
  }
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
  EXPECT_TRUE(collideAllWays(clockwise, Pose::Identity(), Polygon({rectangle(0, 0, 1, 1)}), turnedAndMoved(0, 1, 1)));
}

// 5. Edges collinear with S have sign 0 and contribute nothing to the sum, yet their points are boundary points.
TEST(Repair5EdgesThroughS, TheirPointsAreOnTheBoundary) {
  const Polygon polygon({rectangle(-4, -4, 4, 4), {{1, 0}, {2, 0}, {2, 1}}, {{-1, 0}, {-2, 0}, {-2, -1}}});
  ASSERT_EQ(polygon.origin(), Vec2(0, 0));
  ASSERT_EQ(paper::covering(polygon)[4].sign, 0);
  for (const Vec2& point : {Vec2(1, 0), Vec2(1.5, 0), Vec2(2, 0), Vec2(-1.25, 0)})
    EXPECT_EQ(locate(polygon, point), Location::Boundary);
  for (const Vec2& point : {Vec2(0, 0), Vec2(0.5, 0), Vec2(3, 0), Vec2(1.5, -1e-300)})
    EXPECT_EQ(locate(polygon, point), Location::Inside);
  EXPECT_EQ(locate(polygon, {1.5, 1e-300}), Location::Outside);
  EXPECT_EQ(locate(polygon, {5, 0}), Location::Outside);
}

// 6. The barycentric segment test is undefined for collinear segments; overlapping collinear edges must collide.
TEST(Repair6CollinearEdges, ThatOverlapOrTouchCollide) {
  const Polygon below({rectangle(0, -1, 4, 0)});
  const auto above = [](double from, double to) { return Polygon({{{from, 0}, {to, 0}, {to, 1}, {from, 1}}}); };
  for (const Pose& common : {Pose::Identity(), turnedAndMoved(0.3, 7, -5), mirrored(turnedAndMoved(1.1, 1e6, 3))}) {
    for (const double x : {-1.0, -0.5, 0.0, 1.5, 3.0, 4.0})
      EXPECT_TRUE(collideAllWays(below, common, above(x, x + 1), common)) << x;
    EXPECT_FALSE(collideAllWays(below, common, above(-1, -5e-324), common));
    EXPECT_FALSE(collideAllWays(below, common, above(nudged(4, 1), 5), common));
  }
}

TEST(Repair6CollinearEdges, OfRegionsWithoutAnInside) {
  const Polygon segment({{{0, 0}, {2, 2}, {1, 1}}}), touching({{{2, 2}, {3, 3}, {4, 4}}});
  const Polygon apart({{{nudged(2, 1), nudged(2, 1)}, {3, 3}, {4, 4}}}), dot({{{0.7, 0.7}, {0.7, 0.7}, {0.7, 0.7}}});
  EXPECT_TRUE(collideAllWays(segment, Pose::Identity(), touching, Pose::Identity()));
  // Neither's first vertex lies on the other: only the edges know.
  const Polygon overlapping({{{3, 3}, {1.5, 1.5}, {2.5, 2.5}}}), beyond({{{3, 3}, {2.5, 2.5}, {nudged(2, 1), 2}}});
  EXPECT_TRUE(collideAllWays(segment, Pose::Identity(), overlapping, Pose::Identity()));
  EXPECT_FALSE(collideAllWays(segment, Pose::Identity(), beyond, Pose::Identity()));
  EXPECT_FALSE(collideAllWays(segment, Pose::Identity(), apart, Pose::Identity()));
  EXPECT_TRUE(collideAllWays(segment, Pose::Identity(), dot, Pose::Identity()));
  EXPECT_FALSE(collideAllWays(apart, Pose::Identity(), dot, Pose::Identity()));
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
  for (const Strategy strategy : kStrategies) {
    StrategyCaches cache;
    for (const double x : {0.0, 0.5, 7.5, 7.0, 0.0, -7.5, 0.25})
      EXPECT_EQ(collide(strategy, frame, Pose::Identity(), peg, turnedAndMoved(0, x, 0), cache), std::abs(x) > 5);
  }
}

}  // namespace
}  // namespace tricover::support
