// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "asked.h"
#include "report.h"
#include "scenes/placed.h"
#include "shapes.h"
#include "tricover/tricover.h"

namespace tricover::bench {
namespace {

const Pose kIdentity = Pose::Identity();

constexpr double kGaps[] = {1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13};

Polygon floorPlate() { return Polygon({{{-3, -2}, {3, -2}, {3, 0}, {-3, 0}}}); }
Polygon triangle() { return Polygon({{{0, 0}, {1, 1}, {-0.5, 1}}}); }

/// Ten vertices a side.
Polygon rod() {
  Ring ring = {{0, 0}};
  for (int i = 0; i < 10; ++i) ring.emplace_back(0.02 + 1e-3 * i * (9 - i), 0.1 + 0.1 * i);
  ring.emplace_back(0, 1.1);
  for (int i = 10; i-- > 0;) ring.emplace_back(-0.02 - 1e-3 * i * (9 - i), 0.1 + 0.1 * i);
  return Polygon({ring});
}

/// A body that stands on its lowest point, its frame's origin, above the floor by the gap. It tips about that point by
/// `angle`, slides by `shift`, and slides ever faster by `shift_2`.
struct Row {
  const char* input;
  Polygon body;
  double margin, angle, shift, shift_2;

  Motion motion(double gap) const {
    Motion motion;
    motion.start = poseAt({0.3, gap + margin}, 0.1);
    motion.angle = angle;
    motion.shift = Vec2(shift, 0);
    motion.shift_2 = Vec2(shift_2, 0);
    return motion;
  }
};

std::vector<Row> impactRows() {
  return {{"a triangle tips about its corner", triangle(), 0, 1.2, 0, 0},
          {"a rod of 22 vertices tips about its end", rod(), 0, 1.2, 0, 0},
          {"a stadium tips about its end", Polygon::segment({0, 0}, {0, 1}), 0.1, 1.2, 0, 0},
          {"a triangle tips and drifts along the floor", triangle(), 0, 1.2, 0.5, 0},
          {"a triangle slides along the floor ever faster", triangle(), 0, 0, 0, 1},
          {"a triangle tips and slides ever faster", triangle(), 0, 1.2, 0, 1},
          {"a rod of 22 vertices tips and slides ever faster", rod(), 0, 1.2, 0, 1}};
}

/// The least of several means, since these are no averages: one hard query each.
double secondsOf(const std::function<void()>& ask) {
  constexpr double kAtLeast = 2e-3;
  ask();
  double least = 1e9;
  for (int round = 0; round < 5; ++round) {
    const double start = threadSeconds();
    double passed = 0;
    int asked = 0;
    for (; passed < kAtLeast; passed = threadSeconds() - start, ++asked) ask();
    least = std::min(least, passed / asked);
  }
  return least;
}

Result measured(const char* input, const std::string& query, const std::function<void(double gap)>& ask) {
  Result result{{"gap", input, query}};
  for (const double gap : kGaps)
    result.timings.push_back({"gap " + shortNumber(gap), Role::Ours, 1e9 * secondsOf([&] { ask(gap); })});
  return result;
}

}  // namespace

std::vector<Result> measureLastingContact() {
  const Polygon ground = Polygon::box(20, 1), crate = Polygon::box(1, 1), robot = Polygon::box(1, 0.8),
                square = Polygon::box(2, 2), low = Polygon::box(1, 0.6);
  const Polygon post({{{-0.25, -1}, {0.25, -1}, {0.25, 0}, {-0.25, 0}}}), corner({{{0, 0}, {1, 0.5}, {0.5, 1}}});
  const Polygon rod = Polygon::segment({0, 0}, {1, 0});
  const auto from = [](double x, double y, const Vec2& shift) {
    return Motion::translation(tricover::poseAt(x, y), shift);
  };
  const auto turned = [](const Pose& start, const Vec2& by) {
    Motion motion = Motion::still(start);
    motion.start.translation() += start.linear() * by;
    motion.angle = -3.14159;
    return motion;
  };
  const Motion still, spline = Motion::spline({{-5, 1}, 0, {6, 0}, 0}, {{5, 1}, 0, {8, 0}, 0});
  std::vector<TimedPose> way;
  for (int i = 0; i <= 60; ++i) way.push_back({static_cast<double>(i), tricover::poseAt(-9 + 0.3 * i, 1)});
  Pose stretched = Pose::Identity(), rounded = tricover::poseAt(0, 0, 0.7);
  stretched.linear() *= 1 + 4e-15;
  rounded.linear() = rounded.linear().cast<float>().cast<double>();
  const auto once = [](const Motion& motion) { return Trajectory({{0, 1, motion}}); };
  const Trajectory rests = once(still), east = once(from(-5, 0, {10, 0})), west = once(from(5, 1, {-10, 0})),
                   at_stretched = once(Motion::still(stretched)), at_rounded = once(Motion::still(rounded));
  struct Row {
    const char* input;
    Polygon a;
    Trajectory way_a;
    Polygon b;
    Trajectory way_b;
    double margin = 0;
  };
  const Polygon jaws(
      {{{-1, 0.4375}, {1, 0.4375}, {1, 0.625}, {-1, 0.625}}, {{-1, -0.625}, {1, -0.625}, {1, -0.4375}, {-1, -0.4375}}}),
      bar = Polygon::box(40, 1),
      comb({{{-2, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}, {0, 0.5}, {0, 1}, {-1, 1}, {-1, 0.5}, {-2, 0.5}}});
  std::vector<Result> results;
  for (const Row& r :
       {Row{"a crate slides along a floor", ground, rests, crate, once(from(-5, 1, {10, 0}))},
        {"a crate slides, sunk by 1e-9", ground, rests, crate, once(from(-5, 1 - 1e-9, {10, 0}))},
        {"a crate slides along a spline", ground, rests, crate, once(spline)},
        {"a crate slides for 60 s", ground, Trajectory({{0, 60, still}}), crate, Trajectory::through(way)},
        {"a crate and its floor move alike", ground, east, crate, once(from(-7, 1, {10, 0}))},
        {"robots in lanes, margin 0.19", robot, east, robot, west, 0.19},
        {"robots in lanes at their margin", robot, east, robot, west, 0.2},
        {"robots in lanes, margin 0.21", robot, east, robot, west, 0.21},
        {"a robot leaves its dock", ground, rests, low, once(from(0, 0.8, {0, 1}))},
        {"a square leaves another one", square, rests, square, once(from(0, 2 - 10 * 0.18, {0, 10}))},
        {"a corner turns, off rigid by 4e-15", post, at_stretched, corner, once(turned(stretched, {0, 1e-9}))},
        {"a corner turns, poses of floats", post, at_rounded, corner, once(turned(rounded, {0, 1e-9}))},
        {"segments 3.4e-9 apart", rod, at_rounded, rod, once(turned(rounded, {0.25, 3.4e-9}))},
        {"a crate slides as deep as allowed", ground, rests, crate, once(from(-5, 0.95, {10, 0})), -0.05},
        {"a comb slides as deep as allowed", ground, rests, comb, once(from(-5, -0.45, {10, 0})), -0.05},
        {"jaws grip a bar as deep as allowed", bar, rests, jaws, once(from(-9, 0, {18, 0})), -0.0625},
        {"jaws grip a bar, less deep by 1e-4", bar, rests, jaws, once(from(-9, 0, {18, 0})), -0.0626}}) {
    results.push_back({{"lasting", r.input, "conflicts, and the first impact after contact"}});
    for (const double error : {1e-2, 1e-6, 1e-9, 1e-12}) {
      ImpactOptions options{r.margin, error}, after = options;
      after.ignore_initial = true;
      const auto ask = [&] {
        conflicts(r.a, r.way_a, r.b, r.way_b, options);
        timeOfImpact(r.a, r.way_a, r.b, r.way_b, after);
      };
      results.back().timings.push_back({"time_error " + shortNumber(error), Role::Ours, 1e9 * secondsOf(ask)});
    }
  }
  return results;
}

std::vector<Result> measureGaps() {
  std::vector<Result> results;
  const Polygon still = floorPlate();
  for (const Row& row : impactRows()) {
    for (const double time_error : {1e-3, 1e-6, 1e-12}) {
      results.push_back(measured(row.input, "time of impact to " + shortNumber(time_error), [&](double gap) {
        timeOfImpact(still, {}, row.body, row.motion(gap), {row.margin, time_error});
      }));
    }
  }
  const Polygon box({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  // Bodies whose corner, one to the left of their frame's origin, comes near a box's side after a turn.
  const std::pair<const char*, Polygon> corners[] = {
      {"a box, its corner beside another one's side", Polygon({{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}})},
      {"a triangle, its corner beside a box's side", Polygon({{{-1, 0}, {1, -1}, {1, 1}}})},
      {"an octagon, its corner beside a box's side", Polygon({support::regular(8, 1)})}};
  for (const auto& corner : corners) {
    const auto beside = [](double gap) { return poseAt({1 + std::cos(0.1) + gap, 0.1}, 0.1); };
    results.push_back(
        measured(corner.first, "collide", [&](double gap) { collide(box, kIdentity, corner.second, beside(gap)); }));
    results.push_back(
        measured(corner.first, "distance", [&](double gap) { distance(box, kIdentity, corner.second, beside(gap)); }));
  }
  return results;
}

}  // namespace tricover::bench
