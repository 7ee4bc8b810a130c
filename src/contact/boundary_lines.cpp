// SPDX-License-Identifier: BSD-3-Clause
#include "contact/boundary_lines.h"

namespace tricover::detail {

/// Whether the shorter one lies on the longer one's line; if so, `into` becomes both.
bool BoundaryLines::merged(Line& into, const Line& line) const {
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

bool BoundaryLines::add(Line segment, const Vec2& t, double radius) {
  segment.clip(t, radius);
  for (Line& other : lines_)
    if (merged(other, segment)) return true;
  if (lines_.size() == most_) return false;
  lines_.push_back(segment);
  return true;
}

void BoundaryLines::addRays(const Vec2& p, std::vector<Ray>& rays, double& room) const {
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
}

}  // namespace tricover::detail
