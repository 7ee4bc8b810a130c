// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/union_covers.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "hierarchy/simd.h"
#include "numbers/rigidity.h"
#include "overlay/edge_sides.h"
#include "pair/edge_pairs.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// The interior of the part that no area holds is open: beside some piece of an edge of the part or of an area, on one
/// side, the part has its inside and no area has. The rest of the part are pieces of edges without its inside beside
/// them, and points.
class CoverSearch {
 public:
  CoverSearch(const std::vector<PosedPair>& part_and_areas, double margin)
      : pairs_(part_and_areas), part_(pairs_[0].a), margin_(margin), sides_(PosedRegions(pairs_, true)) {}

  bool isCovered() {
    for (std::size_t ring = 0; ring < part_.ringCount(); ++ring) {
      const EdgePosition begin = part_.edgeBegin(ring);
      const auto holdsBegin = [&](const PosedPair& pair) { return holdsPoint(pair, part_.path[begin]); };
      if (beginsPoint(part_, begin) && std::none_of(pairs_.begin(), pairs_.end(), holdsBegin)) return false;
      for (EdgePosition edge = begin; edge < part_.edgeEnd(ring); ++edge)
        if (sides_.of(EdgeSides::A, edge).hasAny(&EdgeSides::Piece::isUncovered)) return false;
    }
    if (part_.isDegenerate()) return true;
    for (std::size_t area = 1; area <= pairs_.size(); ++area)
      if (hasGapBeside(area)) return false;
    return true;
  }

  /// Whether no boundary of the union is nearer to the part. The distance from the part is that of edges, once the part
  /// is covered.
  bool isClear() {
    bool is_clear = true;
    for (std::size_t area = 1; is_clear && area <= pairs_.size(); ++area) {
      const PosedPair& pair = pairs_[area - 1];
      const bool swaps = pair.a.unit < pair.b.unit;  // forEachPair wants the larger one first
      forEachPair(swaps ? pair.back() : pair, margin_, [&](double, EdgePosition i, EdgePosition j) {
        if (swaps) std::swap(i, j);
        if (edgesWithin(pair, i, j, margin_, 0, true)) is_clear = !sides_.of(area, j).hasBoundaryWithin(i, margin_);
        return is_clear ? margin_ : -1.0;
      });
    }
    return is_clear;
  }

 private:
  /// Whether an area holds a point of the part: with a margin, by more than a ring that is the same point.
  bool holdsPoint(const PosedPair& pair, const Vec2& point) const {
    const Location location = locateInA(pair.back(), point);
    if (location != Location::Boundary || margin_ == 0) return location != Location::Outside;
    std::vector<Ring> rings;
    for (std::size_t r = 0; r < pair.b.ringCount(); ++r)
      if (!beginsPoint(pair.b, pair.b.edgeBegin(r))) rings.push_back(pair.b.vertices(r));
    if (rings.empty()) return false;
    const Polygon rest(rings, pair.b.fill.rule);
    const Location there = locateInA(PosedPair(rest.data(), pair.pose_b, pair.a, pair.pose_a), point);
    return there != (pair.b.fill.is_complement ? Location::Inside : Location::Outside);
  }

  /// Asks those edges of an area that may be inside of the part.
  bool hasGapBeside(std::size_t area) {
    const PosedPair seen = pairs_[area - 1].back();
    const PolygonData& polygon = seen.a;
    const ApproxPoint center = seenFromA(seen, part_.origin).approx;
    const Vec2 at = polygon.inUnits({center.x, center.y});
    const double reach = part_.reach * (1 + 4 * kLargestDefect) + 2 * center.error;
    bool has_gap = false;
    forEachEdgeNear(polygon, at, at, reach * polygon.inverse_unit, [&](EdgePosition edge) {
      return !(has_gap = sides_.of(area, edge).hasAny(&EdgeSides::Piece::isUncovered));
    });
    return has_gap;
  }

  const std::vector<PosedPair>& pairs_;
  const PolygonData& part_;
  const double margin_;
  KnownSides sides_;
};

}  // namespace

bool unionCovers(const std::vector<PosedPair>& part_and_areas, double margin) {
  if (part_and_areas.empty()) return false;
  CoverSearch search(part_and_areas, margin);
  return search.isCovered() && (margin == 0 || search.isClear());
}

}  // namespace tricover::detail
