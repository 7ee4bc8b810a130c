// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/rigidity.h"
#include "pair/discs.h"
#include "pair/pair_descent.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Where b is, seen from a, without a relative pose; of a pair in order. R^T stands for R^-1, as in PointPlace.
///   c         the way, within `error` in any direction, turned back by what is no longer than 1 + kLargestDefect
///             two products and their sum, in U: 2 sqrt2 |w|, where mapUnits() counts |c|_1
///   M         R_a^T R_b: 2 for an entry, 4 as a matrix, where mapUnits() counts 9 for an entry
///   R^T       their difference is R^T R - I, at most the defect less 16U, times R^-1; on the way and on b's points,
///             which are a unit of a's from b's S at most
/// A singular value of M misses 1 by no more than the defects of both poses.
struct PolygonPlace {
  /// `both` is defectOf() the poses.
  PolygonPlace(const PolygonData& a, const PolygonData& b, const Discs& discs, double both) : defect(both) {
    assert(b.unit <= a.unit);
    const Double2 m0 = discs.turnedToA(discs.columnOfB(0)), m1 = discs.turnedToA(discs.columnOfB(1));
    const Double2 center = discs.turnedToA(discs.way()) * a.inverse_unit, away = absolute(center);
    const double error = 1.1 * discs.error() * a.inverse_unit +
                         (kMapRounding * kUnitRoundoff + 1.1 * defect) * (away[0] + away[1] + 4) + kTiny;
    const bool fits = a.fitsUnit() && b.fitsUnit();  // see mapUnits()
    map = {m0[0],
           m1[0],
           m0[1],
           m1[1],
           center[0],
           center[1],
           b.unit * a.inverse_unit,
           fits ? error : std::numeric_limits<double>::infinity()};
  }
  static_assert(kThereShift + 2 <= kMapRounding && kBackShift + 2 <= kMapRounding);

  /// See gapRounding() and PosedPair::reach().
  double rounding() const { return kGapRounding + 8 * defect; }
  double reach(double length) const { return length * (1 + 2 * defect); }

  UnitMap map;
  double defect;
};

}  // namespace tricover::detail
