// SPDX-License-Identifier: BSD-3-Clause
#include "contact/boundary_curves.h"

namespace tricover::detail {

/// Whether the shorter one lies on the longer one's line; if so, `into` becomes both.
bool BoundaryCurves::merged(Line& into, const Line& line) const {
  const bool longer = line.length > into.length;
  const Line &base = longer ? line : into, &other = longer ? into : line;
  if (!(base.length > 0)) return !((other.v - base.v).norm() > resolution_);
  if (std::abs(cross(base.axis, other.v - base.v)) > resolution_ ||
      std::abs(cross(base.axis, other.w - base.v)) > resolution_)
    return false;
  const double p = (other.v - base.v).dot(base.axis), q = (other.w - base.v).dot(base.axis);
  const double low = std::min({0.0, p, q}), high = std::max({base.length, p, q});
  Line both = base;
  if (low < 0) both.v = base.v + low * base.axis;
  if (high > base.length) both.w = base.v + high * base.axis;
  both.length = high - low;
  both.slack = std::max({base.slack, other.slack, std::abs(cross(base.axis, other.axis))});
  both.both_sides = base.both_sides || other.both_sides || !(base.axis.dot(other.axis) > 0.5);
  into = both;
  return true;
}

BoundaryCurves::Added BoundaryCurves::addLine(const Line& line) {
  for (Line& other : lines_)
    if (merged(other, line)) return Repeated;
  if (lines_.size() + centers_.size() == most_) return TooMany;
  lines_.push_back(line);
  return New;
}

BoundaryCurves::Added BoundaryCurves::addCircle(const Vec2& center) {
  for (const Vec2& other : centers_)
    if ((other - center).norm() <= resolution_) return Repeated;
  if (lines_.size() + centers_.size() == most_) return TooMany;
  centers_.push_back(center);
  return New;
}

bool BoundaryCurves::addRays(const Vec2& p, std::vector<Ray>& rays, double& room) const {
  for (const Line& line : lines_) {
    const double apart = (nearestOnSegment(p, line.v, line.w) - p).norm();
    if (apart > 2 * resolution_) {
      room = std::min(room, apart / 2);
      continue;
    }
    for (const Vec2& end : {line.v, line.w}) {
      const Vec2 ray = end - p;
      const double length = ray.norm();
      if (length <= 2 * resolution_) continue;
      room = std::min(room, length / 2);
      const bool is_along = ray.dot(line.axis) > 0;
      rays.push_back({std::atan2(ray.y(), ray.x()), is_along || line.both_sides, !is_along || line.both_sides});
    }
  }
  bool is_curved = false;
  for (const Vec2& center : centers_) {
    const Vec2 spoke = p - center;
    const double apart = std::abs(spoke.norm() - margin_);
    if (apart > 2 * resolution_) {
      room = std::min(room, apart / 2);
      continue;
    }
    is_curved = true;
    rays.push_back({std::atan2(spoke.x(), -spoke.y()), false, true});
    rays.push_back({std::atan2(-spoke.x(), spoke.y()), true, false});
  }
  return is_curved;
}

}  // namespace tricover::detail
