// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cmath>
#include <limits>

#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// A gap that is computed in floats may be too large by this share of what it is computed from: the sum of the query's
/// coordinates and extents in the block's scale, |x| + |y| + along + across + 4. There a block's boxes are within 1 of
/// the origin in either coordinate, and no larger than 1.
///
/// A float is rounded by 2^-24 of itself. On its way into a gap a difference of coordinates is so 6 times at most
/// (converted, subtracted, times an axis that is converted, too, added, and the gap itself), and an extent 9 times (4
/// in the cosine, then the product, two sums, and the gap; 1 for an axis that isn't quite of unit length).
///   Differences: 6 (|x| + |y| + 2). Extents: 9 (along + across + 1). Together at most 9 of the sum above.
/// The rest, three times as much, is for what the kinds of gaps do to it: 1.4143 along a diagonal, 4 roundings of the
/// centres' distance; and for a block's extents, which are rounded outwards beyond 1.
constexpr double kFloatRoundoff = 0x1p-24, kGapRounding = 0x1p-19;
static_assert(kGapRounding >= 3 * 9 * kFloatRoundoff && 6 * 2 + 9 * 1 <= 9 * 4);

/// Doubles lose so much between b's points, as its hierarchy has them, and a's units, or on the way back: in any
/// direction, and in U times a's unit. c is b's S in a's units; no point of either polygon is more than a unit from its
/// own S. There:
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

/// A point in a hierarchy's units, known to within `error` in any direction.
struct Place {
  double x, y, error;
};

/// p -> scale r p + t, from b's units to a's, as boxes, small rings and inner discs are compared.
struct UnitMap {
  /// Where a point of b's units is in a's.
  [[gnu::always_inline]] double mappedX(double x, double y) const { return scale * turnedX(x, y) + tx; }
  [[gnu::always_inline]] double mappedY(double x, double y) const { return scale * turnedY(x, y) + ty; }
  /// r p, by its coordinates.
  [[gnu::always_inline]] double turnedX(double x, double y) const { return r00 * x + r01 * y; }
  [[gnu::always_inline]] double turnedY(double x, double y) const { return r10 * x + r11 * y; }

  /// b's S, all there is of a point.
  Place origin() const { return {tx, ty, error}; }

  /// At least the world's `length`: 1 / (1 - x) <= 1 + 2 x, with x - x^2 to spare, and scale_defect is at least 16U, so
  /// that is more than the two roundings.
  double reach(double length) const { return length * (1 + 2 * scale_defect) * inverse_unit; }
  /// At most the world's `length`, for the few roundings here and where it is compared, too.
  double within(double length) const { return length * ((1 - 2 * scale_defect) * (1 - 0x1p-20) * inverse_unit); }

  /// At most so long in the world is a length of a's units.
  double inWorld(double length, double unit) const { return roundedDown<3>(length * unit * (1 - scale_defect)); }

  double r00, r01, r10, r11, tx, ty, scale;
  double error;  ///< a mapped point is no farther than this from the true one
  /// A gap may be too large by this share of what it is computed from. A box is taken for a rectangle after a map
  /// that is rigid only within a defect: its axis' length and its own extents are wrong by a defect each, the angle of
  /// its sides by two. Twice these four.
  double rounding = kGapRounding;
  double scale_defect = 0;  ///< |len' / len - 1| for any length len of a's frame taken to the world, at most
  double inverse_unit = 1;  ///< a's
};

/// How far off, in a's units, a point of b is that is mapped from S at c. `center_error` is that of c in any direction,
/// in a's frame; R and c are those of an inverse that misses the true one by `inverse_defect`.
inline double mapError(const PolygonData& a, Double2 c, double center_error, double inverse_defect) {
  const Double2 away = absolute(c);
  return center_error * a.inverse_unit + (kMapRounding * kUnitRoundoff + inverse_defect) * (away[0] + away[1] + 4) +
         kTiny;
}

/// The map of a pair in order, whose unit of b is at most a's: R by its columns, b's S at c. Errors are mapError()'s; R
/// misses keeping lengths by `defect`.
inline UnitMap unitMapOf(const PolygonData& a, const PolygonData& b, Double2 r0, Double2 r1, Double2 c,
                         double center_error, double inverse_defect, double defect, double scale_defect) {
  assert(b.unit <= a.unit);
  const double error = mapError(a, c, center_error, inverse_defect);
  // The largest of polygons are more than their unit: nothing is known of those.
  const bool fits = a.fitsUnit() && b.fitsUnit();
  return {r0[0],
          r1[0],
          r0[1],
          r1[1],
          c[0],
          c[1],
          b.unit * a.inverse_unit,
          fits ? error : std::numeric_limits<double>::infinity(),
          kGapRounding + 8 * defect,
          scale_defect,
          a.inverse_unit};
}

/// The way back. Entries of R are wrong by 9U, those of its inverse by 13U. kStretch is what it may stretch an error
/// by: both poses' defects, and this product's rounding.
inline UnitMap inverse(const UnitMap& map) {
  constexpr double kStretch = 1 + 0x1p-10;
  static_assert(kStretch > (1 + 2 * kLargestDefect) * (1 + 2 * kLargestDefect));
  const double d = 1 / (map.r00 * map.r11 - map.r01 * map.r10), scale = 1 / map.scale;
  const double r00 = map.r11 * d, r01 = -map.r01 * d, r10 = -map.r10 * d, r11 = map.r00 * d;
  const double tx = -(r00 * map.tx + r01 * map.ty) * scale, ty = -(r10 * map.tx + r11 * map.ty) * scale;
  return {r00, r01, r10, r11, tx, ty, scale, map.error * scale * kStretch, map.rounding};
}

}  // namespace tricover::detail
