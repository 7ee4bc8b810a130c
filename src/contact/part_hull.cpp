// SPDX-License-Identifier: BSD-3-Clause
#include "contact/part_hull.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

#include "numbers/convex_hull.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

bool isLeftOf(const BoundaryPoint& p, const BoundaryPoint& q) { return isBefore(p.at, q.at); }

/// From left to right. Of few by counting those that are before each: a sort's comparisons can't be predicted.
void sortFromLeft(BoundaryPoint* begin, BoundaryPoint* end) {
  constexpr std::size_t kFew = 48, kLanes = 8;
  const auto size = static_cast<std::size_t>(end - begin);
  if (size <= kFew) {
    // As floats the order is the same, but for those that are the same there.
    float x[kFew];
    BoundaryPoint unsorted[kFew];
    const std::size_t filled = (size + kLanes - 1) / kLanes * kLanes;
    for (std::size_t k = 0; k < filled; ++k) x[k] = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < size; ++k) {
      x[k] = static_cast<float>(begin[k].at.x());
      unsorted[k] = begin[k];
    }
    std::size_t ranks = 0;
    for (std::size_t k = 0; k < size; ++k) {
      const float own = x[k];
      std::int32_t before = 0;
      for (std::size_t i = 0; i < filled; i += kLanes)
        for (std::size_t lane = 0; lane < kLanes; ++lane) before += x[i + lane] < own ? 1 : 0;
      const auto rank = static_cast<std::size_t>(before);
      begin[rank] = unsorted[k];
      ranks += rank;
    }
    if (2 * ranks == size * (size - 1)) return;
    std::copy(unsorted, unsorted + size, begin);
  }
  std::sort(begin, end, [](const BoundaryPoint& p, const BoundaryPoint& q) { return isLeftOf(p, q); });
}

auto chainsAt(BoundaryPoint* place) {
  const auto at = [](const BoundaryPoint& p) -> const Vec2& { return p.at; };
  const auto turnsLeft = [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - q) > 0; };
  return MonotoneChains<BoundaryPoint, decltype(at), decltype(turnsLeft)>(place, at, turnsLeft);
}

}  // namespace

void PartHull::make(const Slice<BoundaryPoint>& points, std::size_t more) {
  assert(!points.empty());
  // A point may be on both chains, and the first one ends the upper chain.
  const std::size_t own = points.size() + 1, likely = points.size() + more, grown = 2 * (own + more);
  const std::size_t needed = likely + 2 * own + 2 * grown;
  likely_ = few_;
  if (needed > kFew) {
    if (capacity_ < needed) {
      capacity_ = std::max(needed, 2 * capacity_);
      room_.reset(new BoundaryPoint[capacity_]);
    }
    likely_ = room_.get();
  }
  place_of_[0] = likely_ + likely + 2 * own;
  place_of_[1] = place_of_[0] + grown;
  takeLikely(points);
  sortFromLeft(likely_, likely_end_);
  // Those above the line from the leftmost to the rightmost one aren't on the lower chain, nor those below on the
  // upper.
  const BoundaryPoint leftmost = *likely_, rightmost = likely_end_[-1];
  const Vec2 along = rightmost.at - leftmost.at;
  BoundaryPoint *upper = likely_, *const lower = place_of_[0], *lower_end = lower;
  for (const BoundaryPoint* p = likely_; p < likely_end_; ++p) {
    const BoundaryPoint point = *p;
    const double above = cross(along, point.at - leftmost.at);
    *upper = *lower_end = point;
    upper += above >= -same_area_;
    lower_end += above <= same_area_;
  }
  BoundaryPoint* const place = likely_ + likely;
  auto chains = chainsAt(place);
  for (const BoundaryPoint* p = lower; p < lower_end; ++p) chains.add(*p);
  chains.turnBack();
  lower_ = chains.size();
  for (const BoundaryPoint* p = upper - 1; p > likely_; --p) chains.add(p[-1]);
  corners_ = {place, chains.close()};
  likely_end_ = likely_;
}

/// Leaves out what is within the triangle of the points before and after it and one in the middle of some: those aren't
/// corners. Without branches that depend on them, as of points around a part none can be predicted.
void PartHull::takeLikely(const Slice<BoundaryPoint>& points) {
  constexpr std::size_t kWorthLooking = 25;  // fewer cost less
  likely_end_ = std::copy(points.begin(), points.end(), likely_);
  if (points.size() < kWorthLooking) return;
  const std::size_t quarter = points.size() / 4;
  const Vec2 middle = 0.25 * (points[0].at + points[quarter].at + points[2 * quarter].at + points[3 * quarter].at);
  // A second time beside those that are left.
  leaveOutWithin(middle);
  leaveOutWithin(middle);
}

void PartHull::leaveOutWithin(const Vec2& middle) {
  // Twice the areas from the middle to the points.
  Vec2 u = likely_[0].at - middle, p = likely_[1].at - middle;
  double to_p = cross(u, p);
  BoundaryPoint* kept = likely_ + 1;
  for (const BoundaryPoint* next = likely_ + 2; next < likely_end_; ++next) {
    const Vec2 v = next->at - middle;
    const double to_v = cross(p, v), beyond = cross(u, v) - to_p - to_v;
    const double least = std::min(std::min(to_p, to_v), beyond), most = std::max(std::max(to_p, to_v), beyond);
    const bool is_within = std::max(least, -most) > same_area_;
    *kept = next[-1];
    kept += !is_within;
    u = p;
    p = v;
    to_p = to_v;
  }
  *kept++ = likely_end_[-1];
  likely_end_ = kept;
}

const Hull& PartHull::grow(int side) {
  sortFromLeft(likely_, likely_end_);
  auto chains = chainsAt(place_of_[side]);
  const BoundaryPoint *corner = corners_.begin(), *const rightmost = corner + lower_ - 1;
  for (const BoundaryPoint* next = likely_; next < likely_end_; ++next) {
    const BoundaryPoint* const before = corner;
    while (corner <= rightmost && !isLeftOf(*next, *corner)) ++corner;
    chains.addCorners(before, corner);
    chains.add(*next);
  }
  chains.addCorners(corner, rightmost + 1);
  chains.turnBack();
  const BoundaryPoint* const leftmost = corners_.end();  // once more
  corner = rightmost;
  for (const BoundaryPoint* next = likely_end_; next > likely_; --next) {
    const BoundaryPoint* const before = corner;
    while (corner <= leftmost && isLeftOf(next[-1], *corner)) ++corner;
    chains.addCorners(before, corner);
    chains.add(next[-1]);
  }
  chains.addCorners(corner, leftmost + 1);
  likely_end_ = likely_;
  return grown_[side] = {place_of_[side], chains.close()};
}

}  // namespace tricover::detail
