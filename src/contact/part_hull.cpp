// SPDX-License-Identifier: BSD-3-Clause
#include "contact/part_hull.h"

#include <algorithm>

#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

bool isLeftOf(const BoundaryPoint& p, const BoundaryPoint& q) { return isBefore(p.at, q.at); }

/// One step of Andrew's monotone chains; the first `floor` corners stay.
inline void add(const BoundaryPoint& point, std::size_t floor, Hull& hull) {
  const auto turnsLeft = [&](const Vec2& p, const Vec2& q) { return cross(q - p, point.at - q) > 0; };
  while (hull.size() > floor && !turnsLeft(hull[hull.size() - 2].at, hull.back().at)) hull.pop_back();
  hull.push_back(point);
}

/// Without the first corner once more.
void close(Hull& hull) {
  if (hull.size() > 1) hull.pop_back();
  if (hull.size() == 2 && hull[0].at == hull[1].at) hull.pop_back();
}

}  // namespace

void PartHull::make(const Slice<BoundaryPoint>& points) {
  takeLikely(points);
  std::sort(likely_.begin(), likely_.end(), isLeftOf);
  corners_.clear();
  corners_.reserve(likely_.size() + 1);
  for (const BoundaryPoint& p : likely_) add(p, 1, corners_);
  lower_ = corners_.size();
  for (auto p = likely_.rbegin() + (likely_.empty() ? 0 : 1); p < likely_.rend(); ++p) add(*p, lower_, corners_);
  close(corners_);
}

/// Whether p is within the triangle of u, v and the middle, by twice the areas from the middle to u p, p v and u v.
bool PartHull::isWithin(double u_p, double p_v, double u_v) const {
  const double beyond = u_v - u_p - p_v;
  return (u_p > same_area_ && p_v > same_area_ && beyond > same_area_) ||
         (u_p < -same_area_ && p_v < -same_area_ && beyond < -same_area_);
}

/// Leaves out what is within the triangle of the points before and after it and the middle of all.
void PartHull::takeLikely(const Slice<BoundaryPoint>& points) {
  constexpr std::size_t kFew = 8;  // cost less than looking
  if (points.size() <= kFew) {
    likely_.assign(points.begin(), points.end());
    return;
  }
  likely_.clear();
  likely_.reserve(points.size());
  Vec2 middle = Vec2::Zero();
  for (const BoundaryPoint& p : points) middle += p.at;
  middle /= static_cast<double>(points.size());
  // From the middle: the last two that are likely, and twice the area between them.
  Vec2 u = middle, p = points.front().at - middle;
  double to_p = 0;
  likely_.push_back(points.front());
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2 v = points[k].at - middle;
    double to_v = cross(p, v);
    while (likely_.size() > 1 && isWithin(to_p, to_v, cross(u, v))) {
      likely_.pop_back();
      p = u;
      if (likely_.size() > 1) u = likely_[likely_.size() - 2].at - middle;
      to_p = cross(u, p);
      to_v = cross(p, v);
    }
    likely_.push_back(points[k]);
    u = p;
    p = v;
    to_p = to_v;
  }
}

void PartHull::grow(std::vector<BoundaryPoint>& more, Hull& hull) const {
  std::sort(more.begin(), more.end(), isLeftOf);
  hull.clear();
  hull.reserve(corners_.size() + 2 * more.size() + 2);
  std::size_t next = 0;
  for (std::size_t k = 0; k < lower_; ++k) {
    for (; next < more.size() && isLeftOf(more[next], corners_[k]); ++next) add(more[next], 1, hull);
    add(corners_[k], 1, hull);
  }
  for (; next < more.size(); ++next) add(more[next], 1, hull);
  const std::size_t floor = hull.size();
  const auto addUpper = [&](const BoundaryPoint& corner) {
    for (; next > 0 && !isLeftOf(more[next - 1], corner); --next) add(more[next - 1], floor, hull);
    add(corner, floor, hull);
  };
  for (std::size_t k = lower_ - 1; k < corners_.size(); ++k) addUpper(corners_[k]);
  addUpper(corners_.front());
  for (; next > 0; --next) add(more[next - 1], floor, hull);
  close(hull);
}

}  // namespace tricover::detail
