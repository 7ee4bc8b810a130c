// SPDX-License-Identifier: BSD-3-Clause
// The convex hull by its laws, on a grid where signs are exact; support vertices of convex rings against all vertices;
// nearest points of segments; peaks of affine functions; the operands' order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "convex/convex_ring.h"
#include "depth/peak.h"
#include "numbers/convex_hull.h"
#include "numbers/segment.h"
#include "pair/kernel_order.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using detail::cross;
using detail::nearestOnSegment;
using detail::OfCorners;
using detail::Peak;
using detail::valueAt;

std::vector<Vec2> hull(std::vector<Vec2> points) {
  return detail::convexHull(
      std::move(points), [](const Vec2& p) -> const Vec2& { return p; },
      [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; });
}

TEST(ConvexHull, TurnsLeftAtEveryCornerAndHoldsEveryPoint) {
  Random random(3);
  int segments = 0;
  for (int i = 0; i < 5000; ++i) {
    const int cells = random.integer(1, 6);
    std::vector<Vec2> points;
    for (int n = random.integer(1, 12); n > 0; --n)
      points.emplace_back(random.integer(0, cells), random.oneIn(5) ? 0 : random.integer(0, cells));
    const std::vector<Vec2> corners = hull(points);
    const std::size_t size = corners.size();
    ASSERT_GT(size, 0u);
    segments += size == 2;
    for (std::size_t k = 0; k < size; ++k) {
      const Vec2 &p = corners[k], &q = corners[(k + 1) % size], &r = corners[(k + 2) % size];
      ASSERT_TRUE(std::find(points.begin(), points.end(), p) != points.end());
      ASSERT_LE(std::pair(corners[0].x(), corners[0].y()), std::pair(p.x(), p.y()));
      ASSERT_TRUE(size < 3 || cross(q - p, r - q) > 0);
      ASSERT_TRUE(size == 1 || p != q);
      for (const Vec2& point : points) ASSERT_TRUE(size == 1 ? point == p : cross(q - p, point - p) >= 0);
    }
  }
  EXPECT_GT(segments, 100);
  EXPECT_TRUE(hull({}).empty());
}

TEST(NearestOnSegment, MeetsTheEndsExactly) {
  const Vec2 v(1, 2), w(4, 6);
  EXPECT_EQ(nearestOnSegment({-3, -1}, v, w), v);
  EXPECT_EQ(nearestOnSegment({9, 9}, v, w), w);
  EXPECT_EQ(nearestOnSegment(v, v, w), v);
  EXPECT_EQ(nearestOnSegment(w, v, w), w);
  EXPECT_EQ(nearestOnSegment({7, 7}, v, v), v);  // one point
  EXPECT_LE((nearestOnSegment({2.5 - 4, 4 + 3}, v, w) - Vec2(2.5, 4)).norm(), 1e-15);
  EXPECT_EQ(detail::squaredDistanceToSegment({-2, -2}, v, w), 25);
}

TEST(NearestOnSegment, IsAtARightAngleFromEitherSide) {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const auto point = [&] { return Vec2(random.real(-1, 1), random.real(-1, 1)); };
    const Vec2 v = point(), w = point(), p = point(), nearest = nearestOnSegment(p, v, w);
    ASSERT_LE((nearestOnSegment(p, w, v) - nearest).norm(), 1e-14);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
      ASSERT_GE((v + share * (w - v) - p).norm(), (nearest - p).norm() - 1e-15);
  }
}

TEST(KernelOrder, IsTotalAndTellsTheZerosApart) {
  const Polygon b({rectangle(0, 0, 1, 1)}), c({rectangle(0, 0, 1, 1)}), a({rectangle(0, 0, 3, 3)});
  const Pose here = Pose::Identity(), there = turnedAndMoved(0.1, 2, 3);
  // The larger first, whatever the poses. Of equal ones the poses decide, and never which one was made first.
  EXPECT_TRUE(detail::inOrder(detail::dataOf(a), here, detail::dataOf(b), there));
  EXPECT_FALSE(detail::inOrder(detail::dataOf(b), there, detail::dataOf(a), here));
  EXPECT_NE(detail::inOrder(detail::dataOf(b), there, detail::dataOf(c), here),
            detail::inOrder(detail::dataOf(c), here, detail::dataOf(b), there));
  EXPECT_EQ(detail::inOrder(detail::dataOf(b), there, detail::dataOf(c), here),
            detail::inOrder(detail::dataOf(c), there, detail::dataOf(b), here));
  // Under equal poses the edges decide, wherever a ring begins and whichever way it runs.
  Ring ring = rectangle(0, 0, 1, 1);
  const Polygon slanted({{{0, 0}, {1, 0}, {1, 1}, {0, 0.5}}}), moved({{ring[2], ring[3], ring[0], ring[1]}}),
      reversed({{ring[3], ring[2], ring[1], ring[0]}});
  for (const Polygon* same : {&moved, &reversed})
    EXPECT_EQ(detail::compareEdges(detail::dataOf(b), detail::dataOf(*same)), 0);
  EXPECT_EQ(detail::compareEdges(detail::dataOf(b), detail::dataOf(slanted)),
            -detail::compareEdges(detail::dataOf(slanted), detail::dataOf(b)));
  EXPECT_NE(detail::compareEdges(detail::dataOf(b), detail::dataOf(slanted)), 0);
  // Of one polygon, any pose that differs by any entry comes before or after, the sign of a zero included.
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      Pose other = there;
      other.matrix()(row, column) = nudged(there.matrix()(row, column), 1);
      ASSERT_NE(detail::inOrder(detail::dataOf(a), there, detail::dataOf(a), other),
                detail::inOrder(detail::dataOf(a), other, detail::dataOf(a), there));
    }
  }
  Pose negative = here;
  negative.translation().x() = -0.0;
  EXPECT_NE(detail::inOrder(detail::dataOf(a), here, detail::dataOf(a), negative),
            detail::inOrder(detail::dataOf(a), negative, detail::dataOf(a), here));
  EXPECT_TRUE(detail::inOrder(detail::dataOf(a), there, detail::dataOf(a), there));
  // And of one polygon and two motions.
  const Motion still = Motion::still(there);
  for (const auto change :
       {+[](Motion& m) { m.shift.x() = 1; }, +[](Motion& m) { m.shift.y() = 1; }, +[](Motion& m) { m.angle = 1; },
        +[](Motion& m) { m.pivot.x() = 1; }, +[](Motion& m) { m.pivot.y() = -0.0; }}) {
    Motion other = still;
    change(other);
    EXPECT_NE(detail::inOrder(detail::dataOf(a), still, detail::dataOf(a), other),
              detail::inOrder(detail::dataOf(a), other, detail::dataOf(a), still));
  }
}

/// Functions that are the same but for rounding, of edges in line, take nothing away from their peak.
TEST(Peak, IsNowhereBelowItsFunctions) {
  int repeated = 0;
  for (int i = 0; i < 4000; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const std::size_t corners = random.coin() ? 2 : 3;
    std::vector<OfCorners> functions;
    Peak peak(corners);
    for (std::size_t k = 0; k < Peak::kMost; ++k) {
      OfCorners function{};
      const bool repeats = k > 0 && random.coin();
      for (std::size_t c = 0; c < corners; ++c)
        function[c] = repeats ? functions[0][c] * (1 + random.integer(-2, 2) * 0x1p-52)
                              : random.integer(0, 4) + random.real(0, 1);
      repeated += repeats;
      functions.push_back(function);
      peak.add(function);
    }
    for (int k = 0; k <= 200; ++k) {
      OfCorners place{k == 0 ? 1 : random.real(0, 1), 0, 0};
      place[1] = (1 - place[0]) * (corners == 3 ? random.real(0, 1) : 1);
      place[2] = 1 - place[0] - place[1];
      double least = std::numeric_limits<double>::infinity();
      for (const OfCorners& function : functions) least = std::min(least, valueAt(function, place));
      ASSERT_LE(least, peak.value + 1e-14) << i;
    }
  }
  EXPECT_GT(repeated, 0);
}

using detail::ConvexRing;
using detail::Double2;
using detail::RingRange;

TEST(ConvexRing, FindsTheSupportVertex) {
  Random random(31);
  int walked = 0, doubtful = 0;
  const int count = scaledCount(4000);
  for (int i = 0; i < count; ++i) {
    Ring vertices = random.oneIn(4) ? rectangle(-2, -1, 2, 1) : regular(random.integer(3, 100), 1);
    const int turn = random.coin() ? 1 : -1;
    if (turn < 0) std::reverse(vertices.begin(), vertices.end());
    std::rotate(vertices.begin(), vertices.begin() + random.integer(0, static_cast<int>(vertices.size()) - 1),
                vertices.end());
    const std::size_t size = vertices.size();
    vertices.push_back(vertices.front());
    const ConvexRing ring(vertices.data(), size, turn);
    const Vec2 n = direction(random.oneIn(4) ? random.integer(0, 3) * 1.5707963267948966 : random.real(0, 6.3));
    const auto height = [&](std::uint32_t k) { return n.dot(vertices[k]); };
    double highest = height(0);
    for (std::uint32_t k = 1; k < size; ++k) highest = std::max(highest, height(k));
    EXPECT_NEAR(height(ring.supportVertex(Double2{n.x(), n.y()})), highest, 1e-15);
    // What is walked over is all that is no lower than by the doubt, wherever the walk begins.
    const double doubt = random.oneIn(3) ? 0.01 : 1e-12;
    RingRange range{static_cast<std::uint32_t>(random.integer(0, static_cast<int>(size) - 1)), 0};
    const std::uint32_t begin = range.first;
    if (!ring.supportVertex(Double2{n.x(), n.y()}, doubt, range)) continue;
    double best = height(range.first);
    for (std::uint32_t k = 0; k < range.count; ++k) best = std::max(best, height(ring.after(range.first, k)));
    EXPECT_EQ(best, highest);
    const std::uint32_t last = ring.after(range.first, range.count - 1);
    EXPECT_GT(height(range.first) - height(ring.previous(range.first)), doubt * (1 - 1e-3));
    EXPECT_GT(height(last) - height(ring.next(last)), doubt * (1 - 1e-3));
    walked += begin != range.first;
    doubtful += range.count > 1;
  }
  EXPECT_GT(walked, count / 2);
  EXPECT_GT(doubtful, count / 20);
}

/// Edges that are parallel but for rounding, the first one among them: all cross products of these two numbers'
/// multiples are whole, and far below what doubles round theirs by.
TEST(ConvexRing, FindsTheSupportVertexOfNearlyStraightChains) {
  Random random(32);
  const Vec2 step(4807526976, 2971215073),
      first(7778742049, 4807526976);  // Fibonacci numbers: their cross product is 1
  const int count = scaledCount(4000);
  for (int i = 0; i < count; ++i) {
    const int edges = random.integer(2, 20);
    Ring vertices{Vec2(0, 0)};
    for (int k = 0; k < edges; ++k) vertices.push_back(vertices.back() + first + k * step);
    vertices.emplace_back(-1e11, 1e11);
    std::rotate(vertices.begin(), vertices.begin() + random.integer(0, edges + 1), vertices.end());
    const std::size_t size = vertices.size();
    vertices.push_back(vertices.front());
    const Vec2 n = direction(random.real(0, 6.3));
    double highest = n.dot(vertices[0]);
    for (const Vec2& v : vertices) highest = std::max(highest, n.dot(v));
    const ConvexRing ring(vertices.data(), size, 1);
    ASSERT_NEAR(n.dot(vertices[ring.supportVertex(Double2{n.x(), n.y()})]), highest, 1) << i;
  }
}

}  // namespace
}  // namespace tricover::support
