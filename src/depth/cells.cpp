// SPDX-License-Identifier: BSD-3-Clause
#include "depth/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "depth/directions.h"
#include "overlay/rings.h"

namespace tricover::detail {
namespace {

/// Near a cell: with more of them the cell is cut.
constexpr std::size_t kMostEdges = 48;

}  // namespace

bool Cells::isOutsideOfArea(const Vec2& p) const {
  if (overlap_.excludes) return overlap_.excludes(overlap_.frame.toWorld(p));
  return area_.locate(p) == (overlap_.is_outside ? Location::Inside : Location::Outside);
}

bool Cells::mayHoldMaximum(const Piece& cell) { return !gatherNearest(cell) || !leadsAway(); }

const std::vector<Piece>& Cells::divide(const Piece& cell, bool is_large) {
  parts_.clear();
  std::optional<Ends> edge;
  if (gatherNearest(cell)) {
    if (leadsAway()) return parts_;
    if (!is_large) {
      const Vec2 center = centerOf(cell);
      edge = edgeAcross(cell, area_, nearest_);
      // A cell that no edge leads through is in the area as a whole or not at all; and so with the part.
      if (!edge && ((isFarFrom(area_, center) && !isOutsideOfArea(center)) || leadsAwayFrom(cell))) return parts_;
      if (!edge && gather(part_, cell, 0, part_edges_)) {
        edge = edgeAcross(cell, part_, part_edges_);
        if (!edge && isFarFrom(part_, center) && part_.locate(center) == Location::Outside) return parts_;
      }
    }
  }
  cut(cell, edge);
  return parts_;
}

/// Finds the area's edges that may be the nearest ones somewhere in a cell. False if there are too many.
bool Cells::gatherNearest(const Piece& cell) { return gather(area_, cell, -cell.least, nearest_); }

/// Finds edges within reach of a cell.
bool Cells::gather(const PosedSide& side, const Piece& cell, double reach, std::vector<EdgePosition>& edges) const {
  const std::size_t longest = longestSideOf(cell);
  const Vec2 center = centerOf(cell);
  const double farthest = reach + reachOf(cell, center);
  edges.clear();
  side.forEachNear(cell.corner[longest], cell.corner[(longest + 1) % 3], reach + heightOf(cell),
                   [&](EdgePosition edge) {
                     if (side.distance(edge, center) <= farthest) edges.push_back(edge);
                     return edges.size() < kMostEdges;
                   });
  return edges.size() < kMostEdges;
}

/// Whether some direction leads away from all of the nearest edges, which are borders with a known side, wherever
/// outside of the area one of them is the nearest: beside an edge along its normal, at a vertex between two of these.
bool Cells::leadsAway() const {
  const std::vector<std::int8_t>& sides = regionSidesOf(area_.polygon).rings;
  OneSidedDirections normals;
  for (const EdgePosition edge : nearest_) {
    const int side = sides[area_.polygon.ringOf(edge)] * (overlap_.is_outside ? 1 : -1) * (area_.isMirrored() ? -1 : 1);
    const Vec2 along = area_.vertex(edge + 1) - area_.vertex(edge);
    if (side == 0) return false;
    if (!along.isZero(0)) normals.add(side * Vec2(-along.y(), along.x()));
    if (!normals.areOneSided()) return false;
  }
  return true;
}

/// The same by the directions from the nearest points of edges, none of which leads through the cell.
bool Cells::leadsAwayFrom(const Piece& cell) const {
  OneSidedDirections directions;
  for (const EdgePosition edge : nearest_) {
    bool is_known = false;
    for (const Vec2& corner : cell.corner) {
      const Vec2 way = corner - area_.foot(edge, corner);
      if (way.norm() > 64 * rounding_) directions.add(way), is_known = true;
    }
    if (!is_known || !directions.areOneSided()) return false;
  }
  return true;
}

/// An edge that leads through a cell's interior, if there is one: that whose line is nearest to the centre.
std::optional<Ends> Cells::edgeAcross(const Piece& cell, const PosedSide& side,
                                      const std::vector<EdgePosition>& edges) const {
  const Vec2 center = centerOf(cell);
  std::optional<Ends> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const EdgePosition edge : edges) {
    const Ends ends{side.vertex(edge), side.vertex(edge + 1)};
    const double length = (ends.w - ends.v).norm();
    if (!leadsThrough(cell, ends, length)) continue;
    const double beside = std::abs(cross(ends.w - ends.v, center - ends.v)) / length;
    if (beside < nearest) nearest = beside, best = ends;
  }
  return best;
}

/// Clips the edge by the triangle, made smaller by rounding.
bool Cells::leadsThrough(const Piece& cell, const Ends& ends, double length) const {
  if (length == 0) return false;
  const double turn = cross(cell.corner[1] - cell.corner[0], cell.corner[2] - cell.corner[0]) > 0 ? 1 : -1;
  double from = 0, to = 1;
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec2 &v = cell.corner[c], side = (cell.corner[(c + 1) % 3] - v) * turn;
    const double room = 16 * rounding_ * side.norm();
    const double at_v = cross(side, ends.v - v) - room, at_w = cross(side, ends.w - v) - room;
    if (at_v < 0 && at_w < 0) return false;
    if (at_v < 0) from = std::max(from, at_v / (at_v - at_w));
    if (at_w < 0) to = std::min(to, at_v / (at_v - at_w));
  }
  return from < to;
}

/// Cuts along an edge's line, or else from the middle of the longest side to the corner opposite.
void Cells::cut(const Piece& cell, const std::optional<Ends>& edge) {
  const std::size_t longest = longestSideOf(cell), opposite = (longest + 2) % 3;
  const Vec2 &p = cell.corner[longest], &q = cell.corner[(longest + 1) % 3], middle = 0.5 * p + 0.5 * q;
  if (!((q - p).norm() > 4 * rounding_)) return;
  const Ends line = edge ? *edge : Ends{middle, cell.corner[opposite]};
  const Vec2 along = line.w - line.v;
  OfCorners beside;
  for (std::size_t c = 0; c < 3; ++c) {
    beside[c] = cross(along, cell.corner[c] - line.v);
    if (edge ? std::abs(beside[c]) <= 2 * rounding_ * along.norm() : c == opposite) beside[c] = 0;
  }
  for (const double side : {1.0, -1.0}) addHalf(cell, beside, side);
}

/// What is on one side of a line, as a fan.
void Cells::addHalf(const Piece& cell, const OfCorners& beside, double side) {
  std::array<Vec2, 4> kept;
  std::size_t count = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3;
    const double at_c = side * beside[c], at_d = side * beside[d];
    if (at_c >= 0) kept[count++] = cell.corner[c];
    if ((at_c < 0 && at_d > 0) || (at_c > 0 && at_d < 0))
      kept[count++] = cell.corner[c] + at_c / (at_c - at_d) * (cell.corner[d] - cell.corner[c]);
  }
  for (std::size_t i = 2; i < count; ++i) {
    Piece half = cell;
    half.corner = {kept[0], kept[i - 1], kept[i]};
    if (heightOf(half) > 0.25 * rounding_) parts_.push_back(half);  // but for rounding the neighbours hold it
  }
}

}  // namespace tricover::detail
