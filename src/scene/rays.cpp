// SPDX-License-Identifier: BSD-3-Clause
// A ray against the bodies of a scene.
#include <algorithm>
#include <limits>

#include "numbers/errors.h"
#include "numbers/rounding.h"
#include "pair/cast_ray.h"
#include "scene/scene_state.h"
#include "tricover/segment.h"

namespace tricover {

using detail::Bounds;
using detail::SceneState;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The part of a ray that is between two values of one coordinate; empty if it begins above where it ends.
struct Interval {
  Interval(double from, double way, double low, double high) {
    if (way == 0) {
      begin = from < low || from > high ? kInfinity : -kInfinity;
      end = kInfinity;
    } else {
      begin = ((way > 0 ? low : high) - from) / way;
      end = ((way > 0 ? high : low) - from) / way;
    }
  }
  double begin, end;
};

/// A lower bound of the fractions at which a ray may hit what is in a box, infinity if it can't. An interval's ends are
/// differences and quotients of `way`, which is rounded itself, and may underflow; a hit's fraction may be below the
/// true one by 1e-14.
double entryInto(const Bounds& box, const Vec2& from, const Vec2& way) {
  const Interval x(from.x(), way.x(), box.min_x, box.max_x), y(from.y(), way.y(), box.min_y, box.max_y);
  const double begin = std::max({x.begin, y.begin, 0.0}), end = std::min(x.end, y.end);
  if (begin * (1 - 0x1p-40) > end * (1 + 0x1p-40) + detail::kTiny) return kInfinity;
  return begin >= 0 ? begin * (1 - 0x1p-40) - 1e-13 : 0;  // 0 for NaN: infinity / infinity
}

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
  const Vec2 way = to - from;
  std::optional<BodyRayHit> best;
  double limit = 1;
  state.tree.visitInOrder(
      1, [&](const Bounds& box) { return entryInto(box, from, way); },
      [&](Body body) {
        const auto& other = state.bodies[body];
        if ((other.options.category & mask) == 0) return limit;
        const auto hit = other.options.margin > 0 ? castRound(other, from, to)
                                                  : detail::castRay(other.polygon.data(), other.pose, from, to, limit);
        if (hit && (!best || hit->fraction < best->hit.fraction ||
                    (hit->fraction == best->hit.fraction && body < best->body))) {
          best = BodyRayHit{body, *hit};
          limit = hit->fraction;
        }
        return limit;
      });
  return best;
}

}  // namespace tricover
