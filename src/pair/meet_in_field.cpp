// SPDX-License-Identifier: BSD-3-Clause
#include "pair/meet_in_field.h"

#include <algorithm>
#include <cmath>

#include "numbers/segment.h"
#include "pair/containment.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// Whether a segment of a's surely meets a disc in b, smaller by what it is off by.
bool meetsDisc(const InnerDiscs& discs, const UnitMap& at, const Vec2& v, const Vec2& w) {
  for (int k = 0; k < discs.count; ++k) {
    const double x = discs.x[k], y = discs.y[k];
    const double radius = discs.radius[k] * at.scale * (1 - at.rounding) - at.error;
    const Vec2 center(at.mappedX(x, y), at.mappedY(x, y));
    if (radius > 0 && squaredDistanceToSegment(center, v, w) < radius * radius * (1 - 0x1p-40)) return true;
  }
  return false;
}

/// A box in a's units, widened by what decides and by all errors.
struct PlacedBox {
  PlacedBox(const Box& box, const UnitMap& at, double limit)
      : middle(at.mappedX(box.x, box.y), at.mappedY(box.x, box.y)),
        axis(at.turnedX(box.ux, box.uy), at.turnedY(box.ux, box.uy)) {
    const double more = limit + at.rounding * 8 + at.error;
    along = box.along * at.scale + more, across = box.across * at.scale + more;
  }
  Vec2 half() const {
    const double x = std::abs(axis.x()), y = std::abs(axis.y());
    return {along * x + across * y, along * y + across * x};
  }
  /// False if a segment surely doesn't come near: by the box's two axes, and by the segment's normal.
  bool mayMeet(const Vec2& v, const Vec2& w) const {
    const double v_along = axis.dot(v - middle), w_along = axis.dot(w - middle);
    const double v_across = cross(axis, v - middle), w_across = cross(axis, w - middle);
    const double u_along = w_along - v_along, u_across = w_across - v_across;
    return std::min(v_along, w_along) <= along && std::max(v_along, w_along) >= -along &&
           std::min(v_across, w_across) <= across && std::max(v_across, w_across) >= -across &&
           std::abs(u_along * v_across - u_across * v_along) <=
               along * std::abs(u_across) + across * std::abs(u_along) + kTiny;
  }

  Vec2 middle, axis;
  double along, across;
};

/// By the edges of a that are in cells near b, whose edges are few.
bool meetByEdges(const InfluenceField& field, const UnitMap& at, const PlacedBox& box, const EdgeTest& test) {
  const PolygonData &a = test.a, &b = test.b;
  const InnerDiscs* discs = innerDiscsIfPaid(b);
  bool is_any_near = false, meet = false;
  field.forEachEdge(box.middle, box.half(), [&](EdgePosition i) {
    const Vec2 v = a.inUnits(a.path[i]), w = a.inUnits(a.path[i + 1]);
    if (!box.mayMeet(v, w)) return true;
    is_any_near = true;
    meet = discs != nullptr && meetsDisc(*discs, at, v, w);
    if (!meet) forEachEdge(b, [&](EdgePosition j) { return !(meet = test(i, j)); });
    return !meet;
  });
  if (meet) return true;
  // Without an edge in the box all of it is on one side.
  const InfluenceField::Look look = field.at(box.middle.x(), box.middle.y());
  return is_any_near || !(look.free > at.error) ? findContainment(test.pair).collides : look.inside;
}

}  // namespace

Meeting meetInField(const InfluenceField& field, const UnitMap& at, double limit, const EdgeTest& test) {
  constexpr std::size_t kFewEdges = 16;
  constexpr double kMostRows = 48;
  const PolygonData& b = test.b;
  if (b.isDegenerate() || b.fill.is_complement || b.path.size() > kFewEdges) return Meeting::Unknown;
  const PlacedBox box(topOf(b).region, at, limit);
  if (!(field.rowsOf(box.half().y()) < kMostRows)) return Meeting::Unknown;
  return meetByEdges(field, at, box, test) ? Meeting::Meet : Meeting::Apart;
}

}  // namespace tricover::detail
