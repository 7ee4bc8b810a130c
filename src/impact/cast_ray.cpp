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

/// With a margin: the impacts of a point that moves along the ray. All lengths are divided by a power of two if the
/// ray's length, or twice that, is not finite.
class RoundRay {
 public:
  RoundRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to, double margin)
      : scale_((to - from).lpNorm<Eigen::Infinity>() < 0x1p1020 ? 1 : 0x1p-4),
        polygon_(scale_ == 1 ? polygon : polygon.scaled(scale_)),
        still_(Motion::still(pose)),
        from_(scale_ * from),
        to_(scale_ * to),
        margin_(scale_ * margin) {
    still_.start.translation() *= scale_;
  }

  std::optional<RayHit> first() const { return first(from_, to_); }

  /// Each hit, until the point has left the grown region. The cast back from there finds the end as precisely as any
  /// hit.
  std::vector<RayInterval> all() const {
    std::vector<RayInterval> intervals;
    const Polygon start = point(from_);
    const Motion motion = Motion::translation(Pose::Identity(), to_ - from_);
    detail::MovingContact contact(start, motion, polygon_, still_, {margin_, 0});
    double outside = 0;
    Vec2 at = from_;
    while (auto begin = first(at, to_)) {
      begin->fraction = detail::timeWithin(outside, 1 - outside, begin->fraction);
      const auto found = contact.endOfContact(begin->fraction);
      const double beyond = found.is_known ? found.time : 1;
      const Vec2 apart = beyond < 1 ? Vec2(motion.at(beyond) * from_) : to_;
      auto end = first(apart, at);
      if (!end) end = RayHit{0, begin->point, -begin->normal, begin->edge};
      end->fraction = std::max(begin->fraction, beyond - end->fraction * (beyond - outside));
      intervals.push_back({*begin, *end});
      if (!(beyond < 1)) break;
      outside = beyond;
      at = apart;
    }
    return intervals;
  }

 private:
  std::optional<RayHit> first(const Vec2& from, const Vec2& to) const {
    const auto impact =
        timeOfImpact(point(from), Motion::translation(Pose::Identity(), to - from), polygon_, still_, {margin_, 0});
    if (!impact) return std::nullopt;
    return RayHit{impact->time, (from + impact->time * (to - from)) / scale_, -impact->normal,
                  impact->time > 0 ? impact->edge_b : -1};
  }

  double scale_;
  Polygon polygon_;
  Motion still_;
  Vec2 from_, to_;
  double margin_;
};

void checkRay(const Pose& pose, const Vec2& from, const Vec2& to, const RayOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireRigid(pose, "pose");
  detail::requireFiniteRay(from, to);
}

}  // namespace

std::optional<RayHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                              const RayOptions& options) {
  checkRay(pose, from, to, options);
  if (options.margin > 0) return RoundRay(polygon, pose, from, to, options.margin).first();
  return detail::castPlainRay(polygon.data(), pose, from, to, 1);
}

std::vector<RayInterval> castRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                    const RayOptions& options) {
  checkRay(pose, from, to, options);
  if (!(options.margin > 0)) return detail::castPlainRayAll(polygon.data(), pose, from, to);
  return RoundRay(polygon, pose, from, to, options.margin).all();
}

}  // namespace tricover
