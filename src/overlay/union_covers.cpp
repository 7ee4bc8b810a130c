// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/union_covers.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "hierarchy/simd.h"
#include "numbers/rigidity.h"
#include "overlay/edge_sides.h"
#include "overlay/rings.h"
#include "pair/containment.h"
#include "pair/edge_pairs.h"
#include "polygon/convexity.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// What one area has of the part.
enum class Share {
  None,   ///< nothing, nor is it as near as the margin
  All,    ///< also with the margin
  Some,   ///< not all, also with the margin
  Unsure  ///< edges touch, or are no borders
};

/// An edge of the part that crosses a border, or comes nearer to it than the margin, is not covered. If no edges meet,
/// each ring of either region is inside or outside of the other one as a whole.
class ShareSearch {
 public:
  ShareSearch(const PosedPair& part_and_area, double margin)
      : given_(part_and_area),
        back_(given_.back()),
        area_is_first_(given_.a.unit < given_.b.unit),
        pair_(area_is_first_ ? back_ : given_),
        margin_(margin) {}

  /// `asks_for_all`: None may be called Some. Then a vertex, which is cheap, often ends the search.
  Share find(bool asks_for_all) {
    const bool starts_inside = asks_for_all && holds(farthestOfFour());
    if (asks_for_all && !starts_inside) return Share::Some;
    const UnitMap at = pair_.inUnits();
    const double reach = at.reach(margin_);
    const auto look = [](const void* search, EdgePosition i, EdgePosition j) {
      return static_cast<ShareSearch*>(const_cast<void*>(search))->isBeyondBorder(i, j);
    };
    const Descent descent{pair_.a, pair_.b, hierarchyOf(pair_.a), hierarchyOf(pair_.b), at, reach};
    if (findHit(descent, {this, look, reach, -1, false}).hit) return Share::Some;
    return have_met_ ? Share::Unsure : shareOfRings(starts_inside);
  }

 private:
  bool holds(EdgePosition vertex) const { return locateInA(back_, given_.a.path[vertex]) != Location::Outside; }

  /// Of four around the part's first ring, the vertex farthest from the area's S.
  EdgePosition farthestOfFour() const {
    const EdgePosition size = given_.a.edgeEnd(0);
    EdgePosition farthest = 0;
    double most = -1;
    for (EdgePosition k = 0; k < 4; ++k) {
      const EdgePosition vertex = k * size / 4;
      const Double2 way = back_.way(back_.a.origin, back_.b.path[vertex]);
      if (const double square = dot(way, way); square > most) most = square, farthest = vertex;
    }
    return farthest;
  }

  /// All of an edge's ring is a border, or nothing is known.
  bool isBorder(EdgePosition edge) const { return regionSidesOf(given_.b).rings[given_.b.ringOf(edge)] != 0; }

  bool isBeyondBorder(EdgePosition i, EdgePosition j) {
    const bool is_beyond =
        crossingDirection(pair_, i, j) != 0 || (margin_ > 0 && edgesWithin(pair_, i, j, margin_, 0, true));
    have_met_ = have_met_ || is_beyond || (margin_ == 0 && edgesMeet(pair_, i, j));
    return is_beyond && isBorder(area_is_first_ ? i : j);
  }

  Share shareOfRings(bool starts_inside) const {
    const PolygonData& part = given_.a;
    std::size_t inside = starts_inside;
    for (std::size_t ring = inside; ring < part.ringCount(); ++ring) inside += holds(part.edgeBegin(ring));
    const EdgePosition hole = part.isDegenerate() ? kNoEdge : ringInside(given_);
    if (hole != kNoEdge) return isBorder(hole) ? Share::Some : Share::Unsure;
    return inside == part.ringCount() ? Share::All : inside == 0 ? Share::None : Share::Some;
  }

  const PosedPair& given_;
  const PosedPair back_;
  const bool area_is_first_;
  const PosedPair& pair_;  ///< the larger one first, as descents want it
  const double margin_;
  bool have_met_ = false;  ///< or come nearer than the margin: some edges
};

/// The interior of the part that no area holds is open: beside some piece of an edge of the part or of an area, on one
/// side, the part has its inside and no area has. The rest of the part are pieces of edges without its inside beside
/// them, and points. Which edges have to be looked at?
///   Say that the piece is the part's. Up to the first place on an area's edges all of its ring is outside of the
///   areas: the edge there meets an area's, and has such a piece. Or the ring comes to no such place: then its vertices
///   tell. Otherwise areas' edges alone go around what is not covered, in the interior of the part: it is a hole.
class CoverSearch {
 public:
  CoverSearch(std::vector<PosedPair> part_and_areas, double margin)
      : pairs_(std::move(part_and_areas)), part_(pairs_[0].a), margin_(margin), sides_(PosedRegions(pairs_, true)) {}

  bool areCovering() { return isCovered() && (margin_ == 0 || isClear()); }

 private:
  bool isCovered() {
    bool is_covered = true;
    forEachEdge(part_, [&](EdgePosition vertex) {
      const auto holdsIt = [&](const PosedPair& pair) { return holdsVertex(pair, vertex); };
      return is_covered = std::any_of(pairs_.begin(), pairs_.end(), holdsIt);
    });
    if (!is_covered) return false;
    for (const EdgePosition edge : edgesThatMeet())
      if (sides_.of(EdgeSides::A, edge).hasAny(&EdgeSides::Piece::isUncovered)) return false;
    if (part_.isDegenerate()) return true;
    // Two convex areas leave no hole, but what is outside of both.
    const auto isConvex = [](const PosedPair& pair) { return cornersOf(pair.b) != nullptr; };
    if (!part_.fill.is_complement && pairs_.size() <= 2 && std::all_of(pairs_.begin(), pairs_.end(), isConvex))
      return true;
    for (std::size_t area = 1; area <= pairs_.size(); ++area)
      if (hasGapBeside(area)) return false;
    return true;
  }

  /// The part's edges that meet some area's, in order.
  std::vector<EdgePosition> edgesThatMeet() const {
    std::vector<EdgePosition> edges;
    for (const PosedPair& pair : pairs_)
      forEachMeeting(pair, 0, [&](EdgePosition i, EdgePosition) {
        edges.push_back(i);
        return true;
      });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  /// Calls visit(i, j) for every edge i of the part and j of an area that meet, or come nearer than the margin, until
  /// it returns false.
  template <typename Visit>
  static void forEachMeeting(const PosedPair& pair, double margin, Visit visit) {
    const bool swaps = pair.a.unit < pair.b.unit;  // forEachPair wants the larger one first
    forEachPair(swaps ? pair.back() : pair, margin, [&](double, EdgePosition i, EdgePosition j) {
      if (swaps) std::swap(i, j);
      return edgesWithin(pair, i, j, margin, 0, true) && !visit(i, j) ? -1.0 : margin;
    });
  }

  /// Whether no boundary of the union is nearer to the part. The distance from the part is that of edges, once the part
  /// is covered.
  bool isClear() {
    bool is_clear = true;
    for (std::size_t area = 1; is_clear && area <= pairs_.size(); ++area)
      forEachMeeting(pairs_[area - 1], margin_, [&](EdgePosition i, EdgePosition j) {
        return is_clear = !sides_.of(area, j).hasBoundaryWithin(i, margin_);
      });
    return is_clear;
  }

  /// Whether an area holds a vertex of the part: with a margin, a ring that is a point by more than another such ring.
  bool holdsVertex(const PosedPair& pair, EdgePosition vertex) const {
    const Vec2& point = part_.path[vertex];
    const Location location = locateInA(pair.back(), point);
    if (location != Location::Boundary || margin_ == 0 || !beginsPoint(part_, vertex))
      return location != Location::Outside;
    std::vector<Ring> rings;
    for (std::size_t r = 0; r < pair.b.ringCount(); ++r)
      if (!beginsPoint(pair.b, pair.b.edgeBegin(r))) rings.push_back(pair.b.vertices(r));
    if (rings.empty()) return false;
    const Polygon rest(rings, pair.b.fill.rule);
    const Location there = locateInA(PosedPair(dataOf(rest), pair.pose_b, pair.a, pair.pose_a), point);
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

  const std::vector<PosedPair> pairs_;
  const PolygonData& part_;
  const double margin_;
  KnownSides sides_;
};

}  // namespace

bool areaCovers(const PosedPair& part_and_area, double margin) {
  const Share share = ShareSearch(part_and_area, margin).find(true);
  return share == Share::Unsure ? CoverSearch({part_and_area}, margin).areCovering() : share == Share::All;
}

bool unionCovers(const std::vector<PosedPair>& part_and_areas, double margin) {
  std::vector<PosedPair> near;
  bool is_sure = true;
  for (const PosedPair& pair : part_and_areas) {
    const Share share = ShareSearch(pair, margin).find(false);
    if (share == Share::All) return true;
    if (share == Share::None) continue;
    is_sure = is_sure && share == Share::Some;
    near.push_back(pair);
  }
  if (near.empty() || (is_sure && near.size() == 1)) return false;
  return CoverSearch(std::move(near), margin).areCovering();
}

}  // namespace tricover::detail
