// SPDX-License-Identifier: BSD-3-Clause
// Branch and bound for the largest distance that a point of a part has from an area.
//
// The distance from one edge of the area is convex. So over a segment or a triangle it is at most the affine function
// with its values at the corners, and the distance from the area is at most the Peak of these functions for any choice
// of edges. The area's edge nearest to that peak joins the choice next: the bound is exact once the choice holds the
// edges that are nearest at the true maximum, as long as their feet are inside of them, and converges elsewhere. From
// the deepest point so far the search climbs along the edges' tangents (Newton's step) to the maximum beside it, and
// cuts there: what is left beside an exact maximum is bounded by it.
//
// The maximum is at a point of the part's edges, on an arc outside of the area, or in the part's interior. There it is
// a local maximum of the distance from the area alone: no direction leads away from all nearest points. A cell that has
// such a direction for all edges that may be nearest holds no such maximum.
#include "depth/deepest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "depth/cells.h"
#include "depth/inner_arcs.h"
#include "depth/peak.h"
#include "numbers/best_first.h"
#include "overlay/rings.h"
#include "pair/edge_pairs.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostSteps = std::size_t{1} << 17;

/// At the peak of a piece, then it is cut.
constexpr int kMostLooks = 24;
/// A cell is large if its height is more than this share of the distance in it. A large cell is cut before it is looked
/// at closely.
constexpr double kLargeCell = 0.4;

class DepthSearch {
 public:
  DepthSearch(const Overlap& overlap, int part_side, double least, double enough)
      : overlap_(overlap),
        frame_(overlap.frame),
        part_(overlap.pair, frame_, part_side),
        area_(overlap.pair, frame_, 1 - part_side),
        arcs_(overlap.arcs[part_side]),
        is_outside_(overlap.is_outside),
        is_concave_(is_outside_ && !overlap.excludes && cornersOf(area_.polygon) != nullptr),
        inside_(is_concave_ ? regionSidesOf(area_.polygon).rings[0] * (area_.isMirrored() ? -1 : 1) : 0),
        precision_(overlap.precision()),
        enough_((enough + kTiny) / frame_.unit() + precision_),
        cells_(overlap, part_, area_),
        search_(-least / frame_.unit()) {}

  DeepestPoint find() {
    for (const InnerArc& arc : arcs_.arcs) addArc(arc);
    if (run()) addInterior(), run();
    DeepestPoint result = best_;
    result.distance = best_.distance * frame_.unit();
    result.upper_bound = std::max(-search_.lower(), best_.distance) * frame_.unit();
    if (best_.distance > 0) {
      result.point = frame_.toWorld(best_.point);
      result.nearest = frame_.toWorld(best_.nearest);
      result.way = (best_.nearest - best_.point) / best_.distance;
    }
    return result;
  }

 private:
  /// A convex function, no less than how far a point outside of the area is from that. From an edge; of a convex region
  /// the depth behind the edge's line.
  double distance(EdgePosition edge, const Vec2& p) const {
    if (!is_concave_) return area_.distance(edge, p);
    const Vec2 v = area_.vertex(edge), along = area_.vertex(edge + 1) - v;
    const double length = along.norm();
    return length > 0 ? inside_ * cross(along, p - v) / length : area_.distance(edge, p);
  }

  bool run() {
    return search_.run(
        precision_, [&] { return ++steps_ > kMostSteps || best_.distance > enough_; },
        [&](Piece&& piece) {
          if (piece.corners == 0)
            expandChain(piece);
          else if (piece.corners == 2)
            expandEdge(piece);
          else
            expandCell(piece);
        });
  }

  /// Returns whether it is the deepest one so far.
  bool offer(const Vec2& point, const PosedSide::Near& near, EdgePosition edge) {
    if (!(-near.distance < search_.upper) || !(near.distance > best_.distance)) return false;
    best_.distance = near.distance;
    best_.point = point;
    best_.nearest = near.point;
    best_.edge = edge;
    best_.nearest_edge = near.edge;
    search_.upper = -near.distance;
    return true;
  }

  // Chains.

  void addArc(const InnerArc& arc) {
    Piece chain{-kInfinity, 0, arc.is_known, arc.from, arc.to, arc.from};
    for (const EdgePosition met : arc.met)
      if (met != kNoEdge) chain.addEdge(met);
    pushChain(chain);
  }

  void pushChain(Piece chain) {
    if (chain.to == chain.from + 1) return pushEdge(chain);
    for (std::size_t k = 0; k < chain.edge_count; ++k) {
      double most = 0;
      std::size_t at = chain.from;
      for (std::size_t i = chain.from; i <= chain.to; ++i)
        if (const double far = distance(chain.edges[k], arcs_.points[i]); far > most) most = far, at = i;
      if (most < -chain.least) chain.least = -most, chain.at = at;
    }
    search_.push(chain);
  }

  void expandChain(Piece& chain) {
    const std::size_t at = chain.at;
    switch (look(chain, arcs_.points[at], edgeAt(chain, at))) {
      case Look::InArea:
        return;
      case Look::NewEdge:
        return pushChain(chain);
      case Look::Deepest:
      case Look::NothingNew:
        break;
    }
    const bool is_between = at > chain.from && at < chain.to;
    const std::size_t middle = is_between ? at : (chain.from + chain.to) / 2;
    for (const auto& [from, to] : {std::pair(chain.from, middle), std::pair(middle, chain.to)}) {
      Piece half = chain;
      half.from = from, half.to = to, half.at = from;
      pushChain(half);
    }
  }

  EdgePosition edgeAt(const Piece& piece, std::size_t at) const { return arcs_.edges[std::min(at, piece.to - 1)]; }

  enum class Look { NewEdge, Deepest, NothingNew, InArea };
  /// Looks at a point of a chain or an edge: which edge of the area is the nearest? An arc that is in the area at a
  /// point away from the borders is there as a whole.
  Look look(Piece& piece, const Vec2& point, EdgePosition edge) {
    const PosedSide::Near near = area_.nearest(point);
    if (!piece.is_known && near.distance > 4 * frame_.error()) {
      piece.is_known = cells_.isOutsideOfArea(point);
      if (!piece.is_known) return Look::InArea;
    }
    const bool is_deepest = offer(point, near, edge), is_new = piece.addEdge(near.edge);
    return is_new ? Look::NewEdge : is_deepest ? Look::Deepest : Look::NothingNew;
  }

  // Edges and cells.

  void pushEdge(Piece edge) {
    edge.corners = 2;
    edge.corner[0] = arcs_.points[edge.from];
    edge.corner[1] = arcs_.points[edge.from + 1];
    pushSimplex(edge);
  }

  void pushSimplex(Piece& simplex) {
    bound(simplex);
    search_.push(simplex);
  }

  /// Bounds it by the edges that it knows; their peak is the next place.
  void bound(Piece& simplex) {
    const auto corners = static_cast<std::size_t>(simplex.corners);
    Peak peak(corners);
    std::array<std::pair<OfCorners, EdgePosition>, Peak::kMost> known;
    for (std::size_t k = 0; k < simplex.edge_count; ++k) {
      OfCorners distances{};
      for (std::size_t c = 0; c < corners; ++c) distances[c] = distance(simplex.edges[k], simplex.corner[c]);
      known[k] = {distances, simplex.edges[k]};
      peak.add(distances);
    }
    simplex.least = std::max(simplex.least, -peak.value);
    if (simplex.edge_count == 0) peak.place = {0.5, 0.5, 0};
    // The last one is the first to be forgotten.
    std::sort(
        known.begin(), known.begin() + static_cast<std::ptrdiff_t>(simplex.edge_count),
        [&](const auto& p, const auto& q) { return valueAt(p.first, peak.place) < valueAt(q.first, peak.place); });
    for (std::size_t k = 0; k < simplex.edge_count; ++k) simplex.edges[k] = known[k].second;
    simplex.place = placeIn(simplex, peak.place);
  }

  /// The next place is the peak of the edges' tangents at one that was looked at.
  void climb(Piece& simplex, const Vec2& from) {
    simplex.place = from;
    const auto corners = static_cast<std::size_t>(simplex.corners);
    Peak peak(corners);
    for (std::size_t k = 0; k < simplex.edge_count; ++k) {
      const Vec2 way = from - area_.foot(simplex.edges[k], from);
      const double far = way.norm();
      if (!(far > 0)) return;
      OfCorners tangent{};
      for (std::size_t c = 0; c < corners; ++c) tangent[c] = far + way.dot(simplex.corner[c] - from) / far;
      peak.add(tangent);
    }
    simplex.place = placeIn(simplex, peak.place);
  }

  void expandEdge(Piece& edge) {
    const Vec2 place = edge.place;
    const Look found = look(edge, place, arcs_.edges[edge.from]);
    if (found == Look::InArea) return;
    if (found != Look::NothingNew && ++edge.looks < kMostLooks) {
      bound(edge);
      if (found == Look::Deepest) climb(edge, place);
      return search_.push(edge);
    }
    const Vec2 middle = cutOf(edge.corner[0], edge.corner[1], place);
    for (const auto& [v, w] : {std::pair(edge.corner[0], middle), std::pair(middle, edge.corner[1])}) {
      Piece half = edge;
      half.looks = 0;
      half.corner[0] = v, half.corner[1] = w;
      pushSimplex(half);
    }
  }

  /// Where to cut a segment: at the deepest point, or else at a place of it, unless that is near an end.
  Vec2 cutOf(const Vec2& v, const Vec2& w, const Vec2& place) const {
    const double length = (w - v).norm();
    const auto isInside = [&](const Vec2& p, double room) { return (p - v).norm() > room && (w - p).norm() > room; };
    if ((best_.point - place).norm() <= 16 * frame_.error() && isInside(best_.point, 0)) return best_.point;
    return isInside(place, 0x1p-4 * length) ? place : Vec2(0.5 * v + 0.5 * w);
  }

  // Cells of the plane, where the part's interior may be.

  /// The box around the overlap, along the longest edge there.
  void addInterior() {
    if (part_.polygon.isDegenerate()) return;
    Vec2 along = Vec2::UnitX();
    double longest = 0;
    for (const InnerArcs& arcs : overlap_.arcs)
      for (const InnerArc& arc : arcs.arcs)
        for (std::size_t i = arc.from; i < arc.to; ++i)
          if (const Vec2 way = arcs.points[i + 1] - arcs.points[i]; way.norm() > longest)
            longest = way.norm(), along = way / longest;
    Eigen::Matrix2d axes;
    axes << along.x(), -along.y(), along.y(), along.x();
    Eigen::AlignedBox2d box;
    for (const InnerArcs& arcs : overlap_.arcs)
      for (const Vec2& point : arcs.points) box.extend(axes.transpose() * point);
    if (box.isEmpty() || !(box.sizes().minCoeff() > 0)) return;
    const auto corner = [&](double x, double y) {
      return Vec2(axes * (box.min() + Vec2(x * box.sizes().x(), y * box.sizes().y())));
    };
    const Vec2 v = corner(0, 0), u = corner(1, 0), w = corner(1, 1), t = corner(0, 1), center = corner(0.5, 0.5);
    const PosedSide::Near near = area_.nearest(center);
    double most = 0;
    for (const Vec2& p : {v, u, w, t}) most = std::max(most, distance(near.edge, p));
    most = std::min(most, (cells_.isOutsideOfArea(center) ? near.distance : -near.distance) + (w - center).norm());
    if (most + search_.upper <= precision_) return;
    for (const Vec2& p : {u, t}) {
      Piece cell{-most, 3};
      cell.corner = {v, w, p};
      if (cells_.mayHoldMaximum(cell)) pushCell(cell);
    }
  }

  /// It is looked at in its middle first.
  void pushCell(Piece cell) {
    cell.looks = 0;
    cell.place = centerOf(cell);
    search_.push(cell);
  }

  void expandCell(Piece& cell) {
    const Vec2 place = cell.place;
    const double reach = reachOf(cell, place);
    const PosedSide::Near near = area_.nearest(place);
    const bool is_outside = cells_.isOutsideOfArea(place);
    if (!is_outside && near.distance > reach) return;
    const bool is_in_part = part_.locate(place) != Location::Outside;
    if (!is_in_part && part_.nearest(place).distance > reach) return;
    const bool is_deepest = is_outside && is_in_part && offer(place, near, kNoEdge);
    cell.least = std::max(cell.least, (is_outside ? -near.distance : near.distance) - reach);
    const bool is_new = cell.addEdge(near.edge);
    bound(cell);
    if (-cell.least + search_.upper <= precision_) return;
    // In a convex region the depth is concave: where its peak in the cell isn't in the part, no inner point of that is
    // one.
    if (is_concave_ && !is_in_part && is_outside && near.distance + precision_ >= -cell.least) return;
    // A large cell is looked at in its middle, another one then at its peak, too.
    const bool is_large = !is_concave_ && heightOf(cell) > -kLargeCell * cell.least;
    if (!is_large && (is_new || is_deepest || cell.looks == 0) && ++cell.looks < kMostLooks) {
      if (is_deepest) climb(cell, place);
      return search_.push(cell);
    }
    if (!is_large && cutAtDeepest(cell)) return;
    for (const Piece& part : cells_.divide(cell, is_large)) pushCell(part);
  }

  /// Cuts a cell at the deepest point so far, if that is in it.
  bool cutAtDeepest(const Piece& cell) {
    if (!(best_.distance > 0 && isInside(cell, best_.point))) return false;
    for (std::size_t c = 0; c < 3; ++c) {
      Piece third = cell;
      third.corner[c] = best_.point;
      pushCell(third);
    }
    return true;
  }

  const Overlap& overlap_;
  const WorldFrame& frame_;
  const PosedSide part_, area_;
  const InnerArcs& arcs_;
  const bool is_outside_, is_concave_;
  const double inside_;  ///< of a convex region: 1 if that is to the left of its edges, -1 to the right
  const double precision_, enough_;
  Cells cells_;
  BestFirst<Piece> search_;
  DeepestPoint best_;  ///< in the frame
  std::size_t steps_ = 0;
};

}  // namespace

Overlap::Overlap(const PolygonData& part, const Pose& pose_part, const Area& area)
    : excludes(area.excludes),
      is_outside(area.is_outside),
      part_side(area.polygon.unit >= part.unit ? 1 : 0),
      pair(part_side == 1 ? PosedPair(area.polygon, area.pose, part, pose_part)
                          : PosedPair(part, pose_part, area.polygon, area.pose)),
      frame(pair),
      crossings(findCrossings(pair, frame)),
      arcs{{pair, frame, crossings, 0, part_side == 0 ? is_outside : true, !excludes},
           {pair, frame, crossings, 1, part_side == 1 ? is_outside : true, !excludes}} {}

DeepestPoint findDeepestPoint(const Overlap& overlap, bool swaps, double least, double enough) {
  return DepthSearch(overlap, swaps ? 1 - overlap.part_side : overlap.part_side, least, enough).find();
}

}  // namespace tricover::detail
