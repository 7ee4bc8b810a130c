// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// What doubles lose between b's points, as its hierarchy has them, and a's units, or on the way back, in any direction
/// and in U times a's unit. c is b's S in a's units; no point of either polygon is more than a unit from its own S.
/// There:
///   18 for the entries of R, wrong by 9U each, on two coordinates of two; 1 for the point, rounded once from S;
///   4 for products and sum; 2 |c| + 3 for the shifts to c and to a block's origin; 6 for the box's centre and axis;
///   |c| for c itself, a rounded difference, or 2 |c| more where it is two products and their sum.
/// Back, where a length l in a's units may be many of b's, but is as wrong as it is long:
///   26 + 26 |c| for the entries of the inverse, wrong by 13U each; 3 |c| for products and sum of the shift;
///   4, 2 |c| + 3 and 6 as above; |c| for c, or 3 |c|.
constexpr int kThere = 18 + 1 + 4 + 3 + 6, kThereShift = 2 + 1 + 2;
constexpr int kBack = 26 + 4 + 3 + 6, kBackShift = 26 + 3 + 2 + 1 + 2;
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

  /// At least the world's `length`, see PosedPair::reach().
  double reach(double length) const { return length * (1 + 2 * scale_defect) * inverse_unit; }
  /// At most the world's `length`, for the few roundings here and where it is compared, too.
  double within(double length) const { return length * ((1 - 2 * scale_defect) * (1 - 0x1p-20) * inverse_unit); }

  UnitMap map;  ///< from b's units to a's
  /// Descent::rounding. A box is taken for a rectangle after a map that is rigid only within a defect: its axis' length
  /// and its own extents are wrong by a defect each, the angle of its sides by two. Twice these four.
  double rounding;
  double scale_defect;  ///< |len' / len - 1| for any length len of a's frame taken to the world, at most
  double inverse_unit;  ///< a's
};

/// Two polygons under their poses, b seen from a, in three stages. Each costs more than the one before, and most
/// queries are answered without the last:
///   Placement      ways between points of a and points of b in the world: for discs
///   UnitPlacement  b's units in a's, with R_a^T in the place of R_a^-1: for boxes, small rings, inner discs, points
///   PosedPair      b's vertices in a's frame: for edges
/// All are rounded and know by how much; the exact stage uses the two poses as given.
class Placement {
 public:
  Placement(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_)
      : a(a_),
        b(b_),
        pose_a(pose_a_),
        pose_b(pose_b_),
        columns_a_{load2(pose_a.data()), load2(pose_a.data() + 3)},
        columns_b_{load2(pose_b.data()), load2(pose_b.data() + 3)},
        shift_(load2(pose_b.data() + 6) - load2(pose_a.data() + 6)) {
    const Double2 apart = absolute(shift_);
    size_ = a.extent + b.extent + (apart[0] + apart[1]);
  }

  /// From a point of a's frame to one of b's, both within their polygon's bounding box, and from S to S.
  Double2 way(const Vec2& p, const Vec2& q) const {
    return (columns_b_[0] * q.x() + columns_b_[1] * q.y()) + (shift_ - (columns_a_[0] * p.x() + columns_a_[1] * p.y()));
  }
  Double2 way() const { return way(a.origin, b.origin); }
  /// A way in a's units, for guesses: with R_a^T for the inverse.
  Double2 inUnitsOfA(Double2 way) const { return turnedToA(way) * a.inverse_unit; }

  /// How far off a way is, in any direction. R_b q + (shift - R_a p), in either coordinate, with lengths p, q <= sqrt2
  /// e of points in the bounding boxes:
  ///   R_b q       products 1, sum 1, the last sum 1                      3 q
  ///   R_a p       products 1, sum 1, the difference 1, the last sum 1    4 p
  ///   shift       itself 1, the difference 1, the last sum 1             3 |t_b - t_a|_1
  /// and sqrt2 of it in any direction: at most 8 e.
  double error() const { return kWayError * size_ + kTiny; }
  static constexpr double kWayError = 16 * kUnitRoundoff;
  static_assert(kWayError >= kUnitRows * kRoot2 * kRoot2 * errorOf(4));

  /// The next stage. `defect` is defectOf() the poses: no singular value of R_a^T R_b misses 1 by more, nor one of R_a.
  ///   c      the way, turned back by what is no longer than 1 + kLargestDefect; two products and their sum round it
  ///   R      R_a^T R_b: 2U for an entry, 4U as a matrix, where kMapRounding counts 9U for an entry
  ///   R^T    differs from R^-1 by R^T R - I, at most the defect less 16U, times R^-1; on the way and on b's points,
  ///   which
  ///          are a unit of a's from b's S at most
  UnitPlacement inUnits(double defect) const {
    return {a,
            b,
            turnedToA(columns_b_[0]),
            turnedToA(columns_b_[1]),
            turnedToA(way()) * a.inverse_unit,
            1.1 * error(),
            1.1 * defect,
            defect,
            defect};
  }
  UnitPlacement inUnits() const { return inUnits(defectOf(pose_a, pose_b)); }

  /// From b's frame to a's, with R_a^T in the place of R_a^-1, so that nothing is divided. `defect` as for inUnits().
  /// In U times the other quantity of a row, for the coordinates of a point of b in its bounding box, of extent e:
  ///   R_a^T R_b   products and sum 2 s_ij, see kMappingError         4 e
  ///   the map     two products, their sum, the last sum              3 sqrt2 e
  ///   t           shift 1, products 1, sum 1, the last sum 1         4 |t_b - t_a|_1
  /// and R_a^T misses the inverse by the defect, on what is no longer than sqrt2 e + |t_b - t_a|_1, but for kUnitRows.
  struct TurnedMap {
    Double2 operator()(const Vec2& p) const { return column0 * p.x() + column1 * p.y() + t; }

    Double2 column0, column1, t;
    double error;  ///< of a coordinate, in a's frame
  };
  TurnedMap turnedMap(double defect) const {
    return {turnedToA(columns_b_[0]), turnedToA(columns_b_[1]), turnedToA(shift_),
            (kWayError + 1.5 * defect) * size_ + kTiny};
  }
  static_assert(kWayError >= kUnitRows * errorOf(1) * (2 * kRoot2 * kRoot2 + 3 * kRoot2) && 1.5 > kUnitRows * kRoot2);

  const PolygonData &a, &b;
  const Pose &pose_a, &pose_b;

 protected:
  Double2 turnedToA(Double2 v) const {
    return Double2{columns_a_[0][0], columns_a_[1][0]} * v[0] + Double2{columns_a_[0][1], columns_a_[1][1]} * v[1];
  }

  Double2 columns_a_[2], columns_b_[2], shift_;
  double size_;  ///< both extents and |t_b - t_a|_1, rounded four times
};

}  // namespace tricover::detail
