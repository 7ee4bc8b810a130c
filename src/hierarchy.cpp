// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "polygon_data.h"
#include "predicates.h"

namespace tricover::detail {

struct Hierarchy::Builder {
  explicit Builder(const PolygonData& polygon_, std::vector<Node>& nodes_)
      : polygon(polygon_),
        nodes(nodes_),
        slack(polygon.extent < 0x1p1000 ? 32 * kUlp * polygon.extent + kTiny
                                        : std::numeric_limits<double>::infinity()) {}

  /// Rings order[begin, end): halved along the longer side of their first vertices' bounding box.
  std::uint32_t addRings(std::vector<std::uint32_t>& order, std::size_t begin, std::size_t end) {
    if (end - begin == 1) return addChain(polygon.edgeBegin(order[begin]), polygon.edgeEnd(order[begin]));
    Vec2 low = firstVertex(order[begin]), high = low;
    for (std::size_t i = begin; i < end; ++i) {
      low = low.cwiseMin(firstVertex(order[i]));
      high = high.cwiseMax(firstVertex(order[i]));
    }
    const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
    const std::size_t mid = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(mid), at(end),
                     [&](std::uint32_t r, std::uint32_t s) { return firstVertex(r)[axis] < firstVertex(s)[axis]; });
    Node box = emptyBox(firstVertex(order[begin]), Vec2(1, 0));
    Bounds bounds;
    for (std::size_t i = begin; i < end; ++i)
      bounds.add(box, polygon.path, polygon.edgeBegin(order[i]), polygon.edgeEnd(order[i]) + 1);
    const std::uint32_t index = addBox(box, bounds);
    addRings(order, begin, mid);
    const std::uint32_t right = addRings(order, mid, end);
    nodes[index].right = right;
    return index;
  }

  /// Edges [begin, end) of one ring.
  std::uint32_t addChain(std::size_t begin, std::size_t end) {
    const Vec2 &first = polygon.path[begin], &last = polygon.path[end];
    Node box = emptyBox(first, last - first);
    Bounds bounds;
    bounds.add(box, polygon.path, begin, end + 1);
    const std::uint32_t index = addBox(box, bounds);
    nodes[index].spanned = true;
    if (end - begin == 1) {
      nodes[index].edge = static_cast<std::uint32_t>(begin);
      return index;
    }
    const std::size_t mid = (begin + end) / 2;
    addChain(begin, mid);
    const std::uint32_t right = addChain(mid, end);
    nodes[index].right = right;
    return index;
  }

 private:
  /// Extents of points in a box's own axes, from its centre.
  struct Bounds {
    void add(const Node& box, const std::vector<Vec2>& path, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double dx = path[i].x() - box.x, dy = path[i].y() - box.y;
        const double u = dx * box.ux + dy * box.uy, v = dy * box.ux - dx * box.uy;
        low_u = std::min(low_u, u);
        high_u = std::max(high_u, u);
        low_v = std::min(low_v, v);
        high_v = std::max(high_v, v);
      }
    }
    double low_u = 0, high_u = 0, low_v = 0, high_v = 0;
  };

  const Vec2& firstVertex(std::uint32_t ring) const { return polygon.path[polygon.edgeBegin(ring)]; }

  static Node emptyBox(const Vec2& at, const Vec2& direction) {
    const double length = std::hypot(direction.x(), direction.y());
    const bool usable = length > 0x1p-1000 && length < 0x1p1000;
    const double ux = usable ? direction.x() / length : 1, uy = usable ? direction.y() / length : 0;
    return {at.x(), at.y(), ux, uy, 0, 0, 0, 0, false};
  }

  /// Moves the box's centre to the middle of the bounds. Rounding, of the projections and of the centre, is below
  /// `slack`.
  std::uint32_t addBox(Node box, const Bounds& bounds) {
    const double u = 0.5 * (bounds.low_u + bounds.high_u), v = 0.5 * (bounds.low_v + bounds.high_v);
    box.x += u * box.ux - v * box.uy;
    box.y += u * box.uy + v * box.ux;
    box.along = 0.5 * (bounds.high_u - bounds.low_u) + slack;
    box.across = 0.5 * (bounds.high_v - bounds.low_v) + slack;
    nodes.push_back(box);
    return static_cast<std::uint32_t>(nodes.size() - 1);
  }

  const PolygonData& polygon;
  std::vector<Node>& nodes;
  double slack;
};

Hierarchy::Hierarchy(const PolygonData& polygon) {
  if (polygon.path.size() >= std::numeric_limits<std::uint32_t>::max() / 2)
    throw std::length_error("rings: more than 2^31 vertices");
  nodes_.reserve(2 * (polygon.path.size() - polygon.ringCount()));
  std::vector<std::uint32_t> order(polygon.ringCount());
  std::iota(order.begin(), order.end(), 0u);
  Builder(polygon, nodes_).addRings(order, 0, order.size());
}

}  // namespace tricover::detail
