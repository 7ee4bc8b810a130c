// SPDX-License-Identifier: BSD-3-Clause
// The short way to the time of impact of convex polygons, against the search through hierarchies, which takes
// the same polygons with each ring gone round several times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "hierarchy/simd.h"
#include "impact/impact_solvers.h"
#include "polygon/convexity.h"
#include "portable_lanes.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/distance.h"
#include "tricover/segment.h"
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

TEST(ConvexImpact, IsTheSearchsWithinTheTimeError) {
  int convex = 0, answered = 0, hits = 0, misses = 0, at_start = 0;
  const int count = scaledCount(20000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = std::pow(10, random.real(-3, 3));
    const Ring ring_a = convexRing(random, size), ring_b = convexRing(random, size * random.real(0.05, 1));
    const Polygon a({ring_a}), b({ring_b});
    const Motion motion_a = randomMotion(random, a, size), motion_b = randomMotion(random, b, size);
    ImpactOptions options;
    options.time_error = std::pow(10, random.integer(-12, -1));
    options.margin = random.oneIn(3) ? size * random.real(0, 0.5) : 0;
    const std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b, options);
    const std::optional<Impact> truth =
        timeOfImpact(goneRoundOften({ring_a}), motion_a, goneRoundOften({ring_b}), motion_b, options);
    ASSERT_EQ(impact.has_value(), truth.has_value()) << i;
    const bool swaps = b.radius() > a.radius();
    MovingPair pair = swaps ? MovingPair(b.data(), motion_b, a.data(), motion_a, options.margin)
                            : MovingPair(a.data(), motion_a, b.data(), motion_b, options.margin);
    pair.prepare();
    if (isConvexPair(pair)) {
      ++convex;
      const FirstContact found = advanceAlongAxis(pair, 0, options.time_error);
      answered += found.verdict != FirstContact::Verdict::Unknown || found.time == 0;
      if (truth) {
        EXPECT_LE(found.time, truth->time + options.time_error + 1e-12) << i;
        EXPECT_NE(found.verdict, FirstContact::Verdict::Never) << i;
      }
    }
    if (!impact) {
      ++misses;
      continue;
    }
    ++hits;
    at_start += impact->time == 0;
    EXPECT_EQ(impact->time == 0, truth->time == 0) << i;
    EXPECT_NEAR(impact->time, truth->time, options.time_error + 1e-12) << i;
    // Where it says, the edges are about as far apart as they should be.
    if (options.time_error > 1e-9 || impact->time == 0) continue;
    const DistanceResult apart = distance(a, motion_a.at(impact->time), b, motion_b.at(impact->time));
    EXPECT_NEAR(apart.distance, options.margin, size * (100 * options.time_error + 1e-12)) << i;
    EXPECT_NEAR(((apart.point_a + apart.point_b) / 2 - impact->point).dot(impact->normal), 0,
                size * (100 * options.time_error + 1e-9))
        << i;
  }
  std::printf("%d pairs, %d of them asked, %d answered, %d hits, %d of them at the start, %d misses\n", count, convex,
              answered, hits, at_start, misses);
  EXPECT_GE(convex, 0.9 * count);
  EXPECT_GE(answered, 0.97 * convex);
  EXPECT_GE(hits, 0.2 * count);
  EXPECT_GE(hits - at_start, 0.1 * count);
  EXPECT_GE(misses, 0.2 * count);
}

/// Whether one of a chain's edges leads ahead along an axis may be beyond doubles: the chain's ends are still seen.
TEST(ConvexImpact, NearlyStraightChainsAreSeenWhole) {
  Ring chain = {Vec2(0, 10)};
  for (int i = -10; i <= 10; ++i) chain.emplace_back(i, 0x1p-50 * i * i);
  const Ring triangle = {Vec2(-1, -1), Vec2(1, -1), Vec2(0, 0)};
  const Polygon a({chain}), b({triangle});
  int hits = 0;
  const int count = scaledCount(2000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    Motion motion_a = Motion::still(turnedAndMoved(random.oneIn(3) ? 0 : random.real(-4, 4), 0, 0)),
           motion_b = motion_a;
    motion_b.start.translation() = motion_a.start * Vec2(random.real(-14, 14), random.real(-9, -0.01));
    motion_b.shift = motion_a.start.linear() * Vec2(0, random.real(0, 10));
    if (random.coin()) motion_a.angle = random.real(-1, 1);
    MovingPair pair(a.data(), motion_a, b.data(), motion_b);
    pair.prepare();
    ASSERT_TRUE(isConvexPair(pair));
    const std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b);
    const std::optional<Impact> truth =
        timeOfImpact(goneRoundOften({chain}), motion_a, goneRoundOften({triangle}), motion_b);
    ASSERT_EQ(impact.has_value(), truth.has_value()) << i;
    if (!impact) continue;
    ++hits;
    EXPECT_NEAR(impact->time, truth->time, 1.1e-6) << i;
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
  return random.coin() ? point(start) : Polygon({ring});
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
  moving.start.translation() = still.start * a.origin() + start - moving.start * b.origin();
  moving.shift = drift - random.real(0.5, 2) * (Eigen::Rotation2Dd(random.real(-1, 1)) * start);
  moving.pivot = b.origin() + (random.oneIn(4) ? Vec2(size, 0) : Vec2(0, 0));
  if (b.data().isPoint() && random.coin()) moving.angle = random.real(-3, 3);
  return {a, b, still, moving, random.oneIn(3) ? size * random.real(0, 0.5) : 0};
}

TEST(ConvexImpact, SlidesAreSolvedAtOnce) {
  int apart = 0, plain = 0, round = 0, solved = 0, hits = 0, level = 0;
  const int count = scaledCount(20000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Slide slide = anySlide(random);
    const ImpactOptions options{slide.margin, 1e-12};
    const std::optional<Impact> impact = timeOfImpact(slide.a, slide.motion_a, slide.b, slide.motion_b, options);
    const std::optional<Impact> truth = timeOfImpact(goneRoundOften(slide.a.rings()), slide.motion_a,
                                                     goneRoundOften(slide.b.rings()), slide.motion_b, options);
    // What comes within rounding may be a hit or none.
    const double size = slide.a.radius() + slide.motion_a.start.translation().norm() + slide.motion_b.shift.norm();
    if (impact.has_value() != truth.has_value()) {
      const ImpactOptions wider{slide.margin + 1e-13 * size, 1e-12};
      ASSERT_TRUE(timeOfImpact(slide.a, slide.motion_a, slide.b, slide.motion_b, wider).has_value()) << i;
      continue;
    }
    if (truth && truth->time == 0) {
      EXPECT_EQ(impact->time, 0) << i;
      continue;
    }
    ++apart;
    const bool swaps = slide.b.radius() > slide.a.radius();
    const Polygon &a = swaps ? slide.b : slide.a, &b = swaps ? slide.a : slide.b;
    Impact found{};
    const FirstContact contact = slideConvex(a.data(), swaps ? slide.motion_b : slide.motion_a, b.data(),
                                             swaps ? slide.motion_a : slide.motion_b, slide.margin, found);
    const auto isSmall = [](const Polygon& polygon) {
      const PolygonData* corners = cornersOf(polygon.data());
      return corners != nullptr && corners->path.size() <= SmallPolygon::kMost + 1;
    };
    const bool is_plain = isSmall(a) && isSmall(b) && slide.motion_b.angle == 0 && slide.margin == 0;
    plain += is_plain;
    round += slide.margin > 0;
    solved += is_plain && contact.verdict != FirstContact::Verdict::Unknown;
    if (!truth) continue;
    ++hits;
    EXPECT_LE(contact.time, truth->time + 1e-11) << i;
    EXPECT_NEAR(impact->time, truth->time, 1e-9) << i;
    // There, the point is in the middle between both edges that are named, along the normal.
    const auto isOn = [&](const Polygon& polygon, const Motion& motion, EdgeIndex edge, double side) {
      const Ring& ring = polygon.rings()[0];
      const auto e = static_cast<std::size_t>(edge);
      const Pose at = motion.at(impact->time);
      const Polygon of_edge = segment(at * ring[e], at * ring[(e + 1) % ring.size()]);
      const Vec2 p = impact->point + side * 0.5 * slide.margin * impact->normal;
      return distance(of_edge, Pose::Identity(), point(p), Pose::Identity()).distance < 1e-11 * size;
    };
    EXPECT_TRUE(isOn(slide.a, slide.motion_a, impact->edge_a, -1)) << i;
    EXPECT_TRUE(isOn(slide.b, slide.motion_b, impact->edge_b, 1)) << i;
    EXPECT_NEAR(impact->normal.norm(), 1, 1e-12) << i;
    level += std::abs(impact->normal.x()) == 1 || std::abs(impact->normal.y()) == 1;
  }
  std::printf(
      "%d slides, %d apart at first, %d of %d small ones without a margin solved, %d with one, %d hits, %d of them "
      "level\n",
      count, apart, solved, plain, round, hits, level);
  EXPECT_GE(plain, 0.4 * apart);
  EXPECT_GE(round, 0.2 * apart);
  EXPECT_GE(solved, 0.99 * plain);
  EXPECT_GE(hits, 0.3 * apart);
  EXPECT_LE(hits, 0.8 * apart);
  EXPECT_GE(level, 0.1 * hits);
}

/// Of slides, the edge that parts the two longest is found at once.
TEST(ConvexImpact, SlidesEndWhereTheirLastEdgeIsMet) {
  int hits = 0, right = 0;
  for (int i = 0; i < scaledCount(2000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({convexRing(random, 1, 16)}), b({convexRing(random, random.real(0.05, 1), 16)});
    const Vec2 start = 3 * direction(random.real(-4, 4));
    const Motion motion =
        Motion::translation(turnedAndMoved(0, start.x(), start.y()), -random.real(0.5, 2) * start + a.origin());
    const std::optional<Impact> impact = timeOfImpact(a, {}, b, motion, {0, 1e-9});
    if (!impact || impact->time == 0) continue;
    const PolygonData &of_a = a.data(), &of_b = b.data();
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
  std::printf("%d hits, %d found at once\n", hits, right);
  EXPECT_GE(hits, scaledCount(2000) / 4);
  EXPECT_GE(right, 0.97 * hits);
}

/// Of two discs, by the root of a square.
TEST(ConvexImpact, DiscsMeetWhereTheirCentresAreSoFarApart) {
  int hits = 0;
  const int count = scaledCount(2000);
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = point({1, 2}), b = point({-3, 0});
    const Vec2 apart = 10 * direction(random.real(-4, 4)), drift(random.real(-5, 5), 1);
    const Vec2 way = -2 * (Eigen::Rotation2Dd(random.real(-0.3, 0.3)) * apart);
    const Motion motion_a = Motion::translation(turnedAndMoved(random.real(-4, 4), 5, 0), drift);
    Motion motion_b = Motion::translation(turnedAndMoved(random.real(-4, 4), 0, 0), way + drift);
    motion_b.start.translation() = motion_a.start * Vec2(1, 2) + apart - motion_b.start * Vec2(-3, 0);
    const double margin = random.real(0, 3), half = apart.dot(way),
                 root = half * half - way.squaredNorm() * (apart.squaredNorm() - margin * margin);
    const std::optional<Impact> impact = timeOfImpact(a, motion_a, b, motion_b, {margin, 1e-12});
    if (std::abs(root) < 1e-9) continue;
    ASSERT_EQ(impact.has_value(), root > 0) << i;
    if (root < 0) continue;
    ++hits;
    // The centres where the poses put them: a glancing contact's time depends on their last digits.
    using Wide = Eigen::Matrix<long double, 2, 1>;
    const auto centre = [](const Pose& pose, const Vec2& p) -> Wide {
      return pose.linear().cast<long double>() * p.cast<long double>() + pose.translation().cast<long double>();
    };
    const Wide from = centre(motion_b.start, {-3, 0}) - centre(motion_a.start, {1, 2}),
               path = motion_b.shift.cast<long double>() - motion_a.shift.cast<long double>();
    const long double h = from.dot(path), square = path.squaredNorm();
    const auto entry = [&](long double reach) {
      return (-h - std::sqrt(h * h - square * (from.squaredNorm() - reach * reach))) / square;
    };
    // What comes within 1e-13 L counts as contact.
    const double lengths = margin + apart.norm() + way.norm() + 2 * drift.norm() + 1;
    EXPECT_LE(impact->time, entry(margin) + 1e-15L) << i;
    EXPECT_GE(impact->time, entry(margin + 1e-13L * lengths) - 1e-12L) << i;
    const Vec2 between = apart + impact->time * way;
    EXPECT_LT((margin * impact->normal - between).norm(), 1e-10) << i;
    EXPECT_LT((motion_a.at(impact->time) * Vec2(1, 2) + 0.5 * between - impact->point).norm(), 1e-10) << i;
  }
  EXPECT_GE(hits, 0.3 * count);
  EXPECT_LE(hits, 0.9 * count);
}

/// What stands still deep in each other no edge parts sooner or later: one that there is, all the same.
TEST(ConvexImpact, WhatStandsStillHasAnEdgeThatPartsIt) {
  for (const int n : {3, 8, 12})
    for (const int m : {3, 8, 12}) {
      const Polygon a({regular(n, 5)}), b({regular(m, 4)});
      const SmallPolygon &ring_a = *hierarchyOf(a.data()).small, &ring_b = *hierarchyOf(b.data()).small;
      const UnitMap map = {1, 0, 0, 1, 0, 0, b.data().unit * a.data().inverse_unit, 0};
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
  const Motion passes = Motion::translation(turnedAndMoved(0, -9, 4), Vec2(18, 0)),
               hits = Motion::translation(turnedAndMoved(0, -9, 0), Vec2(18, 0));
  EXPECT_FALSE(timeOfImpact(a, {}, b, passes).has_value());
  EXPECT_EQ(topIfBuilt(a.data()), nullptr);
  EXPECT_EQ(topIfBuilt(b.data()), nullptr);
  EXPECT_TRUE(timeOfImpact(a, {}, b, hits).has_value());
  EXPECT_NE(topIfBuilt(a.data()), nullptr);
}

}  // namespace
}  // namespace tricover::support
