// SPDX-License-Identifier: BSD-3-Clause
// Rings of fewer vertices.
#include "polygon/simplified.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "numbers/predicates.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// Leaves vertices out by the method of Douglas and Peucker: a chain of a ring's edges becomes its chord wherever all
/// of its vertices are within the tolerance of that; otherwise the vertex farthest from it stays.
///
/// Then the new region is no farther from the old one than the tolerance, nor the old one from the new one, whatever
/// the fill rule, and whatever crosses:
/// - A chain and its chord are a loop. The rings wind around a point as they did, unless it is in a loop or on one.
/// - A chain is within the tolerance of its chord, which is convex: so is the chain's hull, which holds the loop and
///   what that winds around. Chords are edges of the new region: what leaves the region is near to it.
/// - A point beside its chord that a loop winds around, or that is on the chord, has the chain beyond it, straight away
///   from the chord, as far from that as the tolerance at most; one beyond an end of the chord is as near to that end,
///   where the chain begins. Chains are of the old region: what comes into the region was near to it.
class ChainSimplifier {
 public:
  ChainSimplifier(const PolygonData& polygon, double tolerance) : polygon_(polygon), tolerance_(polygon, tolerance) {}

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
      const double distance = tolerance_.distance(polygon_.path[i], v, w);
      if (all_are_near && !tolerance_.holds(distance, polygon_.path[i], v, w)) all_are_near = false;
      if (distance > most) {
        most = distance;
        farthest = i;
      }
    }
    if (all_are_near) return;
    stays_[farthest - begin_] = true;
    chains_.push_back({chain.begin, farthest});
    chains_.push_back({farthest, chain.end});
  }

  const PolygonData& polygon_;
  const Tolerance tolerance_;
  std::size_t begin_ = 0;    ///< of the ring
  std::vector<bool> stays_;  ///< by the position in the ring
  std::vector<Chain> chains_;
};

}  // namespace

double Tolerance::distance(const Vec2& p, const Vec2& v, const Vec2& w) const {
  return std::sqrt(squaredDistanceToSegment(polygon_.inUnits(p), polygon_.inUnits(v), polygon_.inUnits(w)));
}

bool Tolerance::holds(double distance, const Vec2& p, const Vec2& v, const Vec2& w) const {
  const double most = tolerance_ * polygon_.inverse_unit, error = kError * (1 + most);
  if (polygon_.fitsUnit() && distance < most - error) return true;
  if (polygon_.fitsUnit() && distance > most + error) return false;
  return withinExact({nullptr, p}, {nullptr, v}, {nullptr, w}, tolerance_);
}

std::vector<Ring> simplifiedRings(const PolygonData& polygon, double tolerance) {
  ChainSimplifier simplifier(polygon, tolerance);
  std::vector<Ring> rings;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) rings.push_back(simplifier.simplified(r));
  return rings;
}

}  // namespace tricover::detail
