// SPDX-License-Identifier: BSD-3-Clause
// Which bodies a polygon collides with.
#include <algorithm>
#include <optional>
#include <vector>

#include "scene/asked.h"

namespace tricover {
namespace detail {

Slot findMet(const SceneState& state, const Asked& asked, const SlotFilter& filter) {
  // All discs first: one that is met spares all that is near. What is near waits in order.
  constexpr int kMost = 16;
  struct Waiting {
    double rank;
    Slot body;
  } near[kMost];
  int count = 0;
  Slot met = kNoSlot;
  state.tree.visit(asked.surroundings(), [&](Slot body, const Bounds& box) {
    const auto& other = state.bodies[body];
    if (!state.passes(filter, body) || !asked.isNear(other, box)) return true;
    const Asked::Glance glance = asked.glance(other);
    if (glance.answer == Asked::Glance::Apart) return true;
    if (glance.answer == Asked::Glance::Meets || (count == kMost && asked.meetsClose(body))) {
      met = body;
      return false;
    }
    if (count == kMost) return true;
    int place = count++;
    for (; place > 0 && glance.rank < near[place - 1].rank; --place) near[place] = near[place - 1];
    near[place] = {glance.rank, body};
    return true;
  });
  if (met != kNoSlot) return met;
  for (int i = 0; i < count; ++i)
    if (asked.meetsClose(near[i].body)) return near[i].body;
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
