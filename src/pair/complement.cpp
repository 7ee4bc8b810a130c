// SPDX-License-Identifier: BSD-3-Clause
// The complement of a polygon: rings without the edges that are inside or outside of the region as a whole.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "numbers/errors.h"
#include "numbers/predicates.h"
#include "pair/edge_pairs.h"
#include "pair/edge_sides.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {
namespace {

/// A point that is ordered by x, then by y, which is the order along any line.
using Place = std::array<double, 2>;
Place placeOf(const Vec2& p) { return {p.x(), p.y()}; }

/// A piece of an edge, between points exactly on the edge.
struct Piece {
  Vec2 v, w;
  std::size_t edge;  ///< its position
};

/// The ends in their order: the same for pieces that are the same but for their direction.
using Key = std::array<Place, 2>;
Key keyOf(const Piece& piece) {
  const Place v = placeOf(piece.v), w = placeOf(piece.w);
  return {std::min(v, w), std::max(v, w)};
}

/// Whether p is on an edge and neither of its ends.
bool isWithin(const Vec2& v, const Vec2& w, const Vec2& p) {
  return p != v && p != w && orientation(v, w, p) == 0 && (p.array() >= v.cwiseMin(w).array()).all() &&
         (p.array() <= v.cwiseMax(w).array()).all();
}

/// All edges in order, cut where a vertex is on them. Any two pieces are then the same but for their direction, or have
/// no more than points in common.
std::vector<Piece> cutEdges(const PolygonData& polygon) {
  std::vector<std::vector<Vec2>> cuts(polygon.path.size());
  const Pose still = Pose::Identity();
  forEachPair(PosedPair(polygon, still, polygon, still), 0, [&](double, std::size_t i, std::size_t j) {
    if (isWithin(polygon.path[i], polygon.path[i + 1], polygon.path[j])) cuts[i].push_back(polygon.path[j]);
    return 0.0;
  });
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const Vec2 &v = polygon.path[e], &w = polygon.path[e + 1];
      const bool rises = placeOf(v) < placeOf(w);
      std::sort(cuts[e].begin(), cuts[e].end(), [&](const Vec2& p, const Vec2& q) {
        return rises ? placeOf(p) < placeOf(q) : placeOf(q) < placeOf(p);
      });
      cuts[e].push_back(w);
      Vec2 from = v;
      for (const Vec2& to : cuts[e]) {
        if (to == from && !(v == w)) continue;
        pieces.push_back({from, to, e});
        from = to;
      }
    }
  return pieces;
}

/// Tells of pieces of a polygon under the non-zero rule whether the region is on both sides.
class InnerPieces {
 public:
  InnerPieces(const PolygonData& given, const std::vector<Piece>& pieces)
      : given_(given),
        pieces_(pieces),
        outside_(outsideOf(given, pieces)),
        sides_(PosedRegions({outside_, still_, outside_, still_})) {}
  InnerPieces(const InnerPieces&) = delete;
  InnerPieces& operator=(const InnerPieces&) = delete;
  ~InnerPieces() { outside_.release(); }

  bool has(std::size_t piece) {
    const EdgeSides& sides = sides_.of(EdgeSides::A, outside_.edgePosition(piece));
    if (!sides.isBare()) return false;
    if (!sides.hasSought()) return true;
    const std::size_t edge = pieces_[piece].edge, ring = given_.ringOf(edge);
    refuse("rings: ring " + std::to_string(ring) + ", vertex " + std::to_string(edge - given_.edgeBegin(ring)),
           "the edge from there is partly inside of the region, from a crossing on that is no vertex",
           "make a union of the rings before complement(), with vertices at their crossings");
  }

 private:
  /// Makes the outside of the region, with the pieces for edges.
  static const PolygonData& outsideOf(const PolygonData& given, const std::vector<Piece>& pieces) {
    std::vector<Ring> rings(given.ringCount());
    for (const Piece& piece : pieces) rings[given.ringOf(piece.edge)].push_back(piece.v);
    return *PolygonData::make(RingsView(rings), {given.fill.rule, true});
  }

  const PolygonData& given_;
  const std::vector<Piece>& pieces_;
  const Pose still_ = Pose::Identity();
  const PolygonData& outside_;
  KnownSides sides_;
};

/// Leaves the pieces that have the region on one side, each once. All edges of a polygon that stay as they are count as
/// left alone.
struct BorderPieces {
  explicit BorderPieces(const PolygonData& polygon) {
    std::vector<Piece> pieces = cutEdges(polygon);
    struct Group {
      std::size_t first, count;
      int direction;
    };
    std::map<Key, Group> groups;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const Key key = keyOf(pieces[k]);
      if (key[0] == key[1]) continue;
      Group& group = groups.insert({key, {k, 0, 0}}).first->second;
      ++group.count;
      group.direction += key[0] == placeOf(pieces[k].v) ? 1 : -1;
    }
    std::vector<bool> stays(pieces.size(), false);
    const auto keepBorders =
        [&](auto isBorder) {  // in the order of pieces, each of which leads to the next one's sides
          for (std::size_t k = 0; k < pieces.size(); ++k) {
            const auto group = groups.find(keyOf(pieces[k]));
            if (group == groups.end() || group->second.first != k) continue;
            stays[k] = isBorder(group->second);
            are_given = are_given && group->second.count == 1 && stays[k];
          }
        };
    if (polygon.fill.rule == FillRule::EvenOdd) {
      keepBorders([](const Group& group) { return group.count % 2 != 0; });
    } else {
      InnerPieces inner(polygon, pieces);
      keepBorders([&](const Group& group) { return group.direction != 0 && !inner.has(group.first); });
    }
    for (std::size_t k = 0; k < pieces.size(); ++k)
      if (stays[k]) all.push_back(pieces[k]);
  }

  /// Rings of all pieces. An even number of them ends at each point, so that a walk ends where it began.
  std::vector<Ring> rings() const {
    std::map<Place, std::vector<std::size_t>> at;
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const Vec2& end : {all[k].v, all[k].w}) at[placeOf(end)].push_back(k);
    std::vector<bool> is_used(all.size(), false);
    std::vector<Ring> rings;
    for (std::size_t first = 0; first < all.size(); ++first) {
      if (is_used[first]) continue;
      const Vec2 start = all[first].v;
      Vec2 point = start;
      Ring& ring = rings.emplace_back();
      for (std::size_t k = first;;) {
        is_used[k] = true;
        ring.push_back(point);
        point = all[k].v == point ? all[k].w : all[k].v;
        if (point == start) break;
        // The next piece of the same ring leads on, or else any.
        std::vector<std::size_t>& here = at[placeOf(point)];
        here.erase(std::remove_if(here.begin(), here.end(), [&](std::size_t p) { return is_used[p]; }), here.end());
        k = std::count(here.begin(), here.end(), k + 1) != 0 ? k + 1 : here.front();
      }
    }
    return rings;
  }

  std::vector<Piece> all;
  bool are_given = true;  ///< the polygon's rings have no others
};

}  // namespace
}  // namespace tricover::detail

namespace tricover {

Polygon Polygon::complement() const {
  const detail::BorderPieces border(*data_);
  if (border.all.empty())
    detail::refuse("complement()", isComplement() ? "nothing but edges is outside" : "the polygon has no area",
                   "the result would be the whole plane, or nothing");
  // Where all edges are borders, and each is there once, the even-odd rule means the same as the other.
  const detail::Fill fill{FillRule::EvenOdd, !isComplement()};
  const std::vector<Ring> rings = border.are_given ? this->rings() : border.rings();
  return {Adopt::Data, detail::PolygonData::make(detail::RingsView(rings), fill)};
}

}  // namespace tricover
