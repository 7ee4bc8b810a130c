// SPDX-License-Identifier: BSD-3-Clause
#include "contact/parting_limits.h"

#include <algorithm>
#include <cmath>

#include "numbers/angle.h"

namespace tricover::detail {

bool PartingLimits::find(const BoundaryCurves& curves, const Vec2& center, double half, double radius,
                         TranslationProbe& probe, BestParting& best, double& reach) {
  limits_.clear();
  const auto isWanted = [&](const Vec2& p) {
    return (p - center).lpNorm<Eigen::Infinity>() <= half + resolution_ && p.norm() < reach;
  };
  const auto offer = [&](const Vec2& p, double error) {
    if (!isWanted(p)) return;
    for (const PossibleLimit& other : limits_)
      if ((p - other.p).norm() <= noise_) return;
    limits_.push_back({p, error});
  };
  bool resolved = true;
  curves.forEachPossibleLimit(offer, [&](const Vec2& p, const Vec2& along) {
    if (isWanted(p)) resolved = decideTouch(p, along, radius, probe, best) && resolved;
  });
  if (reach > best.length) {
    // What is free on beyond the square may be nearest to 0 on its sides.
    offer(center - center.cwiseMax(-half).cwiseMin(half), 0);
    for (const double side : {-half, half}) {
      curves.forEachCrossing(center + Vec2(-half, side), center + Vec2(half, side), offer);
      curves.forEachCrossing(center + Vec2(side, -half), center + Vec2(side, half), offer);
    }
  }
  std::sort(limits_.begin(), limits_.end(),
            [](const PossibleLimit& c, const PossibleLimit& d) { return c.p.squaredNorm() < d.p.squaredNorm(); });
  for (const PossibleLimit& limit : limits_) {
    if (!(limit.p.norm() < reach)) break;
    // Its lines may stand for others beside them.
    if (probe.overlapAround(limit.p, limit.error + 2 * resolution_)) continue;
    resolved &= decide(limit, curves, radius, probe, best, reach);
  }
  return resolved;
}

/// Samples the two cusps that circles, or a circle and a line, leave where they touch: at s along them they are
/// s^2 / (2 margin) wide, and what is narrower than some resolutions isn't seen. False if they are yet to be found.
bool PartingLimits::decideTouch(const Vec2& p, const Vec2& along, double radius, TranslationProbe& probe,
                                BestParting& best) const {
  const double first = std::max(8 * std::sqrt(resolution_ * margin_), resolution_);  // the product may underflow
  for (const Vec2& way : {along, Vec2(-along)})
    for (double step = first; step < kRoom * radius; step *= 2) {
      Vec2 sample = p + step * way;
      if (!probe.isFree(sample)) continue;
      best.improve(sample, sample);
      break;
    }
  return first >= kRoom * radius || !(p.norm() + first < best.length);
}

/// Samples each sector between the curves through p. False if one is too narrow to be certain of it: what is free
/// there is found, and what isn't may be so for curves that are taken for one.
bool PartingLimits::decide(const PossibleLimit& limit, const BoundaryCurves& curves, double radius,
                           TranslationProbe& probe, BestParting& best, double& reach) {
  const Vec2& p = limit.p;
  double room = kRoom * radius;
  rays_.clear();
  const bool is_curved = curves.addRays(p, rays_, room);
  if (rays_.empty()) rays_.push_back({std::atan2(-p.y(), -p.x()), true, true});
  std::sort(rays_.begin(), rays_.end(), [](const auto& r, const auto& q) { return r.angle < q.angle; });
  bool resolved = true;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const BoundaryCurves::Ray &ray = rays_[i], &next = rays_[i + 1 < rays_.size() ? i + 1 : 0];
    if (!ray.left || !next.right) continue;
    const double gap = next.angle - ray.angle + (i + 1 < rays_.size() ? 0 : 2 * kPi);
    const double middle = ray.angle + gap / 2, width = std::sin(std::min(gap, kPi) / 2);
    // On a way s a circle leaves its tangent by s^2 / (2 margin): no more than half of the sector's width.
    const double far = is_curved ? std::min(room, margin_ * width) : room;
    resolved &= far * width >= 3 * resolution_;
    if (far * width < 3 * noise_) continue;
    const Vec2 way(std::cos(middle), std::sin(middle));
    Vec2 sample = p + far * way;
    if (!probe.isFree(sample)) continue;
    for (double step = noise_ / width; step < far; step *= 2) {
      Vec2 beside = p + step * way;
      if (!probe.isFree(beside)) continue;
      best.improve(p, beside, limit.error);
      reach = std::min(reach, p.norm() - limit.error);
      return resolved;
    }
    best.improve(sample, sample);
    reach = std::min(reach, sample.norm());
    resolved = false;
  }
  return resolved;
}

}  // namespace tricover::detail
