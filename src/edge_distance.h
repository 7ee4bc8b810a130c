// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "double2.h"
#include "polygon_data.h"
#include "predicates.h"

namespace tricover::detail {

/// Distances of two posed polygons' edges, in the world, where lengths are the true ones. Edges are given by their
/// positions in the paths.
class EdgeDistances {
 public:
  EdgeDistances(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b);

  /// What at() may be wrong by, beside the smallest double.
  static constexpr double kRelativeError = 0x1p-48;
  /// A lower bound of the distance, too, made one of what at() returns: the smallest double is for at()'s rounding and
  /// for that of this product.
  static double below(double distance) { return distance * (1 - 2 * kRelativeError) - 2 * kSmallest; }
  /// The other way: nothing that is farther apart than this has an at() of at most `distance`.
  static double above(double distance) { return distance * (1 + 4 * kRelativeError) + 4 * kSmallest; }

  struct Bounds {
    bool meet;         ///< the edges share a point: exact
    double low, high;  ///< of what at() returns, for edges that don't meet
  };
  Bounds bounds(std::size_t i, std::size_t j) const;

  /// Where two edges are nearest: an end of one, and a part of the other from its start (0) to its end (1).
  struct Nearest {
    double distance;
    double along_a, along_b;
  };

  /// For edges that don't meet. Depends on nothing but them and the poses. Where `slack` suffices, a value is
  /// returned that may be above the true one by as much (a factor beyond 1, and a length).
  Nearest at(std::size_t i, std::size_t j, double relative_slack, double absolute_slack) const;

  /// A point common to two edges that meet, rounded: what along_a and along_b give is the same point but for that.
  Nearest whereTheyMeet(std::size_t i, std::size_t j) const;

 private:
  static constexpr double kSmallest = 0x1p-1074;
  static constexpr int kCombinations = 4;

  /// Each end of one edge against the other edge, as doubles see it: b's ends against the edge of a, then the converse.
  struct Rounded {
    double square[kCombinations], along[kCombinations], area[kCombinations];
    bool apart;  ///< whether they certainly don't meet
  };
  Rounded rounded(std::size_t i, std::size_t j) const;
  Nearest combination(int k, std::size_t i, std::size_t j) const;
  Nearest exactCombination(int k, std::size_t i, std::size_t j) const;
  bool meetExactly(std::size_t i, std::size_t j) const;

  const PolygonData &a_, &b_;
  const Pose &pose_a_, &pose_b_;
  Double2 columns_a_[2], columns_b_[2];
  Double2 shift_, shift_rest_;  ///< t_b - t_a, scaled: the rounded one and exactly the rest
  double scale_, inverse_;      ///< powers of two: what the doubles here are, per world length
  double size_;                 ///< |p|_1 + |q|_1 + |t_b - t_a|_1 is at most this for all vertices p, q; scaled
  double error_;                ///< of a rounded distance, scaled
};

}  // namespace tricover::detail
