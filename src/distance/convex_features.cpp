// SPDX-License-Identifier: BSD-3-Clause
#include "distance/convex_features.h"

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"

namespace tricover::detail {
namespace {

double cross(Double2 v, Double2 w) {
  const Double2 products = v * swapped(w);
  return products[0] - products[1];
}

/// A strictly convex ring in the world.
class Outline {
 public:
  Outline(const PolygonData& polygon, const Pose& pose)
      : path_(polygon.path.data()),
        count_(static_cast<std::uint32_t>(polygon.path.size() - 1)),
        columns_{load2(pose.data()), load2(pose.data() + 3)},
        turn_(hierarchyOf(polygon).convex),
        is_forward_((cross(columns_[0], columns_[1]) > 0) == (turn_ > 0)) {}

  /// Whether positions increase that way around.
  bool isForward(bool ccw) const { return ccw == is_forward_; }
  std::uint32_t next(std::uint32_t v, bool ccw) const {
    if (isForward(ccw)) return v + 1 == count_ ? 0 : v + 1;
    return (v == 0 ? count_ : v) - 1;
  }
  Double2 way(std::uint32_t from, std::uint32_t to) const {
    const Double2 along = load2(path_[to].data()) - load2(path_[from].data());
    return columns_[0] * along[0] + columns_[1] * along[1];
  }

  /// The vertex that is farthest along n: where edges begin to lead back, which turn one way from the first one on.
  std::uint32_t foremost(Double2 n) const {
    const double x = dot(columns_[0], n), y = dot(columns_[1], n);
    const Double2 sideways{-turn_ * y, turn_ * x}, first = edge(0);
    const bool is_far = turn_ * cross(first, sideways) < 0;  // by more than half a turn
    std::uint32_t low = 0, size = count_;
    while (size > 0) {
      const std::uint32_t half = size / 2;
      const Double2 e = edge(low + half);
      const bool e_is_far = turn_ * cross(first, e) < 0;
      const bool is_past = e_is_far != is_far ? e_is_far : turn_ * cross(sideways, e) >= 0;
      low = is_past ? low : low + half + 1;
      size = is_past ? half : size - half - 1;
    }
    return low == count_ ? 0 : low;
  }

 private:
  Double2 edge(std::uint32_t e) const { return load2(path_[e + 1].data()) - load2(path_[e].data()); }

  const Vec2* path_;
  std::uint32_t count_;
  Double2 columns_[2];
  double turn_;
  bool is_forward_;
};

}  // namespace

// Let v and w be the foremost vertices along an axis n from a to b, and of b along -n. The gap n . (w - v) grows to its
// greatest value, which is the distance, while n turns towards w - v, and v and w change where n is across an edge.
// There the gap's slope is along the edge: either w - v isn't, and the greatest gap was before; or it still is with the
// edge's other end, and it comes later; or it is at that edge.
ConvexFeatures guessNearest(const PlainWays& ways) {
  const Outline a(ways.a(), ways.poseA()), b(ways.b(), ways.poseB());
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
