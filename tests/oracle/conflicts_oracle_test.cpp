// SPDX-License-Identifier: BSD-3-Clause
// Spans of conflict against exact collisions at many times on the way, whose changes are found by bisection. The poses
// there are computed here, in long doubles: nothing is shared with the kernel but the types.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "exact_reference.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/conflicts.h"
#include "tricover/segment.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

/// Of times: what 1e-13 of lengths may move them by, where bodies don't touch in passing.
constexpr double kRounding = 1e-8;
constexpr int kSamples = 300;  // in a unit of time

struct Flight {
  Polygon a;
  Trajectory way_a;
  Polygon b;
  Trajectory way_b;
  double margin = 0;
};

Trajectory whole(const Motion& motion) { return Trajectory({{0, 1, motion}}); }

Pose poseAt(const Motion& m, long double t) {
  using Real = long double;
  const auto cubic = [t](Real first, Real second, Real third) { return ((third * t + second) * t + first) * t; };
  const Real angle = cubic(m.angle, m.angle_2, m.angle_3), c = std::cos(angle), s = std::sin(angle);
  const auto start = [&](int row, int column) { return static_cast<Real>(m.start.matrix()(row, column)); };
  Pose pose = Pose::Identity();
  for (int column = 0; column < 2; ++column) {
    pose.linear()(0, column) = static_cast<double>(c * start(0, column) - s * start(1, column));
    pose.linear()(1, column) = static_cast<double>(s * start(0, column) + c * start(1, column));
  }
  const Real arm[2] = {start(0, 0) * m.pivot.x() + start(0, 1) * m.pivot.y(),
                       start(1, 0) * m.pivot.x() + start(1, 1) * m.pivot.y()};
  const Real turned[2] = {c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]};
  for (int i = 0; i < 2; ++i)
    pose.translation()[i] =
        static_cast<double>(start(i, 2) + arm[i] - turned[i] + cubic(m.shift[i], m.shift_2[i], m.shift_3[i]));
  return pose;
}

Pose poseAt(const Trajectory& way, double time) {
  if (time <= way.begin()) return way.legs().front().motion.start;
  for (const Leg& leg : way.legs())
    if (time <= leg.end)
      return poseAt(leg.motion,
                    (static_cast<long double>(time) - leg.begin) / (static_cast<long double>(leg.end) - leg.begin));
  return poseAt(way.legs().back().motion, 1);
}

bool meet(const Flight& f, double time) {
  const Pose pose_a = poseAt(f.way_a, time), pose_b = poseAt(f.way_b, time);
  if (f.margin == 0) return exact::collide(f.a, pose_a, f.b, pose_b);
  return exact::within(exact::distanceSquared(f.a, pose_a, f.b, pose_b), f.margin);
}

struct Span {
  double begin, end;
};

/// All that last for a sample or more, and those that hold one of these times as well; likewise of what is between
/// them.
std::vector<Span> truthOf(const Flight& f, double begin, double end, std::vector<double> samples) {
  const auto change = [&](double before, double after, bool to) {
    while (after - before > kRounding / 64) {
      const double middle = before + (after - before) / 2;
      (meet(f, middle) == to ? after : before) = middle;
    }
    return after;
  };
  const int count = static_cast<int>(kSamples * (end - begin));
  for (int i = 0; i <= count; ++i) samples.push_back(i == count ? end : begin + (end - begin) * i / count);
  std::sort(samples.begin(), samples.end());
  std::vector<Span> spans;
  bool met = false;
  double last = begin;
  for (const double time : samples) {
    const bool now = meet(f, time);
    if (now && !met) spans.push_back({time == begin ? begin : change(last, time, true), end});
    if (!now && met) spans.back().end = change(last, time, false);
    met = now;
    last = time;
  }
  return spans;
}

struct Counts {
  int cases = 0, none = 0, one = 0, more = 0, at_begin = 0, until_end = 0, unseen = 0, spans = 0;
};

/// Whether the two come within what they move in so short a time, near a time.
bool comeNear(const Flight& f, double from, double until, double near) {
  for (int i = 0; i <= 64; ++i) {
    const double time = from + (until - from) * i / 64;
    if (exact::within(exact::distanceSquared(f.a, poseAt(f.way_a, time), f.b, poseAt(f.way_b, time)), f.margin + near))
      return true;
  }
  return false;
}

void expectConflicts(const Flight& f, double error, Counts& counts) {
  const double begin = std::min(f.way_a.begin(), f.way_b.begin()), end = std::max(f.way_a.end(), f.way_b.end());
  ImpactOptions options{f.margin, error};
  const std::vector<Conflict> found = conflicts(f.a, f.way_a, f.b, f.way_b, options);
  // What is told says where to look more closely.
  std::vector<double> places;
  for (const Conflict& c : found)
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      places.push_back(c.impact.time + share * (c.end - c.impact.time));
  const std::vector<Span> truth = truthOf(f, begin, end, places);
  std::string told;
  for (const Conflict& c : found) told += std::to_string(c.impact.time) + " to " + std::to_string(c.end) + "; ";
  SCOPED_TRACE("told with " + std::to_string(error) + ": " + told);
  // None is missed, and each is told no later than it begins and no sooner than it ends.
  for (const Span& span : truth) {
    const auto at =
        std::find_if(found.begin(), found.end(), [&](const Conflict& c) { return c.end >= span.end - kRounding; });
    ASSERT_TRUE(at != found.end() && at->impact.time <= span.begin + kRounding) << span.begin << " to " << span.end;
  }
  std::size_t next = 0;
  for (const Conflict& c : found) {
    ASSERT_LE(c.impact.time, c.end);
    ASSERT_TRUE(begin <= c.impact.time && c.end <= end);
    // Those within it: the first begins, and the last ends, when it does.
    const std::size_t first = next;
    while (next < truth.size() && truth[next].begin <= c.end + kRounding) ++next;
    if (first == next) {
      ++counts.unseen;  // too short for a sample
      ASSERT_LE(c.end - c.impact.time, 2 * error + 1.0 / kSamples + kRounding);
      ASSERT_TRUE(comeNear(f, c.impact.time, std::min(c.end, c.impact.time + error), 1000 * error + 1e-9));
      continue;
    }
    // Before and after those that hold a sample there may be shorter ones.
    const auto short_ones = [&](double from, double until) {
      return until - from <= error + kRounding ||
             (until - from < 1.0 / kSamples && comeNear(f, from, until, 1000 * error + 1e-9));
    };
    ASSERT_TRUE(short_ones(c.impact.time, truth[first].begin)) << c.impact.time << " " << truth[first].begin;
    ASSERT_TRUE(short_ones(truth[next - 1].end, c.end)) << truth[next - 1].end << " " << c.end;
    for (std::size_t k = first + 1; k < next; ++k)
      ASSERT_LE(truth[k].begin - truth[k - 1].end, error + kRounding) << "what parts them for longer is seen";
    if (c.end < end) {
      ASSERT_FALSE(meet(f, c.end)) << c.end;
    }
  }
  options.ignore_initial = true;
  const std::vector<Conflict> later = conflicts(f.a, f.way_a, f.b, f.way_b, options);
  const bool at_begin = !found.empty() && found.front().impact.time == begin;
  ASSERT_EQ(at_begin, meet(f, begin));
  ASSERT_EQ(later.size() + at_begin, found.size());
  const auto impact = timeOfImpact(f.a, f.way_a, f.b, f.way_b, options);
  ASSERT_EQ(impact.has_value(), !later.empty());
  if (impact) {
    ASSERT_NEAR(impact->time, later.front().impact.time, error + kRounding);
  }
  ++counts.cases;
  counts.spans += static_cast<int>(found.size());
  ++(found.empty() ? counts.none : found.size() == 1 ? counts.one : counts.more);
  counts.at_begin += at_begin;
  counts.until_end += !found.empty() && found.back().end == end;
}

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
  const auto plan = [&] {
    std::vector<Leg> legs;
    double time = random.real(-0.5, 0.5);
    Vec2 at = anyVec(random, 3);
    double heading = random.real(-3, 3);
    for (int i = random.integer(1, 4); i > 0; --i) {
      const double begin = time;
      time += random.real(0.1, 0.5);
      Motion leg = Motion::still(pose(heading, at.x(), at.y()));
      if (!random.oneIn(3)) {
        leg.shift = anyVec(random, 6) - at;
        leg.angle = random.real(-2, 2);
        at += leg.shift, heading += leg.angle;
      }
      legs.push_back({begin, time, leg});
    }
    return Trajectory(legs);
  };
  return {anyStar(random, 1), plan(), anyStar(random, 1), plan()};
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
  Counts all;
  for (const Kind& kind : kKinds) {
    Counts counts;
    const int cases = scaledCount(kind.count);
    for (int i = 0; i < cases; ++i) {
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(i));
      Random random(static_cast<std::uint64_t>(1000 * (&kind - kKinds) + i));
      const double error = std::pow(10, -random.integer(2, 6));
      const bool grazes = kind.make == grazing;
      ASSERT_NO_FATAL_FAILURE(expectConflicts(kind.make(random), grazes ? 1e-3 : error, counts));
    }
    std::printf(
        "%-14s %4d cases %4d without %4d with one %4d with more (%d spans) %4d at once %4d until the end %d short\n",
        kind.name, counts.cases, counts.none, counts.one, counts.more, counts.spans, counts.at_begin, counts.until_end,
        counts.unseen);
    EXPECT_GT(10 * (counts.one + counts.more), counts.cases) << kind.name;
    EXPECT_LT(10 * counts.unseen, counts.spans + 10) << kind.name;
    for (int Counts::*each : {&Counts::cases, &Counts::none, &Counts::one, &Counts::more, &Counts::at_begin,
                              &Counts::until_end, &Counts::spans})
      all.*each += counts.*each;
  }
  for (const int some : {all.none, all.one, all.more, all.at_begin, all.until_end}) EXPECT_GT(20 * some, all.cases);
}

}  // namespace
}  // namespace tricover::support
