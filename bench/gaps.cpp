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
          {"a stadium tips about its end", segment({0, 0}, {0, 1}), 0.1, 1.2, 0, 0},
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
