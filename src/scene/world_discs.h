// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <limits>

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "pair/discs.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// The bounding disc of a posed polygon and a disc inside its region, in the world. Rounding grows the one and shrinks
/// the other: what pair/discs.h finds for a pair, ready for tests against many others.
struct WorldDiscs {
  WorldDiscs() = default;
  WorldDiscs(const PolygonData& polygon, const Pose& pose) {
    const InnerDisc disc(polygon);
    // How far off both centres are, in any direction.
    const Double2 away = absolute(load2(pose.data() + 6));
    const double error = PosedPair::kWayError * (polygon.extent + away[0] + away[1]) + kTiny;
    center = placed(polygon.origin, pose);
    radius = polygon.radius * (1 + kLargestDefect) + error;
    inner = placed(disc.center, pose);
    inner_radius =
        disc.radius >= 0 ? disc.radius * (1 - kLargestDefect) - error : -std::numeric_limits<double>::infinity();
  }

  /// Whether the bounding discs prove two regions to be farther apart than the margin.
  bool areApart(const WorldDiscs& other, double margin) const {
    return isBeyond(other.center - center, radius + other.radius + margin);
  }
  /// Whether the inner discs prove two regions to be within the margin.
  bool innerMeet(const WorldDiscs& other, double margin) const {
    return isWithin(other.inner - inner, inner_radius + other.inner_radius + margin);
  }

  Double2 center, inner;
  double radius, inner_radius;  ///< inner_radius is -infinity if no inner disc is known

 private:
  static Double2 placed(const Vec2& p, const Pose& pose) {
    const double* m = pose.data();  // columns of three
    return load2(m) * p.x() + load2(m + 3) * p.y() + load2(m + 6);
  }
};

/// A body's discs. The first query that comes near computes them, on any thread; they are kept until the body moves.
class KeptDiscs {
 public:
  KeptDiscs() = default;
  KeptDiscs(const KeptDiscs& other) { *this = other; }
  KeptDiscs& operator=(const KeptDiscs& other) {
    const bool kept = other.state_.load(std::memory_order_acquire) == kKept;
    if (kept) discs_ = other.discs_;
    state_.store(kept ? kKept : kNone, std::memory_order_relaxed);
    return *this;
  }

  void forget() { state_.store(kNone, std::memory_order_relaxed); }

  /// They aren't kept before the polygon's inner discs have been built.
  WorldDiscs of(const PolygonData& polygon, const Pose& pose) {
    if (state_.load(std::memory_order_acquire) == kKept) return discs_;
    const bool is_known = polygon.isDegenerate() || innerDiscsIfBuilt(polygon) != nullptr;
    const WorldDiscs found(polygon, pose);
    char none = kNone;
    if (is_known && state_.compare_exchange_strong(none, kBeingKept, std::memory_order_relaxed)) {
      discs_ = found;
      state_.store(kKept, std::memory_order_release);
    }
    return found;
  }

 private:
  static constexpr char kNone = 0, kBeingKept = 1, kKept = 2;
  WorldDiscs discs_;
  std::atomic<char> state_{kNone};
};

}  // namespace tricover::detail
