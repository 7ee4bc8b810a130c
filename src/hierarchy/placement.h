// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cmath>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/double2.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// What doubles lose between b's points, as its hierarchy has them, and a's units, or on the way back, in any direction
/// and in U times a's unit. c is b's S in a's units; no point of either polygon is more than a unit from its own S.
/// There:
///   18 for the entries of R, wrong by 9U each, on two coordinates of two; 1 for the point, rounded once from S;
///   4 for products and sum; 2 |c| + 3 for the shifts to c and to a block's origin; 6 for the box's centre and axis;
///   6 |c| for c itself, turned back by R_a^-1, or less by R_a^T.
/// Back, where a length l in a's units may be many of b's, but is as wrong as it is long:
///   26 + 26 |c| for the entries of the inverse, wrong by 13U each; 3 |c| for products and sum of the shift;
///   4, 2 |c| + 3 and 6 as above; 6 |c| for c.
constexpr int kThere = 18 + 1 + 4 + 3 + 6, kThereShift = 2 + 1 + 6;
constexpr int kBack = 26 + 4 + 3 + 6, kBackShift = 26 + 3 + 2 + 6;
constexpr int kMapRounding = 64;  ///< of |c|_1 + 4
static_assert(kThere <= 4 * kMapRounding && kBack <= 4 * kMapRounding, "of points");
static_assert(kThereShift <= kMapRounding && kBackShift <= kMapRounding, "of the shift");

/// b in a's units, as boxes, small rings and inner discs are compared; of a pair in order, so that b's unit is at most
/// a's.
struct UnitPlacement {
  /// R by its columns, b's S at c. `center_error` is that of c in any direction, in a's frame; R and c are those of an
  /// inverse that misses the true one by `inverse_defect`. See below for the others.
  UnitPlacement(const PolygonData& a, const PolygonData& b, Double2 r0, Double2 r1, Double2 c, double center_error,
                double inverse_defect, double defect, double scale_defect_)
      : rounding(kGapRounding + 8 * defect), scale_defect(scale_defect_), inverse_unit(a.inverse_unit) {
    assert(b.unit <= a.unit);
    const Double2 away = absolute(c);
    const double error =
        center_error * inverse_unit + (kMapRounding * kUnitRoundoff + inverse_defect) * (away[0] + away[1] + 4) + kTiny;
    // The largest of polygons are more than their unit: nothing is known of those.
    const bool fits = a.fitsUnit() && b.fitsUnit();
    map = {r0[0],
           r1[0],
           r0[1],
           r1[1],
           c[0],
           c[1],
           b.unit * inverse_unit,
           fits ? error : std::numeric_limits<double>::infinity()};
  }

  /// b's S, all there is of a point.
  Place origin() const { return {map.tx, map.ty, map.error}; }

  /// At least the world's `length`: 1 / (1 - x) <= 1 + 2 x, with x - x^2 to spare, and scale_defect is at least 16U, so
  /// that is more than the two roundings.
  double reach(double length) const { return length * (1 + 2 * scale_defect) * inverse_unit; }
  /// At most the world's `length`, for the few roundings here and where it is compared, too.
  double within(double length) const { return length * ((1 - 2 * scale_defect) * (1 - 0x1p-20) * inverse_unit); }

  /// At most so long in the world is a length of a's units.
  double inWorld(double length, double unit) const { return roundedDown<3>(length * unit * (1 - scale_defect)); }

  UnitMap map;  ///< from b's units to a's
  /// Descent::rounding. A box is taken for a rectangle after a map that is rigid only within a defect: its axis' length
  /// and its own extents are wrong by a defect each, the angle of its sides by two. Twice these four.
  double rounding;
  double scale_defect;  ///< |len' / len - 1| for any length len of a's frame taken to the world, at most
  double inverse_unit;  ///< a's
};

/// v -> R^-1 v = adj(R) v / det R, for the R of a pose: from the world, less the pose's translation, into its frame.
struct TurnBack {
  explicit TurnBack(const Pose& pose) {
    const Double2 r0 = load2(pose.data()), r1 = load2(pose.data() + 3);  // columns of three
    const double det = r0[0] * r1[1] - r1[0] * r0[1];
    diagonal = Double2{r1[1], r0[0]};
    off = Double2{r1[0], r0[1]};
    d = 1 / det - Double2{};
  }
  Double2 operator()(Double2 v) const { return (diagonal * v - off * swapped(v)) * d; }

  /// A rounded point. Either coordinate errs by
  ///   det 2U, d 3U, products 1U, difference 1U, product with d 1U   6U |p|_1
  ///   the point's own error e                                       at most sqrt2 e
  ApproxPoint operator()(const ApproxPoint& p) const {
    const Double2 at = (*this)(Double2{p.x, p.y});
    return {at[0], at[1], 1.5 * p.error + kError * (std::abs(p.x) + std::abs(p.y)) + kTiny};
  }
  static constexpr double kError = 8 * kUnitRoundoff;
  static_assert(kError >= kUnitRows * errorOf(6) && 1.5 > kUnitRows * kRoot2);

  Double2 diagonal, off, d;
};

}  // namespace tricover::detail
