// SPDX-License-Identifier: BSD-3-Clause
// The reference against truths known by hand.
#include "exact_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact_depth.h"
#include "exact_shifts.h"
#include "families.h"
#include "shapes.h"
#include "tricover/polygon.h"

namespace tricover {
namespace {

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();

Ring square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

bool collide(const Polygon& a, const Polygon& b, const Pose& pose_b = Pose::Identity()) {
  const bool forwards = exact::collide(a, Pose::Identity(), b, pose_b);
  EXPECT_EQ(forwards, exact::collide(b, pose_b, a, Pose::Identity()));
  EXPECT_EQ(forwards, exact::distanceSquared(a, Pose::Identity(), b, pose_b) == 0);
  return forwards;
}

TEST(ExactLocate, InsideBoundaryOutsideOfASquareInEitherDirection) {
  for (const Polygon& polygon : {Polygon({square(0, 1)}), Polygon({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}})}) {
    EXPECT_EQ(exact::locate(polygon, {0.5, 0.5}), Location::Inside);
    EXPECT_EQ(exact::locate(polygon, {1, 1}), Location::Boundary);
    EXPECT_EQ(exact::locate(polygon, {0.3, 0}), Location::Boundary);
    EXPECT_EQ(exact::locate(polygon, {0.3, -kTiny}), Location::Outside);
    EXPECT_EQ(exact::locate(polygon, {0.3, kTiny}), Location::Inside);
    EXPECT_EQ(exact::locate(polygon, {-1, 1}), Location::Outside);
    EXPECT_EQ(exact::locate(polygon, {kHuge, -kHuge}), Location::Outside);
  }
}

TEST(ExactLocate, FillRulesDifferWhereRingsOverlap) {
  const std::vector<Ring> rings = {square(0, 4), square(1, 3)};
  EXPECT_EQ(exact::locate(Polygon(rings, FillRule::EvenOdd), {2, 2}), Location::Outside);
  EXPECT_EQ(exact::locate(Polygon(rings, FillRule::NonZero), {2, 2}), Location::Inside);
  EXPECT_EQ(exact::locate(Polygon(rings, FillRule::NonZero), {1, 2}), Location::Boundary);
  const std::vector<Ring> opposite = {square(0, 4), {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
  EXPECT_EQ(exact::locate(Polygon(opposite, FillRule::NonZero), {2, 2}), Location::Outside);
}

TEST(ExactLocate, BowTieRegionsWithoutInsideAndVerticesOnTheRay) {
  const Polygon bow_tie({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
  EXPECT_EQ(exact::locate(bow_tie, {1, 1}), Location::Boundary);
  EXPECT_EQ(exact::locate(bow_tie, {0.5, 1}), Location::Inside);
  EXPECT_EQ(exact::locate(bow_tie, {1, 1.5}), Location::Outside);
  const Polygon segment({{{0, 0}, {1, 1}, {3, 3}}});
  EXPECT_EQ(exact::locate(segment, {2, 2}), Location::Boundary);
  EXPECT_EQ(exact::locate(segment, {4, 4}), Location::Outside);
  const Polygon diamond({{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}});
  EXPECT_EQ(exact::locate(diamond, {-2, 0}), Location::Outside);
  EXPECT_EQ(exact::locate(diamond, {0, 0}), Location::Inside);
  EXPECT_EQ(exact::locate(diamond, {-2, 1}), Location::Outside);
}

TEST(ExactCollide, TouchingIsCollidingAndOneUlpIsNot) {
  const Polygon a({square(0, 1)});
  EXPECT_TRUE(collide(a, a, poseAt(1, 0)));
  EXPECT_TRUE(collide(a, a, poseAt(1, 1)));
  EXPECT_FALSE(collide(a, a, poseAt(std::nextafter(1, 2), 0)));
  EXPECT_FALSE(collide(a, a, poseAt(0, -std::nextafter(1, 2))));
  EXPECT_TRUE(collide(a, a, poseAt(0, -std::nextafter(1, 0))));
}

TEST(ExactCollide, ThePoseIsTheAffineMapAsWrittenNotARoundedOne) {
  // 1e16 + 1 is no double, yet that is where the vertex is.
  const Polygon a({{{0, 0}, {1, 0}, {0, 1}}}), point_like({{{0, 0}, {1, -1}, {2, -1}}});
  Pose far = poseAt(1e16, 0);
  EXPECT_TRUE(exact::collide(a, far, point_like, poseAt(1e16, 0)));
  const Polygon beyond({{{1, 0}, {2, -1}, {2, 1}}}), farther({{{std::nextafter(1, 2), 0}, {2, -1}, {2, 1}}});
  EXPECT_TRUE(exact::collide(a, far, beyond, far));
  EXPECT_FALSE(exact::collide(a, far, farther, far));
  Pose shrunk = Pose::Identity();
  shrunk.linear()(0, 0) = std::nextafter(1, 0);
  EXPECT_FALSE(exact::collide(a, shrunk, beyond, Pose::Identity()));
  Pose flipped = Pose::Identity();
  flipped.linear()(1, 1) = -1;
  EXPECT_FALSE(exact::collide(Polygon({{{0, 1}, {1, 1}, {0, 2}}}), flipped, a, Pose::Identity()));
}

TEST(ExactCollide, ContainmentHolesAndRegionsInThem) {
  const Polygon block({square(0, 10)}), frame({square(0, 10), square(2, 8)}), small({square(4, 5)});
  EXPECT_TRUE(collide(block, small));
  EXPECT_FALSE(collide(frame, small));
  EXPECT_TRUE(collide(frame, small, poseAt(3, 0)));
  EXPECT_TRUE(collide(Polygon({square(0, 10), square(2, 8), square(3, 7)}), small));
  EXPECT_FALSE(collide(frame, Polygon({square(-5, 15), square(-1, 11)})));
}

TEST(ExactCollide, CollinearEdgesAndSinglePoints) {
  const Polygon a({square(0, 2)}), needle({{{2, 1}, {2, 5}, {2, 3}}}), dot({{{1, 2}, {1, 2}, {1, 2}}});
  EXPECT_TRUE(collide(a, needle));
  EXPECT_FALSE(collide(a, needle, poseAt(0, std::nextafter(1, 2))));
  EXPECT_TRUE(collide(a, dot));
  EXPECT_TRUE(collide(a, dot, poseAt(0, -1)));
  EXPECT_FALSE(collide(a, dot, poseAt(0, kTiny)));
  EXPECT_TRUE(collide(dot, dot));
}

TEST(ExactCollide, EveryExponent) {
  const Polygon huge({{{0, 0}, {kHuge, 0}, {0, kHuge}}}), tiny({{{0, -kTiny}, {kTiny, -kTiny}, {0, 0}}});
  EXPECT_TRUE(collide(huge, tiny));
  EXPECT_FALSE(collide(huge, tiny, poseAt(0, -kTiny)));
  EXPECT_TRUE(collide(huge, tiny, poseAt(kHuge, 0)));
  EXPECT_FALSE(collide(huge, tiny, poseAt(kHuge, kTiny * 2)));
}

TEST(ExactDistance, BetweenVerticesToAnEdgeAndAsADouble) {
  const Polygon a({square(0, 1)});
  EXPECT_EQ(exact::distanceSquared(a, Pose::Identity(), a, poseAt(4, 5)), 25);
  EXPECT_EQ(exact::distanceSquared(a, Pose::Identity(), a, poseAt(4, 0.5)), 9);
  EXPECT_EQ(exact::distanceSquared({0, 0}, {1, 0}, {0, 1}), mpq_class(1, 2));
  EXPECT_EQ(exact::distanceSquared({5, 1}, {1, 1}, {1, 1}), 16);
  EXPECT_EQ(exact::distanceSquared({0, 0}, {kTiny, 0}, {1, 0}), mpq_class(kTiny) * kTiny);
  EXPECT_EQ(exact::distanceBelow(25), 5);
  EXPECT_EQ(exact::distanceBelow(mpq_class(kTiny) * kTiny), kTiny);
  const double root_two = exact::distanceBelow(2);
  EXPECT_LT(mpq_class(root_two) * root_two, 2);
  EXPECT_TRUE(exact::within(2, mpq_class(std::nextafter(root_two, 2))));
  EXPECT_FALSE(exact::within(2, mpq_class(root_two)));
}

TEST(ExactDepth, OfClosedForms) {
  const Pose here = Pose::Identity();
  const auto isAbout = [](const exact::Bracket& found, double truth) {
    return found.low <= truth + 1e-15 && found.high >= truth - 1e-15 && found.high - found.low <= 1e-15;
  };
  const Polygon a({{{0, 0}, {100, 0}, {10, 100}}}), b({{{0, 100}, {0, 10}, {80, 10}}});
  // As lines, there and back.
  const Polygon line_a({{{0, 0}, {100, 0}, {10, 100}, {100, 0}}}), line_b({{{0, 100}, {0, 10}, {80, 10}, {0, 10}}});
  EXPECT_NEAR(double(exact::excess(line_a, here, line_b, here).low), 910 / 19.0, 1e-14);
  EXPECT_NEAR(double(exact::excessByCandidates(line_a, here, line_b, here)), 910 / 19.0, 1e-14);
  EXPECT_NEAR(double(exact::excess(a, here, b, here).low), std::sqrt(500), 1e-14);
  EXPECT_TRUE(isAbout(exact::depth(Polygon::box(2, 2), here, Polygon::box(2, 2), poseAt(1.5, 0)), 0.5));
  EXPECT_TRUE(isAbout(exact::depth(Polygon::box(2, 2), here, Polygon::box(2, 2), poseAt(2, 0)), 0));
  EXPECT_TRUE(isAbout(exact::depth(Polygon::box(4, 2), here, Polygon::segment({0, 0.5}, {3, -1.5}), here), 1));
  EXPECT_TRUE(isAbout(exact::depth(Polygon::box(4, 2), here, Polygon::point({0, 0.5}), here), 0.5));
  EXPECT_TRUE(
      isAbout(exact::depth(Polygon::box(4, 2).complement(), here, Polygon::box(1, 1), poseAt(2, 1)), std::sqrt(0.5)));
  const Polygon hole({support::regular(64, 4), support::regular(64, 3)});
  const exact::Bracket tied = exact::excess(Polygon::box(1, 1), here, hole, here);
  EXPECT_NEAR(double(tied.low), 3 * std::cos(M_PI / 64), 1e-14);
  EXPECT_LE(tied.high - tied.low, 1e-15);
}

/// A crate that slides along a floor past a gap in it, falls short of a wall, and passes a post at its margin.
TEST(ExactShifts, AreIntervalsByHand) {
  const Polygon floor({support::rectangle(-10, -1, 0, 0), support::rectangle(3, -1, 10, 0)});
  support::MovingCase c{
      floor, {}, Polygon({support::rectangle(-1, 0, 0, 1)}), Motion::translation(Pose::Identity(), {8, 0})};
  const auto contacts = [&](double margin) {
    return exact::contactsOfShifts(c.a, c.motion_a, c.b, c.motion_b, margin);
  };
  auto times = contacts(0);
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].begin, 0);
  EXPECT_EQ(times[0].end, mpq_class(1, 8));
  EXPECT_EQ(times[1].begin, mpq_class(3, 8));
  EXPECT_EQ(times[1].end, 1);
  c = {Polygon::point({0, 0}), {}, Polygon::point({0, 0}), Motion::translation(tricover::poseAt(-5, 3), {10, 0})};
  times = contacts(5);
  ASSERT_EQ(times.size(), 1u);
  EXPECT_EQ(times[0].begin, mpq_class(1, 10));
  EXPECT_EQ(times[0].end, mpq_class(9, 10));
  EXPECT_EQ(contacts(3).size(), 1u);
  EXPECT_EQ(contacts(2).size(), 0u);
  // Held all of the time; and in a hole.
  c = {Polygon({support::rectangle(-9, -9, 9, 9), support::rectangle(-3, -3, 3, 3)}),
       {},
       Polygon::box(1, 1),
       Motion::still(tricover::poseAt(6, 0))};
  ASSERT_EQ(contacts(0).size(), 1u);
  EXPECT_EQ(contacts(0)[0].end, 1);
  c.motion_b = Motion::translation(Pose::Identity(), {5, 0});
  ASSERT_EQ(contacts(0).size(), 1u);
  EXPECT_EQ(contacts(0)[0].begin, mpq_class(1, 2));
}

}  // namespace
}  // namespace tricover
