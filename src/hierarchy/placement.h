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

/// Two polygons under their poses in the world, seen from a's translation: lengths are the true ones. All of it is
/// rounded and knows by how much; the exact stage uses the two poses as given.
class PosedPair {
 public:
  PosedPair(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_)
      : a(a_),
        b(b_),
        pose_a(pose_a_),
        pose_b(pose_b_),
        columns_a_{load2(pose_a.data()), load2(pose_a.data() + 3)},
        columns_b_{load2(pose_b.data()), load2(pose_b.data() + 3)},
        shift_(load2(pose_b.data() + 6) - load2(pose_a.data() + 6)) {
    const Double2 apart = absolute(shift_);
    size_of_b_ = b.extent + (apart[0] + apart[1]);
    size_ = a.extent + size_of_b_;
  }

  // Poses are referred to, so that a temporary one would be gone.
  PosedPair(const PolygonData&, const Pose&&, const PolygonData&, const Pose&) = delete;
  PosedPair(const PolygonData&, const Pose&, const PolygonData&, const Pose&&) = delete;
  PosedPair(const PolygonData&, const Pose&&, const PolygonData&, const Pose&&) = delete;

  PosedPair back() const { return {b, pose_b, a, pose_a}; }

  /// Points within a polygon's bounding box. In U times the other quantity of a row, either coordinate errs by, with
  /// lengths p, q <= sqrt2 e of points in boxes of extent e:
  ///   R_a p       products 1, sum 1                 2 p
  ///   R_b q       the same, the sum with shift 1    3 q
  ///   shift       itself 1, the sum with it 1       2 |t_b - t_a|_1
  Double2 atA(const Vec2& p) const { return mapped(columns_a_, p); }
  Double2 atB(const Vec2& q) const { return mapped(columns_b_, q) + shift_; }
  ApproxPoint fromA(const Vec2& p) const {
    const Double2 at = atA(p);
    return {at[0], at[1], errorOfA()};
  }
  ApproxPoint fromB(const Vec2& q) const {
    const Double2 at = atB(q);
    return {at[0], at[1], errorOfB()};
  }
  double errorOfA() const { return kErrorOfA * a.extent + kTiny; }
  double errorOfB() const { return kErrorOfB * size_of_b_ + kTiny; }
  /// Both together.
  double pointError() const { return kErrorOfB * size_ + 2 * kTiny; }
  static constexpr double kErrorOfA = 3 * kUnitRoundoff, kErrorOfB = 5 * kUnitRoundoff;
  static_assert(kErrorOfA >= kUnitRows * kRoot2 * errorOf(2) && kErrorOfB >= kUnitRows * kRoot2 * errorOf(3));

  /// |p|_1 + |q|_1 + |t_b - t_a|_1 is at most this for all vertices p, q, but for four roundings.
  double size() const { return size_; }

  /// From a point of a's frame to one of b's, both within their polygon's bounding box, and from S to S.
  Double2 way(const Vec2& p, const Vec2& q) const { return mapped(columns_b_, q) + (shift_ - mapped(columns_a_, p)); }
  Double2 way() const { return way(a.origin, b.origin); }
  /// t_b - t_a, rounded.
  Double2 shift() const { return shift_; }
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

  /// b in a's units. `defect` is defectOf() the poses: no singular value of R_a^T R_b misses 1 by more, nor one of R_a.
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

  /// The same with R_a^-1, by a division: boxes are no larger for poses that miss orthonormality. As a matrix, R_a^-1
  /// R_b errs by the spectral norms of 3U times itself (det and d), U times itself (the last product, entry by entry:
  /// sqrt2) and 2U s_ij (at most 2U * 2). c rounds by 6U |c|_1 (TurnBack).
  UnitPlacement inUnits() const {
    const TurnBack to_a(pose_a);
    const Double2 r0 = to_a(columns_b_[0]), r1 = to_a(columns_b_[1]);
    return {a,
            b,
            r0,
            r1,
            to_a(way()) * a.inverse_unit,
            1.1 * error(),
            0,
            Gram(r0, r1).defect(),
            Gram(columns_a_[0], columns_a_[1]).defect()};
  }
  static_assert(Gram::kMatrixError >= kUnitRows * errorOf(1) * (3 + kRoot2 + 2 * 2));

  const PolygonData &a, &b;
  const Pose &pose_a, &pose_b;

 protected:
  static Double2 mapped(const Double2 (&columns)[2], Double2 p) { return columns[0] * p[0] + columns[1] * p[1]; }
  static Double2 mapped(const Double2 (&columns)[2], const Vec2& p) { return mapped(columns, load2(p.data())); }
  Double2 turnedToA(Double2 v) const {
    return Double2{columns_a_[0][0], columns_a_[1][0]} * v[0] + Double2{columns_a_[0][1], columns_a_[1][1]} * v[1];
  }

  Double2 columns_a_[2], columns_b_[2], shift_;
  double size_, size_of_b_;  ///< |p|_1, |q|_1 and |t_b - t_a|_1 together, and of b and t alone, rounded four times
};

}  // namespace tricover::detail
