// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

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

  static constexpr int kCombinations = 4;

  /// What doubles tell of two edges: each end of one against the other edge, first b's ends, then a's.
  struct View {
    bool meet;         ///< whether the edges share a point: exact
    int nearest;       ///< of the combinations
    double low, high;  ///< of what at() returns, for edges that don't meet
    /// Equal for pairs whose nearest points are certainly of the same vertices and edges, so that at() finds them to be
    /// just as far apart; 0 if there is no telling.
    std::uint64_t feature;

    double square[kCombinations];        ///< of the distance
    double part[kCombinations];          ///< where on the edge the nearest point is, from 0 to 1
    double area[kCombinations];          ///< spanned by the point and the edge, twice
    double along[kCombinations];         ///< times the edge's length, from its start
    double length_square[2], unsure[2];  ///< the edge's; what areas and positions may be wrong by

    /// Whether the nearest point is certainly the edge's start (-1), inside of it (0) or its end (1); otherwise
    /// kUncertain.
    int place(int k) const {
      const double at = along[k], length = length_square[k / 2], error = unsure[k / 2];
      return at < -error ? -1 : at > length + error ? 1 : at > error && at < length - error ? 0 : kUncertain;
    }
  };
  View view(std::size_t i, std::size_t j) const;

  /// Where two edges are nearest: an end of one, and a part of the other from its start (0) to its end (1).
  struct Nearest {
    double distance;
    double along_a, along_b;
  };

  /// For edges that don't meet. Depends on nothing but them and the poses. Where `slack` suffices, a value is
  /// returned that may be above the true one by as much (a factor beyond 1, and a length).
  Nearest at(const View& view, std::size_t i, std::size_t j, double relative_slack, double absolute_slack) const;

  /// A point common to two edges that meet, rounded: what along_a and along_b give is the same point but for that.
  Nearest whereTheyMeet(const View& view) const;

 private:
  static constexpr double kSmallest = 0x1p-1074;

  Nearest combination(int k, const View& view, std::size_t i, std::size_t j) const;
  Nearest exactCombination(int k, std::size_t i, std::size_t j) const;
  std::uint64_t featureOf(const View& view, double d, std::size_t i, std::size_t j) const;
  /// Squares above this are of combinations that can't be the nearest, `d` being the least rounded distance.
  double mostSquare(double d) const;
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
