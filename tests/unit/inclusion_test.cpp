// SPDX-License-Identifier: BSD-3-Clause
// Points in polygons of many rings: by the edges along a ray as by all edges, and as exact rationals say.
#include "hierarchy/inclusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "exact_reference.h"
#include "pair/posed_pair.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/prepare.h"

namespace tricover::support {
namespace {

using detail::IncludedPoint;
using detail::Inclusion;

/// Speckles on a grid, rings in rings either way round, rings over each other, slivers and rings without area; all of
/// them times `size` and moved by a whole number of it, perhaps so far that doubles know nothing between those numbers.
Polygon manyRings(Random& random, double size) {
  const Vec2 shift = random.oneIn(4) ? Vec2(0x1p52, 0x1p52) : Vec2(random.coin() ? 1000 : 0, 0);
  std::vector<Ring> rings;
  for (int n = random.integer(16, 60); n > 0; --n) {
    const Vec2 at(random.integer(0, 12), random.integer(0, 12));
    Ring ring;
    switch (random.integer(0, 4)) {
      case 0:
        ring = rectangle(at.x(), at.y(), at.x() + 1, at.y() + 1);
        break;
      case 1:
        ring = rectangle(6 - at.x(), 6 - at.x(), 6 + at.x() + 1, 6 + at.x() + 1);
        break;
      case 2:
        ring = star(random, random.integer(3, random.coin() ? 8 : 40), 0.5, 4, at);
        break;
      case 3:
        ring = {at, at + Vec2(random.integer(1, 5), 0), at + Vec2(random.integer(0, 5), 1e-9)};
        break;
      default:
        ring = {at, at + Vec2(random.integer(0, 4), random.integer(0, 4)), at};
    }
    if (random.coin()) std::reverse(ring.begin(), ring.end());
    for (Vec2& p : ring) p = size * (p + shift);
    rings.push_back(ring);
  }
  return Polygon(rings, random.coin() ? FillRule::NonZero : FillRule::EvenOdd);
}

/// Anywhere, on the grid, at vertices and beside them, on edges but for rounding.
Vec2 somePoint(Random& random, const Polygon& polygon, double size) {
  const detail::PolygonData& data = polygon.data();
  const auto position = static_cast<std::size_t>(random.integer(0, static_cast<int>(data.path.size()) - 2));
  const Vec2 v = data.path[position], w = data.path[position + 1];
  switch (random.integer(0, 4)) {
    case 0:
      return polygon.origin() + 8 * size * Vec2(random.real(-1, 1), random.real(-1, 1));
    case 1:
      return size * (v / size + Vec2(random.integer(-2, 2), random.integer(-2, 2)));
    case 2:
      return v;
    case 3:
      return v + size * std::pow(10, random.integer(-16, -1)) * Vec2(random.real(-1, 1), random.real(-1, 1));
    default:
      return v + random.real(0, 1) * (w - v);
  }
}

/// By the edges along a ray, which is expected to be as by all edges.
Inclusion located(const Polygon& polygon, const IncludedPoint& point) {
  const Inclusion found = includeInPolygon(polygon.data(), point), truth = includeInCovering(polygon.data(), point);
  EXPECT_EQ(found.location, truth.location);
  EXPECT_EQ(found.winding, truth.winding);
  return found;
}

TEST(Inclusion, AlongARayIsAsByAllEdges) {
  int inside = 0, outside = 0, boundary = 0;
  for (int i = 0; i < scaledCount(300); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = random.coin() ? 1 : std::pow(2, random.integer(-900, 900));
    const Polygon polygon = manyRings(random, size);
    prepare(polygon);
    for (int k = 0; k < 60; ++k) {
      const Vec2 p = somePoint(random, polygon, size);
      const Inclusion found = located(polygon, IncludedPoint::ofFrame(p));
      ASSERT_FALSE(testing::Test::HasFailure()) << i << ", " << k;
      if (k < 10) {
        ASSERT_EQ(found.location, exact::locate(polygon, p)) << i << ", " << k;
      }
      ++(found.location == Location::Inside ? inside : found.location == Location::Outside ? outside : boundary);
    }
  }
  std::printf("%d inside, %d outside, %d on the boundary\n", inside, outside, boundary);
  const int all = inside + outside + boundary;
  EXPECT_GE(inside, all / 10);
  EXPECT_GE(outside, all / 10);
  EXPECT_GE(boundary, all / 10);
}

/// Under poses, by which the point is known only roughly in the polygon's frame, or not at all so far away.
TEST(Inclusion, AlongARayUnderPoses) {
  int inside = 0, all = 0;
  for (int i = 0; i < scaledCount(200); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1000);
    const Polygon polygon = manyRings(random, 1), few = Polygon({rectangle(-1, -1, 1, 1)});
    prepare(polygon);
    const double far = std::pow(10, random.integer(0, 17));
    const Vec2 shift = far * Vec2(random.real(-1, 1), random.real(-1, 1));
    const Pose pose_a = pose(random.real(0, 6.28), shift.x(), shift.y());
    for (int k = 0; k < 30; ++k) {
      const Vec2 at = pose_a * somePoint(random, polygon, 1);
      const Pose pose_b = pose(random.real(0, 6.28), at.x(), at.y());
      const detail::PosedPair pair(polygon.data(), pose_a, few.data(), pose_b);
      const Vec2 p(0, random.coin() ? 0 : 1e-17);
      const detail::SeenFromA seen(pair);
      const IncludedPoint point{&pair.pose_a, seen.at(p), {&pair.pose_b, p}, seen.handed()};
      const Inclusion found = located(polygon, point);
      ASSERT_FALSE(testing::Test::HasFailure()) << i << ", " << k;
      inside += found.location == Location::Inside;
      ++all;
    }
  }
  EXPECT_GE(inside, all / 10);
  EXPECT_LE(inside, 9 * all / 10);
}

/// A point that is known only so far that it may seem to be beyond an edge, as a far pose makes of it.
TEST(Inclusion, AlongARayOfPointsKnownRoughly) {
  int inside = 0, all = 0;
  for (int i = 0; i < scaledCount(200); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 2000);
    const Polygon polygon = manyRings(random, 1);
    prepare(polygon);
    for (int k = 0; k < 100; ++k) {
      const double error = polygon.data().unit * std::pow(2, random.integer(-23, -21));
      const auto aside = [&]() -> Vec2 { return error * Vec2(random.integer(-1, 1), random.integer(-1, 1)); };
      const Vec2 p = somePoint(random, polygon, 1) + 0.5 * aside(), seen = p + aside();
      const IncludedPoint point{nullptr, {seen.x(), seen.y(), 1.001 * error}, {nullptr, p}, 1};
      const Inclusion found = located(polygon, point);
      ASSERT_FALSE(testing::Test::HasFailure()) << i << ", " << k;
      inside += found.location == Location::Inside;
      ++all;
    }
  }
  EXPECT_GE(inside, all / 10);
  EXPECT_LE(inside, 9 * all / 10);
}

}  // namespace
}  // namespace tricover::support
