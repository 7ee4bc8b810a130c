// SPDX-License-Identifier: BSD-3-Clause
#include "contact/parting_limits.h"

#include <algorithm>
#include <cmath>

#include "numbers/angle.h"

namespace tricover::detail {

bool PartingLimits::find(const BoundaryLines& lines, const Vec2& center, double half, double surroundings,
                         TranslationProbe& probe, BestParting& best) {
  limits_.clear();
  lines.forEachPossibleLimit([&](const Vec2& p, double error) {
    if ((p - center).lpNorm<Eigen::Infinity>() > half + resolution_ || !(p.norm() < best.length)) return;
    for (const PossibleLimit& other : limits_)
      if ((p - other.p).norm() <= noise_) return;
    limits_.push_back({p, error});
  });
  std::sort(limits_.begin(), limits_.end(),
            [](const PossibleLimit& c, const PossibleLimit& d) { return c.p.squaredNorm() < d.p.squaredNorm(); });
  bool resolved = true;
  for (const PossibleLimit& limit : limits_) {
    if (!(limit.p.norm() < best.length)) break;
    // Its lines may stand for others beside them.
    if (probe.overlapAround(limit.p, limit.error + 2 * resolution_)) continue;
    resolved &= decide(limit, lines, kRoom * surroundings, probe, best);
  }
  return resolved;
}

/// Samples each sector between the lines through p. False if a sector is too narrow to be certain of it: a free
/// translation found there counts, but one that is not free may be so for lines that count as one.
bool PartingLimits::decide(const PossibleLimit& limit, const BoundaryLines& lines, double room, TranslationProbe& probe,
                           BestParting& best) {
  const Vec2& p = limit.p;
  rays_.clear();
  lines.addRays(p, rays_, room);
  if (rays_.empty()) rays_.push_back({std::atan2(-p.y(), -p.x()), true, true});
  std::sort(rays_.begin(), rays_.end(), [](const auto& r, const auto& q) { return r.angle < q.angle; });
  bool resolved = true;
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    const BoundaryLines::Ray &ray = rays_[i], &next = rays_[i + 1 < rays_.size() ? i + 1 : 0];
    if (!ray.left || !next.right) continue;
    const double gap = next.angle - ray.angle + (i + 1 < rays_.size() ? 0 : 2 * kPi);
    const double middle = ray.angle + gap / 2, width = std::sin(std::min(gap, kPi) / 2);
    resolved &= room * width >= 3 * resolution_;
    if (room * width < 3 * noise_) continue;
    const Vec2 way(std::cos(middle), std::sin(middle));
    Vec2 sample = p + room * way;
    if (!probe.isFree(sample)) continue;
    for (double step = noise_ / width; step < room; step *= 2) {
      Vec2 beside = p + step * way;
      if (!probe.isFree(beside)) continue;
      best.improve(p, beside, limit.error);
      return resolved;
    }
    best.improve(sample, sample);
    resolved = false;
  }
  return resolved;
}

}  // namespace tricover::detail
