// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

#include "numbers/double2.h"
#include "numbers/double_double.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "pair/posed_pair.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A vertex of one polygon beside an edge of the other, in the world, or two vertices.
struct Foot {
  double distance;
  double inside;  ///< how far the foot is inside of the edge's nearer end, times the edge's length; 0 of vertices
  double square, length;  ///< the edge's
  Double2 axis;           ///< the direction of the shortest way from a to b
  bool at_end;            ///< whether the nearer end is the edge's end rather than its start
  bool is_plain;          ///< whether the distance is right to PosedVertices::kRelativeError
  bool is_left = false;   ///< whether the vertex is on the left of the edge that it is beside, as doubles see it

  /// Of the edge, from its start (0) to its end (1).
  double part() const {
    const double from_end = inside > 0 ? inside / square : 0;
    return at_end ? 1 - from_end : from_end;
  }
};

/// A pair's ways between vertices, as precise as plain doubles make them, for distances. Vertices and edges are given
/// by their positions in the paths.
class PosedVertices : public PosedPair {
 public:
  PosedVertices(const PolygonData& a_, const Pose& pose_a_, const PolygonData& b_, const Pose& pose_b_, double defect_,
                bool is_swapped_ = false)
      : PosedPair(a_, pose_a_, b_, pose_b_),
        defect(defect_),
        is_swapped(is_swapped_),
        shift_rest_(twoSum(load2(pose_b.data() + 6), -load2(pose_a.data() + 6)).low),
        is_unscaled_(size_ > 0x1p-300 && size_ < 0x1p300) {
    size_ = roundedUp<4>(size_);
  }
  explicit PosedVertices(const PosedPair& pair)
      : PosedVertices(pair.a, pair.pose_a, pair.b, pair.pose_b, defectOf(pair.pose_a, pair.pose_b)) {}

  /// Whether a ring of a (or b) that runs counter-clockwise in its frame does so in the world.
  bool keepsHandOfA() const { return cross(columns_a_[0], columns_a_[1]) > 0; }
  bool keepsHandOfB() const { return cross(columns_b_[0], columns_b_[1]) > 0; }

  /// Whether squares of lengths neither overflow nor underflow. What follows is for those that don't.
  bool isUnscaled() const { return is_unscaled_; }

  const double defect;    ///< defectOf() the poses
  const bool is_swapped;  ///< the caller's order is the other one

  using PosedPair::way;
  /// From a's vertex p to b's vertex q.
  Double2 way(std::size_t p, std::size_t q) const {
    return mapped(columns_b_, b.path[q]) + shift_ - mapped(columns_a_, a.path[p]) + shift_rest_;
  }

  /// Two edges as doubles see them, from a's translation.
  struct EdgePairEnds {
    Double2 a1, a2, b1, b2;
  };
  EdgePairEnds ends(EdgePosition i, EdgePosition j) const {
    const Vec2 *p = a.path.data() + i, *q = b.path.data() + j;
    return {mapped(columns_a_, p[0]), mapped(columns_a_, p[1]), mapped(columns_b_, q[0]) + shift_,
            mapped(columns_b_, q[1]) + shift_};
  }

  /// What a distance may be wrong by, beside the smallest double.
  static constexpr double kRelativeError = 0x1p-47;

  template <bool kEdgeOfA>
  Foot foot(EdgePosition edge, std::size_t vertex) const {
    const Vec2* path = (kEdgeOfA ? a : b).path.data();
    const Double2 along = load2(path[edge + 1].data()) - load2(path[edge].data());
    const Double2 u = mapped(kEdgeOfA ? columns_a_ : columns_b_, along), squares = u * u;
    const double square = squares[0] + squares[1], length = std::sqrt(square);
    const auto wayFrom = [&](std::size_t end) { return kEdgeOfA ? way(end, vertex) : way(vertex, end); };
    const auto from = [&](Double2 w) {
      const Double2 products = u * w;
      return kEdgeOfA ? products[0] + products[1] : -(products[0] + products[1]);
    };
    std::size_t end = edge;
    Double2 w = wayFrom(end);
    double inside = from(w);
    const bool at_end = 2 * inside > square;
    if (at_end) {
      w = wayFrom(++end);
      inside = -from(w);
    }
    if (inside > 0 && square > 0x1p-900) {
      const Double2 areas = u * swapped(w), away = w * w;
      const double area = areas[0] - areas[1], inverse = 1 / length, distance = std::abs(area) * inverse;
      const Double2 axis = Double2{-u[1], u[0]} * (area < 0 ? -inverse : inverse);
      const bool is_plain = isPlain(kEdgeOfA ? end : vertex, kEdgeOfA ? vertex : end, away[0] + away[1], distance);
      return {distance, inside, square, length, axis, at_end, is_plain, kEdgeOfA ? area > 0 : area < 0};
    }
    Foot foot = footOf(w, kEdgeOfA ? end : vertex, kEdgeOfA ? vertex : end);
    foot.square = square;
    foot.length = length;
    foot.at_end = at_end;
    return foot;
  }
  /// The same of two vertices.
  Foot betweenVertices(std::size_t p, std::size_t q) const { return footOf(way(p, q), p, q); }
  /// The same by two-fold numbers, plain if it is kLeastShare of the size.
  Foot twofoldBetween(std::size_t p, std::size_t q) const;
  static constexpr double kLeastShare = 0x1p-44;
  /// How far a vertex is from an edge, by two-fold numbers; 0 if these don't tell. The nearest point is certainly the
  /// edge's start (place -1), its end (1) or inside (0), or that is kUncertain, and `at_end` names the nearer end.
  /// `part` becomes where the nearest point is on the edge, from 0 to 1, or stays if that is certainly inside. Beside
  /// an edge the last steps are in doubles where the way from the nearer end is no longer than kSteepest times the
  /// distance: see EdgeDistances. All lengths times `scale`.
  double twofoldDistance(bool edge_of_a, int place, bool at_end, EdgePosition edge, std::size_t vertex, double scale,
                         double& part) const;
  static constexpr double kSteepest = 8.5;

 protected:
  using Twofold2 = Twofold<Double2>;

  /// From a's vertex to b's, times `scale`: right to 100 U^2 of the size.
  Twofold2 twofoldWay(std::size_t p, std::size_t q, double scale) const;

  Double2 shift_rest_;  ///< what t_b - t_a was rounded by, exactly
  bool is_unscaled_;

 private:
  Foot footOf(Double2 w, std::size_t p, std::size_t q) const {
    const Double2 squares = w * w;
    const double square = squares[0] + squares[1], distance = std::sqrt(square);
    return {distance, 0, 0, 0, w * (1 / distance), false, isPlain(p, q, square, distance)};
  }

  // Whether foot() is right to kRelativeError. Let x be the way, from v of a to w of b, that a distance d was computed
  // from; in units of U, rows of R being unit vectors but for kUnitRows:
  //   R v, R w    products sqrt2 in any direction, sum 1                   2.42 |v| + 2.42 |w|
  //   R w + t     the sum, which is at most |x| + |v|                      |v| + |x|
  //   x           the difference 1, the sum with the rest of t 1           2 |x|
  // which is 3.42 |v| + 2.42 |w| + 3 |x|. Where x itself is nearest, its length adds 2 d: squares and sum, halved, and
  // the root. Beside an edge u, |u x x| / |u| adds
  //   u           difference 1, products sqrt2, sum 1: turns x by          3.42 |x|
  //   u x x       products 1, difference 1                                 |x| + d
  //   / |u|       squares and sum, halved, root, quotient and product      4 d
  // By Cauchy, the square of 3.42 |v| + 2.42 |w| + 7.42 |x| is at most
  //   (3.42^2 + 2.42^2 + 7.42^2 / 4) (|v|^2 + |w|^2 + 4 |x|^2), below 31.4 kPlainShare d^2, the square of 58 d:
  // in all 63 d, and kRelativeError is 64U. As it bounds the angles by which x and u are wrong, too, a vertex taken for
  // one beside an end of the edge rather than beyond it, or the converse, is so by an angle below 128U: in the distance
  // the square of that. Squares of what is nearer than kLeastPlain might underflow.
  static constexpr double kPlainShare = 107, kLeastPlain = 0x1p-400;
  static_assert(kPlainShare * (3.42 * 3.42 + 2.42 * 2.42 + 7.42 * 7.42 / 4) < 58 * 58 &&
                kRelativeError >= kUnitRows * errorOf(58 + 5));
  bool isPlain(std::size_t p, std::size_t q, double way_square, double distance) const {
    const Double2 v = load2(a.path[p].data()), w = load2(b.path[q].data()), squares = v * v + w * w;
    return distance > kLeastPlain && squares[0] + squares[1] + 4 * way_square <= kPlainShare * (distance * distance);
  }
};

}  // namespace tricover::detail
