// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "hierarchy/unit_map.h"
#include "numbers/predicates.h"
#include "polygon/covering.h"

namespace tricover::detail {

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
  UnitMap inUnits(double defect) const {
    return unitMapOf(a, b, turnedToA(columns_b_[0]), turnedToA(columns_b_[1]), turnedToA(way()) * a.inverse_unit,
                     1.1 * error(), 1.1 * defect, defect, defect);
  }

  /// The same with R_a^-1, by a division: boxes are no larger for poses that miss orthonormality. As a matrix, R_a^-1
  /// R_b errs by the spectral norms of 3U times itself (det and d), U times itself (the last product, entry by entry:
  /// sqrt2) and 2U s_ij (at most 2U * 2). c rounds by 6U |c|_1 (turnedBack()).
  UnitMap inUnits() const {
    const auto to_a = [&](Double2 v) { return turnedBack(columns_a_[0], columns_a_[1], v); };
    const Double2 r0 = to_a(columns_b_[0]), r1 = to_a(columns_b_[1]);
    return unitMapOf(a, b, r0, r1, to_a(way()) * a.inverse_unit, 1.1 * error(), 0, Gram(r0, r1).defect(),
                     Gram(columns_a_[0], columns_a_[1]).defect());
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

/// Whether edge i of a and edge j of b (positions in the paths) share a point. Exact.
bool edgesMeet(const PosedPair& pair, EdgePosition i, EdgePosition j);

/// Whether they come within `reach` in the world. True is certain up to `reach`, and may be answered up to reach +
/// tolerance only. Exact where tolerance is 0. Strictly: whether they come nearer than a `reach` that isn't 0.
bool edgesWithin(const PosedPair& pair, EdgePosition i, EdgePosition j, double reach, double tolerance,
                 bool strictly = false);

/// Where the filters prove that two edges cross at a point inside both: 1 if, in the world, b's edge leads from the
/// right of a's to the left, -1 for the other way. Otherwise 0.
int crossingDirection(const PosedPair& pair, EdgePosition i, EdgePosition j);

/// How far each point of b may at least be moved before these two edges come apart; 0 where that isn't certain.
double crossingDepth(const PosedPair& pair, EdgePosition i, EdgePosition j);

/// A point of b as a's frame sees it: for the winding of a's rings around it.
inline IncludedPoint seenFromA(const PosedPair& pair, const Vec2& of_b) {
  return {&pair.pose_a, turnedBack(pair.pose_a, pair.fromB(of_b)), {&pair.pose_b, of_b}};
}
/// Where that point is (the paper's Algorithm 1 under a's fill rule). Exact.
Location locateInA(const PosedPair& pair, const Vec2& of_b);

}  // namespace tricover::detail
