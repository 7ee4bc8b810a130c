// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/convexity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/double2.h"
#include "numbers/predicates.h"

namespace tricover::detail {
namespace {

/// Whether q, on the line of p and r, is between them: a straight vertex rather than a spike's tip.
bool isBetween(const Vec2& p, const Vec2& q, const Vec2& r) {
  return std::min(p.x(), r.x()) <= q.x() && q.x() <= std::max(p.x(), r.x()) && std::min(p.y(), r.y()) <= q.y() &&
         q.y() <= std::max(p.y(), r.y());
}

/// orientation() of p, q and r, by the edges into q and out of it. Their cross product is that of q - p and r - p, and
/// what approxArea() has for exact points bounds it as well.
int turnAt(const Vec2& p, const Vec2& q, const Vec2& r, Double2 into, Double2 out) {
  const Double2 products = into * swapped(out), sizes = absolute(products);
  const double det = products[0] - products[1], bound = kAreaError * (sizes[0] + sizes[1]) + kTiny;
  return det > bound ? 1 : -det > bound ? -1 : orientation(p, q, r);
}

/// How many of the positions are corners, which come first then; 0 if it isn't convex. They take the place of the
/// distinct vertices that they are of.
std::size_t findCorners(const PolygonData& polygon, EdgePosition* corners, int& direction) {
  const Vec2* const path = polygon.path.data();
  const auto at = [&](EdgePosition position) { return load2(path[position].data()); };
  std::size_t n = 0;
  for (EdgePosition i = 0; i + 1 < polygon.path.size(); ++i) {
    corners[n] = i;
    n += bitsOf(at(i) == at(i + 1)) != 3 ? 1 : 0;
  }
  if (n < 3) return 0;
  const EdgePosition start[] = {corners[0], corners[1]};
  std::size_t count = 0;
  int turns_in_x = 0;
  EdgePosition before = start[0], middle = start[1];
  Double2 into = at(middle) - at(before);
  for (std::size_t i = 2; i < n + 2; ++i) {
    const EdgePosition after = i < n ? corners[i] : start[i - n];
    const Vec2 &p = path[before], &q = path[middle], &r = path[after];
    const Double2 out = at(after) - at(middle);
    const int turn = turnAt(p, q, r, into, out);
    turns_in_x += (q.x() > p.x()) != (r.x() > q.x());  // differences may underflow
    const bool is_corner = turn != 0 || !isBetween(p, q, r);
    if (is_corner && (turn == 0 || turn == -direction)) return 0;
    if (is_corner) {
      direction = turn;
      corners[count++] = middle;
    }
    before = middle;
    middle = after;
    into = out;
  }
  // The second distinct vertex was tested first.
  if (count > 0 && corners[count - 1] < corners[0]) std::rotate(corners, corners + count - 1, corners + count);
  // Once around: x falls and rises once each.
  return turns_in_x == 2 ? count : 0;
}

/// Convexity::edge_depth of a polygon all of whose vertices are corners. Squares that leave the range of doubles make
/// it 0.
double edgeDepthOf(const PolygonData& polygon) {
  const auto edge = [&](std::size_t k) { return load2(polygon.path[k + 1].data()) - load2(polygon.path[k].data()); };
  double least = std::numeric_limits<double>::max();
  const std::size_t count = polygon.path.size() - 1;
  Double2 before = edge(count - 1);
  double square_before = dot(before, before);
  for (std::size_t k = 0; k < count; ++k) {
    const Double2 along = edge(k);
    const double square = dot(along, along), area = cross(before, along);
    if (!(area * area > kClearCorner * kClearCorner * (square_before * square))) return 0;
    least = std::min(least, area * area / std::max(square_before, square));
    before = along;
    square_before = square;
  }
  return std::sqrt(least);
}

}  // namespace

Convexity::Convexity(const PolygonData& polygon) {
  constexpr std::size_t kFew = 32;
  EdgePosition few[kFew];
  std::size_t count = 0;
  if (polygon.ringCount() == 1 && !polygon.fill.is_complement) {
    std::vector<EdgePosition> many;
    if (polygon.path.size() > kFew) many.resize(polygon.path.size());
    EdgePosition* const found = many.empty() ? few : many.data();
    count = findCorners(polygon, found, direction);
    has_others = count > 0 && count + 1 < polygon.path.size();
    if (has_others) corners.assign(found, found + count);
  }
  const bool is_convex = count > 0;
  if (!is_convex) direction = 0;
  by_corners = has_others ? polygon.reducedTo(corners) : is_convex ? &polygon : nullptr;
  if (by_corners == &polygon) edge_depth = edgeDepthOf(polygon);
}

Convexity::~Convexity() {
  if (has_others) by_corners->release();
}

const Convexity& findConvexity(const PolygonData& polygon) { return polygon.convexity.made<Convexity>(polygon); }

EdgePosition edgeBeside(const PolygonData& polygon, std::size_t begin, std::size_t end, const Vec2& p) {
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
  return static_cast<EdgePosition>(after(low));
}

EdgeIndex edgeOfPath(const PolygonData& polygon, std::size_t k, const Vec2& p) {
  const std::vector<EdgePosition>& corners = convexityOf(polygon).corners;
  return polygon.edgeName(edgeBeside(polygon, corners[k], corners[k + 1 < corners.size() ? k + 1 : 0], p));
}

EdgeIndex givenEdge(const PolygonData& given, const PolygonData& taken, EdgePosition position, double part) {
  if (&given == &taken) return given.edgeName(position);
  const Vec2 point = (1 - part) * taken.path[position] + part * taken.path[position + 1];
  return edgeOfPath(given, position, point);
}

}  // namespace tricover::detail
