// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/convexity.h"

#include <algorithm>
#include <memory>

#include "numbers/predicates.h"

namespace tricover::detail {
namespace {

/// Whether q, on the line of p and r, is between them: a straight vertex rather than a spike's tip.
bool isBetween(const Vec2& p, const Vec2& q, const Vec2& r) {
  return std::min(p.x(), r.x()) <= q.x() && q.x() <= std::max(p.x(), r.x()) && std::min(p.y(), r.y()) <= q.y() &&
         q.y() <= std::max(p.y(), r.y());
}

/// The corners so far, until it proves not to be convex.
bool findCorners(const PolygonData& polygon, Convexity& convexity) {
  if (polygon.ringCount() != 1) return false;
  std::vector<std::size_t> distinct;
  distinct.reserve(polygon.path.size());
  for (std::size_t i = polygon.edgeBegin(0); i < polygon.edgeEnd(0); ++i)
    if (polygon.path[i] != polygon.path[i + 1]) distinct.push_back(i);
  int turns_in_x = 0;
  const std::size_t n = distinct.size();
  convexity.corners.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &p = polygon.path[distinct[i]], &q = polygon.path[distinct[(i + 1) % n]],
               &r = polygon.path[distinct[(i + 2) % n]];
    const int turn = orientation(p, q, r);
    turns_in_x += (q.x() > p.x()) != (r.x() > q.x());
    if (turn == 0 && isBetween(p, q, r)) continue;
    if (turn == 0 || turn == -convexity.direction) return false;
    convexity.direction = turn;
    convexity.corners.push_back(distinct[(i + 1) % n]);
  }
  // Once around: x falls and rises once each.
  return turns_in_x == 2;
}

}  // namespace

const Convexity& findConvexity(const PolygonData& polygon) {
  const Derived::Thing* convexity = polygon.convexity.built([&] {
    auto found = std::make_unique<Convexity>();
    if (!findCorners(polygon, *found)) {
      found->direction = 0;
      found->corners.clear();
    }
    found->is_strict = found->corners.size() + 1 == polygon.path.size();
    return found;
  });
  return *static_cast<const Convexity*>(convexity);
}

}  // namespace tricover::detail
