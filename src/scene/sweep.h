// SPDX-License-Identifier: BSD-3-Clause
// Boxes around a polygon on its way.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "numbers/cubic.h"
#include "numbers/rigidity.h"
#include "scene/bounds.h"
#include "scene/scene_state.h"
#include "tricover/trajectory.h"

namespace tricover::detail {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// An interval of time is chosen so long that the polygon moves by about its width, and boxes are twice as wide.
constexpr double kMostIntervals = 64;
/// A polygon on a leg of its path, which runs from 0 to 1 in the leg's own time.
class SweptLeg {
 public:
  SweptLeg(const Polygon& polygon, const Leg& leg, double margin)
      : polygon_(dataOf(polygon)),
        motion_(leg.motion),
        margin_(marginOfBox(margin)),
        begin_(leg.begin),
        duration_(leg.end - leg.begin),
        path_(pathOf(motion_)),
        rotation_(rotationOf(motion_)) {
    const Vec2 arm = polygon_.origin - motion_.pivot;
    reach_ = (std::hypot(arm.x(), arm.y()) + polygon_.radius) * (1 + 2 * kLargestDefect);
    // Sums of coordinates, because squares may leave the range of doubles.
    length_ = (path_.first.cwiseAbs() + path_.second.cwiseAbs() + path_.third.cwiseAbs()).sum();
    // timeOfImpact() may report bodies at a distance of 1e-13 of this length, and eight times that on a trajectory's
    // leg. Ten times as much covers what rounds here.
    const double size = motion_.start.translation().cwiseAbs().sum() + motion_.pivot.cwiseAbs().sum() + length_ +
                        (1 + rotation_.size()) * reach_;
    margin_ += 1e-12 * size + errorOfLargest(polygon_);
  }

  double begin() const { return begin_; }  ///< by the clock
  double end() const { return begin_ + duration_; }
  double clockAt(double time) const { return begin_ + duration_ * time; }
  double timeAt(double clock) const { return std::clamp((clock - begin_) / duration_, 0.0, 1.0); }

  /// Into how many intervals the leg is divided.
  double intervals() const {
    const double wide = 2 * reach_ + margin_, longest = length_ + rotation_.size() * reach_;
    return longest < kMostIntervals * wide ? std::max(1.0, std::ceil(longest / wide)) : kMostIntervals;
  }

  /// A box around all points within the margin of the polygon at some time from `begin` to `end`.
  Bounds between(double begin, double end) const {
    if (polygon_.fill.is_complement) return {-kNoBound, -kNoBound, kNoBound, kNoBound};
    const double half = 0.5 * (end - begin), middle = begin + half;
    // A bound of how far points move against the pivot from their places at the middle.
    const double rotated = rotation_.mostRate(begin, end) * half * reach_;
    const Vec2 pivot = motion_.start * motion_.pivot;
    const double r = reach_ + margin_;
    const bool rotates_far = !(rotated < reach_);
    const Bounds box = rotates_far ? Bounds{pivot.x() - r, pivot.y() - r, pivot.x() + r, pivot.y() + r}
                                   : boundsOf(polygon_, motion_.at(middle), margin_ + rotated);
    const Vec2 now = rotates_far ? Vec2(0, 0) : path_.at(middle);
    // A cubic leaves its chord by at most its acceleration times h^2 / 8, h the interval's length.
    const Vec2 bend =
        0.5 * half * half * path_.accelerationAt(begin).cwiseAbs().cwiseMax(path_.accelerationAt(end).cwiseAbs());
    const Vec2 first = path_.at(begin), last = path_.at(end);
    const Vec2 low = first.cwiseMin(last) - bend - now, high = first.cwiseMax(last) + bend - now;
    const Bounds bounds{box.min_x + low.x(), box.min_y + low.y(), box.max_x + high.x(), box.max_y + high.y()};
    // Negated for NaN.
    if (!(bounds.min_x <= bounds.max_x && bounds.min_y <= bounds.max_y))
      return {-kNoBound, -kNoBound, kNoBound, kNoBound};
    return bounds;
  }

 private:
  const PolygonData& polygon_;
  const Motion motion_;
  double margin_, begin_, duration_;
  double reach_;   ///< no point of the polygon is farther from the pivot
  double length_;  ///< at least that of the pivot's path
  Cubic<Vec2> path_;
  Cubic<double> rotation_;
};

/// A motion as a trajectory's one leg: it runs from 0 to 1.
inline std::vector<Leg> legsOf(const Motion& motion) { return {{0, 1, motion}}; }
inline const std::vector<Leg>& legsOf(const Trajectory& trajectory) { return trajectory.legs(); }

/// A body that rests beside a motion, and beside a trajectory.
inline Motion stillBeside(const Motion&, const Pose& pose) { return Motion::still(pose); }
inline Trajectory stillBeside(const Trajectory&, const Pose& pose) { return pose; }

/// A polygon on all of its path, by a clock.
class Sweep {
 public:
  Sweep(const Polygon& polygon, const std::vector<Leg>& legs, double margin) {
    for (const Leg& leg : legs) legs_.emplace_back(polygon, leg, margin);
  }

  const std::vector<SweptLeg>& legs() const { return legs_; }
  double begin() const { return legs_.front().begin(); }
  double end() const { return legs_.back().end(); }
  double intervals() const {
    double sum = 0;
    for (const SweptLeg& leg : legs_) sum += leg.intervals();
    return sum;
  }

  /// A box around all points within the margin of the polygon at some time from `begin` to `end`. The polygon stands
  /// still before its first leg and after the last.
  Bounds between(double begin, double end) const {
    const auto ends_before = [](const SweptLeg& leg, double time) { return leg.end() < time; };
    auto leg = std::lower_bound(legs_.begin(), std::prev(legs_.end()), begin, ends_before);
    Bounds all = leg->between(leg->timeAt(begin), leg->timeAt(end));
    for (++leg; leg != legs_.end() && leg->begin() <= end; ++leg)
      all = unite(all, leg->between(leg->timeAt(begin), leg->timeAt(end)));
    return all;
  }

 private:
  std::vector<SweptLeg> legs_;
};

}  // namespace tricover::detail
