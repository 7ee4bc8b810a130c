// SPDX-License-Identifier: BSD-3-Clause
// Negative margins in time. Translations of convex polygons by the roots of linear functions: the depth along each
// edge's normal is linear in time, and the depth is the least of these. All others against depths at many times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "conflict_laws.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/segment.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

using Real = long double;

/// The time in which b, translated by t times `way`, is deeper than `allowed` in a; empty if begin >= end.
struct Interval {
  Real begin, end;
};

Interval deepInterval(const Ring& a, const Ring& b, const Vec2& from, const Vec2& way, double allowed) {
  Interval deep{0, 1};
  const auto cut = [&](const Ring& own, const Ring& other, Real sign) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Vec2 &v = own[i], &w = own[(i + 1) % own.size()];
      const Real x = Real{w.y()} - v.y(), y = Real{v.x()} - w.x(), length = std::sqrt(x * x + y * y);
      if (length == 0) continue;
      Real least = 0;
      bool first = true;
      for (const Vec2& p : other) {
        const Real height = (x * (Real{p.x()} - v.x()) + y * (Real{p.y()} - v.y())) / length;
        least = first ? height : std::min(least, height);
        first = false;
      }
      // Outwards from this face the other polygon is lowest at `least`, and moves by sign * n . (from + t way).
      const Real at_start = -(least + sign * (x * from.x() + y * from.y()) / length) - allowed;
      const Real rate = -sign * (x * way.x() + y * way.y()) / length;
      if (rate == 0) {
        if (at_start <= 0) deep.end = -1;
      } else if (rate > 0) {
        deep.begin = std::max(deep.begin, -at_start / rate);
      } else {
        deep.end = std::min(deep.end, -at_start / rate);
      }
    }
  };
  cut(a, b, 1);
  cut(b, a, -1);
  return deep;
}

TEST(NegativeMarginOracle, TranslationsOfConvexPolygonsAreRootsOfLinearFunctions) {
  int apart = 0, allowed_overlaps = 0, later = 0, at_once = 0, left_out = 0;
  const int cases = scaledCount(4000);
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    Random random(static_cast<std::uint64_t>(i));
    const Ring a = anyConvex(random, 1, 16), b = anyConvex(random, random.coin() ? 1 : 0.3, 16);
    const Vec2 through(random.real(-2, 2), random.real(-2, 2)), way(random.real(-6, 6), random.real(-6, 6));
    // Half of them start in each other.
    const Vec2 from = through - random.real(0, random.coin() ? 1.2 : 0.2) * way;
    const double allowed = random.coin() ? std::pow(10, random.real(-9, -1)) : random.real(0.01, 1);
    const Polygon p(a), q(b);
    const Motion rests = Motion::still(Pose::Identity()),
                 moves = Motion::translation(tricover::pose(from.x(), from.y()), way);
    const double speed = way.norm(), slack = 1e-11 / speed, error = std::pow(10, -random.integer(2, 12));
    const Interval deep = deepInterval(a, b, from, way, allowed);
    const Interval surely = deepInterval(a, b, from, way, allowed + 1e-11),
                   maybe = deepInterval(a, b, from, way, allowed - 1e-11);
    const bool is_deep = deep.begin < deep.end;
    // Grazing.
    if ((surely.begin < surely.end) != (maybe.begin < maybe.end) || (is_deep && maybe.end - maybe.begin < 1e-9)) {
      ++left_out;
      continue;
    }
    ImpactOptions options{-allowed, error};
    const auto impact =
        random.coin() ? timeOfImpact(p, rests, q, moves, options) : timeOfImpact(q, moves, p, rests, options);
    ASSERT_EQ(impact.has_value(), is_deep);
    const auto found = conflicts(p, rests, q, moves, options);
    ASSERT_EQ(found.size(), is_deep ? 1u : 0u);
    if (!is_deep) {
      const Interval touch = deepInterval(a, b, from, way, 0);
      ++(touch.begin < touch.end ? allowed_overlaps : apart);
      continue;
    }
    const auto begin = static_cast<double>(deep.begin), end = static_cast<double>(deep.end);
    EXPECT_FALSE(impact->budget_ended || found[0].budget_ended);
    for (const double time : {impact->time, found[0].impact.time}) {
      EXPECT_LE(time, static_cast<double>(surely.begin) + slack);
      EXPECT_GE(time, static_cast<double>(maybe.begin) - error - slack);
    }
    EXPECT_TRUE(impact->time == 0 || begin > 0 || surely.begin > 0);
    EXPECT_GE(found[0].end, static_cast<double>(surely.end) - slack);
    EXPECT_LE(found[0].end, std::min(1.0, static_cast<double>(maybe.end) + std::max(error, 1e-9) + slack));
    EXPECT_LE(end, 1);
    ++(begin == 0 ? at_once : later);
  }
  std::printf("%d apart, %d overlaps that are allowed, %d impacts, %d at once, %d left out\n", apart, allowed_overlaps,
              later, at_once, left_out);
  for (const int some : {apart, allowed_overlaps, later, at_once}) EXPECT_GT(20 * some, cases);
  EXPECT_LT(20 * left_out, cases);
}

Vec2 anyVec(Random& random, double most) { return {random.real(-most, most), random.real(-most, most)}; }
Polygon anyStar(Random& random, double size) { return Polygon({star(random, random.integer(3, 9), 0.3 * size, size)}); }
Trajectory whole(const Motion& motion) { return Trajectory({{0, 1, motion}}); }
Trajectory still() { return whole(Motion::still(Pose::Identity())); }

/// A crate on a floor with steps, along it: over gaps, into walls, off the end.
Flight floors(Random& random) {
  Ring floor{{-8, -2}, {8, -2}};
  double x = 8, y = 0;
  while (x > -8) {
    floor.emplace_back(x, y);
    x = std::max(-8.0, x - random.real(0.5, 6));
    floor.emplace_back(x, y);
    if (random.oneIn(3)) y += random.real(-0.5, 0.5);
  }
  const double allowed = std::pow(10, random.real(-6, -1)), from = random.real(-6, 6);
  const Motion slides =
      random.coin()
          ? Motion::translation(tricover::pose(from, 0.5 + random.real(-0.9, 0.5) * allowed), {random.real(-20, 20), 0})
          : Motion::spline({{from, 0.5}, 0, {9, 0}, 0}, {{random.real(-6, 6), 0.5}, 0, {9, 0}, 0});
  return {Polygon(floor), still(), box(1, 1), whole(slides), -allowed};
}

Flight turns(Random& random) {
  Motion motion = Motion::still(support::pose(random.real(0, 6), random.real(-3, 3), random.real(-3, 3)));
  motion.angle = random.real(-6, 6);
  motion.shift = anyVec(random, 4);
  return {anyStar(random, 1), still(), Polygon({rectangle(-1, -0.2, random.real(1, 4), 0.2)}), whole(motion),
          -random.real(0.001, 0.05)};
}

Flight splines(Random& random) {
  const auto any = [&] {
    return whole(Motion::spline({anyVec(random, 2), random.real(-3, 3), anyVec(random, 8), random.real(-3, 3)},
                                {anyVec(random, 2), random.real(-3, 3), anyVec(random, 8), random.real(-3, 3)}));
  };
  return {Polygon(anyConvex(random, 1, 8)), any(), Polygon(anyConvex(random, 1, 8)), any(), -random.real(0.001, 0.5)};
}

Flight combs(Random& random) {
  const Ring teeth = comb(random.integer(2, 4), 4, 1.5, 2);
  const Vec2 from = anyVec(random, 3) - Vec2(12, random.real(0, 4));
  return {Polygon({teeth}), still(), Polygon({teeth}),
          whole(Motion::translation(support::pose(M_PI, from.x(), from.y()), Vec2(24, random.real(-4, 4)))),
          -random.real(0.001, 0.05)};
}

Flight trajectories(Random& random) {
  return {Polygon(anyConvex(random, 1, 8)), anyPlan(random), anyStar(random, 1), anyPlan(random),
          -random.real(0.001, 0.05)};
}

/// The local depth jumps where components join or separate, as trajectories of stars do in 1 of 2,000 cases. What is
/// proven by the depth then ends too late, or begins too late.
struct Kind {
  const char* name;
  Flight (*make)(Random& random);
  bool jumps;
};
constexpr Kind kKinds[] = {{"floors", floors, false},
                           {"turns", turns, false},
                           {"splines", splines, false},
                           {"combs", combs, false},
                           {"trajectories", trajectories, true}};

TEST(NegativeMarginOracle, ConflictsAreWhereDepthsSaySo) {
  const Meet isDeep = [](const Case& c, double margin) { return collide(c.a, c.pose_a, c.b, c.pose_b, {margin, 0}); };
  ConflictCounts all;
  for (const Kind& kind : kKinds) {
    ConflictCounts counts;
    const int cases = scaledCount(200);
    int jumped = 0;
    for (int i = 0; i < cases; ++i) {
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(i));
      Random random(static_cast<std::uint64_t>(1000 * (&kind - kKinds) + i));
      const double error = std::pow(10, -random.integer(2, 5));
      const Flight flight = kind.make(random);
      const std::string wrong = wrongConflicts(flight, error, isDeep, counts);
      jumped += !wrong.empty() && kind.jumps;
      EXPECT_TRUE(wrong.empty() || kind.jumps) << wrong << ", " << error << " " << flight.margin;
    }
    std::printf(
        "%-14s %4d cases %4d without %4d with one %4d with more (%d spans) %4d at once %4d until the end %d short\n",
        kind.name, counts.cases, counts.none, counts.one, counts.more, counts.spans, counts.at_begin, counts.until_end,
        counts.unseen);
    EXPECT_LE(200 * jumped, cases);
    for (int ConflictCounts::*each :
         {&ConflictCounts::cases, &ConflictCounts::none, &ConflictCounts::one, &ConflictCounts::more,
          &ConflictCounts::at_begin, &ConflictCounts::until_end, &ConflictCounts::spans})
      all.*each += counts.*each;
  }
  for (const int some : {all.none, all.one, all.more, all.at_begin, all.until_end}) EXPECT_GT(30 * some, all.cases);
}

}  // namespace
}  // namespace tricover::support
