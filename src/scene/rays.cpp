// SPDX-License-Identifier: BSD-3-Clause
// A ray against the bodies of a scene.
#include <utility>

#include "numbers/errors.h"
#include "pair/cast_ray.h"
#include "scene/scene_state.h"
#include "tricover/segment.h"

namespace tricover {

using detail::SceneState;

namespace {

/// A body that is grown by a margin, by the impact of a point that moves along the ray.
std::optional<RayHit> castRound(const SceneState::BodyState& body, const Vec2& from, const Vec2& to) {
  if (!(to - from).allFinite()) {  // no motion is as long: in two halves
    const Vec2 middle = 0.5 * from + 0.5 * to;
    std::optional<RayHit> hit = castRound(body, from, middle);
    if (hit) {
      hit->fraction *= 0.5;
    } else if ((hit = castRound(body, middle, to))) {
      hit->fraction = 0.5 + 0.5 * hit->fraction;
    }
    return hit;
  }
  const auto impact = timeOfImpact(point(from), Motion::translation(Pose::Identity(), to - from), body.polygon,
                                   Motion::still(body.pose), {0, body.options.margin});
  if (!impact) return std::nullopt;
  return RayHit{impact->time, from + impact->time * (to - from), -impact->normal,
                impact->time > 0 ? impact->edge_b : -1};
}

}  // namespace

std::optional<BodyRayHit> Scene::castRay(const Vec2& from, const Vec2& to, std::uint32_t mask) const {
  if (!from.allFinite()) detail::refuse("from", "a coordinate is not finite");
  if (!to.allFinite()) detail::refuse("to", "a coordinate is not finite");
  const SceneState& state = *impl_;
  std::optional<BodyRayHit> best;
  double limit = 1;
  // A hit's fraction may be below the true one by 1e-14, and of a body with a margin by what timeOfImpact() allows.
  state.tree.visitOnRay(detail::BoxRay(from, to), limit, [&](Body body) {
    const auto& other = state.bodies[body];
    if ((other.options.category & mask) == 0) return limit;
    const auto hit = other.options.margin > 0 ? castRound(other, from, to)
                                              : detail::castRay(other.polygon.data(), other.pose, from, to, limit);
    if (hit && (!best || std::pair(hit->fraction, body) < std::pair(best->hit.fraction, best->body))) {
      best = BodyRayHit{body, *hit};
      limit = hit->fraction;
    }
    return limit;
  });
  return best;
}

}  // namespace tricover
