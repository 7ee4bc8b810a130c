// SPDX-License-Identifier: BSD-3-Clause
// Points in polygons of many rings: by the edges along a ray as by all edges.
#include "hierarchy/inclusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

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
  const detail::PolygonData& data = detail::dataOf(polygon);
  const auto position = static_cast<std::size_t>(random.integer(0, static_cast<int>(data.path.size()) - 2));
  const Vec2 v = data.path[position], w = data.path[position + 1];
  switch (random.integer(0, 4)) {
    case 0:
      return polygon.coveringOrigin() + 8 * size * Vec2(random.real(-1, 1), random.real(-1, 1));
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

struct Tally {
  int all = 0, inside = 0, outside = 0;

  /// By the edges along a ray, which is expected to be as by all edges.
  Inclusion locate(const Polygon& polygon, const IncludedPoint& point) {
    const Inclusion found = includeInPolygon(detail::dataOf(polygon), point),
                    truth = includeInDisc(detail::dataOf(polygon), nullptr, point);
    EXPECT_EQ(found.location, truth.location);
    EXPECT_EQ(found.winding, truth.winding);
    ++all;
    inside += found.location == Location::Inside;
    outside += found.location == Location::Outside;
    return found;
  }
};

/// check(random, polygon, its size, number of the point, tally) of so many polygons and points of each.
template <typename Check>
Tally checkPoints(std::uint64_t seed, int polygons, int points, bool resized, const Check& check) {
  Tally tally;
  for (int i = 0; i < scaledCount(polygons); ++i) {
    Random random(static_cast<std::uint64_t>(i) + seed);
    const double size = !resized || random.coin() ? 1 : std::pow(2, random.integer(-900, 900));
    const Polygon polygon = manyRings(random, size);
    prepare(polygon);
    for (int k = 0; k < points && !testing::Test::HasFailure(); ++k) {
      SCOPED_TRACE(testing::Message() << i << ", " << k);
      check(random, polygon, size, k, tally);
    }
  }
  EXPECT_GE(tally.inside, tally.all / 10);
  EXPECT_LE(tally.inside, 9 * tally.all / 10);
  return tally;
}

/// Under poses, by which the point is known only roughly in the polygon's frame, or not at all so far away.
TEST(Inclusion, AlongARayUnderPoses) {
  const Polygon few = Polygon({rectangle(-1, -1, 1, 1)});
  checkPoints(1000, 1000, 6, false, [&](Random& random, const Polygon& polygon, double, int, Tally& points) {
    const Vec2 shift = std::pow(10, random.integer(0, 17)) * Vec2(random.real(-1, 1), random.real(-1, 1));
    const Pose pose_a = turnedAndMoved(random.real(0, 6.28), shift.x(), shift.y());
    const Vec2 at = pose_a * somePoint(random, polygon, 1);
    const Pose pose_b = turnedAndMoved(random.real(0, 6.28), at.x(), at.y());
    const detail::PosedPair pair(detail::dataOf(polygon), pose_a, detail::dataOf(few), pose_b);
    const Vec2 p(0, random.coin() ? 0 : 1e-17);
    points.locate(polygon, detail::seenFromA(pair, p));
  });
}

/// A point that is known only so far that it may seem to be beyond an edge, as a far pose makes of it.
TEST(Inclusion, AlongARayOfPointsKnownRoughly) {
  checkPoints(2000, 200, 100, false, [](Random& random, const Polygon& polygon, double, int, Tally& points) {
    const double error = detail::dataOf(polygon).unit * std::pow(2, random.integer(-23, -21));
    const auto aside = [&]() -> Vec2 { return error * Vec2(random.integer(-1, 1), random.integer(-1, 1)); };
    const Vec2 p = somePoint(random, polygon, 1) + 0.5 * aside(), seen = p + aside();
    points.locate(polygon, {nullptr, {seen.x(), seen.y(), 1.001 * error}, {nullptr, p}});
  });
}

}  // namespace
}  // namespace tricover::support
