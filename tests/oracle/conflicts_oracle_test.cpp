// SPDX-License-Identifier: BSD-3-Clause
// Spans of conflict against exact collisions at many times on the way, whose changes are found by bisection.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "conflict_laws.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/conflicts.h"
#include "tricover/segment.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

Trajectory whole(const Motion& motion) { return Trajectory({{0, 1, motion}}); }

Vec2 anyVec(Random& random, double most) { return {random.real(-most, most), random.real(-most, most)}; }

Polygon anyStar(Random& random, double size) { return Polygon({star(random, random.integer(3, 9), 0.3 * size, size)}); }

Motion still() { return Motion::still(Pose::Identity()); }

Motion anySpline(Random& random, double reach, double turn) {
  Motion motion = Motion::spline({anyVec(random, reach), random.real(-3, 3), anyVec(random, 4 * reach), turn},
                                 {anyVec(random, reach), random.real(-turn, turn), anyVec(random, 4 * reach), -turn},
                                 anyVec(random, 0.5));
  return motion;
}

/// Through walls a few apart.
Flight throughWalls(Random& random) {
  std::vector<Ring> walls;
  double x = -6;
  while (x < 6) {
    const double next = x + random.real(0.1, 2);
    walls.push_back(rectangle(x, -20, next, 20));
    x = next + random.real(0.2, 4);
  }
  const Vec2 way(random.real(-30, 30), random.real(-9, 9));
  const Vec2 from = anyVec(random, 4) - way / 2;
  return {Polygon(walls), whole(still()), anyStar(random, 1),
          whole(Motion::translation(pose(random.real(0, 6), from.x(), from.y()), way))};
}

/// A bar that turns beside posts.
Flight turns(Random& random) {
  std::vector<Ring> posts;
  for (int i = random.integer(1, 4); i > 0; --i) {
    const Vec2 at = anyVec(random, 6);
    posts.push_back(rectangle(at.x(), at.y(), at.x() + 0.5, at.y() + 0.5));
  }
  Motion motion = Motion::still(pose(random.real(0, 6), random.real(-1, 1), 0));
  motion.angle = random.real(-15, 15);
  motion.shift = anyVec(random, 1);
  return {Polygon(posts), whole(still()), Polygon({rectangle(-1, -0.2, random.real(2, 6), 0.2)}), whole(motion)};
}

/// Both on cubics, there and back.
Flight splines(Random& random) {
  return {anyStar(random, 1), whole(anySpline(random, 2, 2)), anyStar(random, 1), whole(anySpline(random, 2, 4))};
}

/// In and out of a frame, in which there is room.
Flight frames(Random& random) {
  const double hole = random.real(1.5, 4);
  return {Polygon({rectangle(-5, -5, 5, 5), rectangle(-hole, -hole, hole, hole)}), whole(still()),
          anyStar(random, random.real(0.3, 1.2)), whole(anySpline(random, 6, 3))};
}

/// Teeth past teeth.
Flight combs(Random& random) {
  const Ring teeth = comb(random.integer(2, 5), 4, 2, 2);
  const Vec2 from = anyVec(random, 3) - Vec2(12, random.real(0, 4));
  return {Polygon({teeth}), whole(still()), Polygon({teeth}),
          whole(Motion::translation(pose(random.coin() ? M_PI : random.real(0, 6), from.x(), from.y()),
                                    Vec2(24, random.real(-4, 4))))};
}

/// What crosses itself, points and segments.
Flight degenerate(Random& random) {
  const Ring ring = star(random, 7, -1, 2);
  const Polygon crossing({ring, rectangle(-1, -1, 1, 1)}, random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
  const Vec2 p = anyVec(random, 1);
  return {crossing, whole(anySpline(random, 1, 2)), random.coin() ? point(p) : segment(p, anyVec(random, 1)),
          whole(anySpline(random, 3, 3))};
}

Flight margins(Random& random) {
  Flight f = random.coin() ? splines(random) : turns(random);
  f.margin = random.real(0.01, 0.8);
  return f;
}

/// Legs and waits by clocks of their own.
Flight trajectories(Random& random) {
  return {anyStar(random, 1), anyPlan(random), anyStar(random, 1), anyPlan(random)};
}

/// Along a wall, at exactly its height: they touch for a while, and closed regions meet.
Flight grazing(Random& random) {
  const double x = random.integer(-6, 6), width = random.integer(1, 4);
  return {Polygon({rectangle(x, -2, x + width, 0)}), whole(still()), Polygon({rectangle(-1, 0, 1, 2)}),
          whole(Motion::translation(pose(0, -8, 0), {16, 0}))};
}

struct Kind {
  const char* name;
  Flight (*make)(Random& random);
  int count;
};
constexpr Kind kKinds[] = {{"through walls", throughWalls, 240},
                           {"turns", turns, 240},
                           {"splines", splines, 240},
                           {"frames", frames, 240},
                           {"combs", combs, 160},
                           {"degenerate", degenerate, 240},
                           {"margins", margins, 160},
                           {"trajectories", trajectories, 240},
                           {"grazing", grazing, 40}};

TEST(ConflictsOracle, AreAllAndNoOthers) {
  ConflictCounts all;
  for (const Kind& kind : kKinds) {
    ConflictCounts counts;
    const int cases = scaledCount(kind.count);
    for (int i = 0; i < cases; ++i) {
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(i));
      Random random(static_cast<std::uint64_t>(1000 * (&kind - kKinds) + i));
      const double error = std::pow(10, -random.integer(2, 6));
      const bool grazes = kind.make == grazing;
      ASSERT_EQ(wrongConflicts(kind.make(random), grazes ? 1e-3 : error, meetExactly, counts), "");
    }
    std::printf(
        "%-14s %4d cases %4d without %4d with one %4d with more (%d spans) %4d at once %4d until the end %d short\n",
        kind.name, counts.cases, counts.none, counts.one, counts.more, counts.spans, counts.at_begin, counts.until_end,
        counts.unseen);
    EXPECT_GT(10 * (counts.one + counts.more), counts.cases) << kind.name;
    EXPECT_LT(10 * counts.unseen, counts.spans + 10) << kind.name;
    for (int ConflictCounts::*each :
         {&ConflictCounts::cases, &ConflictCounts::none, &ConflictCounts::one, &ConflictCounts::more,
          &ConflictCounts::at_begin, &ConflictCounts::until_end, &ConflictCounts::spans})
      all.*each += counts.*each;
  }
  for (const int some : {all.none, all.one, all.more, all.at_begin, all.until_end}) EXPECT_GT(20 * some, all.cases);
}

}  // namespace
}  // namespace tricover::support
