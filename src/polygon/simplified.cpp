// SPDX-License-Identifier: BSD-3-Clause
// Rings of fewer vertices.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "numbers/errors.h"
#include "numbers/predicates.h"
#include "polygon/polygon_data.h"

namespace tricover {
namespace detail {
namespace {

/// Leaves vertices out by the method of Douglas and Peucker: a chain of a ring's edges becomes its chord wherever all
/// of its vertices are within the tolerance of that; otherwise the vertex farthest from it stays.
///
/// Then the new region is no farther from the old one than the tolerance, nor the old one from the new one, whatever
/// the fill rule, and whatever crosses:
/// - A chain and its chord are a loop. The rings wind around a point as they did, unless it is in a loop or on one.
/// - A chain is within the tolerance of its chord, which is convex: so is the chain's hull, which holds the loop and
/// all
///   that it winds around. Chords are edges of the new region: what leaves the region is near to it.
/// - A point beside its chord that a loop winds around, or that is on the chord, has the chain beyond it, straight away
///   from the chord, as far from that as the tolerance at most; one beyond an end of the chord is as near to that end,
///   where the chain begins. Chains are of the old region: what comes into the region was near to it.
class ChainSimplifier {
 public:
  ChainSimplifier(const PolygonData& polygon, double tolerance) : polygon_(polygon), tolerance_(tolerance) {}

  Ring simplified(std::size_t ring) {
    const std::size_t begin = polygon_.edgeBegin(ring), end = polygon_.edgeEnd(ring);
    stays_.assign(end + 1 - begin, false);
    begin_ = begin;
    stays_.front() = true;
    chains_ = {{begin, end}};
    while (!chains_.empty()) {
      const Chain chain = chains_.back();
      chains_.pop_back();
      divide(chain);
    }
    Ring left;
    for (std::size_t i = begin; i < end; ++i)
      if (stays_[i - begin]) left.push_back(polygon_.path[i]);
    // A segment there and back, or a point, as rings are written.
    while (left.size() < 3) left.push_back(left.back());
    return left;
  }

 private:
  struct Chain {
    std::size_t begin, end;
  };

  void divide(const Chain& chain) {
    const Vec2 &v = polygon_.path[chain.begin], &w = polygon_.path[chain.end];
    bool all_are_near = true;
    double most = -1;
    std::size_t farthest = chain.end;
    for (std::size_t i = chain.begin + 1; i < chain.end; ++i) {
      const Distance distance(polygon_, polygon_.path[i], v, w);
      if (all_are_near && !isWithin(distance, polygon_.path[i], v, w)) all_are_near = false;
      if (distance.rounded > most) {
        most = distance.rounded;
        farthest = i;
      }
    }
    if (all_are_near) return;
    stays_[farthest - begin_] = true;
    chains_.push_back({chain.begin, farthest});
    chains_.push_back({farthest, chain.end});
  }

  /// Of a point from a segment, in units. In units of the roundoff it errs by at most 13 lengths of the segment and 8
  /// distances (see BesideSegment), which are at most 4 units each, and by what underflows.
  struct Distance {
    static constexpr double kError = 0x1p-45;

    Distance(const PolygonData& polygon, const Vec2& p, const Vec2& v, const Vec2& w) {
      const Vec2 from = polygon.inUnits(p) - polygon.inUnits(v), way = polygon.inUnits(w) - polygon.inUnits(v);
      const double square = way.squaredNorm();
      const double part = square > 0 ? std::clamp(from.dot(way) / square, 0.0, 1.0) : 0;
      rounded = (from - part * way).norm();
    }
    double rounded;
  };

  bool isWithin(const Distance& distance, const Vec2& p, const Vec2& v, const Vec2& w) const {
    const double most = tolerance_ * polygon_.inverse_unit, error = Distance::kError * (1 + most);
    if (polygon_.fitsUnit() && distance.rounded < most - error) return true;
    if (polygon_.fitsUnit() && distance.rounded > most + error) return false;
    return withinExact({nullptr, p}, {nullptr, v}, {nullptr, w}, tolerance_);
  }

  const PolygonData& polygon_;
  const double tolerance_;
  std::size_t begin_ = 0;    ///< of the ring
  std::vector<bool> stays_;  ///< by the position in the ring
  std::vector<Chain> chains_;
};

}  // namespace
}  // namespace detail

Polygon Polygon::simplified(double tolerance) const {
  detail::requireFiniteNotNegative(tolerance, "tolerance");
  detail::ChainSimplifier simplifier(*data_, tolerance);
  std::vector<Ring> rings;
  for (std::size_t r = 0; r < data_->ringCount(); ++r) rings.push_back(simplifier.simplified(r));
  return Polygon(rings, data_->fill);
}

}  // namespace tricover
