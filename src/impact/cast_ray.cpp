// SPDX-License-Identifier: BSD-3-Clause
#include "pair/cast_ray.h"

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "tricover/ray.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"

namespace tricover {
namespace {

/// With a margin: the impact of a point that moves along the ray.
std::optional<RayHit> castRoundRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                   double margin) {
  if (!(to - from).allFinite()) {  // no motion is as long: in two halves
    const Vec2 middle = 0.5 * from + 0.5 * to;
    std::optional<RayHit> hit = castRoundRay(polygon, pose, from, middle, margin);
    if (hit) {
      hit->fraction *= 0.5;
    } else if ((hit = castRoundRay(polygon, pose, middle, to, margin))) {
      hit->fraction = 0.5 + 0.5 * hit->fraction;
    }
    return hit;
  }
  const auto impact = timeOfImpact(point(from), Motion::translation(Pose::Identity(), to - from), polygon,
                                   Motion::still(pose), {margin, 0});
  if (!impact) return std::nullopt;
  return RayHit{impact->time, from + impact->time * (to - from), -impact->normal,
                impact->time > 0 ? impact->edge_b : -1};
}

}  // namespace

std::optional<RayHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                              const RayOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireRigid(pose, "pose");
  detail::requireFiniteRay(from, to);
  if (options.margin > 0) return castRoundRay(polygon, pose, from, to, options.margin);
  return detail::castPlainRay(polygon.data(), pose, from, to, 1);
}

}  // namespace tricover
