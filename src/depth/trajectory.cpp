// SPDX-License-Identifier: BSD-3-Clause
// Queries of trajectories: those of motions, between all times at which a leg begins or ends.
#include "tricover/trajectory.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "depth/conflicts.h"
#include "impact/impact_options.h"
#include "numbers/errors.h"

namespace tricover {
namespace {

/// visit(motion of a, motion of b, begin, end), in order, between all times at which a leg of either one ends, while
/// both bodies are there, until it returns false. Bodies that are there together for an instant stand still in it.
template <typename Visit>
void forEachInterval(const Trajectory& a, const Trajectory& b, Visit visit) {
  const detail::TimeTogether together = detail::timeTogether(a, b);
  if (together.begin == together.end) {
    visit(Motion::still(a.at(together.begin)), Motion::still(b.at(together.begin)), together.begin, together.begin);
    return;
  }
  std::vector<double> times;
  times.reserve(a.legs().size() + b.legs().size() + 2);
  for (const Trajectory* body : {&a, &b}) {
    if (body->rests()) continue;
    times.push_back(body->begin());
    for (const Leg& leg : body->legs()) times.push_back(leg.end);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double from = times[i - 1], until = times[i];
    if (from < together.begin || until > together.end) continue;
    if (!visit(a.part(from, until), b.part(from, until), from, until)) return;
  }
}

}  // namespace

detail::TimeTogether detail::timeTogether(const Trajectory& a, const Trajectory& b) {
  if (a.rests() && b.rests()) refuse("trajectories", "both bodies always rest", "ask collide() or distance()");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double begin = kInfinity, end = -kInfinity, appear = -kInfinity, vanish = kInfinity;
  for (const Trajectory* body : {&a, &b}) {
    if (body->rests()) continue;
    begin = std::min(begin, body->begin());
    end = std::max(end, body->end());
    if (body->appears()) appear = std::max(appear, body->begin());
    if (body->vanishes()) vanish = std::min(vanish, body->end());
  }
  return {std::max(begin, appear), std::min(end, vanish)};
}

std::optional<Impact> detail::timeOfImpact(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                           const Trajectory& trajectory_b, const ImpactOptions& options) {
  if (options.ignore_initial) {
    const std::vector<Conflict> all = detail::conflicts(a, trajectory_a, b, trajectory_b, options);
    if (all.empty()) return std::nullopt;
    return all.front().impact;
  }
  std::optional<Impact> found;
  forEachInterval(trajectory_a, trajectory_b,
                  [&](const Motion& motion_a, const Motion& motion_b, double begin, double end) {
                    found = tricover::timeOfImpact(a, motion_a, b, motion_b, optionsWithin(options, end - begin));
                    if (found) found->time = timeWithin(begin, end - begin, found->time);
                    return !found;
                  });
  return found;
}

std::vector<Conflict> detail::conflicts(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                        const Trajectory& trajectory_b, const ImpactOptions& options) {
  std::vector<Conflict> all;
  bool leaves_out = options.ignore_initial;
  forEachInterval(trajectory_a, trajectory_b,
                  [&](const Motion& motion_a, const Motion& motion_b, double begin, double end) {
                    addConflicts(a, motion_a, b, motion_b, begin, end, options, leaves_out, all);
                    return true;
                  });
  return all;
}

std::optional<Impact> timeOfImpact(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                   const Trajectory& trajectory_b, const ImpactOptions& options) {
  detail::checkOptions(options);
  return detail::timeOfImpact(a, trajectory_a, b, trajectory_b, options);
}

std::vector<Conflict> conflicts(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                                const Trajectory& trajectory_b, const ImpactOptions& options) {
  detail::checkOptions(options);
  return detail::conflicts(a, trajectory_a, b, trajectory_b, options);
}

}  // namespace tricover
