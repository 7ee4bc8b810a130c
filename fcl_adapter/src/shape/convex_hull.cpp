// SPDX-License-Identifier: BSD-3-Clause
#include "shape/convex_hull.h"

#include <algorithm>

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
  std::sort(seen.begin(), seen.end(), [](const Seen& s, const Seen& t) {
    return s.at.x() != t.at.x() ? s.at.x() < t.at.x() : s.at.y() < t.at.y();
  });

  // Andrew's monotone chain: the lower half from left to right, then the upper one back.
  const auto turnsLeft = [](const Seen& p, const Seen& q, const Seen& r) {
    const Vec2 u = q.at - p.at, v = r.at - p.at;
    return u.x() * v.y() - u.y() * v.x() > 0;
  };
  std::vector<Seen> chain;
  const auto addHalf = [&](auto first, auto last) {
    const std::size_t start = chain.size();
    for (; first != last; ++first) {
      while (chain.size() >= start + 2 && !turnsLeft(chain[chain.size() - 2], chain.back(), *first)) chain.pop_back();
      chain.push_back(*first);
    }
    chain.pop_back();  // the other half starts with it
  };
  addHalf(seen.begin(), seen.end());
  addHalf(seen.rbegin(), seen.rend());

  Ring ring;
  for (const Seen& s : chain) ring.push_back(*s.point);
  while (ring.size() < 3) ring.push_back(ring.back());
  return ring;
}

}  // namespace tricover_fcl
