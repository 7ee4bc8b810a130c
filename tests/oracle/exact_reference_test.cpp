// SPDX-License-Identifier: BSD-3-Clause
// The reference against truths known by hand.
#include "exact_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

namespace tricover {
namespace {

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();

Ring square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

Pose shift(double x, double y) {
  Pose pose = Pose::Identity();
  pose.translation() = Vec2(x, y);
  return pose;
}

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
  EXPECT_TRUE(collide(a, a, shift(1, 0)));
  EXPECT_TRUE(collide(a, a, shift(1, 1)));
  EXPECT_FALSE(collide(a, a, shift(std::nextafter(1, 2), 0)));
  EXPECT_FALSE(collide(a, a, shift(0, -std::nextafter(1, 2))));
  EXPECT_TRUE(collide(a, a, shift(0, -std::nextafter(1, 0))));
}

TEST(ExactCollide, ThePoseIsTheAffineMapAsWrittenNotARoundedOne) {
  // 1e16 + 1 is no double, yet that is where the vertex is.
  const Polygon a({{{0, 0}, {1, 0}, {0, 1}}}), point_like({{{0, 0}, {1, -1}, {2, -1}}});
  Pose far = shift(1e16, 0);
  EXPECT_TRUE(exact::collide(a, far, point_like, shift(1e16, 0)));
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
  EXPECT_TRUE(collide(frame, small, shift(3, 0)));
  EXPECT_TRUE(collide(Polygon({square(0, 10), square(2, 8), square(3, 7)}), small));
  EXPECT_FALSE(collide(frame, Polygon({square(-5, 15), square(-1, 11)})));
}

TEST(ExactCollide, CollinearEdgesAndSinglePoints) {
  const Polygon a({square(0, 2)}), needle({{{2, 1}, {2, 5}, {2, 3}}}), dot({{{1, 2}, {1, 2}, {1, 2}}});
  EXPECT_TRUE(collide(a, needle));
  EXPECT_FALSE(collide(a, needle, shift(0, std::nextafter(1, 2))));
  EXPECT_TRUE(collide(a, dot));
  EXPECT_TRUE(collide(a, dot, shift(0, -1)));
  EXPECT_FALSE(collide(a, dot, shift(0, kTiny)));
  EXPECT_TRUE(collide(dot, dot));
}

TEST(ExactCollide, EveryExponent) {
  const Polygon huge({{{0, 0}, {kHuge, 0}, {0, kHuge}}}), tiny({{{0, -kTiny}, {kTiny, -kTiny}, {0, 0}}});
  EXPECT_TRUE(collide(huge, tiny));
  EXPECT_FALSE(collide(huge, tiny, shift(0, -kTiny)));
  EXPECT_TRUE(collide(huge, tiny, shift(kHuge, 0)));
  EXPECT_FALSE(collide(huge, tiny, shift(kHuge, kTiny * 2)));
}

TEST(ExactDistance, BetweenVerticesToAnEdgeAndAsADouble) {
  const Polygon a({square(0, 1)});
  EXPECT_EQ(exact::distanceSquared(a, Pose::Identity(), a, shift(4, 5)), 25);
  EXPECT_EQ(exact::distanceSquared(a, Pose::Identity(), a, shift(4, 0.5)), 9);
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

}  // namespace
}  // namespace tricover
