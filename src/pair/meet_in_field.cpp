// SPDX-License-Identifier: BSD-3-Clause
#include "pair/meet_in_field.h"

#include <algorithm>
#include <cmath>

#include "numbers/segment.h"
#include "pair/containment.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// Discs in b, in a's units, smaller by what they are off by. None before they are paid for.
class InnerPlaces {
 public:
  InnerPlaces(const PolygonData& b, const UnitMap& at) {
    const InnerDiscs* discs = innerDiscsIfPaid(b);
    if (discs == nullptr) return;
    for (; count_ < discs->count; ++count_) {
      const double x = discs->x[count_], y = discs->y[count_];
      centers_[count_] = {at.mappedX(x, y), at.mappedY(x, y)};
      radii_[count_] = discs->radius[count_] * at.scale * (1 - at.rounding) - at.error;
    }
  }

  /// Whether a segment surely meets a disc.
  bool meet(const Vec2& v, const Vec2& w) const {
    for (int k = 0; k < count_; ++k)
      if (radii_[k] > 0 && squaredDistanceToSegment(centers_[k], v, w) < radii_[k] * radii_[k] * (1 - 0x1p-40))
        return true;
    return false;
  }

 private:
  Vec2 centers_[kLanes];
  double radii_[kLanes];
  int count_ = 0;
};

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
bool meetByEdges(const InfluenceField& field, const UnitMap& at, const PlacedBox& box, const InnerPlaces& inner,
                 const EdgeTest& test) {
  const PolygonData &a = test.a, &b = test.b;
  bool is_any_near = false, meet = false;
  field.forEachEdge(box.middle, box.half(), [&](EdgePosition i) {
    const Vec2 v = a.inUnits(a.path[i]), w = a.inUnits(a.path[i + 1]);
    if (!box.mayMeet(v, w)) return true;
    is_any_near = true;
    meet = inner.meet(v, w);
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
  return meetByEdges(field, at, box, InnerPlaces(b, at), test) ? Meeting::Meet : Meeting::Apart;
}

}  // namespace tricover::detail
