// SPDX-License-Identifier: BSD-3-Clause
#include "contact/boundary_curves.h"

namespace tricover::detail {

BoundaryCurves::Line BoundaryCurves::clipped(const Ends& line, const Vec2& center, double radius) {
  const Vec2 u = line.w - line.v;
  const double length = u.norm();
  if (!(length > 0)) return {{line.v, line.w}, Vec2::Zero(), 0};
  const Vec2 axis = u / length;
  const double middle = (center - line.v).dot(axis);
  const double low = std::clamp(middle - radius, 0.0, length), high = std::clamp(middle + radius, 0.0, length);
  return {{low > 0 ? Vec2(line.v + low * axis) : line.v, high < length ? Vec2(line.v + high * axis) : line.w},
          axis,
          high - low};
}

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
  into = {{low < 0 ? Vec2(base.v + low * base.axis) : base.v,
           high > base.length ? Vec2(base.v + high * base.axis) : base.w},
          base.axis,
          high - low};
  return true;
}

BoundaryCurves::Added BoundaryCurves::addLine(const Line& line) {
  for (Line& other : lines_)
    if (merged(other, line)) return Repeated;
  if (lines_.size() + centers_.size() == kMost) return TooMany;
  lines_.push_back(line);
  return New;
}

BoundaryCurves::Added BoundaryCurves::addCircle(const Vec2& center) {
  for (const Vec2& other : centers_)
    if ((other - center).norm() <= resolution_) return Repeated;
  if (lines_.size() + centers_.size() == kMost) return TooMany;
  centers_.push_back(center);
  return New;
}

bool BoundaryCurves::addRays(const Vec2& p, std::vector<double>& rays, double& room) const {
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
      rays.push_back(std::atan2(ray.y(), ray.x()));
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
    rays.push_back(std::atan2(spoke.x(), -spoke.y()));
    rays.push_back(std::atan2(-spoke.x(), spoke.y()));
  }
  return is_curved;
}

}  // namespace tricover::detail
