// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cmath>
#include <limits>

#include "hierarchy/simd.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// What doubles lose between b's points, as its hierarchy has them, and a's units, or on the way back, in any direction
/// and in U times a's unit. c is b's S in a's units; no point of either polygon is more than a unit from its own S.
/// There:
///   18 for the entries of R, wrong by 9U each, on two coordinates of two; 1 for the point, rounded once from S;
///   4 for products and sum; 2 |c| + 3 for the shifts to c and to a block's origin; 6 for the box's centre and axis;
///   |c| for c itself, a rounded difference.
/// Back, where a length l in a's units may be many of b's, but is as wrong as it is long:
///   26 + 26 |c| for the entries of the inverse, wrong by 13U each; 3 |c| for products and sum of the shift;
///   4, 2 |c| + 3 and 6 as above; |c| for c.
constexpr int kThere = 18 + 1 + 4 + 3 + 6, kThereShift = 2 + 1;
constexpr int kBack = 26 + 4 + 3 + 6, kBackShift = 26 + 3 + 2 + 1;
constexpr int kMapRounding = 64;  ///< of |c|_1 + 4
static_assert(kThere <= 4 * kMapRounding && kBack <= 4 * kMapRounding, "of points");
static_assert(kThereShift <= kMapRounding && kBackShift <= kMapRounding, "of the shift");

/// From b's units to a's. Only for a pair in order: b's unit is at most a's.
inline UnitMap mapUnits(const PosedPair& pair) {
  assert(pair.b.unit <= pair.a.unit);
  const double inverse_unit = pair.a.inverse_unit;
  const ApproxPoint center = pair.center();
  const double cx = (center.x - pair.a.origin.x()) * inverse_unit, cy = (center.y - pair.a.origin.y()) * inverse_unit;
  // b's S is wrong by `error` in either coordinate, by 1.4143 of it in any direction; the rest is for rounding this.
  const double rounding =
      1.5 * center.error * inverse_unit + kMapRounding * kUnitRoundoff * (std::abs(cx) + std::abs(cy) + 4) + kTiny;
  // The largest of polygons are more than their unit: nothing is known of those.
  const bool fits = pair.a.fitsUnit() && pair.b.fitsUnit();
  const double error = fits ? rounding : std::numeric_limits<double>::infinity();
  return {pair.m00, pair.m01, pair.m10, pair.m11, cx, cy, pair.b.unit * inverse_unit, error};
}

/// Descent::rounding. A box is taken for a rectangle after a map that is rigid only within `defect`: its axis' length
/// and its own extents are wrong by a defect each, the angle of its sides by two. Twice these four.
inline double gapRounding(const PosedPair& pair) { return kGapRounding + 8 * pair.defect; }

/// A descent of the pair's hierarchies, which are built if need be. The limit is in a's units.
inline Descent descentOf(const PosedPair& pair, const UnitMap& to_a, double rounding, double limit,
                         bool degenerate = false) {
  return {pair.a, pair.b, hierarchyOf(pair.a), hierarchyOf(pair.b), to_a, rounding, limit, degenerate};
}

}  // namespace tricover::detail
