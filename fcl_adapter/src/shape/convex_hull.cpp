// SPDX-License-Identifier: BSD-3-Clause
#include "shape/convex_hull.h"

#include <algorithm>
#include <utility>

#include "numbers/convex_hull.h"

namespace tricover_fcl {

using tricover::Ring;
using tricover::Vec2;

Ring convexHull(const std::vector<Vec2>& points) {
  // Seen from the first point and scaled to 1, because products of the coordinates themselves may over- or underflow.
  struct Seen {
    Vec2 at;
    const Vec2* point;
  };
  std::vector<Seen> seen;
  double size = 0;
  for (const Vec2& p : points) {
    seen.push_back({0.25 * p - 0.25 * points.front(), &p});
    size = std::max(size, seen.back().at.lpNorm<Eigen::Infinity>());
  }
  if (size == 0) return Ring(3, points.front());
  for (Seen& s : seen) s.at /= size;
  const auto turnsLeft = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    const Vec2 u = q - p, v = r - p;
    return u.x() * v.y() - u.y() * v.x() > 0;
  };
  const auto at = [](const Seen& point) -> const Vec2& { return point.at; };
  Ring ring;
  for (const Seen& corner : tricover::detail::convexHull(std::move(seen), at, turnsLeft)) ring.push_back(*corner.point);
  while (ring.size() < 3) ring.push_back(ring.back());
  return ring;
}

}  // namespace tricover_fcl
