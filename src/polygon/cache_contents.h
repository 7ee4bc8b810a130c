// SPDX-License-Identifier: BSD-3-Clause
// The contents of caches. Users see bytes alone: see cache_access.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "polygon/edge_position.h"
#include "tricover/pair_cache.h"

namespace tricover::detail {

/// The back-off of certificates and hints: what failed to help k times in a row is left out of the next 2^k queries, at
/// most 255. A success halves k, hence failures that alternate with successes back off, too.
struct BackOff {
  std::uint8_t failed = 0;  ///< k
  std::uint8_t left = 0;    ///< queries that go without

  bool isOn() const { return left > 0; }
  void judge(bool has_helped) {
    constexpr int kMostFailed = 8;
    if (has_helped) {
      failed /= 2;
      return;
    }
    failed = static_cast<std::uint8_t>(std::min(failed + 1, kMostFailed));
    left = static_cast<std::uint8_t>(std::min(1 << failed, 255));
  }
};

/// Finding a clearance looks ahead for as many steps like the last ones: more of them cost more to find, and are seldom
/// used up.
constexpr double kStepsAhead = 32;
/// A motion by more than this part of a polygon's radius is a jump, a step that no clearance would pay for.
constexpr double kCoherentPart = 0.25;

/// A certificate of collide(): "With the polygons at these poses (columns of R, then t) the answer was `overlapping`.
/// Whether the regions overlap stays so while no point is moved against the other polygon by `clearance`, a world
/// length, or more." A hit by the margin or the tolerance alone is kept as overlapping, with a clearance of 0, by which
/// nothing stays so.
struct Certificate {
  double clearance = 0;
  std::uint32_t uses = 0;   ///< queries answered since: their mean motion sets how far the next one looks ahead
  bool was_sought = false;  ///< finding the clearance cost more than the answer; false: it is 0
  BackOff back_off;
  bool overlapping = false;
  std::uint64_t first_id = 0;   ///< of the polygons, in the kernel's own order (0: none)
  std::uint64_t second_id = 0;  ///< likewise
  double first_pose[6] = {1, 0, 0, 1, 0, 0};
  double second_pose[6] = {1, 0, 0, 1, 0, 0};
  /// The edges of the last hit, if there was one. They are tried first at the next pose.
  EdgePosition first_edge = kNoEdge, second_edge = kNoEdge;

  /// The clearance that would pay for a good many steps like the last ones; 0 if that is too long for the radius.
  double lookahead(double motion, double radius) const {
    const double ahead = kStepsAhead * motion / (uses + 1.0);
    return ahead <= kCoherentPart * radius ? ahead : 0;
  }
  /// Judges the certificate, which doesn't answer any more, unless it is another pair's (not `known`). Returns whether
  /// finding the next one may pay. `coherent`: there was no jump since.
  bool isWorthRenewing(bool known, bool coherent) {
    constexpr std::uint32_t kPaying = 3;  // a certificate costs as much as two queries, at the most
    if (known && (was_sought || !coherent)) back_off.judge(coherent && uses >= kPaying);
    return coherent && !back_off.isOn();
  }
};

/// The features or edges that were nearest at the last distance() of two polygons, or crossed: tried first.
struct DistanceHint {
  std::uint64_t first_id = 0;
  std::uint64_t second_id = 0;
  EdgePosition edge_a = 0, edge_b = 0;
  std::uint8_t kind = 0;  ///< a kind of FeaturePair, or kNearEdges; 0: none
  BackOff back_off;
};

/// Where the second polygon's origin S was, in the first one's frame, after the last penetration's translation.
struct PenetrationHint {
  double end[2] = {NAN, NAN};  ///< NaN: nowhere yet
};

/// What a PairCache holds.
struct PairCacheContents {
  Certificate collision;
  DistanceHint distance;
  PenetrationHint penetration;
};

}  // namespace tricover::detail
