// SPDX-License-Identifier: BSD-3-Clause
// locate() against the exact reference, cold and with point coherence, where signs vanish: vertices, edges, S, and the
// rays from S through vertices.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "polygon/cache_access.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/locate.h"

namespace tricover::support {
namespace {

constexpr int kPolygons = 150;
constexpr int kPointsEach = 24;

struct Tally {
  int points = 0, by_location[3] = {0, 0, 0}, disagreements = 0;
};

Vec2 degeneratePoint(Random& random, const Polygon& polygon) {
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  constexpr double kLargest = std::numeric_limits<double>::max();
  const EdgeIndex edge = anyEdge(random, polygon);
  const Vec2 v = polygon.edgeStart(edge), w = polygon.edgeEnd(edge), s = polygon.origin();
  const int ulps = random.integer(0, 2);
  switch (random.integer(0, 8)) {
    case 0:
      return v;
    case 1:
      return nudged(random, v, ulps);
    case 2:
      return nudged(random, v + random.integer(1, 7) / 8.0 * (w - v), ulps);
    case 3:
      return s;
    case 4:
      return nudged(random, s + random.integer(1, 7) / 4.0 * (v - s), ulps);
    case 5:
      return {v.x(), w.y()};
    case 6:
      return {random.coin() ? s.x() : v.x(), random.coin() ? s.y() : w.y()};
    case 7:
      return s + random.unit() * (v - s) + random.unit() * (w - s);
    default: {
      const double odd[] = {0, -0.0, kSmallest, -kSmallest, kLargest, -kLargest, 1e300, 1e-300, v.x(), v.y()};
      return {odd[random.integer(0, 9)], odd[random.integer(0, 9)]};
    }
  }
}

void check(const Polygon& polygon, const Vec2& point, PointCache& cache, PointCache& old, Tally& tally) {
  const Location truth = exact::locate(polygon, point);
  ++tally.points;
  ++tally.by_location[static_cast<int>(truth)];
  const Location cold = locate(polygon, point), cached = locate(polygon, point, cache);
  const Location stale = locate(polygon, point, old);
  if (cold == truth && cached == truth && stale == truth) return;
  if (++tally.disagreements <= 3) {
    ADD_FAILURE() << "cold " << static_cast<int>(cold) << ", cached " << static_cast<int>(cached) << ", old cache "
                  << static_cast<int>(stale) << ", truth " << static_cast<int>(truth) << "\n"
                  << reproduction(polygon, point);
  }
}

class LocateOracle : public testing::TestWithParam<Family> {};

TEST_P(LocateOracle, AgreesWithExactRationals) {
  Tally tally;
  PointCache old;
  for (int i = 0; i < scaledCount(kPolygons); ++i) {
    const auto seed = static_cast<std::uint64_t>(i) + 2000000;
    const Case c = GetParam().make(seed);
    Random random(seed);
    for (const Polygon& polygon : {c.a, c.b}) {
      PointCache cache;
      for (int k = 0; k < kPointsEach; ++k) {
        const Vec2 point = degeneratePoint(random, polygon);
        if (point.allFinite()) check(polygon, point, cache, old, tally);
      }
    }
  }
  const auto& by = tally.by_location;
  std::printf("%-22s %6d points %6d outside %6d boundary %6d inside %4d disagreements\n", GetParam().name, tally.points,
              by[0], by[1], by[2], tally.disagreements);
  EXPECT_EQ(tally.disagreements, 0);
  for (const int count : by) EXPECT_GE(count, 0.05 * tally.points);
}

INSTANTIATE_TEST_SUITE_P(Families, LocateOracle, testing::ValuesIn(familiesOfAllSizes()),
                         [](const auto& family) { return family.param.name; });

/// Squares in rows, with S among them and as large as doubles go, so many that rays are led past them.
TEST(LocateOracleRows, AgreesWithExactRationals) {
  Tally tally;
  PointCache old;
  for (int i = 0; i < scaledCount(120); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const int columns = random.integer(4, 20), rows = random.integer(1, 3), slope = random.integer(-1, 1);
    const double side = random.coin() ? 2 : random.real(0.5, 1.5);
    std::vector<Ring> rings;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const double x = 2 * column - columns, y = 2 * row + slope * x;
        rings.push_back(rectangle(x, y, x + side, y + side));
      }
    constexpr double kLargest = std::numeric_limits<double>::max();
    const double size = random.oneIn(3) ? kLargest / (2 * columns + 32) : random.oneIn(4) ? 1e-300 : 1;
    const double shift = random.coin() && size > 1 ? kLargest - (slope == 0 ? 8 : columns + 8) * size : 0;
    for (Ring& ring : rings) ring = shifted(scaled(std::move(ring), size), {0, shift});
    const Polygon polygon(redirected(random, rings), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
    PointCache cache;
    // After the first few the hierarchy is there.
    for (int k = 0; k < 3 * kPointsEach; ++k) {
      const Vec2 point = degeneratePoint(random, polygon);
      if (point.allFinite()) check(polygon, point, cache, old, tally);
    }
  }
  EXPECT_EQ(tally.disagreements, 0);
  for (const int count : tally.by_location) EXPECT_GE(count, 0.05 * tally.points);
}

/// Steps from an ulp to the whole size, so that zones are kept, left and left far behind; two points share a cache.
TEST(PointCacheWalk, EveryCachedAnswerIsTheColdOne) {
  Tally tally;
  for (int walk = 0; walk < scaledCount(200); ++walk) {
    Random random(static_cast<std::uint64_t>(walk));
    std::vector<Ring> rings = {star(random, 9, 2, 4), star(random, 5, 0.5, 1.5)};
    if (random.coin()) rings.push_back(rectangle(-3, -1, 0, 2));
    const Polygon polygon(redirected(random, rings), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
    const Polygon other = Polygon({rectangle(-2, -2, 2, 2)});
    PointCache cache, shared;
    Vec2 point = degeneratePoint(random, other);
    for (int step = 0; step < 100; ++step) {
      const double length = std::pow(10, random.integer(-17, 0));
      point += length * Vec2(random.real(-1, 1), random.real(-1, 1));
      if (random.oneIn(10) || point.norm() > 5) point = degeneratePoint(random, random.coin() ? polygon : other);
      if (!point.allFinite() || point.norm() > 100) point = {0, 0};
      check(polygon, point, cache, shared, tally);
      if (random.oneIn(5)) check(other, point, shared, shared, tally);
    }
  }
  EXPECT_EQ(tally.disagreements, 0);
  for (const int count : tally.by_location) EXPECT_GE(count, 0.01 * tally.points);
}

/// A certificate answers for a point that stays, and for most steps of one that goes through the polygon slowly.
TEST(PointCacheWalk, FactsAnswerSlowSteps) {
  Random random(5);
  const Polygon polygon({star(random, 300, 2, 4)});
  PointCache cache;
  int answered = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 point(-5 + 10.0 * i / kSteps, 0.3);
    const Location location = locate(polygon, point, cache);
    const std::uint32_t uses = detail::contentsOf(cache).uses;
    answered += uses > 0;
    PointCache copy = cache;
    EXPECT_EQ(locate(polygon, point, copy), location);
    const bool is_near = (point - polygon.origin()).norm() <= polygon.radius();  // elsewhere the disc answers
    EXPECT_EQ(detail::contentsOf(copy).uses, uses + (is_near && !detail::contentsOf(cache).back_off.isOn()))
        << "a point that stays where its certificate is from, or within reach of it";
  }
  EXPECT_GT(answered, kSteps / 2);
}

/// Of a point that jumps nothing is kept, until it moves slowly again.
TEST(PointCacheWalk, FactsRestWhileTheyDoNotPay) {
  Random random(6);
  const Polygon polygon({star(random, 300, 2, 4)});
  PointCache cache;
  int rested = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2 point(random.real(-4, 4), random.real(-4, 4));
    EXPECT_EQ(locate(polygon, point, cache), locate(polygon, point));
    rested += detail::contentsOf(cache).back_off.isOn();
  }
  EXPECT_GT(rested, 400);
  int answered = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 point(0.002 * i - 2, 0.3);
    EXPECT_EQ(locate(polygon, point, cache), locate(polygon, point));
    answered += detail::contentsOf(cache).uses > 0;
  }
  EXPECT_GT(answered, 1000);
}

/// The same edges, and yet another answer: the middle of a pentagram under either fill rule.
TEST(PointCacheWalk, APolygonsZonesAreItsOwn) {
  Ring ring;
  for (int i = 0; i < 5; ++i) ring.push_back(Vec2(std::cos(0.8 * M_PI * i), std::sin(0.8 * M_PI * i)));
  const Polygon even_odd({ring}, FillRule::EvenOdd), non_zero({ring}, FillRule::NonZero);
  PointCache cache;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(tricover::locate(even_odd, Vec2::Zero(), cache), Location::Outside);
    EXPECT_EQ(tricover::locate(non_zero, Vec2::Zero(), cache), Location::Inside);
  }
}

}  // namespace
}  // namespace tricover::support
