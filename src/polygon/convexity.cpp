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

/// The corners so far, until it proves not to be convex. They take the place of the distinct vertices that they are of.
bool findCorners(const PolygonData& polygon, Convexity& convexity) {
  if (polygon.ringCount() != 1) return false;
  std::vector<std::size_t>& corners = convexity.corners;
  corners.reserve(polygon.path.size() - 1);
  for (std::size_t i = polygon.edgeBegin(0); i < polygon.edgeEnd(0); ++i)
    if (polygon.path[i] != polygon.path[i + 1]) corners.push_back(i);
  const std::size_t n = corners.size();
  if (n < 3) return false;
  const std::size_t start[] = {corners[0], corners[1]};
  std::size_t count = 0;
  int turns_in_x = 0;
  std::size_t before = start[0], middle = start[1];
  for (std::size_t i = 2; i < n + 2; ++i) {
    const std::size_t after = i < n ? corners[i] : start[i - n];
    const Vec2 &p = polygon.path[before], &q = polygon.path[middle], &r = polygon.path[after];
    const int turn = orientation(p, q, r);
    turns_in_x += (q.x() > p.x()) != (r.x() > q.x());
    const bool is_corner = turn != 0 || !isBetween(p, q, r);
    if (is_corner && (turn == 0 || turn == -convexity.direction)) return false;
    if (is_corner) {
      convexity.direction = turn;
      corners[count++] = middle;
    }
    before = middle;
    middle = after;
  }
  corners.resize(count);
  // Once around: x falls and rises once each.
  return turns_in_x == 2;
}

}  // namespace

const Convexity& findConvexity(const PolygonData& polygon) {
  const Derived::Thing* convexity = polygon.convexity.built([&] {
    auto found = std::make_unique<Convexity>();
    if (!findCorners(polygon, *found)) {
      found->direction = 0;
      found->corners = std::vector<std::size_t>();  // without its memory
    }
    found->is_strict = found->corners.size() + 1 == polygon.path.size();
    return found;
  });
  return *static_cast<const Convexity*>(convexity);
}

}  // namespace tricover::detail
