// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/least_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "impact/options.h"
#include "numbers/errors.h"
#include "tricover/distance.h"
#include "tricover/time_of_impact.h"

namespace tricover {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

void checkOptions(const LeastDistanceOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  if (!(options.error > 0 && std::isfinite(options.error))) detail::refuse("error", "it must be finite and positive");
}

/// By bisection: where an impact with a margin is, the distance is at most that; where there is none, it is more.
/// `Path` is a Motion or a Trajectory.
template <typename Path>
LeastDistance leastOn(const Polygon& a, const Path& path_a, const Polygon& b, const Path& path_b, double begin,
                      double end, const LeastDistanceOptions& options) {
  LeastDistance least{};
  const auto look = [&](double time) {
    const DistanceResult at = distance(a, path_a.at(time), b, path_b.at(time));
    const double left = std::max(at.distance - options.margin, 0.0);
    if (time != begin && !(left < least.distance)) return;
    least = {left, 0, time, at.point_a, at.point_b, at.edge_a, at.edge_b, false};
  };
  look(begin);
  look(end);
  double lower = 0;
  // The first step asks whether they meet, whatever the error. Each other one halves what is between the bounds, all of
  // the range of doubles at most.
  for (int step = 0; step < 2200 && least.distance - lower > (step == 0 ? 0 : options.error); ++step) {
    const double before = least.distance, middle = step == 0 ? 0 : lower + 0.5 * (std::min(before, kLargest) - lower);
    if (step > 0 && !(lower < middle && middle < before)) break;  // they are neighbours
    ImpactOptions closer{std::min(middle + options.margin, kLargest), 0};
    closer.absent_outside = options.absent_outside;
    const std::optional<Impact> impact = timeOfImpact(a, path_a, b, path_b, closer);
    if (!impact) {
      lower = middle;
      continue;
    }
    least.budget_ended = impact->budget_ended;
    if (!impact->budget_ended) look(impact->time);
    if (impact->budget_ended || !(least.distance < before)) break;
    if (step == 0) least.distance = 0;  // but for rounding
  }
  least.lower_bound = std::min(lower, least.distance);
  return least;
}

}  // namespace

LeastDistance leastDistance(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                            const LeastDistanceOptions& options) {
  checkOptions(options);
  detail::checkMotions(motion_a, motion_b);
  return leastOn(a, motion_a, b, motion_b, 0, 1, options);
}

LeastDistance leastDistance(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                            const Trajectory& trajectory_b, const LeastDistanceOptions& options) {
  checkOptions(options);
  const bool together = options.absent_outside;
  const double begin = together ? std::max(trajectory_a.begin(), trajectory_b.begin())
                                : std::min(trajectory_a.begin(), trajectory_b.begin());
  const double end =
      together ? std::min(trajectory_a.end(), trajectory_b.end()) : std::max(trajectory_a.end(), trajectory_b.end());
  if (!(begin <= end)) detail::refuse("absent_outside", "the bodies are never there together");
  return leastOn(a, trajectory_a, b, trajectory_b, begin, end, options);
}

}  // namespace tricover
