// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "exact_overlay.h"

/// An overlay in long doubles: coordinates from one of its vertices on, in units of about its size.
namespace tricover::exact {

using Real = long double;

struct Spot {
  Real x, y;
  friend Spot operator+(const Spot& p, const Spot& q) { return {p.x + q.x, p.y + q.y}; }
  friend Spot operator-(const Spot& p, const Spot& q) { return {p.x - q.x, p.y - q.y}; }
  friend Spot operator*(Real s, const Spot& p) { return {s * p.x, s * p.y}; }
};
inline Real dot(const Spot& p, const Spot& q) { return p.x * q.x + p.y * q.y; }
inline Real cross(const Spot& p, const Spot& q) { return p.x * q.y - p.y * q.x; }
inline Real norm(const Spot& p) { return std::hypot(p.x, p.y); }

struct Segment {
  Spot v, w;
};

/// The point of a segment that is nearest to p.
inline Spot nearestOn(const Segment& s, const Spot& p) {
  const Spot along = s.w - s.v;
  const Real square = dot(along, along), ahead = dot(p - s.v, along);
  if (!(ahead > 0)) return s.v;
  return ahead < square ? s.v + (ahead / square) * along : s.w;
}

/// The distance of p, precise relative to itself where p is beside the segment.
inline Real distanceFrom(const Segment& s, const Spot& p) {
  const Spot along = s.w - s.v;
  const Real square = dot(along, along), ahead = dot(p - s.v, along);
  if (0 < ahead && ahead < square) return std::abs(cross(along, p - s.v)) / std::sqrt(square);
  return norm(p - (ahead > 0 ? s.w : s.v));
}

struct RealOverlay {
  explicit RealOverlay(const Overlay& exact);

  std::vector<std::array<Spot, 3>> cells;
  std::vector<Segment> border;
  int exponent = 0;  ///< The unit is 2^exponent.
};

}  // namespace tricover::exact
