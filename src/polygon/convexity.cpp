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
  // The second one that is distinct was the first to be asked.
  if (!corners.empty() && corners.back() < corners.front())
    std::rotate(corners.begin(), corners.end() - 1, corners.end());
  // Once around: x falls and rises once each.
  return turns_in_x == 2;
}

}  // namespace

Convexity::Convexity(const PolygonData& polygon) {
  const bool is_convex = findCorners(polygon, *this);
  if (!is_convex) direction = 0;
  has_others = is_convex && corners.size() + 1 < polygon.path.size();
  if (!has_others) corners = std::vector<std::size_t>();  // without its memory
  by_corners = has_others ? polygon.reducedTo(corners) : is_convex ? &polygon : nullptr;
}

Convexity::~Convexity() {
  if (has_others) by_corners->release();
}

const Convexity& findConvexity(const PolygonData& polygon) {
  return *static_cast<const Convexity*>(
      polygon.convexity.built([&] { return std::make_unique<const Convexity>(polygon); }));
}

std::size_t edgeBeside(const PolygonData& polygon, std::size_t begin, std::size_t end, const Vec2& p) {
  const std::size_t count = polygon.path.size() - 1;
  const Vec2 point = polygon.inUnits(p), start = polygon.inUnits(polygon.path[begin]),
             way = polygon.inUnits(polygon.path[end]) - start;
  // The last one that begins before p, and before the end: vertices may be repeated.
  const double along = std::min(way.dot(point - start), way.squaredNorm());
  const auto after = [&](std::size_t steps) { return begin + steps < count ? begin + steps : begin + steps - count; };
  std::size_t low = 0, high = end > begin ? end - begin : end + count - begin;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    const double at = way.dot(polygon.inUnits(polygon.path[after(middle)]) - start);
    (at <= along && at < way.squaredNorm() ? low : high) = middle;
  }
  return after(low);
}

std::size_t edgeOfPath(const PolygonData& polygon, std::size_t k, const Vec2& p) {
  const std::vector<std::size_t>& corners = convexityOf(polygon).corners;
  return edgeBeside(polygon, corners[k], corners[k + 1 < corners.size() ? k + 1 : 0], p);
}

EdgeIndex givenEdge(const PolygonData& given, const PolygonData& taken, std::size_t position, double part) {
  if (&given == &taken) return static_cast<EdgeIndex>(given.edgeNumber(position));
  const Vec2 point = (1 - part) * taken.path[position] + part * taken.path[position + 1];
  return static_cast<EdgeIndex>(edgeOfPath(given, position, point));
}

}  // namespace tricover::detail
