// SPDX-License-Identifier: BSD-3-Clause
#include "impact/tight_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// Along an axis, projections of what is within 2 units are wrong by a few U units, and so are the axis and the middle.
constexpr double kRoom = 0x1p-47;

/// How far a box is from a point at either end of a window, at the least and at the most.
struct Distances {
  Double2 low, high;
};

Double2 roots(Double2 squares) { return Double2{std::sqrt(squares[0]), std::sqrt(squares[1])}; }

Distances distancesFrom(Double2 x, Double2 y, const MovingBox& box) {
  const Double2 dx = box.x - x, dy = box.y - y, zero{};
  const Double2 uv = absolute(box.ux * box.vx + box.uy * box.vy);
  const Double2 uu = box.ux * box.ux + box.uy * box.uy, vv = box.vx * box.vx + box.vy * box.vy;
  const Double2 along = (absolute(box.ux * dx + box.uy * dy) - (uu * box.along + uv * box.across)) / roots(uu);
  const Double2 across = (absolute(box.vx * dx + box.vy * dy) - (uv * box.along + vv * box.across)) / roots(vv);
  Double2 farthest = zero;
  for (const double s : {-box.along, box.along})
    for (const double t : {-box.across, box.across}) {
      const Double2 cx = dx + box.ux * s + box.vx * t, cy = dy + box.uy * s + box.vy * t;
      const Double2 square = cx * cx + cy * cy;
      farthest = farthest > square ? farthest : square;
    }
  const Double2 low = along > across ? along : across;
  return {low > zero ? low : zero, roots(farthest)};
}

/// Between the ends a distance that changes at no more than `rate` leaves both ends' mean by at most half of what it
/// can change by. MovingPair::error is for points of two movers: here those of one are compared with a pivot, and what
/// is left of it is more than the levers' rounding.
bool parted(const Window& window, const Mover& turning, const Node& node, const Places& places, const MovingBox& other,
            double rate) {
  const Distances d = distancesFrom(places.pivot_x, places.pivot_y, other);
  const double change = rate * window.length * (1 + 0x1p-10), room = window.pair.margin + window.pair.error;
  const double low = 0.5 * (d.low[0] + d.low[1] - change), high = 0.5 * (d.high[0] + d.high[1] + change);
  return low - room > node.far * turning.scale || high + room < node.near * turning.scale;
}

void addEdgesBelow(const std::vector<Block>& blocks, std::uint32_t index, std::vector<std::uint32_t>& edges) {
  const Block& block = blocks[index];
  if (block.leaf) edges.insert(edges.end(), block.child, block.child + block.count);
  for (int i = 0; i < block.count && !block.leaf; ++i) addEdgesBelow(blocks, block.child[i], edges);
}

}  // namespace

std::vector<std::uint32_t> edgesBelow(const Mover& mover, const Node& node) {
  std::vector<std::uint32_t> edges;
  if (node.edge)
    edges.push_back(node.child);
  else
    addEdgesBelow(mover.tree->blocks, node.child, edges);
  return edges;
}

Node TightNodes::fit(std::uint32_t index) const {
  const Node node = mover_.node(index);
  if (!mover_.polygon->fitsUnit()) return node;
  const std::vector<std::uint32_t> edges = edgesBelow(mover_, node);
  const Vec2 chord = at(edges.back() + 1) - at(edges.front());
  const double length = chord.norm();
  if (length > 0x1p-40) {
    const Node fitted = fitAlong(node, edges, chord / length);
    if (fitted.along * fitted.across <= node.along * node.across) return fitted;
  }
  return fitAlong(node, edges, Vec2(node.ux, node.uy).normalized());
}

Node TightNodes::fitAlong(Node node, const std::vector<std::uint32_t>& edges, const Vec2& axis) const {
  const Vec2 pivot = mover_.polygon->inUnits(mover_.pivot);
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  double near = low.x(), far = 0;
  for (const std::uint32_t edge : edges) {
    const Vec2 begin = at(edge), end = at(edge + 1);
    for (const Vec2& p : {begin, end}) {
      const Vec2 q(p.dot(axis), cross(axis, p));
      low = low.cwiseMin(q);
      high = high.cwiseMax(q);
    }
    const Vec2 lever_begin = mover_.linear * (begin - pivot), lever_end = mover_.linear * (end - pivot);
    far = std::max({far, lever_begin.norm(), lever_end.norm()});
    near = std::min(near, nearestOnSegment(Vec2(0, 0), lever_begin, lever_end).norm());
  }
  // Of a pivot so far away, squares might overflow.
  if (pivot.norm() < 0x1p100) {
    node.near = near;
    node.far = far;
  }
  const Vec2 middle = 0.5 * (low + high);
  node.x = middle.x() * axis.x() - middle.y() * axis.y();
  node.y = middle.x() * axis.y() + middle.y() * axis.x();
  node.ux = axis.x();
  node.uy = axis.y();
  node.along = 0.5 * (high.x() - low.x()) + kRoom;
  node.across = 0.5 * (high.y() - low.y()) + kRoom;
  return node;
}

bool partedByPivots(const Window& window, const Node& node_a, const MovingBox& a, const Node& node_b,
                    const MovingBox& b) {
  const Rates& rates = window.rates;
  return parted(window, window.pair.b, node_b, window.b, a, rates.speed + rates.a * leverAtBegin(a, window.a)) ||
         parted(window, window.pair.a, node_a, window.a, b, rates.speed + rates.b * leverAtBegin(b, window.b));
}

}  // namespace tricover::detail
