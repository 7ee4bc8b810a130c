// SPDX-License-Identifier: BSD-3-Clause
// The short way to the time of impact of convex polygons, against the search through hierarchies, which takes
// the same polygons with each ring gone round several times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hierarchy/simd.h"
#include "impact/impact_solvers.h"
#include "numbers/segment.h"
#include "polygon/convexity.h"
#include "portable_lanes.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/polygon.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

using namespace detail;

/// Down to needles, around the origin or beside it.
Ring convexRing(Random& random, double size, int most = 150) {
  const Vec2 center = random.oneIn(4) ? Vec2(3 * size, -2 * size) : Vec2(0, 0);
  const Ring ring = shifted(anyConvex(random, size, most, 1e-4), center);
  return eitherWay(random, random.oneIn(6) ? withStraightVertices(random, ring) : ring);
}

/// Of polygons and of the same rings gone round often, which the search through hierarchies is asked about: the same
/// impact within the time error. Returns the latter's.
std::optional<Impact> expectTheSearchs(const Polygon& a, const Motion& motion_a, const Polygon& b,
                                       const Motion& motion_b, const ImpactOptions& options) {
  const std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b, options),
                              truth = timeOfImpact(goneRoundOften(a.rings()), motion_a, goneRoundOften(b.rings()),
                                                   motion_b, options);
  EXPECT_EQ(impact.has_value(), truth.has_value());
  if (!impact || !truth) return truth;
  EXPECT_EQ(impact->time == 0, truth->time == 0);
  EXPECT_NEAR(impact->time, truth->time, options.time_error + 1e-12);
  return truth;
}

TEST(ConvexImpact, IsTheSearchsWithinTheTimeError) {
  int convex = 0, answered = 0, hits = 0, misses = 0;
  const int count = scaledCount(20000);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Random random(static_cast<std::uint64_t>(i));
    const double size = std::pow(10, random.real(-3, 3));
    const Polygon a({convexRing(random, size)}), b({convexRing(random, size * random.real(0.05, 1))});
    const Motion motion_a = randomMotion(random, a, size), motion_b = randomMotion(random, b, size);
    ImpactOptions options;
    options.time_error = std::pow(10, random.integer(-12, -1));
    options.margin = random.oneIn(3) ? size * random.real(0, 0.5) : 0;
    const std::optional<Impact> truth = expectTheSearchs(a, motion_a, b, motion_b, options);
    hits += truth && truth->time > 0;
    misses += !truth;
    MovingPair pair = b.radius() > a.radius()
                          ? MovingPair(detail::dataOf(b), motion_b, detail::dataOf(a), motion_a, options.margin)
                          : MovingPair(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b, options.margin);
    pair.prepare();
    if (!isConvexPair(pair)) continue;
    ++convex;
    const FirstContact found = advanceAlongAxis(pair, 0, options.time_error);
    answered += found.verdict != FirstContact::Verdict::Unknown || found.time == 0;
    if (!truth) continue;
    EXPECT_LE(found.time, truth->time + options.time_error + 1e-12);
    EXPECT_NE(found.verdict, FirstContact::Verdict::Never);
  }
  EXPECT_GE(convex, 0.9 * count);
  EXPECT_GE(answered, 0.97 * convex);
  EXPECT_GE(hits, 0.1 * count);
  EXPECT_GE(misses, 0.2 * count);
}

/// Whether one of a chain's edges leads ahead along an axis may be beyond doubles: the chain's ends are still seen.
TEST(ConvexImpact, NearlyStraightChainsAreSeenWhole) {
  Ring chain = {Vec2(0, 10)};
  for (int i = -10; i <= 10; ++i) chain.emplace_back(i, 0x1p-50 * i * i);
  const Polygon a({chain}), b({{{-1, -1}, {1, -1}, {0, 0}}});
  int hits = 0;
  const int count = scaledCount(2000);
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    Random random(static_cast<std::uint64_t>(i));
    Motion motion_a = Motion::still(turnedAndMoved(random.oneIn(3) ? 0 : random.real(-4, 4), 0, 0)),
           motion_b = motion_a;
    motion_b.start.translation() = motion_a.start * Vec2(random.real(-14, 14), random.real(-9, -0.01));
    motion_b.shift = motion_a.start.linear() * Vec2(0, random.real(0, 10));
    if (random.coin()) motion_a.angle = random.real(-1, 1);
    MovingPair pair(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b);
    pair.prepare();
    ASSERT_TRUE(isConvexPair(pair));
    hits += expectTheSearchs(a, motion_a, b, motion_b, {}).has_value();
  }
  EXPECT_GE(hits, 0.3 * count);
  EXPECT_LE(hits, 0.9 * count);
}

/// Boxes at whole numbers, whose faces meet along their whole length or by an end; or any convex rings, one of which
/// may be a point, under any poses.
struct Slide {
  Polygon a, b;
  Motion motion_a, motion_b;
  double margin;
};
Polygon pointOrSegment(Random& random, double size) {
  const Vec2 start = size * Vec2(random.real(-1, 1), 0);
  const Vec2 end = start + random.real(0.05, 4) * size * direction(random.real(-4, 4));
  const Ring ring = random.oneIn(3)   ? Ring{start, start, end}
                    : random.oneIn(2) ? Ring{start, end, end}
                                      : Ring{start, end, start};
  return random.coin() ? Polygon::point(start) : Polygon({ring});
}
Slide anySlide(Random& random) {
  const auto whole = [&](int low, int high) { return static_cast<double>(random.integer(low, high)); };
  if (random.oneIn(3)) {
    const auto box = [&] { return Polygon({rectangle(whole(-4, -1), whole(-4, -1), whole(1, 4), whole(1, 4))}); };
    const Motion moving = Motion::translation(turnedAndMoved(0, whole(-12, 12), whole(5, 12)),
                                              Vec2(whole(-6, 6), random.oneIn(4) ? 0 : whole(-16, 2)));
    return {box(), box(), {}, moving, random.oneIn(4) ? 0.5 : 0};
  }
  const double size = std::pow(10, random.real(-3, 3)), far = random.oneIn(3) ? 1e6 * size : 0;
  const Polygon a({convexRing(random, size, 16)}),
      b = random.oneIn(3) ? pointOrSegment(random, size)
                          : Polygon({convexRing(random, random.real(0.05, 1) * size, 16)});
  const Vec2 start = 3 * size * direction(random.real(-4, 4)), drift = size * Vec2(random.real(-9, 9), 2);
  Motion still = Motion::translation(turnedAndMoved(random.real(-4, 4), far, far), drift);
  if (random.oneIn(4)) still.start = mirrored(still.start);
  Motion moving;
  moving.start = turnedAndMoved(random.real(-4, 4), 0, 0);
  moving.start.translation() = still.start * a.coveringOrigin() + start - moving.start * b.coveringOrigin();
  moving.shift = drift - random.real(0.5, 2) * (Eigen::Rotation2Dd(random.real(-1, 1)) * start);
  moving.pivot = b.coveringOrigin() + (random.oneIn(4) ? Vec2(size, 0) : Vec2(0, 0));
  if (detail::dataOf(b).isPoint() && random.coin()) moving.angle = random.real(-3, 3);
  return {a, b, still, moving, random.oneIn(3) ? size * random.real(0, 0.5) : 0};
}

TEST(ConvexImpact, SlidesAreSolvedAtOnce) {
  int apart = 0, plain = 0, round = 0, solved = 0, hits = 0;
  const int count = scaledCount(20000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto [a, b, motion_a, motion_b, margin] = anySlide(random);
    const ImpactOptions options{margin, 1e-12};
    const std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b, options);
    const std::optional<Impact> truth =
        timeOfImpact(goneRoundOften(a.rings()), motion_a, goneRoundOften(b.rings()), motion_b, options);
    // What comes within rounding may be a hit or none.
    const double size = a.radius() + motion_a.start.translation().norm() + motion_b.shift.norm();
    if (impact.has_value() != truth.has_value()) {
      ASSERT_TRUE(timeOfImpact(a, motion_a, b, motion_b, {margin + 1e-13 * size, 1e-12}).has_value()) << i;
      continue;
    }
    if (truth && truth->time == 0) {
      EXPECT_EQ(impact->time, 0) << i;
      continue;
    }
    ++apart;
    const bool swaps = b.radius() > a.radius();
    Impact found{};
    const FirstContact contact =
        swaps ? slideConvex(detail::dataOf(b), motion_b, detail::dataOf(a), motion_a, margin, found)
              : slideConvex(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b, margin, found);
    const auto isSmall = [](const Polygon& polygon) {
      const PolygonData* corners = cornersOf(detail::dataOf(polygon));
      return corners != nullptr && corners->path.size() <= SmallPolygon::kMost + 1;
    };
    const bool is_plain = isSmall(a) && isSmall(b) && motion_b.angle == 0 && margin == 0;
    plain += is_plain;
    round += margin > 0;
    solved += is_plain && contact.verdict != FirstContact::Verdict::Unknown;
    if (!truth) continue;
    ++hits;
    EXPECT_LE(contact.time, truth->time + 1e-11) << i;
    EXPECT_NEAR(impact->time, truth->time, 1e-9) << i;
    // There, the point is in the middle between both edges that are named, along the normal.
    const auto off = [&](const Polygon& polygon, const Motion& motion, EdgeIndex edge, const Vec2& p) {
      const Pose at = motion.at(impact->time);
      return std::sqrt(squaredDistanceToSegment(p, at * polygon.edgeStart(edge), at * polygon.edgeEnd(edge)));
    };
    const Vec2 half = 0.5 * margin * impact->normal;
    EXPECT_LT(off(a, motion_a, impact->edge_a, impact->point - half), 1e-11 * size) << i;
    EXPECT_LT(off(b, motion_b, impact->edge_b, impact->point + half), 1e-11 * size) << i;
  }
  EXPECT_GE(plain, 0.4 * apart);
  EXPECT_GE(round, 0.2 * apart);
  EXPECT_GE(solved, 0.99 * plain);
  EXPECT_GE(hits, 0.3 * apart);
  EXPECT_LE(hits, 0.8 * apart);
}

/// Of slides, the edge that parts the two longest is found at once.
TEST(ConvexImpact, SlidesEndWhereTheirLastEdgeIsMet) {
  int hits = 0, right = 0;
  for (int i = 0; i < scaledCount(2000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({convexRing(random, 1, 16)}), b({convexRing(random, random.real(0.05, 1), 16)});
    const Vec2 start = 3 * direction(random.real(-4, 4));
    const Motion motion =
        Motion::translation(turnedAndMoved(0, start.x(), start.y()), -random.real(0.5, 2) * start + a.coveringOrigin());
    const std::optional<Impact> impact = timeOfImpact(a, {}, b, motion, {0, 1e-9});
    if (!impact || impact->time == 0) continue;
    const PolygonData &of_a = detail::dataOf(a), &of_b = detail::dataOf(b);
    const PolygonData *corners_a = cornersOf(of_a), *corners_b = cornersOf(of_b);
    if (corners_a == nullptr || corners_b == nullptr) continue;
    ++hits;
    const Vec2 between = of_a.inverse_unit * (start + of_b.origin - of_a.origin),
               way = of_a.inverse_unit * motion.shift;
    const UnitMap map = {1, 0, 0, 1, between.x(), between.y(), of_b.unit * of_a.inverse_unit, 0};
    const SmallPolygon &ring_a = *hierarchyOf(*corners_a).small, &ring_b = *hierarchyOf(*corners_b).small;
    const ConvexGap entry = convexEntry(ring_a, ring_b, map, way.x(), way.y(), 0);
    right += std::abs(static_cast<double>(entry.gap) - impact->time) < 1e-4;
    const ConvexGap portable = onPortableLanes([&] { return convexEntry(ring_a, ring_b, map, way.x(), way.y(), 0); });
    ASSERT_TRUE(entry.gap == portable.gap && entry.edge == portable.edge && entry.of_a == portable.of_a) << i;
  }
  EXPECT_GE(hits, scaledCount(2000) / 4);
  EXPECT_GE(right, 0.97 * hits);
}

/// What stands still deep in each other no edge parts sooner or later: one that there is, all the same.
TEST(ConvexImpact, WhatStandsStillHasAnEdgeThatPartsIt) {
  for (const int n : {3, 8, 12})
    for (const int m : {3, 8, 12}) {
      const Polygon a({regular(n, 5)}), b({regular(m, 4)});
      const SmallPolygon &ring_a = *hierarchyOf(detail::dataOf(a)).small,
                         &ring_b = *hierarchyOf(detail::dataOf(b)).small;
      const UnitMap map = {1, 0, 0, 1, 0, 0, detail::dataOf(b).unit * detail::dataOf(a).inverse_unit, 0};
      const ConvexGap entry = convexEntry(ring_a, ring_b, map, 0, 0, 0);
      EXPECT_LT(entry.edge, entry.of_a ? ring_a.count : ring_b.count) << n << " x " << m;
      const std::optional<Impact> impact = timeOfImpact(a, {}, b, {});
      ASSERT_TRUE(impact.has_value()) << n << " x " << m;
      EXPECT_EQ(impact->time, 0);
    }
}

/// Trees are for those that come near.
TEST(TimeOfImpact, BuildsNothingWhereDiscsStayApart) {
  const Polygon a({rectangle(-1, -1, 1, 1)}), b({rectangle(-1, -1, 1, 1)});
  EXPECT_FALSE(timeOfImpact(a, {}, b, Motion::translation(turnedAndMoved(0, -9, 4), Vec2(18, 0))).has_value());
  EXPECT_TRUE(topIfBuilt(detail::dataOf(a)) == nullptr && topIfBuilt(detail::dataOf(b)) == nullptr);
  EXPECT_TRUE(timeOfImpact(a, {}, b, Motion::translation(turnedAndMoved(0, -9, 0), Vec2(18, 0))).has_value());
  EXPECT_NE(topIfBuilt(detail::dataOf(a)), nullptr);
}

}  // namespace
}  // namespace tricover::support
