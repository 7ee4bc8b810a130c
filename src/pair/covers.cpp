// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/covers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "hierarchy/simd.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/coverage.h"
#include "pair/edge_pairs.h"
#include "pair/edge_sides.h"
#include "polygon/edge_walk.h"

namespace tricover {
namespace detail {
namespace {

/// The interior of the part that no area holds is open: beside some piece of an edge of the part or of an area, on one
/// side, the part has its inside and no area has. The rest of the part are pieces of edges without its inside beside
/// them, and points.
class CoverSearch {
 public:
  explicit CoverSearch(const std::vector<PosedPair>& part_and_areas)
      : pairs_(part_and_areas), part_(pairs_[0].a), sides_(PosedRegions(pairs_, PosedRegions::Outside)) {}

  bool isCovered() {
    for (std::size_t ring = 0; ring < part_.ringCount(); ++ring) {
      const std::size_t begin = part_.edgeBegin(ring);
      const auto holdsBegin = [&](const PosedPair& pair) {
        return locateInA(pair.back(), part_.path[begin]) != Location::Outside;
      };
      if (beginsPoint(part_, begin) && std::none_of(pairs_.begin(), pairs_.end(), holdsBegin)) return false;
      for (std::size_t edge = begin; edge < part_.edgeEnd(ring); ++edge)
        if (sides_.of(EdgeSides::A, edge).hasSought()) return false;
    }
    if (part_.isDegenerate()) return true;
    for (std::size_t area = 1; area <= pairs_.size(); ++area)
      if (hasGapBeside(area)) return false;
    return true;
  }

  /// Whether no boundary of the union is nearer to the part. The distance from the part is that of edges, once the part
  /// is covered.
  bool isClear(double margin) {
    bool is_clear = true;
    for (std::size_t area = 1; is_clear && area <= pairs_.size(); ++area) {
      const PosedPair& pair = pairs_[area - 1];
      const bool swaps = pair.a.unit < pair.b.unit;  // forEachPair wants the larger one first
      forEachPair(swaps ? pair.back() : pair, margin, [&](double, std::size_t i, std::size_t j) {
        if (swaps) std::swap(i, j);
        if (edgesWithin(pair, i, j, margin, 0, true)) is_clear = !sides_.of(area, j).hasBoundaryWithin(i, margin);
        return is_clear ? margin : -1.0;
      });
    }
    return is_clear;
  }

 private:
  /// Asks those edges of an area that may be inside of the part.
  bool hasGapBeside(std::size_t area) {
    const PosedPair seen = pairs_[area - 1].back();
    const PolygonData& polygon = seen.a;
    const ApproxPoint center = seenFromA(seen, part_.origin).approx;
    const Vec2 at = polygon.inUnits({center.x, center.y});
    const double reach = part_.reach * (1 + 4 * kLargestDefect) + 2 * center.error;
    bool has_gap = false;
    forEachEdgeNear(polygon, at, at, reach * polygon.inverse_unit,
                    [&](std::size_t edge) { return !(has_gap = sides_.of(area, edge).hasSought()); });
    return has_gap;
  }

  const std::vector<PosedPair>& pairs_;
  const PolygonData& part_;
  KnownSides sides_;
};

}  // namespace

bool unionCovers(const std::vector<PosedPair>& part_and_areas, double margin) {
  if (part_and_areas.empty()) return false;
  CoverSearch search(part_and_areas);
  return search.isCovered() && (margin == 0 || search.isClear(margin));
}

}  // namespace detail

bool covers(const Polygon& area, const Pose& pose_area, const Polygon& part, const Pose& pose_part,
            const CoverOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireRigid(pose_area, "pose_area");
  detail::requireRigid(pose_part, "pose_part");
  return detail::unionCovers({detail::PosedPair(part.data(), pose_part, area.data(), pose_area)}, options.margin);
}

}  // namespace tricover
