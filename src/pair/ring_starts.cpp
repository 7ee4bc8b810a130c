// SPDX-License-Identifier: BSD-3-Clause
#include "pair/ring_starts.h"

#include <algorithm>

#include "numbers/union_find.h"
#include "pair/edge_pairs.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

RingStarts::RingStarts(const PolygonData& polygon) : polygon_(polygon) {
  const Hierarchy& hierarchy = hierarchyOf(polygon);
  std::vector<std::uint32_t> ring_of(polygon.path.size());
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (EdgePosition e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) ring_of[e] = static_cast<std::uint32_t>(r);
  UnionFind connected(polygon.ringCount());
  std::size_t count = polygon.ringCount();
  // In a mesh, each edge meets some thirty others. Where there are more, the connections found so far will do.
  constexpr std::size_t kPairsPerEdge = 64;
  std::size_t pairs_left = kPairsPerEdge * polygon.path.size();
  const Pose still = Pose::Identity();
  const PosedPair itself(polygon, still, polygon, still);
  forEachPair(itself, 0, [&](double, EdgePosition i, EdgePosition j) {
    const std::size_t r = connected.find(ring_of[i]), s = connected.find(ring_of[j]);
    if (r != s && edgesMeet(itself, i, j)) {
      connected.join(r, s);
      --count;
    }
    return --pairs_left == 0 || count == 1 ? -1 : 0;
  });
  const auto isStart = [&](EdgePosition edge) {
    const std::size_t ring = ring_of[edge];
    return edge == polygon.edgeBegin(ring) && connected.find(ring) == ring;
  };
  marked_.resize(hierarchy.blocks.size());
  for (std::size_t k = marked_.size(); k-- > 0;) {  // children stand behind their parents
    const Block& block = hierarchy.blocks[k];
    for (unsigned i = 0; i < block.count; ++i)
      if (block.leaf ? isStart(block.child[i]) : marked_[block.child[i]] != 0)
        marked_[k] = static_cast<std::uint8_t>(marked_[k] | 1u << i);
  }
}

std::vector<std::uint32_t> RingStarts::near(const Vec2& point, double radius) const {
  std::vector<std::uint32_t> edges;
  const Vec2 at = polygon_.inUnits(point);
  // Three roundings, of the point and of a start. The boxes of the largest of polygons tell nothing.
  const double error = polygon_.fitsUnit() ? 0x1p-50 * (at.lpNorm<1>() + 1) : std::numeric_limits<double>::infinity();
  visitMarkedNear(
      hierarchyOf(polygon_), {at.x(), at.y(), error}, radius * polygon_.inverse_unit, marked_.data(),
      [](void* to, EdgePosition edge) { static_cast<std::vector<std::uint32_t>*>(to)->push_back(edge); }, &edges);
  std::sort(edges.begin(), edges.end());
  return edges;
}

namespace {

bool hasFewRings(const PolygonData& polygon) { return polygon.ringCount() <= 4; }

}  // namespace

void buildRingStarts(const PolygonData& polygon) {
  if (!hasFewRings(polygon)) polygon.starts.made<RingStarts>(polygon);
}

const RingStarts* ringStarts(const PolygonData& polygon) {
  // An edge's share in the price of the starts, in the cost of looking at a ring.
  constexpr std::size_t kPerEdge = 32;
  if (hasFewRings(polygon)) return nullptr;
  if (const Derived::Thing* ready = polygon.starts.ifBuilt()) return static_cast<const RingStarts*>(ready);
  if (polygon.starts_rental.left(kPerEdge * polygon.path.size()) > 0) return nullptr;
  buildRingStarts(polygon);
  return static_cast<const RingStarts*>(polygon.starts.ifBuilt());
}

void countRings(const PolygonData& polygon, std::size_t rings, std::size_t located) {
  constexpr std::size_t kPerLocation = 1000;
  if (hasFewRings(polygon) || hierarchyIfBuilt(polygon) == nullptr) return;
  polygon.starts_rental.add(rings + kPerLocation * located);
}

}  // namespace tricover::detail
