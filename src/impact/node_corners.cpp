// SPDX-License-Identifier: BSD-3-Clause
#include "impact/node_corners.h"

#include <algorithm>
#include <cmath>

#include "impact/tight_nodes.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// The foremost corner along an axis, at a window's begin.
Vec2 foremost(const std::vector<Vec2>& corners, const Places& p, const Vec2& n) {
  const double mx = p.m00[0] * n.x() + p.m10[0] * n.y(), my = p.m01[0] * n.x() + p.m11[0] * n.y();
  const Vec2* best = corners.data();
  double most = mx * best->x() + my * best->y();
  for (const Vec2& corner : corners) {
    const double height = mx * corner.x() + my * corner.y();
    if (height > most) most = height, best = &corner;
  }
  return {p.m00[0] * best->x() + p.m01[0] * best->y() + p.x[0], p.m10[0] * best->x() + p.m11[0] * best->y() + p.y[0]};
}

Double2 reachAlong(Double2 nx, Double2 ny, const std::vector<Vec2>& corners, const Places& p) {
  const Double2 mx = p.m00 * nx + p.m10 * ny, my = p.m01 * nx + p.m11 * ny;
  Double2 most = mx * corners[0].x() + my * corners[0].y();
  for (const Vec2& corner : corners) most = larger(most, mx * corner.x() + my * corner.y());
  return most;
}

bool holdsOrigin(const Vec2& p, const Vec2& q, const Vec2& r) {
  const double pq = cross(p, q), qr = cross(q, r), rp = cross(r, p);
  return (pq >= 0 && qr >= 0 && rp >= 0) || (pq <= 0 && qr <= 0 && rp <= 0);
}

}  // namespace

const std::vector<Vec2>& NodeCorners::below(std::uint32_t index) {
  return corners_.of(index, [&] {
    std::vector<Vec2> corners;
    for (const std::uint32_t edge : edgesBelow(mover_, mover_.node(index))) {
      const Vec2 from = mover_.vertex(edge);
      if (corners.empty() || corners.back() != from) corners.push_back(from);
      corners.push_back(mover_.vertex(edge + 1));
    }
    return corners;
  });
}

// Whatever the axis is, what it is used for is proven along it: so nothing here needs to be.
std::optional<Vec2> axisBetween(const std::vector<Vec2>& a, const Places& places_a, const std::vector<Vec2>& b,
                                const Places& places_b, const Vec2& guess, double least) {
  constexpr int kMostSteps = 16;
  constexpr double kNearly = 0.9;
  const Vec2 origin(0, 0);
  Vec2 nearest = guess, ends[2], best(0, 0);
  double widest = least;
  for (int step = 0; step < kMostSteps; ++step) {
    const double distance = nearest.norm();
    if (!(distance > 0)) break;
    const Vec2 axis = nearest / distance;
    const Vec2 found = foremost(b, places_b, -axis) - foremost(a, places_a, axis);
    const double gap = axis.dot(found);
    if (gap > widest) widest = gap, best = axis;
    if (step == 0) {
      ends[0] = ends[1] = nearest = found;
      continue;
    }
    if (gap >= kNearly * distance || !(distance > least)) break;
    if (step > 1 && holdsOrigin(ends[0], ends[1], found)) break;
    const Vec2 beside[] = {nearestOnSegment(origin, ends[0], found), nearestOnSegment(origin, ends[1], found)};
    const int kept = beside[0].squaredNorm() <= beside[1].squaredNorm() ? 0 : 1;
    nearest = beside[kept];
    ends[0] = ends[kept];
    ends[1] = found;
  }
  return best != origin ? std::optional<Vec2>(best) : std::nullopt;
}

Double2 gapAlong(const GapCutter::Axis& axis, const std::vector<Vec2>& a, const Places& places_a,
                 const std::vector<Vec2>& b, const Places& places_b) {
  return axis.x * (places_b.x - places_a.x) + axis.y * (places_b.y - places_a.y) -
         reachAlong(axis.x, axis.y, a, places_a) - reachAlong(-axis.x, -axis.y, b, places_b);
}

}  // namespace tricover::detail
