// SPDX-License-Identifier: BSD-3-Clause
#include "contact/part_hull.h"

#include <algorithm>
#include <cassert>

#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

bool isLeftOf(const BoundaryPoint& p, const BoundaryPoint& q) { return isBefore(p.at, q.at); }

/// Andrew's monotone chains, where there is room for them.
class Chains {
 public:
  explicit Chains(BoundaryPoint* begin) : begin_(begin), end_(begin), floor_(begin + 1) {}

  /// The next point of a chain, unless it turns_left there. Whether all corners before it stay.
  bool add(const BoundaryPoint& point, bool turns_left = false) {
    BoundaryPoint* const end = end_;
    while (!turns_left && end_ > floor_ && !turnsLeft(end_[-2].at, end_[-1].at, point.at)) --end_;
    const bool all_stay = end_ == end;
    *end_++ = point;
    return all_stay;
  }
  /// After the lower chain; its size.
  std::size_t turnBack() {
    floor_ = end_;
    return static_cast<std::size_t>(end_ - begin_);
  }
  /// Without the first corner once more.
  Hull closed() {
    if (end_ - begin_ > 1) --end_;
    if (end_ - begin_ == 2 && begin_[0].at == begin_[1].at) --end_;
    return {begin_, static_cast<std::size_t>(end_ - begin_)};
  }

 private:
  static bool turnsLeft(const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; }

  BoundaryPoint *const begin_, *end_, *floor_;  ///< before which corners stay
};

}  // namespace

void PartHull::make(const Slice<BoundaryPoint>& points, std::size_t more) {
  assert(!points.empty());
  // A point may be on both chains, and the first one ends the upper chain.
  const std::size_t own = points.size() + 1, likely = points.size() + more, grown = 2 * (own + more);
  const std::size_t needed = likely + 2 * own + 2 * grown;
  if (capacity_ < needed) {
    capacity_ = std::max(needed, 2 * capacity_);
    room_.reset(new BoundaryPoint[capacity_]);
  }
  likely_ = room_.get();
  place_of_[0] = likely_ + likely + 2 * own;
  place_of_[1] = place_of_[0] + grown;
  takeLikely(points);
  std::sort(likely_, likely_end_, isLeftOf);
  Chains chains(likely_ + likely);
  for (const BoundaryPoint* p = likely_; p < likely_end_; ++p) chains.add(*p);
  lower_ = chains.turnBack();
  for (const BoundaryPoint* p = likely_end_ - 1; p > likely_; --p) chains.add(p[-1]);
  corners_ = chains.closed();
  likely_end_ = likely_;
}

/// Whether p is within the triangle of u, v and the middle, by twice the areas from the middle to u p, p v and u v.
bool PartHull::isWithin(double u_p, double p_v, double u_v) const {
  const double beyond = u_v - u_p - p_v;
  return (u_p > same_area_ && p_v > same_area_ && beyond > same_area_) ||
         (u_p < -same_area_ && p_v < -same_area_ && beyond < -same_area_);
}

/// Leaves out what is within the triangle of the points before and after it and one in the middle of some.
void PartHull::takeLikely(const Slice<BoundaryPoint>& points) {
  constexpr std::size_t kFew = 32;  // cost less than looking
  if (points.size() <= kFew) {
    likely_end_ = std::copy(points.begin(), points.end(), likely_);
    return;
  }
  likely_end_ = likely_;
  const std::size_t quarter = points.size() / 4;
  const Vec2 middle = 0.25 * (points[0].at + points[quarter].at + points[2 * quarter].at + points[3 * quarter].at);
  // From the middle: the last two that are likely, and twice the area between them.
  Vec2 u = middle, p = points.front().at - middle;
  double to_p = 0;
  add(points.front());
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2 v = points[k].at - middle;
    double to_v = cross(p, v);
    while (likely_end_ > likely_ + 1 && isWithin(to_p, to_v, cross(u, v))) {
      --likely_end_;
      p = u;
      if (likely_end_ > likely_ + 1) u = likely_end_[-2].at - middle;
      to_p = cross(u, p);
      to_v = cross(p, v);
    }
    add(points[k]);
    u = p;
    p = v;
    to_p = to_v;
  }
}

const Hull& PartHull::grow(int side) {
  std::sort(likely_, likely_end_, isLeftOf);
  Chains chains(place_of_[side]);
  int row = 0;  // corners of its own in a row: more than two turn left
  const auto addMore = [&](const BoundaryPoint& point) {
    chains.add(point);
    row = 0;
  };
  const auto addOwn = [&](const BoundaryPoint& corner) { row = chains.add(corner, row > 1) ? row + 1 : 1; };
  const BoundaryPoint* next = likely_;
  for (std::size_t k = 0; k < lower_; ++k) {
    for (; next < likely_end_ && isLeftOf(*next, corners_[k]); ++next) addMore(*next);
    addOwn(corners_[k]);
  }
  for (; next < likely_end_; ++next) addMore(*next);
  chains.turnBack();
  row = 0;
  for (std::size_t k = lower_ - 1; k <= corners_.size(); ++k) {
    const BoundaryPoint& corner = corners_[k < corners_.size() ? k : 0];
    for (; next > likely_ && !isLeftOf(next[-1], corner); --next) addMore(next[-1]);
    addOwn(corner);
  }
  for (; next > likely_; --next) addMore(next[-1]);
  likely_end_ = likely_;
  return grown_[side] = chains.closed();
}

}  // namespace tricover::detail
