// SPDX-License-Identifier: BSD-3-Clause
// Which bodies a polygon collides with.
#include <algorithm>
#include <optional>
#include <vector>

#include "scene/asked.h"

namespace tricover {
namespace detail {

Slot findMet(const SceneState& state, const Asked& asked, const SlotFilter& filter) {
  // All inner discs first: one that is met spares all that is near. What is near waits, and the likeliest comes first:
  // by keys, so that no branch depends on their order.
  Slot near[kLanes];
  LaneKeys others;
  std::int64_t first = kNoLane;
  int count = 0;
  Slot met = kNoSlot;
  state.tree.visit(asked.surroundings(), [&](Slot body, const Bounds& box) {
    const auto& other = state.bodies[body];
    if (!state.passes(filter, body) || !asked.isNear(other, box)) return true;
    if (asked.meetsInside(other) || (count == kLanes && asked.meetsClose(body))) {
      met = body;
      return false;
    }
    if (count == kLanes) return true;
    const std::int64_t key = laneKey(asked.rank(box), count);
    near[count] = body;
    others[count++] = std::max(first, key);
    first = std::min(first, key);
    return true;
  });
  if (met != kNoSlot || count == 0) return met;
  const auto nearAt = [&](std::int64_t key) { return near[static_cast<std::uint64_t>(key) % kLanes]; };
  if (asked.meetsClose(nearAt(first))) return nearAt(first);
  for (int i = 1; i < count; ++i)
    if (asked.meetsClose(nearAt(others[i]))) return nearAt(others[i]);
  return kNoSlot;
}

}  // namespace detail

using detail::Asked;
using detail::SceneState;
using detail::Slot;

bool Scene::collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) const {
  const double defect = detail::checkAsked(pose, options);
  const SceneState& state = impl_->settled();
  return findMet(state, Asked(state, polygon.data(), pose, defect, options), state.slots(filter)) != detail::kNoSlot;
}

std::optional<Scene::Body> Scene::anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                               const BodyFilter& filter) const {
  const double defect = detail::checkAsked(pose, options);
  const SceneState& state = impl_->settled();
  const Slot met = findMet(state, Asked(state, polygon.data(), pose, defect, options), state.slots(filter));
  return met != detail::kNoSlot ? std::optional<Body>(state.handleOf(met)) : std::nullopt;
}

std::vector<Scene::Body> Scene::colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                          const BodyFilter& filter) const {
  const double defect = detail::checkAsked(pose, options);
  const SceneState& state = impl_->settled();
  const Asked asked(state, polygon.data(), pose, defect, options);
  const detail::SlotFilter slots = state.slots(filter);
  std::vector<Body> found;
  state.tree.visit(asked.surroundings(), [&](Slot body, const detail::Bounds& box) {
    if (state.passes(slots, body) && asked.isNear(state.bodies[body], box) && asked.meets(body))
      found.push_back(state.handleOf(body));
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace tricover
