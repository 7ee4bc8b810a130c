// SPDX-License-Identifier: BSD-3-Clause
#include "pair/cast_ray.h"

#include <algorithm>

#include "impact/conflicts.h"
#include "impact/options.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "tricover/ray.h"
#include "tricover/segment.h"
#include "tricover/time_of_impact.h"

namespace tricover {
namespace {

/// Whether half of a ray is cast at a time, since lengths of motions, and twice these, are finite.
bool isTooLong(const Vec2& from, const Vec2& to) { return !((to - from).lpNorm<Eigen::Infinity>() < 0x1p1020); }

/// With a margin: the impact of a point that moves along the ray.
std::optional<RayHit> castRoundRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                   double margin) {
  if (isTooLong(from, to)) {
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

/// With a margin, all hits: each one, until the point has left the grown region. The cast back from there finds the end
/// as precisely as any hit.
std::vector<RayInterval> castRoundRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                         double margin) {
  std::vector<RayInterval> intervals;
  if (isTooLong(from, to)) {
    const Vec2 middle = 0.5 * from + 0.5 * to;
    for (const int half : {0, 1})
      for (RayInterval part :
           castRoundRayAll(polygon, pose, half == 0 ? from : middle, half == 0 ? middle : to, margin)) {
        for (RayHit* hit : {&part.begin, &part.end}) hit->fraction = 0.5 * (half + hit->fraction);
        const bool goes_on = !intervals.empty() && intervals.back().end.fraction == part.begin.fraction;
        if (goes_on) intervals.back().end = part.end;
        if (!goes_on) intervals.push_back(part);
      }
    return intervals;
  }
  const Polygon start = point(from);
  const Motion motion = Motion::translation(Pose::Identity(), to - from), still = Motion::still(pose);
  detail::MovingContact contact(start, motion, polygon, still, {margin, 0});
  double outside = 0;
  Vec2 at = from;
  while (auto begin = castRoundRay(polygon, pose, at, to, margin)) {
    begin->fraction = detail::timeWithin(outside, 1 - outside, begin->fraction);
    const auto found = contact.endOfContact(begin->fraction);
    const double beyond = found.is_known ? found.time : 1;
    const Vec2 apart = beyond < 1 ? Vec2(motion.at(beyond) * from) : to;
    auto end = castRoundRay(polygon, pose, apart, at, margin);
    if (!end) end = RayHit{0, begin->point, -begin->normal, begin->edge};
    end->fraction = std::max(begin->fraction, beyond - end->fraction * (beyond - outside));
    intervals.push_back({*begin, *end});
    if (!(beyond < 1)) break;
    outside = beyond;
    at = apart;
  }
  return intervals;
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

std::vector<RayInterval> castRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                    const RayOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireRigid(pose, "pose");
  detail::requireFiniteRay(from, to);
  if (!(options.margin > 0)) return detail::castPlainRayAll(polygon.data(), pose, from, to);
  return castRoundRayAll(polygon, pose, from, to, options.margin);
}

}  // namespace tricover
