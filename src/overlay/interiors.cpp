// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/interiors.h"

#include <utility>

#include "hierarchy/simd.h"
#include "overlay/edge_sides.h"
#include "pair/containment.h"
#include "pair/discs.h"
#include "pair/kernel_order.h"
#include "pair/posed_pair.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// A point of either region in the interior of the other one: the overlap of the interiors, or a piece of an edge, or a
/// ring that is a point. The overlap of the interiors, if there is one, is open and bounded: beside some piece of an
/// edge, on one side, both regions have their inside. Which edges have to be looked at? Say that the piece is a's, and
/// K what is connected with it of a's edges.
///   K meets an edge of b. Between the piece and the first place on b's edges all of K is inside of b: the last edge on
///   that way, which meets one of b, has both insides beside it there, or is bare.
///   K doesn't. Then all of it is inside of b, the starts of its rings, too.
/// An edge is bare where a has no inside on either side of it, as along a ring that goes back the way it came. That is
/// rare: then all of a's edges are looked at.
class InteriorSearch {
 public:
  InteriorSearch(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b)
      : pair_(a, pose_a, b, pose_b), sides_(PosedRegions({pair_})) {}

  bool meet() {
    const UnitMap at = pair_.inUnits();
    const auto look = [](const void* search, EdgePosition i, EdgePosition j) {
      return static_cast<InteriorSearch*>(const_cast<void*>(search))->meetBeside(i, j);
    };
    const Descent descent{pair_.a, pair_.b, hierarchyOf(pair_.a), hierarchyOf(pair_.b), at, 0};
    if (findHit(descent, {this, look, 0, -1, false}).hit) return true;
    return meetInside(EdgeSides::A, ringInside(pair_.back())) || meetInside(EdgeSides::B, ringInside(pair_));
  }

 private:
  bool meetBeside(EdgePosition i, EdgePosition j) {
    return edgesMeet(pair_, i, j) &&
           (crossAlone(pair_, i, j) || meetBeside(EdgeSides::A, i) || meetBeside(EdgeSides::B, j));
  }

  bool meetBeside(EdgeSides::Operand operand, EdgePosition edge) {
    if (sides_.ifKnown(operand, edge) != nullptr) return false;
    if (beginsPoint(operand == EdgeSides::A ? pair_.a : pair_.b, edge))
      return isInInterior(pair_, operand, edge, sides_);
    const EdgeSides& sides = sides_.of(operand, edge);
    has_bare_[operand] |= sides.hasAny(&EdgeSides::Piece::isBare);
    return sides.hasAny(&EdgeSides::Piece::bordersBoth) || sides.hasAny(&EdgeSides::Piece::isInOther);
  }

  /// `start` is the first edge of a ring that starts inside of the other region, or kNoEdge.
  bool meetInside(EdgeSides::Operand operand, EdgePosition start) {
    if (start != kNoEdge && meetBeside(operand, start)) return true;
    if (start == kNoEdge && !has_bare_[operand]) return false;
    bool has_found = false;
    forEachEdge(operand == EdgeSides::A ? pair_.a : pair_.b,
                [&](EdgePosition edge) { return !(has_found = meetBeside(operand, edge)); });
    return has_found;
  }

  const PosedPair pair_;
  KnownSides sides_;
  bool has_bare_[2] = {};
};

}  // namespace

bool isInInterior(const PosedPair& given, EdgeSides::Operand operand, EdgePosition edge, KnownSides& sides) {
  // The point is b's from here on.
  const PosedPair pair = operand == EdgeSides::A ? given.back() : given;
  const EdgeSides::Operand other = operand == EdgeSides::A ? EdgeSides::B : EdgeSides::A;
  const Vec2& point = pair.b.path[edge];
  const Location location = locateInA(pair, point);
  if (location != Location::Boundary) return location == Location::Inside;
  bool is_on_edge = false, is_inner = true;
  const IncludedPoint seen = seenFromA(pair, point);
  CoveringSum around(pair.a, seen);
  forEachEdge(pair.a, [&](EdgePosition e) {
    if (pair.a.path[e] == pair.a.path[e + 1]) return true;  // it may be that point
    if (edgesMeet(pair, e, edge)) {
      is_on_edge = true;
      is_inner = !sides.of(other, e).hasAnyAt(&EdgeSides::Piece::isNoSeam, edge);
    } else {
      around.add(e);
    }
    return is_inner;
  });
  return is_on_edge ? is_inner : around.result().location == Location::Inside;
}

bool interiorsMeet(const PolygonData& polygon_a, const Pose& pose_a, const PolygonData& polygon_b, const Pose& pose_b) {
  return inKernelOrder(
      polygon_a, pose_a, polygon_b, pose_b,
      [](const auto&... operands) {
        const PosedPair placement(operands...);
        if (gapOfDiscs(placement, 0) >= 0) return false;
        return depthOfDiscs(placement, 0) >= 0 || InteriorSearch(operands...).meet();
      },
      [](bool) {});
}

Outcome findCertificateOf(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                          double defect, const CollideOptions& options, const CertificateWish& wish) {
  if (!asksForInteriors(options)) return findCertificate(a, pose_a, b, pose_b, defect, options, wish);
  Outcome found = findCertificate(a, pose_a, b, pose_b, defect, {}, wish);
  if (!found.collides) return found;
  // What keeps regions together doesn't keep their interiors together.
  found.collides = interiorsMeet(a, pose_a, b, pose_b);
  found.clearance = 0;
  return found;
}

}  // namespace tricover::detail
