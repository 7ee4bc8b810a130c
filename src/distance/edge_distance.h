// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "convex/nearest_features.h"
#include "distance/distance_query.h"
#include "numbers/beside_segment.h"
#include "numbers/double2.h"
#include "numbers/predicates.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Of two edges: where they are nearest, from their starts (0) to their ends (1). One of the two points is an end.
struct EdgeDistance {
  double distance;
  double along_a, along_b;
};

/// Distances of two posed polygons' edges, in the world, where lengths are the true ones. Edges are given by their
/// positions in the paths.
class EdgeDistances : public PosedVertices {
 public:
  explicit EdgeDistances(const PosedVertices& vertices);

  /// A lower bound of the distance, too, made one of what at() returns: the smallest double is for at()'s rounding and
  /// for that of this product.
  static double below(double distance) { return distance * (1 - 2 * kRelativeError) - 2 * kSmallest; }
  /// The other way: nothing that is farther apart than this has an at() of at most `distance`.
  static double above(double distance) { return distance * (1 + 4 * kRelativeError) + 4 * kSmallest; }
  /// What at() says of edges that are truly no farther apart than `limit` is at most this, which rounds once, as at()
  /// does last: so it isn't above 0 for 0.
  static double mostWithin(double limit) {
    const double most = limit * (1 + 1.25 * kRelativeError);
    return most < std::numeric_limits<double>::infinity() ? most : limit;
  }

  /// What doubles tell of two edges.
  struct Bounds {
    double low, high;  ///< of what at() returns, for edges that don't meet
    bool clear;        ///< whether they certainly don't
  };
  Bounds bounds(EdgePosition i, EdgePosition j) const {
    const EdgePairEnds e = ends(i, j);
    const Beside of_a = beside(e.a2 - e.a1, e.b1 - e.a1, e.b2 - e.a1);
    if (b.isPoint()) {  // which crosses nothing
      const double distance = std::sqrt(of_a.square[0]);
      return boundsOf(distance, distance > error_);
    }
    const Beside of_b = beside(e.b2 - e.b1, e.a1 - e.b1, e.a2 - e.b1);
    const Double2 least = of_a.square < of_b.square ? of_a.square : of_b.square;
    return boundsOf(std::sqrt(least[0] < least[1] ? least[0] : least[1]), isClear(of_a) || isClear(of_b));
  }

  /// Whether two edges share a point. Exact.
  bool meet(EdgePosition i, EdgePosition j) const;

  static constexpr int kCombinations = 4;
  /// One does for a point b.
  int combinations() const { return b.isPoint() ? 1 : kCombinations; }

  /// The same, and more, of each end of one edge against the other edge, first b's ends, then a's.
  struct View {
    int nearest;      ///< of the combinations
    double distance;  ///< its own, scaled
    /// Equal for pairs whose nearest points are certainly of the same vertices and edges, so that at() finds them to be
    /// just as far apart; 0 if there is no telling.
    std::uint64_t feature;
    double square[kCombinations];  ///< of the distance
    double part[kCombinations];    ///< where on the edge the nearest point is, from 0 to 1
    double area[kCombinations];    ///< spanned by the point and the edge, twice
    double along[kCombinations];   ///< times the edge's length, from its start
    double length_square[2];       ///< the edge's
  };
  View view(EdgePosition i, EdgePosition j) const;

  /// For edges that don't meet. It depends on nothing but them, the poses and the options. These may allow errors of
  /// what is left beyond the margin, if something certainly is, and no more than the limit. Infinity may stand for
  /// what is certainly above `least`, and dear.
  EdgeDistance at(const View& view, EdgePosition i, EdgePosition j, const DistanceQuery& options, double least) const;
  /// The same where the features are known to be the nearest ones, with their foot. Only for what is unscaled.
  static EdgeDistance ofFeatures(const PosedVertices& vertices, const FeaturePair& features, const Foot& foot,
                                 const DistanceQuery& options) {
    const double part = features.kind == FeaturePair::kVertices ? 0 : foot.part();
    if (!foot.is_plain) return ofCloseFeatures(vertices, features, foot, part, options);
    return placed(features.kind == FeaturePair::kEdgeOfB ? 2 : 0, foot.distance, part);
  }

  /// A point common to two edges that meet, rounded: what along_a and along_b give is the same point but for that.
  EdgeDistance whereTheyMeet(const View& view) const;
  /// Whether plain doubles tell that two edges of what is unscaled cross, and where.
  static bool cross(const PosedVertices& vertices, EdgePosition i, EdgePosition j, EdgeDistance& point);

 private:
  static constexpr double kSmallest = 0x1p-1074;

  /// The points w1 and w2 beside the edge from the origin to u. The members are as in View.
  struct Beside : BesideSegment<Double2> {
    Double2 area;
    double length_square;
  };
  static Beside beside(Double2 u, Double2 w1, Double2 w2) {
    const Double2 x{w1[0], w2[0]}, y{w1[1], w2[1]};
    const double square = u[0] * u[0] + u[1] * u[1], inverse = square > 0x1p-960 ? 1 / square : 0;
    return {besideSegment(x, y, u[0], u[1], inverse), y * u[0] - x * u[1], square};
  }
  /// Whether both points are certainly on one side of the edge's line, or beyond the same end.
  bool isClear(const Beside& s) const {
    const double end = s.length_square + unsure_;
    return (s.area[0] > unsure_ && s.area[1] > unsure_) || (s.area[0] < -unsure_ && s.area[1] < -unsure_) ||
           (s.along[0] < -unsure_ && s.along[1] < -unsure_) || (s.along[0] > end && s.along[1] > end);
  }
  Bounds boundsOf(double d, bool clear) const {
    return {below((d > error_ ? d - error_ : 0) * inverse_),
            (d + error_) * (1 + 2 * kRelativeError) * inverse_ + kSmallest, clear};
  }

  /// Where a point's nearest one is: certainly the edge's start (-1), inside of it (0), its end (1); or kUncertain.
  int placeOf(const View& view, int k) const {
    const double at = view.along[k], length = view.length_square[k / 2];
    return at < -unsure_ ? -1 : at > length + unsure_ ? 1 : at > unsure_ && at < length - unsure_ ? 0 : kUncertain;
  }

  /// What an answer may be where the doubles' distance is this, scaled, if that is within the errors that the options
  /// allow; otherwise 0.
  double allowed(double distance, const DistanceQuery& options) const;
  /// A combination's: the nearest point is at `part` of the edge.
  static EdgeDistance placed(int k, double distance, double part) {
    const double end = k % 2;
    return {distance, k < 2 ? part : end, k < 2 ? end : part};
  }
  static EdgeDistance ofCloseFeatures(const PosedVertices& vertices, const FeaturePair& features, const Foot& foot,
                                      double part, const DistanceQuery& options);
  EdgeDistance combination(int k, const View& view, EdgePosition i, EdgePosition j, double least) const;
  EdgeDistance exactCombination(int k, EdgePosition i, EdgePosition j) const;
  std::uint64_t featureOf(const View& view, EdgePosition i, EdgePosition j) const;
  /// Squares above this are of combinations that can't be the nearest.
  double mostSquare(const View& view) const;

  double scale_, inverse_;  ///< powers of two: what the doubles here are, per world length
  double error_;            ///< of a rounded distance, scaled
  double unsure_;           ///< of areas, and of lengths times lengths
};

}  // namespace tricover::detail
