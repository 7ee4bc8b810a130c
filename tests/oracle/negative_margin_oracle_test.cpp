// SPDX-License-Identifier: BSD-3-Clause
// Negative margins in time. Translations of convex polygons by the roots of linear functions: one is e deep in the
// other while it meets what is left of that when each of its sides moves inwards by e. All others against depths at
// many times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
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

struct Interval {
  Real begin, end;
};
struct Spot {
  Real x, y;
};
using Outline = std::vector<Spot>;

Outline outlineOf(const Ring& ring) {
  Outline result;
  for (const Vec2& p : ring) result.push_back({p.x(), p.y()});
  return result;
}

/// What is at least `deep` inside of a convex ring that runs counter-clockwise.
Outline inner(const Outline& ring, Real deep) {
  Outline left = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Spot &v = ring[i], &w = ring[(i + 1) % ring.size()];
    const Real x = v.y - w.y, y = w.x - v.x, length = std::hypot(x, y);
    if (length == 0) continue;
    const auto height = [&](const Spot& p) { return (x * (p.x - v.x) + y * (p.y - v.y)) / length - deep; };
    Outline cut;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const Spot &p = left[k], &q = left[(k + 1) % left.size()];
      const Real at_p = height(p), at_q = height(q);
      if (at_p >= 0) cut.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
        const Real share = at_p / (at_p - at_q);
        cut.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
      }
    }
    left = cut;
  }
  return left;
}

/// The time in which b, translated by `from` and t times `way`, meets a; empty if begin >= end.
Interval meeting(const Outline& a, const Outline& b, const Vec2& from, const Vec2& way) {
  Interval time{0, 1};
  if (a.size() < 3 || b.size() < 3) return {0, -1};
  const auto cut = [&](const Outline& own, const Outline& other, Real sign) {
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Spot &v = own[i], &w = own[(i + 1) % own.size()];
      const Real x = w.y - v.y, y = v.x - w.x, length = std::hypot(x, y);
      if (length == 0) continue;
      Real least = std::numeric_limits<Real>::infinity();
      for (const Spot& p : other) least = std::min(least, (x * (p.x - v.x) + y * (p.y - v.y)) / length);
      // Outwards from this face the other polygon is lowest at `least`, and moves by sign * n . (from + t way).
      const Real at_start = -(least + sign * (x * from.x() + y * from.y()) / length);
      const Real rate = -sign * (x * way.x() + y * way.y()) / length;
      if (rate == 0) {
        if (at_start <= 0) time.end = -1;
      } else if (rate > 0) {
        time.begin = std::max(time.begin, -at_start / rate);
      } else {
        time.end = std::min(time.end, -at_start / rate);
      }
    }
  };
  cut(a, b, 1);
  cut(b, a, -1);
  return time;
}

/// The times in which either has a point `deep` inside of the other one, in order.
std::vector<Interval> deepIntervals(const Ring& a, const Ring& b, const Vec2& from, const Vec2& way, Real deep) {
  const Outline p = outlineOf(a), q = outlineOf(b);
  std::vector<Interval> all;
  for (const Interval& time : {meeting(inner(p, deep), q, from, way), meeting(p, inner(q, deep), from, way)})
    if (time.begin < time.end) all.push_back(time);
  if (all.size() == 2 && all[1].begin < all[0].begin) std::swap(all[0], all[1]);
  if (all.size() == 2 && all[1].begin <= all[0].end) {
    all[0].end = std::max(all[0].end, all[1].end);
    all.pop_back();
  }
  return all;
}

/// Whether rounding may change how many there are.
bool isDelicate(const std::vector<Interval>& surely, const std::vector<Interval>& maybe) {
  if (surely.size() != maybe.size()) return true;
  for (const Interval& time : maybe)
    if (time.end - time.begin < 1e-9) return true;
  return maybe.size() == 2 && maybe[1].begin - maybe[0].end < 1e-2;
}

TEST(NegativeMarginOracle, TranslationsOfConvexPolygonsAreRootsOfLinearFunctions) {
  int apart = 0, allowed_overlaps = 0, later = 0, at_once = 0, twice = 0, left_out = 0;
  const int cases = scaledCount(4000);
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    Random random(static_cast<std::uint64_t>(i));
    const Ring a = anyConvex(random, 1, 16), b = anyConvex(random, random.coin() ? 1 : 0.3, 16);
    const Vec2 through(random.real(-2, 2), random.real(-2, 2)), way(random.real(-6, 6), random.real(-6, 6));
    // Half of them start in each other.
    const Vec2 from = through - random.real(0, random.coin() ? 1.2 : 0.2) * way;
    const double allowed = random.coin() ? std::pow(10, random.real(-9, -1)) : random.real(0.01, 0.5);
    const Polygon p(a), q(b);
    const Motion rests = Motion::still(Pose::Identity()),
                 moves = Motion::translation(tricover::pose(from.x(), from.y()), way);
    const double speed = way.norm(), slack = 1e-11 / speed, error = std::pow(10, -random.integer(2, 12));
    const auto deep = deepIntervals(a, b, from, way, allowed),
               surely = deepIntervals(a, b, from, way, allowed + 1e-11L),
               maybe = deepIntervals(a, b, from, way, allowed - 1e-11L);
    if (isDelicate(surely, maybe) || deep.size() != maybe.size()) {
      ++left_out;
      continue;
    }
    ImpactOptions options{-allowed, error};
    const auto impact =
        random.coin() ? timeOfImpact(p, rests, q, moves, options) : timeOfImpact(q, moves, p, rests, options);
    ASSERT_EQ(impact.has_value(), !deep.empty());
    const auto found = conflicts(p, rests, q, moves, options);
    ASSERT_EQ(found.size(), deep.size());
    if (deep.empty()) {
      const Interval touch = meeting(outlineOf(a), outlineOf(b), from, way);
      ++(touch.begin < touch.end ? allowed_overlaps : apart);
      continue;
    }
    twice += deep.size() == 2;
    EXPECT_FALSE(impact->budget_ended);
    EXPECT_LE(impact->time, static_cast<double>(surely[0].begin) + slack);
    EXPECT_GE(impact->time, static_cast<double>(maybe[0].begin) - error - slack);
    for (std::size_t k = 0; k < deep.size(); ++k) {
      EXPECT_FALSE(found[k].budget_ended);
      EXPECT_LE(found[k].impact.time, static_cast<double>(surely[k].begin) + slack);
      EXPECT_GE(found[k].impact.time, static_cast<double>(maybe[k].begin) - error - slack);
      EXPECT_GE(found[k].end, static_cast<double>(surely[k].end) - slack);
      EXPECT_LE(found[k].end, std::min(1.0, static_cast<double>(maybe[k].end) + std::max(error, 1e-9) + slack));
    }
    ++(deep[0].begin == 0 ? at_once : later);
  }
  std::printf("%d apart, %d overlaps that are allowed, %d impacts, %d at once, %d with two, %d left out\n", apart,
              allowed_overlaps, later, at_once, twice, left_out);
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

/// A ring of walls about a body that isn't convex, with much of its width allowed.
Flight rings(Random& random) {
  const Polygon walls({rectangle(-2, -2, 2, 2), rectangle(-1, -1, 1, 1)}),
      body({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  const Vec2 from = anyVec(random, 4);
  Motion motion = Motion::translation(tricover::pose(from.x(), from.y()), anyVec(random, 8));
  if (random.coin()) motion.angle = random.real(-2, 2);
  return {body, still(), walls, whole(motion), -random.real(0.01, 0.45)};
}

/// A car in a lot with a post, of which the outside is forbidden.
Flight lots(Random& random) {
  const Polygon lot({rectangle(-5, -4, 5, 4), rectangle(-0.5, -0.5, 0.5, 0.5)});
  Motion motion = Motion::still(support::pose(random.real(0, 6), random.real(-5, 5), random.real(-4, 4)));
  motion.shift = anyVec(random, 8);
  motion.angle = random.real(-1, 1);
  return {lot.complement(), still(), box(2, 1), whole(motion), -random.real(0.001, 0.3)};
}

/// Segments through thick bodies.
Flight segments(Random& random) {
  Motion motion = Motion::still(support::pose(random.real(0, 6), random.real(-2, 2), random.real(-2, 2)));
  motion.shift = anyVec(random, 4);
  motion.angle = random.real(-2, 2);
  const Polygon thin = segment(anyVec(random, 2), anyVec(random, 2));
  return {random.coin() ? anyStar(random, 1) : box(4, 2), still(), thin, whole(motion), -random.real(0.001, 0.5)};
}

struct Kind {
  const char* name;
  Flight (*make)(Random& random);
};
constexpr Kind kKinds[] = {
    {"floors", floors}, {"turns", turns}, {"splines", splines},  {"combs", combs}, {"trajectories", trajectories},
    {"rings", rings},   {"lots", lots},   {"segments", segments}};

TEST(NegativeMarginOracle, ConflictsAreWhereDepthsSaySo) {
  const Meet isDeep = [](const Case& c, double margin) { return collide(c.a, c.pose_a, c.b, c.pose_b, {margin, 0}); };
  ConflictCounts all;
  for (const Kind& kind : kKinds) {
    ConflictCounts counts;
    const int cases = scaledCount(200);
    for (int i = 0; i < cases; ++i) {
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(i));
      Random random(static_cast<std::uint64_t>(1000 * (&kind - kKinds) + i));
      const double error = std::pow(10, -random.integer(2, 5));
      const Flight flight = kind.make(random);
      const std::string wrong = wrongConflicts(flight, error, isDeep, counts);
      EXPECT_EQ(wrong, "") << error << " " << flight.margin;
    }
    std::printf(
        "%-14s %4d cases %4d without %4d with one %4d with more (%d spans) %4d at once %4d until the end %d short\n",
        kind.name, counts.cases, counts.none, counts.one, counts.more, counts.spans, counts.at_begin, counts.until_end,
        counts.unseen);
    for (int ConflictCounts::*each :
         {&ConflictCounts::cases, &ConflictCounts::none, &ConflictCounts::one, &ConflictCounts::more,
          &ConflictCounts::at_begin, &ConflictCounts::until_end, &ConflictCounts::spans})
      all.*each += counts.*each;
  }
  for (const int some : {all.none, all.one, all.more, all.at_begin, all.until_end}) EXPECT_GT(30 * some, all.cases);
}

}  // namespace
}  // namespace tricover::support
