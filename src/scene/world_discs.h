// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cmath>
#include <limits>

#include "hierarchy/axis_boxes.h"
#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "pair/discs.h"
#include "pair/find_fact.h"
#include "pair/root_box.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A posed polygon's bounding disc, grown by what rounding may do to it in the world.
struct WorldDisc {
  WorldDisc() = default;
  WorldDisc(const PolygonData& polygon, const Pose& pose)
      : center(placed(polygon.origin, pose)), radius(polygon.radius * (1 + kLargestDefect) + errorOf(polygon, pose)) {}

  /// Where a point of a polygon is.
  static Double2 placed(const Vec2& p, const Pose& pose) {
    const double* m = pose.data();  // columns of three
    return load2(m) * p.x() + load2(m + 3) * p.y() + load2(m + 6);
  }
  /// How far off centres are, in any direction.
  static double errorOf(const PolygonData& polygon, const Pose& pose) {
    const Double2 away = absolute(load2(pose.data() + 6));
    return Placement::kWayError * (polygon.extent + away[0] + away[1]) + kTiny;
  }

  /// A lower bound of the distance of what is in it from the box around all of a posed polygon; it may be negative. The
  /// centre is taken to the polygon's units as Placement::inUnits() takes a point, with kLargestDefect for both the
  /// defect there and what lengths miss on the way back; as much again is more than the roundings here.
  double leastFrom(const Box& root, const PolygonData& polygon, const Pose& pose) const {
    if (!polygon.fitsUnit()) return 0;
    const Double2 way = center - placed(polygon.origin, pose);
    const double x = dot(load2(pose.data()), way) * polygon.inverse_unit;
    const double y = dot(load2(pose.data() + 3), way) * polygon.inverse_unit;
    constexpr double kLost = kMapRounding * kUnitRoundoff + 1.1 * kLargestDefect;
    const double error = 1.1 * errorOf(polygon, pose) * polygon.inverse_unit + kLost * (std::abs(x) + std::abs(y) + 4);
    const double least = distanceFromRoot(root, {x, y, error}) * polygon.unit;
    return least * (1 - 2 * kLargestDefect) - radius;
  }

  Double2 center;
  double radius;
};

/// The same, and a disc inside of it, shrunk likewise: what pair/discs.h asks of a pair, ready for many others; and
/// what else of its pose each of them needs.
struct WorldDiscs : WorldDisc {
  WorldDiscs() = default;
  WorldDiscs(const PolygonData& polygon, const Pose& pose, double defect_) : WorldDisc(polygon, pose), defect(defect_) {
    const InnerDisc disc(polygon);
    inner = placed(disc.center, pose);
    inner_radius = disc.radius >= 0 ? disc.radius * (1 - kLargestDefect) - errorOf(polygon, pose)
                                    : -std::numeric_limits<double>::infinity();
  }

  /// These are the polygon's and its pose's.
  CloseUp of(const PolygonData& polygon, const Pose& pose) const {
    return {polygon, pose, center, errorOf(polygon, pose), defect};
  }

  /// Whether the region may lie in a box: some of it, the inner disc, is known.
  bool mayBeIn(const Bounds& box) const {
    return (bitsOf(box.low() <= inner - inner_radius) & bitsOf(inner + inner_radius <= box.high())) == 3;
  }

  double inner_radius;  ///< -infinity if no such disc is known
  Double2 inner;
  double defect;  ///< defectOf() the pose
};

/// A body's, found by the first query that comes near, on whichever thread, and kept until it moves. (A base, so that
/// its padding holds the state: a body takes four cache lines.)
class KeptDiscs : private WorldDiscs {
 public:
  KeptDiscs() = default;
  KeptDiscs(const KeptDiscs& other) : WorldDiscs() { *this = other; }
  KeptDiscs& operator=(const KeptDiscs& other) {
    const bool kept = other.state_.load(std::memory_order_acquire) == kKept;
    if (kept) WorldDiscs::operator=(other);
    state_.store(kept ? kKept : kNone, std::memory_order_relaxed);
    return *this;
  }

  void forget() { state_.store(kNone, std::memory_order_relaxed); }

  /// `found` is where they are put if they can't be kept yet: not before the polygon's discs have been built.
  const WorldDiscs& of(const PolygonData& polygon, const Pose& pose, WorldDiscs& found) {
    if (state_.load(std::memory_order_acquire) == kKept) return *this;
    const bool is_known = polygon.isDegenerate() || innerDiscsIfBuilt(polygon) != nullptr;
    found = WorldDiscs(polygon, pose, defectOf(pose));
    if (!is_known) return found;
    char none = kNone;
    if (state_.compare_exchange_strong(none, kBeingKept, std::memory_order_relaxed)) {
      WorldDiscs::operator=(found);
      state_.store(kKept, std::memory_order_release);
    }
    return found;
  }

 private:
  static constexpr char kNone = 0, kBeingKept = 1, kKept = 2;
  std::atomic<char> state_{kNone};
};

}  // namespace tricover::detail
