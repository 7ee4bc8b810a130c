// SPDX-License-Identifier: BSD-3-Clause
// The body that a ray meets first, and all of a ray that is in bodies.
#include <algorithm>
#include <tuple>
#include <utility>

#include "numbers/errors.h"
#include "overlay/plain_ray.h"
#include "scene/scene_state.h"

namespace tricover {

using detail::SceneState;

std::optional<BodyRayHit> Scene::castRay(const Vec2& from, const Vec2& to, const RayOptions& options,
                                         const BodyFilter& filter) const {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireFiniteRay(from, to);
  const SceneState& state = impl_->settled();
  const detail::SlotFilter slots = state.slots(filter);
  std::optional<BodyRayHit> best;
  double limit = 1;
  // A hit's fraction may be below the true one by 1e-14, and by more for a body with a margin; see timeOfImpact().
  state.tree.visitOnRay(detail::BoxRay(from, to, options.margin), limit, [&](detail::Slot slot) {
    const auto& other = state.bodies[slot];
    if (!state.passes(slots, slot)) return limit;
    const Body body = state.handleOf(slot);
    const double margin = detail::marginSum(options.margin, other.options.margin);
    const auto hit = margin > 0 ? tricover::castRay(other.polygon, other.pose, from, to, {margin})
                                : detail::castPlainRay(detail::dataOf(other.polygon), other.pose, from, to, limit);
    if (hit && (!best || std::pair(hit->fraction, body) < std::pair(best->hit.fraction, best->body))) {
      best = BodyRayHit{body, *hit};
      limit = hit->fraction;
    }
    return limit;
  });
  return best;
}

std::vector<BodyRayInterval> Scene::castRayAll(const Vec2& from, const Vec2& to, const RayOptions& options,
                                               const BodyFilter& filter) const {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireFiniteRay(from, to);
  const SceneState& state = impl_->settled();
  const detail::SlotFilter slots = state.slots(filter);
  std::vector<BodyRayInterval> found;
  state.tree.visitOnRay(detail::BoxRay(from, to, options.margin), 1, [&](detail::Slot slot) {
    const auto& other = state.bodies[slot];
    if (!state.passes(slots, slot)) return 1.0;
    const double margin = detail::marginSum(options.margin, other.options.margin);
    for (const RayInterval& interval :
         tricover::castRayAll(other.polygon, other.pose, from, to, {std::max(margin, 0.0)}))
      found.push_back({state.handleOf(slot), interval});
    return 1.0;
  });
  std::sort(found.begin(), found.end(), [](const BodyRayInterval& p, const BodyRayInterval& q) {
    return std::tuple(p.interval.begin.fraction, p.body, p.interval.end.fraction) <
           std::tuple(q.interval.begin.fraction, q.body, q.interval.end.fraction);
  });
  return found;
}

}  // namespace tricover
