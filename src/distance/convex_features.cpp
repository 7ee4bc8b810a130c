// SPDX-License-Identifier: BSD-3-Clause
#include "distance/convex_features.h"

#include "convex/convex_ring.h"
#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"

namespace tricover::detail {
namespace {

double cross(Double2 v, Double2 w) { return ConvexRing::cross(v, w); }

/// A convex ring in the world.
class PosedRing {
 public:
  PosedRing(const PolygonData& polygon, const Pose& pose)
      : ring_(polygon.path.data(), polygon.path.size() - 1, hierarchyOf(polygon).convex),
        columns_{load2(pose.data()), load2(pose.data() + 3)},
        is_forward_((cross(columns_[0], columns_[1]) > 0) == (ring_.turn() > 0)) {}

  /// Whether positions increase that way around.
  bool isForward(bool ccw) const { return ccw == is_forward_; }
  std::uint32_t next(std::uint32_t v, bool ccw) const { return isForward(ccw) ? ring_.next(v) : ring_.previous(v); }
  Double2 way(std::uint32_t from, std::uint32_t to) const {
    const Double2 along = ring_.way(from, to);
    return columns_[0] * along[0] + columns_[1] * along[1];
  }
  std::uint32_t foremost(Double2 n) const { return ring_.foremost(Double2{dot(columns_[0], n), dot(columns_[1], n)}); }

 private:
  ConvexRing ring_;
  Double2 columns_[2];
  bool is_forward_;
};

}  // namespace

// Let v and w be the foremost vertices along an axis n from a to b, and of b along -n. The gap n . (w - v) grows to its
// greatest value, which is the distance, while n turns towards w - v, and v and w change where n is across an edge.
// There the gap's slope is along the edge: either w - v isn't, and the greatest gap was before; or it still is with the
// edge's other end, and it comes later; or it is at that edge.
ConvexFeatures guessNearest(const PlainWays& ways) {
  const PosedRing a(ways.a(), ways.poseA()), b(ways.b(), ways.poseB());
  const Double2 n = ways.betweenOrigins();
  std::uint32_t v = a.foremost(n), w = b.foremost(-n);
  Double2 x = ways.way(v, w);
  const bool ccw = cross(n, x) > 0;
  std::uint32_t next_v = a.next(v, ccw), next_w = b.next(w, ccw);
  Double2 of_a = a.way(v, next_v), of_b = b.way(next_w, w);
  for (std::size_t steps = ways.a().path.size() + ways.b().path.size(); steps > 0; --steps) {
    const double turn = cross(of_a, of_b);
    const bool is_a = ccw ? turn > 0 : turn < 0;
    const Double2 edge = is_a ? of_a : of_b;
    const bool is_beyond = ccw ? cross(edge, x) < 0 : cross(edge, x) > 0;
    if (!(dot(edge, x) > 0))
      return {is_beyond || dot(n, x) > 0 ? ConvexFeatures::kVertices : ConvexFeatures::kNone, v, w};
    x -= edge;
    const bool is_before = dot(edge, x) > 0;
    if (!is_before && !is_beyond) return {};
    if (!is_before && is_a) return {ConvexFeatures::kEdgeOfA, a.isForward(ccw) ? v : next_v, w};
    if (!is_before) return {ConvexFeatures::kEdgeOfB, v, b.isForward(ccw) ? w : next_w};
    if (is_a) {
      v = next_v;
      next_v = a.next(v, ccw);
      of_a = a.way(v, next_v);
    } else {
      w = next_w;
      next_w = b.next(w, ccw);
      of_b = b.way(next_w, w);
    }
  }
  return {};
}

}  // namespace tricover::detail
