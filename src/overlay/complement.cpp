// SPDX-License-Identifier: BSD-3-Clause
// The complement of a polygon: rings without the edges that are inside or outside of the region as a whole.
#include "overlay/complement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "numbers/errors.h"
#include "numbers/predicates.h"
#include "overlay/edge_sides.h"
#include "pair/edge_pairs.h"
#include "polygon/edge_walk.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {
namespace {

/// A piece of an edge, between points exactly on the edge.
struct EdgePiece {
  /// The same for pieces that are the same but for their direction.
  std::array<OrderedPoint, 2> key() const { return {std::min(v, w), std::max(v, w)}; }

  OrderedPoint v, w;
  EdgePosition edge;  ///< its position
};

/// All edges in order, cut where a vertex is on them. Any two pieces are then the same but for their direction, or have
/// no more than points in common.
std::vector<EdgePiece> cutEdges(const PolygonData& polygon) {
  std::vector<std::vector<OrderedPoint>> places(polygon.path.size());
  const Pose still = Pose::Identity();
  forEachPair(PosedPair(polygon, still, polygon, still), 0, [&](double, EdgePosition i, EdgePosition j) {
    const Vec2 &v = polygon.path[i], &w = polygon.path[i + 1], &p = polygon.path[j];
    if (p == v || p == w || (orientation(v, w, p) == 0 && betweenExact({nullptr, p}, {nullptr, v}, {nullptr, w})))
      places[i].push_back(ordered(p));
    return 0.0;
  });
  std::vector<EdgePiece> pieces;
  forEachEdge(polygon, [&](EdgePosition edge) {
    std::vector<OrderedPoint>& along = places[edge];
    std::sort(along.begin(), along.end());
    along.erase(std::unique(along.begin(), along.end()), along.end());
    if (along.front() != ordered(polygon.path[edge])) std::reverse(along.begin(), along.end());
    if (along.size() == 1) along.push_back(along[0]);
    for (std::size_t k = 1; k < along.size(); ++k) pieces.push_back({along[k - 1], along[k], edge});
    return true;
  });
  return pieces;
}

/// Rounded points, each the same as one before that is within rounding of it.
class SnappedPoints {
 public:
  explicit SnappedPoints(double reach) : reach_(reach) {}

  OrderedPoint snap(const Vec2& p) {
    for (auto it = known_.lower_bound({p.x() - reach_, p.y()}); it != known_.end() && (*it)[0] <= p.x() + reach_; ++it)
      if (std::abs((*it)[1] - p.y()) <= reach_) return *it;
    return *known_.insert(ordered(p)).first;
  }

 private:
  const double reach_;
  std::set<OrderedPoint> known_;
};

/// Tells of each piece whether the region is on one side of it alone, under the non-zero rule. Where that changes at a
/// crossing, the piece is cut there if crossings are to be `rounded`, and otherwise refused.
std::vector<bool> bordersOf(const PolygonData& given, std::vector<EdgePiece>& pieces, bool rounded) {
  std::vector<Ring> rings(given.ringCount());
  // Where they cross is known where areas don't leave the range of doubles.
  const bool is_in_range = given.unit < 0x1p300 && given.unit > 0x1p-300;
  const double scale = rounded && !is_in_range ? given.inverse_unit : 1;
  for (const EdgePiece& piece : pieces) rings[given.ringOf(piece.edge)].push_back(scale * Vec2(piece.v.data()));
  const Polygon cut(rings, given.fill.rule);
  KnownSides sides{PosedRegions(detail::dataOf(cut))};
  std::vector<EdgePiece> all;
  std::vector<bool> borders;
  for (const EdgePiece& piece : pieces) {
    const EdgeSides& beside = sides.of(EdgeSides::A, detail::dataOf(cut).edgePosition(&piece - pieces.data()));
    const bool is_border = beside.hasAny(&EdgeSides::Piece::isBorder);
    if (!is_border || !beside.hasAny(&EdgeSides::Piece::isNoBorder)) {
      all.push_back(piece);
      borders.push_back(is_border);
      continue;
    }
    const std::size_t ring = given.ringOf(piece.edge);
    if (!rounded)
      refuse("rings: ring " + std::to_string(ring) + ", vertex " +
                 std::to_string(given.edgeNumber(piece.edge) - given.firstNumber(ring)),
             "the edge from there is partly inside of the region, from a crossing on that is no vertex",
             "make a union of the rings before complement(), with vertices at their crossings");
    const Vec2 v(piece.v.data()), w(piece.w.data());
    OrderedPoint from = piece.v;
    for (const EdgeSides::Piece& part : beside.pieces()) {
      const OrderedPoint to = part.to < 1 ? ordered((1 - part.to) * v + part.to * w) : piece.w;
      all.push_back({from, to, piece.edge});
      borders.push_back(part.isBorder());
      from = to;
    }
  }
  if (all.size() > pieces.size()) {
    // A crossing may be within rounding of a vertex, or of another one.
    SnappedPoints snapped(0x1p-48 * given.extent);
    for (std::vector<EdgePiece>* some : {&pieces, &all})
      for (EdgePiece& piece : *some)
        piece.v = snapped.snap(Vec2(piece.v.data())), piece.w = snapped.snap(Vec2(piece.w.data()));
  }
  pieces = std::move(all);
  return borders;
}

/// The pieces that have the region on one side, each once. All edges of a polygon that stay as they are count as left
/// alone.
struct BorderPieces {
  BorderPieces(const PolygonData& polygon, bool rounded) {
    std::vector<EdgePiece> pieces = cutEdges(polygon);
    std::vector<bool> borders;
    if (polygon.fill.rule == FillRule::NonZero) borders = bordersOf(polygon, pieces, rounded);
    std::map<std::array<OrderedPoint, 2>, int> counts;
    for (const EdgePiece& piece : pieces) ++counts[piece.key()];
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (pieces[k].v == pieces[k].w) {
        are_given = are_given && !beginsPoint(polygon, pieces[k].edge);
        continue;
      }
      int& count = counts[pieces[k].key()];
      const bool stays = borders.empty() ? count % 2 != 0 : count > 0 && borders[k];
      if (stays) all.push_back(pieces[k]);
      are_given = are_given && stays && count == 1;
      count = 0;
    }
  }

  using PiecesByEnds = std::map<OrderedPoint, std::set<std::size_t>>;

  /// Among the points where an odd number of pieces is left, and `start`.
  static OrderedPoint nearestEnd(const PiecesByEnds& left, const OrderedPoint& point, const OrderedPoint& start) {
    const auto way = [&](const OrderedPoint& p) { return (Vec2(p.data()) - Vec2(point.data())).stableNorm(); };
    const OrderedPoint* nearest = &start;
    for (const auto& [end, pieces] : left)
      if (pieces.size() % 2 != 0 && way(end) < way(*nearest)) nearest = &end;
    return *nearest;
  }

  /// Rings of all pieces, and the given edges that theirs are pieces of. An even number of pieces ends at each point,
  /// so that a walk ends where it began.
  BorderRings rings() const {
    PiecesByEnds left;
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const OrderedPoint& end : {all[k].v, all[k].w}) left[end].insert(k);
    BorderRings found;
    for (std::size_t first = 0; first < all.size(); ++first) {
      if (left[all[first].v].count(first) == 0) continue;
      found.rings.emplace_back();
      OrderedPoint point = all[first].v;
      for (std::size_t k = first;;) {
        found.rings.back().push_back(Vec2(point.data()));
        found.edges.push_back(all[k].edge);
        for (const OrderedPoint& end : {all[k].v, all[k].w}) left[end].erase(k);
        point = all[k].v == point ? all[k].w : all[k].v;
        if (left[point].empty() && point != all[first].v) {
          // A crossing was rounded apart: the walk goes on from the nearest end.
          const OrderedPoint other = nearestEnd(left, point, all[first].v);
          if (other != all[first].v) {
            found.rings.back().push_back(Vec2(point.data()));
            found.edges.push_back(all[k].edge);
          }
          point = other;
        }
        if (point == all[first].v) break;
        // The next piece of the same ring leads on, or else any.
        k = left[point].count(k + 1) != 0 ? k + 1 : *left[point].begin();
      }
      // Where points were rounded, as in a sliver.
      for (Ring& ring = found.rings.back(); ring.size() < 3;) {
        ring.push_back(ring.back());
        found.edges.push_back(found.edges.back());
      }
    }
    return found;
  }

  std::vector<EdgePiece> all;
  bool are_given = true;  ///< the polygon's rings have no others
};

}  // namespace

std::optional<BorderRings> borderRings(const PolygonData& polygon) {
  const BorderPieces border(polygon, true);
  if (border.are_given && !border.all.empty()) return std::nullopt;
  return border.rings();
}

}  // namespace tricover::detail

namespace tricover {

Polygon Polygon::complement() const {
  const detail::BorderPieces border(*data_, false);
  if (border.all.empty())
    detail::refuse("complement()", isComplement() ? "nothing but edges is outside" : "the polygon has no area",
                   "the result would be the whole plane, or nothing");
  // Where all edges are borders, and each is there once, the even-odd rule means the same as the other.
  const detail::Fill fill{FillRule::EvenOdd, !isComplement()};
  const std::vector<Ring> rings = border.are_given ? this->rings() : border.rings().rings;
  return {Adopt::Data, detail::PolygonData::make(detail::RingsView(rings), fill)};
}

}  // namespace tricover
