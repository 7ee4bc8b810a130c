// SPDX-License-Identifier: BSD-3-Clause
#include "pair/edge_sides.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "polygon/covering.h"

namespace tricover::detail {

namespace {

/// On which side of the first edge's line an end of the other one is: 0 at once for an end that both have.
int sideOf(const FourEnds& ends, int end) {
  const Vec2 *edge = ends.first.ends, &p = ends.second.ends[end - 2];
  if (ends.first.pose == ends.second.pose && (p == edge[0] || p == edge[1])) return 0;
  return ends.sign(0, 1, end);
}

}  // namespace

FourEnds EdgeSides::endsWith(Operand operand, std::size_t edge) const {
  return {{approx(operand_, edge_), approx(operand_, edge_ + 1), approx(operand, edge), approx(operand, edge + 1)},
          segment(operand_, edge_),
          segment(operand, edge)};
}

EdgeSides::EdgeSides(const PosedPair& pair, const PosedPair& back, Operand operand, std::size_t edge)
    : pair_(pair), operand_(operand), edge_(edge) {
  const Path& path = polygon(operand).path;
  if (path[edge] == path[edge + 1]) return;
  findCuts(A, pair);
  findCuts(B, back);
  std::sort(cuts_.begin(), cuts_.end(), [&](const Cut& p, const Cut& q) { return isBefore(p, q); });
  look(kNone, cuts_.empty() ? kNone : 0);
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    windings_[cuts_[i].operand].add(cuts_[i]);
    // Between cuts at one place there is nothing.
    const bool is_last = i + 1 == cuts_.size();
    if (is_last || isBefore(cuts_[i], cuts_[i + 1])) look(i, is_last ? kNone : i + 1);
  }
}

/// Of one polygon, `seen` from its frame: those of its edges that may meet the ray from w through v.
///
/// Error, in units, with e what w and v err by in any direction, l their distance and |w| the norm of w: nothing of the
/// polygon is farther from w than |w| + 1, where the ray's direction, wrong by 2 e / l and a few roundings, is off by
/// 2 e (|w| + 1) / l. Twice that is taken.
void EdgeSides::findCuts(Operand operand, const PosedPair& seen) {
  const PolygonData& of = polygon(operand);
  const auto place = [&](std::size_t position) {
    const Vec2& p = polygon(operand_).path[position];
    return operand == operand_ ? ApproxPoint{p.x(), p.y(), 0} : seenFromA(seen, p).approx;
  };
  const ApproxPoint v = place(edge_), w = place(edge_ + 1);
  const Vec2 from = of.inUnits({w.x, w.y}), way = of.inUnits({v.x, v.y}) - from;
  const double length = way.norm(), far = from.lpNorm<1>() + 4;
  const double error = 1.5 * std::max(v.error, w.error) * of.inverse_unit + 0x1p-48 * (far + length);
  const double error_of_ray = error * (2 + 4 * far / length);
  if (of.fitsUnit() && error_of_ray < 0x1p-4 && length < 0x1p1000) {
    const Ray ray{from.x(), from.y(), way.x() / length, way.y() / length, error_of_ray};
    struct To {
      EdgeSides& sides;
      Operand operand;
    } to{*this, operand};
    const auto visit = [](void* context, std::uint32_t edge) {
      const To& found = *static_cast<const To*>(context);
      return found.sides.add(found.operand, edge), true;
    };
    visitEdgesOnRay(hierarchyOf(of), ray, visit, &to);
    return;
  }
  for (std::size_t ring = 0; ring < of.ringCount(); ++ring)
    for (std::size_t edge = of.edgeBegin(ring); edge < of.edgeEnd(ring); ++edge) add(operand, edge);
}

/// With u from v to w, d along the other edge from q to r, and D = |u d|, that edge's line meets this one's at
///   s     = |q r v| / D,
///   s - 1 = |q r w| / D,
/// and D has the sign of what r is to the left of q by. The way goes from the left of d to its right where D > 0.
void EdgeSides::add(Operand operand, std::size_t edge) {
  const FourEnds ends = endsWith(operand, edge);
  const int q = sideOf(ends, 2), r = sideOf(ends, 3);
  if (q == r || q * r > 0) return;
  const int slant = r > q ? 1 : -1;
  if (ends.sign(2, 3, 1) * slant >= 0) return;
  Cut cut{ends.second, operand, static_cast<std::int8_t>(-slant), q > 0 || r > 0, q < 0 || r < 0, 0, 1};
  if (ends.sign(2, 3, 0) * slant <= 0) return windings_[operand].add(cut);
  // Of x / (x + y), with x and y wrong by their bounds, at most the sum of both divided by x + y, but for the latter's
  // error: twice.
  const ApproxPoint* e = ends.approx;
  const ApproxArea of_v = approxArea(e[2], e[3], e[0]), of_w = approxArea(e[2], e[3], e[1]);
  const double whole = std::abs(of_v.area - of_w.area), bound = of_v.bound + of_w.bound;
  if (whole > 4 * bound && whole < 0x1p1000) {
    const double place = std::abs(of_v.area) / whole, error = 2 * bound / whole + 4 * kUnitRoundoff;
    cut.low = place - error;
    cut.high = place + error;
  }
  cuts_.push_back(cut);
}

bool EdgeSides::isBefore(const Cut& p, const Cut& q) const {
  if (p.high < q.low) return true;
  if (q.high < p.low) return false;
  return compareFractionsExact(segment(operand_, edge_), p.edge, q.edge) < 0;
}

/// At the current piece.
void EdgeSides::look(std::size_t begin, std::size_t end) {
  bool left[2], right[2];
  for (const Operand operand : {A, B}) {
    left[operand] = isInside(polygon(operand).fill, windings_[operand].left);
    right[operand] = isInside(polygon(operand).fill, windings_[operand].right);
  }
  const Operand other = operand_ == A ? B : A;
  if ((left[A] && left[B]) || (right[A] && right[B])) bordering_.push_back({begin, end});
  if (left[operand_] || right[operand_]) return;
  is_bare_ = true;
  is_bare_inside_ |= left[other] && right[other];
}

/// Whether what the other edge has in common with this one is, as a whole, on one side of a cut: 1 after it, -1 before.
/// Of an edge along the line each end is on it, at t: with c the cut's edge, the cut is at t + |c t| / D.
bool EdgeSides::isBeyond(const FourEnds& ends, const Cut& cut, int side) const {
  if (sideOf(ends, 2) != 0 || sideOf(ends, 3) != 0) {
    const Cut at{ends.second, A, 0, false, false, 0, 1};  // as isBefore() sees it
    return side > 0 ? isBefore(cut, at) : isBefore(at, cut);
  }
  const auto isEndBeyond = [&](int end) {
    const int sign = orientExact(cut.edge[0], cut.edge[1], ends.exact(end));
    return sign * -cut.turn * side < 0;
  };
  return isEndBeyond(2) && isEndBeyond(3);
}

bool EdgeSides::bordersBothUntil(const std::vector<std::size_t>& edges, int side) const {
  return std::any_of(bordering_.begin(), bordering_.end(), [&](const Piece& piece) {
    const std::size_t cut = side > 0 ? piece.begin : piece.end;
    return cut == kNone || std::none_of(edges.begin(), edges.end(), [&](std::size_t edge) {
             return isBeyond(endsWith(operand_ == A ? B : A, edge), cuts_[cut], -side);
           });
  });
}

bool EdgeSides::bordersBothAt(std::size_t edge) const {
  const FourEnds ends = endsWith(operand_ == A ? B : A, edge);
  return std::any_of(bordering_.begin(), bordering_.end(), [&](const Piece& piece) {
    return !(piece.begin != kNone && isBeyond(ends, cuts_[piece.begin], -1)) &&
           !(piece.end != kNone && isBeyond(ends, cuts_[piece.end], 1));
  });
}

}  // namespace tricover::detail
