// SPDX-License-Identifier: BSD-3-Clause
// crossings(): which pairs of edges, and where.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "shapes.h"
#include "tricover/contacts.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();

/// Sorted by edges; the swapped question must have the same answer.
std::vector<Crossing> ask(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const auto order = [](const Crossing& p, const Crossing& q) {
    return p.edge_a != q.edge_a ? p.edge_a < q.edge_a : p.edge_b < q.edge_b;
  };
  std::vector<Crossing> found = crossings(a, pose_a, b, pose_b), swapped = crossings(b, pose_b, a, pose_a);
  for (Crossing& crossing : swapped) std::swap(crossing.edge_a, crossing.edge_b);
  std::sort(found.begin(), found.end(), order);
  std::sort(swapped.begin(), swapped.end(), order);
  EXPECT_EQ(found.size(), swapped.size());
  for (std::size_t i = 0; i < std::min(found.size(), swapped.size()); ++i) {
    EXPECT_EQ(found[i].edge_a, swapped[i].edge_a);
    EXPECT_EQ(found[i].edge_b, swapped[i].edge_b);
    EXPECT_EQ(found[i].point, swapped[i].point);
  }
  return found;
}

void expectCrossing(const Crossing& crossing, std::ptrdiff_t edge_a, std::ptrdiff_t edge_b, const Vec2& point,
                    double size = 1) {
  EXPECT_EQ(crossing.edge_a, edge_a);
  EXPECT_EQ(crossing.edge_b, edge_b);
  EXPECT_LE(((crossing.point - point) / size).norm(), 1e-13) << crossing.point.transpose();
}

TEST(Crossings, OfTwoSquares) {
  const auto found = ask(Polygon({rectangle(0, 0, 4, 4)}), kHere, Polygon({rectangle(3, 1, 5, 3)}), kHere);
  ASSERT_EQ(found.size(), 2u);
  expectCrossing(found[0], 1, 0, {4, 1});
  expectCrossing(found[1], 1, 2, {4, 3});
}

TEST(Crossings, AreNoneInAContainmentOrApart) {
  const Polygon a({rectangle(0, 0, 4, 4)}), b({rectangle(1, 1, 3, 3)});
  EXPECT_TRUE(ask(a, kHere, b, kHere).empty());
  EXPECT_TRUE(ask(a, kHere, b, turnedAndMoved(0, 100, 0)).empty());
  EXPECT_TRUE(ask(a, kHere, b, turnedAndMoved(0, 3 + 1e-15, 0)).empty());
}

TEST(Crossings, AreNumberedThroughTheRings) {
  const Polygon a({rectangle(0, 0, 9, 9), rectangle(3, 3, 6, 6)}), b({rectangle(2, 4, 4, 5)});
  const auto found = ask(a, kHere, b, kHere);
  ASSERT_EQ(found.size(), 2u);
  expectCrossing(found[0], 7, 0, {3, 4});
  expectCrossing(found[1], 7, 2, {3, 5});
}

TEST(Crossings, OfAVertexOnAnEdgeAreBothItsEdges) {
  const auto found = ask(Polygon({rectangle(0, 0, 4, 4)}), kHere, Polygon({{{4, 2}, {6, 1}, {6, 3}}}), kHere);
  ASSERT_EQ(found.size(), 2u);
  expectCrossing(found[0], 1, 0, {4, 2});
  expectCrossing(found[1], 1, 2, {4, 2});
}

TEST(Crossings, OfCollinearEdgesAreInTheCommonStretch) {
  const auto found = ask(Polygon({rectangle(0, 0, 4, 4)}), kHere, Polygon({rectangle(4, 1, 6, 9)}), kHere);
  ASSERT_EQ(found.size(), 3u);
  expectCrossing(found[0], 1, 0, {4, 1});
  expectCrossing(found[1], 1, 3, {4, 2.5});
  expectCrossing(found[2], 2, 3, {4, 4});
}

/// As if that were written once; edges keep the numbers that they were written with.
TEST(Crossings, OfARepeatedVertexAreItsEdgesWithALength) {
  const Polygon b({{{4, 2}, {4, 2}, {6, 1}, {6, 3}}});
  const auto found = ask(Polygon({rectangle(0, 0, 4, 4)}), kHere, b, kHere);
  ASSERT_EQ(found.size(), 2u);
  expectCrossing(found[0], 1, 1, {4, 2});
  expectCrossing(found[1], 1, 3, {4, 2});
}

TEST(Crossings, AreInTheWorldAtEveryScale) {
  for (const double s : {1e-300, 1.0, 1e300}) {
    const Polygon a({scaled(rectangle(0, 0, 4, 4), s)}), b({scaled(rectangle(0, 0, 2, 2), s)});
    const auto found = ask(a, turnedAndMoved(0, 10 * s, 20 * s), b, turnedAndMoved(0, 13 * s, 21 * s));
    ASSERT_EQ(found.size(), 2u);
    expectCrossing(found[0], 1, 0, Vec2(14, 21) * s, s);
    expectCrossing(found[1], 1, 2, Vec2(14, 23) * s, s);
  }
}

TEST(Crossings, OfNearlyParallelEdgesAreOnBoth) {
  // They cross at (0.5, 0.5e-9): the place along them is known less well than across.
  const Polygon a({{{0, 0}, {1, 1e-9}, {0.5, -9}}}), b({{{0, 1e-9}, {1, 0}, {0.5, 9}}});
  const auto found = ask(a, kHere, b, kHere);
  for (const Crossing& crossing : found)
    if (crossing.edge_a == 0 && crossing.edge_b == 0) {
      EXPECT_NEAR(crossing.point.x(), 0.5, 1e-5);
      EXPECT_NEAR(crossing.point.y(), 0.5e-9, 1e-14);
      return;
    }
  ADD_FAILURE() << "the crossing is missing";
}

TEST(Crossings, RefuseWhatCollideRefuses) {
  const Polygon a({rectangle(0, 0, 4, 4)});
  Pose bad = kHere;
  bad.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(crossings(a, bad, a, kHere), std::invalid_argument);
  EXPECT_THROW(crossings(a, kHere, a, bad), std::invalid_argument);
}

TEST(Crossings, WithAMarginAreOfEdgesWithinIt) {
  const Polygon square({rectangle(0, 0, 4, 4)});
  const auto beside = [&](double x, double margin) {
    return crossings(square, Pose::Identity(), square, turnedAndMoved(0, x, 1), {margin});
  };
  EXPECT_TRUE(beside(5, 0.5).empty());
  EXPECT_TRUE(beside(5, nudged(1, -1)).empty());
  const std::vector<Crossing> found = beside(5, 1);
  ASSERT_FALSE(found.empty());
  for (const Crossing& crossing : found) EXPECT_EQ(crossing.point.x(), 4.5);
  EXPECT_EQ(beside(5, 100).size(), 16u);
  EXPECT_EQ(beside(5, 1e300).size(), 16u);
}

}  // namespace
}  // namespace tricover::support
