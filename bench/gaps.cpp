// SPDX-License-Identifier: BSD-3-Clause
#include "gaps.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "measure.h"
#include "report.h"
#include "tricover/tricover.h"

namespace tricover::bench {
namespace {

const Pose kIdentity = Pose::Identity();

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

/// Stands on its lowest point, its frame's origin, above the floor by the gap, and tips about it.
Motion tipping(double gap) {
  Motion motion;
  motion.start.linear() = Eigen::Rotation2Dd(0.1).toRotationMatrix();
  motion.start.translation() = Vec2(0.3, gap);
  motion.angle = 1.2;
  return motion;
}

Motion drifting(double gap) {
  Motion motion = tipping(gap);
  motion.shift = Vec2(0.5, 0);
  return motion;
}

Motion accelerating(double gap) {
  Motion motion = tipping(gap);
  motion.angle = 0;
  motion.shift_2 = Vec2(1, 0);
  return motion;
}

Motion tippingAndAccelerating(double gap) {
  Motion motion = accelerating(gap);
  motion.angle = 1.2;
  return motion;
}

struct Row {
  const char* input;
  Polygon body;
  double margin;
  Motion (*move)(double gap);
};

std::vector<Row> impactRows() {
  return {{"a triangle tips about its corner", triangle(), 0, tipping},
          {"a rod of 22 vertices tips about its end", rod(), 0, tipping},
          {"a stadium tips about its end", segment({0, 0}, {0, 1}), 0.1, tipping},
          {"a triangle tips and drifts along the floor", triangle(), 0, drifting},
          {"a triangle slides along the floor, faster and faster", triangle(), 0, accelerating},
          {"a triangle tips and slides, faster and faster", triangle(), 0, tippingAndAccelerating},
          {"a rod of 22 vertices tips and slides, faster and faster", rod(), 0, tippingAndAccelerating}};
}

/// A body whose corner, `reach` to the left of its frame's origin, comes near a box's side after a turn.
struct Corner {
  const char* input;
  Polygon body;
  double reach, turn;
};

std::vector<Corner> corners() {
  constexpr double kHalf = 0.70710678118654752;
  const Polygon octagon(
      {{{-1, 0}, {-kHalf, -kHalf}, {0, -1}, {kHalf, -kHalf}, {1, 0}, {kHalf, kHalf}, {0, 1}, {-kHalf, kHalf}}});
  return {{"a box, its corner beside another one's side", Polygon({{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}}), 1, 0.1},
          {"a triangle, its corner beside a box's side", Polygon({{{-1, 0}, {1, -1}, {1, 1}}}), 1, 0.1},
          {"an octagon, its corner beside a box's side", octagon, 1, 0.1}};
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

GapCost measured(const char* input, const std::string& query, const std::function<void(double gap)>& ask) {
  GapCost cost{input, query, {}};
  for (std::size_t i = 0; i < kGaps.size(); ++i) cost.seconds[i] = secondsOf([&] { ask(kGaps[i]); });
  return cost;
}

const char* const kImpact = "time of impact";

}  // namespace

std::vector<GapCost> measureGaps() {
  std::vector<GapCost> costs;
  const Polygon still = floorPlate();
  for (const Row& row : impactRows()) {
    for (const double time_error : {1e-3, 1e-6, 1e-12}) {
      const std::string query = kImpact + (", time_error " + shortNumber(time_error));
      costs.push_back(measured(row.input, query, [&](double gap) {
        Motion motion = row.move(gap);
        motion.start.translation().y() += row.margin;
        timeOfImpact(still, {}, row.body, motion, {row.margin, time_error});
      }));
    }
  }
  const Polygon box({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
  for (const Corner& corner : corners()) {
    const auto beside = [&](double gap) {
      Pose pose = Pose::Identity();
      pose.linear() = Eigen::Rotation2Dd(corner.turn).toRotationMatrix();
      pose.translation() = Vec2(1 + corner.reach * std::cos(corner.turn) + gap, 0.1);
      return pose;
    };
    costs.push_back(
        measured(corner.input, "collide", [&](double gap) { collide(box, kIdentity, corner.body, beside(gap)); }));
    costs.push_back(
        measured(corner.input, "distance", [&](double gap) { distance(box, kIdentity, corner.body, beside(gap)); }));
  }
  return costs;
}

std::string gapTable(const std::vector<GapCost>& costs) {
  TextTable lines = {{"input", "query"}};
  for (const double gap : kGaps) lines[0].push_back("gap " + shortNumber(gap) + ": us");
  for (const GapCost& cost : costs) {
    lines.push_back({cost.input, cost.query});
    for (const double seconds : cost.seconds) lines.back().push_back(shortNumber(1e6 * seconds));
  }
  return markdown(lines);
}

std::string gapCsv(const std::vector<GapCost>& costs) {
  std::string csv = "input,query";
  for (const double gap : kGaps) csv += ",seconds_" + shortNumber(gap);
  for (const GapCost& cost : costs) {
    csv += "\n\"" + cost.input + "\",\"" + cost.query + '"';
    for (const double seconds : cost.seconds) csv += ',' + shortNumber(seconds);
  }
  return csv + "\n";
}

std::vector<Target> judgeGaps(const std::vector<GapCost>& costs) {
  std::vector<Figure> impacts, steps;
  for (const GapCost& cost : costs) {
    const std::string cell = cost.input + ", " + cost.query;
    if (cost.query.rfind(kImpact, 0) == 0) {
      impacts.push_back({1e3 * *std::max_element(cost.seconds.begin(), cost.seconds.end()), cell});
    } else {
      // Down to 1e-12: across the narrowest gap a distance has a step of 3.5.
      const auto [least, most] = std::minmax_element(cost.seconds.begin(), cost.seconds.end() - 1);
      steps.push_back({*most / *least, cell});
    }
  }
  return {judged("times of impact close to each other, any gap", "a query", impacts, {false, 1, 0, "ms"}),
          judged("small convex pairs, gaps of 1e-3 to 1e-12", "the dearest / the cheapest gap", steps, {false, 1.5})};
}

}  // namespace tricover::bench
