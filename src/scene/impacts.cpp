// SPDX-License-Identifier: BSD-3-Clause
// Moving polygons and the bodies of a scene.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "depth/conflicts.h"
#include "impact/impact_options.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "scene/in_parallel.h"
#include "scene/scene_state.h"
#include "scene/sweep.h"

namespace tricover {

using detail::Bounds;
using detail::legsOf;
using detail::SceneState;
using detail::Slot;
using detail::stillBeside;
using detail::Sweep;
using detail::SweptLeg;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Pairs of moving bodies take intervals twice as long, and at most this number for each leg. A finer division saves
/// less than its boxes cost.
constexpr double kMostPairIntervals = 8;

ImpactOptions withMargin(ImpactOptions options, double margin) {
  options.margin = detail::marginSum(options.margin, margin);
  return options;
}

/// `path` is a Motion or a Trajectory.
template <typename Path>
std::optional<BodyImpact> firstImpactOn(const Path& path, const Polygon& polygon, const ImpactOptions& options,
                                        const SceneState& state, const BodyFilter& filter) {
  detail::checkOptions(options);
  const Sweep sweep(polygon, legsOf(path), options.margin);
  std::optional<BodyImpact> best;
  const detail::SlotFilter slots = state.slots(filter);
  std::vector<Slot> tested, near;  // in earlier intervals, sorted; in this interval for the first time
  for (const SweptLeg& leg : sweep.legs()) {
    const double count = leg.intervals();
    for (double i = 0; i < count; ++i) {
      // Bodies that are near in no earlier interval aren't hit before this one begins, nor reported much earlier.
      const double clock = leg.clockAt(i / count);
      if (best && best->impact.time < clock - options.time_error - 0x1p-50 * std::abs(clock)) return best;
      near.clear();
      state.tree.visit(leg.between(i / count, (i + 1) / count), [&](Slot slot) {
        if (state.passes(slots, slot) && !std::binary_search(tested.begin(), tested.end(), slot)) near.push_back(slot);
        return true;
      });
      for (const Slot slot : near) {
        const auto& other = state.bodies[slot];
        const BodyHandle body = state.handleOf(slot);
        const auto impact = timeOfImpact(polygon, path, other.polygon, stillBeside(path, other.pose),
                                         withMargin(options, other.options.margin));
        if (impact && (!best || std::pair(impact->time, body) < std::pair(best->impact.time, best->body)))
          best = BodyImpact{body, *impact};
      }
      tested.insert(tested.end(), near.begin(), near.end());
      std::sort(tested.begin(), tested.end());
    }
  }
  return best;
}

}  // namespace

std::optional<BodyImpact> Scene::firstImpact(const Polygon& polygon, const Motion& motion, const ImpactOptions& options,
                                             const BodyFilter& filter) const {
  checkMotion(motion);
  return firstImpactOn(motion, polygon, options, impl_->settled(), filter);
}

std::optional<BodyImpact> Scene::firstImpact(const Polygon& polygon, const Trajectory& trajectory,
                                             const ImpactOptions& options, const BodyFilter& filter) const {
  if (trajectory.rests()) detail::refuse("trajectory", "it always rests, as all bodies do", "ask anyColliding()");
  return firstImpactOn(trajectory, polygon, options, impl_->settled(), filter);
}

namespace {

const Motion& pathOf(const BodyMotion& moving) { return moving.motion; }
const Trajectory& pathOf(const BodyTrajectory& moving) { return moving.trajectory; }

/// The first begin and the last end of what moves.
struct Clock {
  double begin = kInfinity, end = -kInfinity;
};
Clock clockOf(const std::vector<BodyMotion>&) { return {0, 1}; }
Clock clockOf(const std::vector<BodyTrajectory>& trajectories) {
  Clock clock;
  for (const BodyTrajectory& moving : trajectories) {
    if (moving.trajectory.rests()) continue;
    clock.begin = std::min(clock.begin, moving.trajectory.begin());
    clock.end = std::max(clock.end, moving.trajectory.end());
  }
  if (!trajectories.empty() && !(clock.begin < clock.end))
    detail::refuse("trajectories", "all bodies always rest", "ask collisions() or nearest()");
  return clock;
}

/// Two trajectories that always rest have no time of their own: the first one then rests by the clock.
void restByClock(BodyMotion&, const BodyMotion&, const Clock&) {}
void restByClock(BodyTrajectory& first, const BodyTrajectory& second, const Clock& clock) {
  if (first.trajectory.rests() && second.trajectory.rests())
    first.trajectory = Trajectory({{clock.begin, clock.end, Motion::still(first.trajectory.at(clock.begin))}});
}

/// Returns the pairs of bodies that may meet while some of them move, sorted. They are near in some interval of time.
template <typename Moving>
std::vector<BodyPair> pairsNear(const SceneState& state, const std::vector<Moving>& motions,
                                const std::vector<std::uint32_t>& motion_of, const Clock& clock, double margin) {
  std::vector<Sweep> sweeps;
  const auto [begin, end] = clock;
  double most = 1;
  std::size_t legs = 1;
  for (const Moving& moving : motions) {
    const auto& body = state.bodies[Scene::indexOf(moving.body)];
    // The query's own margin counts once a pair: half of it for each body.
    const Sweep& sweep = sweeps.emplace_back(body.polygon, legsOf(pathOf(moving)), body.options.margin + 0.5 * margin);
    most = std::max(most, sweep.intervals());
    legs = std::max(legs, sweep.legs().size());
  }
  // Boxes of bodies that stand still hold their own margins alone.
  const double half = 0.5 * detail::marginOfBox(margin) * (1 + 0x1p-40);
  const double count = std::ceil(std::min(0.5 * most, kMostPairIntervals * static_cast<double>(legs)));
  std::vector<BodyPair> pairs;
  std::vector<detail::BoxTree::Entry> boxes(motions.size());
  detail::BoxTree moving;
  for (double interval = 0; interval < count; ++interval) {
    const double from = begin + (end - begin) * (interval / count),
                 to = begin + (end - begin) * ((interval + 1) / count);
    for (std::uint32_t i = 0; i < motions.size(); ++i) boxes[i] = {sweeps[i].between(from, to), i};
    moving.pack(boxes);
    for (std::uint32_t i = 0; i < motions.size(); ++i) {
      const Slot body = Scene::indexOf(motions[i].body);
      const auto add = [&](Slot other) {
        if (state.mayMeet(body, other)) pairs.push_back(state.handlesOf(body, other));
      };
      moving.visit(boxes[i].bounds, [&](std::uint32_t j) {
        if (j < i) add(Scene::indexOf(motions[j].body));
        return true;
      });
      state.tree.visit(boxes[i].bounds.grown(half), [&](Slot other) {
        if (motion_of[other] == motions.size()) add(other);
        return true;
      });
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }
  return pairs;
}

/// By the slots of bodies: which of the motions is theirs, or how many there are. Throws, naming them by `name`.
template <typename Moving>
std::vector<std::uint32_t> motionsOf(const SceneState& state, const std::vector<Moving>& motions, const char* name) {
  const auto still = static_cast<std::uint32_t>(motions.size());
  std::vector<std::uint32_t> motion_of(state.bodies.size(), still);
  for (std::uint32_t i = 0; i < motions.size(); ++i) {
    std::uint32_t& of_body = motion_of[state.slot(motions[i].body)];
    if (of_body != still) detail::refuse(name + ("[" + std::to_string(i)) + "]", "its body has a motion already");
    of_body = i;
  }
  return motion_of;
}

const Impact& impactOf(const PairImpact& found) { return found.impact; }
const Impact& impactOf(const PairConflict& found) { return found.conflict.impact; }

void add(const BodyPair& pair, const std::optional<Impact>& found, std::vector<PairImpact>& all) {
  if (found) all.push_back({pair, *found});
}
void add(const BodyPair& pair, const std::vector<Conflict>& found, std::vector<PairConflict>& all) {
  for (const Conflict& conflict : found) all.push_back({pair, conflict});
}

/// Calls query(polygon, moving, polygon, moving, options) for each pair that may meet, in parallel. Returns what is
/// found, by time and then by handles. `motions` are BodyMotions or BodyTrajectories.
template <typename Found, typename Answer, typename Moving, typename Query>
std::vector<Found> queryPairs(const std::vector<Moving>& motions, const char* name, const SceneState& state,
                              const ImpactOptions& options, const Parallel& parallel, const Query& query) {
  detail::checkOptions(options);
  const std::vector<std::uint32_t> motion_of = motionsOf(state, motions, name);
  const Clock clock = clockOf(motions);
  const std::vector<BodyPair> pairs = pairsNear(state, motions, motion_of, clock, options.margin);
  // One body of a pair may stand still while the other one moves.
  const auto movingBeside = [&](Slot slot, Slot other) -> Moving {
    const std::uint32_t own = motion_of[slot];
    if (own < motions.size()) return motions[own];
    return {state.handleOf(slot), stillBeside(pathOf(motions[motion_of[other]]), state.bodies[slot].pose)};
  };
  std::vector<Answer> answers(pairs.size());
  detail::inParallel(parallel, pairs.size(), [&](std::size_t i) {
    const Slot first = Scene::indexOf(pairs[i].first), second = Scene::indexOf(pairs[i].second);
    const auto &p = state.bodies[first], &q = state.bodies[second];
    const ImpactOptions both = withMargin(withMargin(options, p.options.margin), q.options.margin);
    Moving of_p = movingBeside(first, second);
    const Moving of_q = movingBeside(second, first);
    restByClock(of_p, of_q, clock);
    answers[i] = query(p.polygon, of_p, q.polygon, of_q, both);
  });
  std::vector<Found> all;
  for (std::size_t i = 0; i < pairs.size(); ++i) add(pairs[i], answers[i], all);
  std::stable_sort(all.begin(), all.end(),
                   [](const Found& p, const Found& q) { return impactOf(p).time < impactOf(q).time; });
  return all;
}

void checkMotions(const std::vector<BodyMotion>& motions) {
  for (std::size_t i = 0; i < motions.size(); ++i)
    checkMotion(motions[i].motion, ("motions[" + std::to_string(i) + "]").c_str());
}

}  // namespace

std::vector<PairImpact> Scene::impacts(const std::vector<BodyMotion>& motions, const ImpactOptions& options,
                                       const Parallel& parallel) const {
  checkMotions(motions);
  return queryPairs<PairImpact, std::optional<Impact>>(
      motions, "motions", impl_->settled(), options, parallel,
      [](const auto& p, const auto& moving_p, const auto& q, const auto& moving_q, const ImpactOptions& both) {
        return timeOfImpact(p, moving_p.motion, q, moving_q.motion, both);
      });
}

std::vector<PairImpact> Scene::impacts(const std::vector<BodyTrajectory>& trajectories, const ImpactOptions& options,
                                       const Parallel& parallel) const {
  return queryPairs<PairImpact, std::optional<Impact>>(
      trajectories, "trajectories", impl_->settled(), options, parallel,
      [](const auto& p, const auto& moving_p, const auto& q, const auto& moving_q, const ImpactOptions& both) {
        return detail::timeOfImpact(p, moving_p.trajectory, q, moving_q.trajectory, both);
      });
}

std::vector<PairConflict> Scene::conflicts(const std::vector<BodyMotion>& motions, const ImpactOptions& options,
                                           const Parallel& parallel) const {
  checkMotions(motions);
  return queryPairs<PairConflict, std::vector<Conflict>>(
      motions, "motions", impl_->settled(), options, parallel,
      [](const auto& p, const auto& moving_p, const auto& q, const auto& moving_q, const ImpactOptions& both) {
        return tricover::conflicts(p, moving_p.motion, q, moving_q.motion, both);
      });
}

std::vector<PairConflict> Scene::conflicts(const std::vector<BodyTrajectory>& trajectories,
                                           const ImpactOptions& options, const Parallel& parallel) const {
  return queryPairs<PairConflict, std::vector<Conflict>>(
      trajectories, "trajectories", impl_->settled(), options, parallel,
      [](const auto& p, const auto& moving_p, const auto& q, const auto& moving_q, const ImpactOptions& both) {
        return detail::conflicts(p, moving_p.trajectory, q, moving_q.trajectory, both);
      });
}

}  // namespace tricover
