// SPDX-License-Identifier: BSD-3-Clause
// The body that a moving polygon comes nearest to.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "depth/conflicts.h"
#include "numbers/errors.h"
#include "scene/scene_state.h"
#include "scene/sweep.h"

namespace tricover {

using detail::SceneState;
using detail::Slot;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The tree proposes bodies by the distances of their boxes from those around the polygon on its way. `path`
/// is a Motion or a Trajectory.
template <typename Path>
std::optional<BodyLeastDistance> leastOn(const Path& path, const Polygon& polygon, const LeastDistanceOptions& options,
                                         const SceneState& state, const BodyFilter& filter) {
  detail::checkOptions(options);
  const detail::SlotFilter slots = state.slots(filter);
  std::optional<BodyLeastDistance> best;
  double proven = kInfinity;  // no body comes nearer whose search ended at its budget
  std::vector<Slot> tested;   // sorted
  const auto look = [&](Slot slot) {
    const auto& body = state.bodies[slot];
    LeastDistanceOptions sum = options;
    sum.margin = detail::marginOfBox(detail::marginSum(options.margin, body.options.margin));
    const LeastDistance least =
        tricover::leastDistance(polygon, path, body.polygon, detail::stillBeside(path, body.pose), sum);
    if (least.budget_ended) proven = std::min(proven, least.lower_bound);
    const bool budget_ended = least.budget_ended || (best && best->least.budget_ended);
    const BodyLeastDistance found{state.handleOf(slot), least};
    if (!best || std::pair(least.distance, found.body) < std::pair(best->least.distance, best->body)) best = found;
    best->least.budget_ended = budget_ended;
  };
  const detail::Sweep sweep(polygon, detail::legsOf(path), options.margin);
  for (const detail::SweptLeg& leg : sweep.legs()) {
    const double count = leg.intervals();
    for (double i = 0; i < count; ++i) {
      const auto limit = [&] { return best ? best->least.distance : kInfinity; };
      state.tree.visitNear(leg.between(i / count, (i + 1) / count), limit(), [&](Slot slot) {
        const auto place = std::lower_bound(tested.begin(), tested.end(), slot);
        if (state.passes(slots, slot) && (place == tested.end() || *place != slot)) {
          tested.insert(place, slot);
          look(slot);
        }
        return limit();
      });
    }
  }
  // The bounds of the others, which depend on the order, are at most the error below their distances.
  if (best) {
    const double of_others = std::max(best->least.distance - options.absolute_error, 0.0);
    best->least.lower_bound = std::min({proven, best->least.lower_bound, of_others});
  }
  return best;
}

}  // namespace

std::optional<BodyLeastDistance> Scene::leastDistance(const Polygon& polygon, const Motion& motion,
                                                      const LeastDistanceOptions& options,
                                                      const BodyFilter& filter) const {
  checkMotion(motion);
  return leastOn(motion, polygon, options, impl_->settled(), filter);
}

std::optional<BodyLeastDistance> Scene::leastDistance(const Polygon& polygon, const Trajectory& trajectory,
                                                      const LeastDistanceOptions& options,
                                                      const BodyFilter& filter) const {
  if (trajectory.rests()) detail::refuse("trajectory", "it always rests, as all bodies do", "ask nearest()");
  return leastOn(trajectory, polygon, options, impl_->settled(), filter);
}

}  // namespace tricover
