// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tricover/pose.h"

namespace tricover::detail {

/// In lexicographic order: by x, then by y.
inline bool isBefore(const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); }

/// Andrew's monotone chains, one behind the other, where there is room for them: points from left to right, turnBack(),
/// then from right to left, without the rightmost one again and with the leftmost. at(point) is where a point is, and
/// turnsLeft(p, q, r), of such places, whether the way through them turns to the left at q: what that decides rounded,
/// the hull is right to.
template <typename Point, typename At, typename TurnsLeft>
class MonotoneChains {
 public:
  MonotoneChains(Point* begin, At at, TurnsLeft turnsLeft)
      : begin_(begin), end_(begin), floor_(begin + 1), at_(at), turnsLeft_(turnsLeft) {}

  /// Whether all corners before it stay.
  bool add(const Point& point) {
    Point* const end = end_;
    while (end_ > floor_ && !turnsLeft_(at_(end_[-2]), at_(end_[-1]), at_(point))) --end_;
    const bool all_stay = end_ == end;
    *end_++ = point;
    return all_stay;
  }
  /// Corners of a hull, in a row: behind the second one that stays they all turn left.
  void addCorners(const Point* corner, const Point* end) {
    for (int row = 0; corner < end && row < 2; ++corner) row = add(*corner) ? row + 1 : 1;
    if (corner < end) end_ = std::copy(corner, end, end_);
  }
  void turnBack() { floor_ = end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  /// At the end: how many corners the hull has, counter-clockwise from the leftmost one, which is behind them once
  /// more. A segment has two, a point one.
  std::size_t close() {
    if (size() > 1) --end_;
    if (size() == 2 && at_(begin_[0]) == at_(begin_[1])) --end_;
    *end_ = *begin_;
    return size();
  }

 private:
  Point *const begin_, *end_, *floor_;  ///< before which corners stay
  const At at_;
  const TurnsLeft turnsLeft_;
};

/// The corners of the convex hull, as MonotoneChains have them, in O(n log n).
template <typename Point, typename At, typename TurnsLeft>
std::vector<Point> convexHull(std::vector<Point> points, At at, TurnsLeft turnsLeft) {
  if (points.empty()) return points;
  std::sort(points.begin(), points.end(), [&](const Point& p, const Point& q) { return isBefore(at(p), at(q)); });
  std::vector<Point> hull(2 * points.size());
  MonotoneChains<Point, At, TurnsLeft> chains(hull.data(), at, turnsLeft);
  for (const Point& p : points) chains.add(p);
  chains.turnBack();
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) chains.add(*p);
  hull.resize(chains.close());
  return hull;
}

}  // namespace tricover::detail
