// SPDX-License-Identifier: BSD-3-Clause
#include "pair/ring_starts.h"

#include <algorithm>
#include <memory>

#include "numbers/union_find.h"
#include "pair/edge_pairs.h"
#include "pair/posed_pair.h"

namespace tricover::detail {
RingStarts::RingStarts(const PolygonData& polygon) {
  std::vector<std::uint32_t> ring_of(polygon.path.size());
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) ring_of[e] = static_cast<std::uint32_t>(r);
  UnionFind connected(polygon.ringCount());
  std::size_t count = polygon.ringCount();
  // Of a mesh's edges each meets some thirty others. Where there are more, what has been found will do.
  constexpr std::size_t kPairsPerEdge = 64;
  std::size_t pairs_left = kPairsPerEdge * polygon.path.size();
  const Pose still = Pose::Identity();
  const PosedPair itself(polygon, still, polygon, still);
  forEachPair(itself, 0, [&](double, std::size_t i, std::size_t j) {
    const std::size_t r = connected.find(ring_of[i]), s = connected.find(ring_of[j]);
    if (r != s && edgesMeet(itself, i, j)) {
      connected.join(r, s);
      --count;
    }
    return --pairs_left == 0 || count == 1 ? -1 : 0;
  });
  by_x_.reserve(count);
  for (std::uint32_t r = 0; r < polygon.ringCount(); ++r)
    if (connected.find(r) == r) by_x_.push_back({polygon.path[polygon.edgeBegin(r)].x(), r});
  std::sort(by_x_.begin(), by_x_.end(), [](const Start& p, const Start& q) { return p.x < q.x; });
}

std::vector<std::uint32_t> RingStarts::between(double low, double high) const {
  const auto begin = std::partition_point(by_x_.begin(), by_x_.end(), [&](const Start& s) { return s.x < low; });
  const auto end = std::partition_point(begin, by_x_.end(), [&](const Start& s) { return !(s.x > high); });
  std::vector<std::uint32_t> rings;
  for (auto it = begin; it != end; ++it) rings.push_back(it->ring);
  std::sort(rings.begin(), rings.end());
  return rings;
}

namespace {

bool hasFewRings(const PolygonData& polygon) { return polygon.ringCount() <= 4; }

}  // namespace

void buildRingStarts(const PolygonData& polygon) {
  if (!hasFewRings(polygon)) polygon.starts.built([&] { return std::make_unique<const RingStarts>(polygon); });
}

const RingStarts* ringStarts(const PolygonData& polygon) {
  // In the cost of looking at a ring: an edge's part in finding the starts.
  constexpr std::size_t kPerEdge = 32;
  if (hasFewRings(polygon)) return nullptr;
  if (const Derived::Thing* ready = polygon.starts.ifBuilt()) return static_cast<const RingStarts*>(ready);
  if (polygon.starts_rent.left(kPerEdge * polygon.path.size()) > 0) return nullptr;
  buildRingStarts(polygon);
  return static_cast<const RingStarts*>(polygon.starts.ifBuilt());
}

void countRings(const PolygonData& polygon, std::size_t rings, std::size_t located) {
  constexpr std::size_t kPerLocation = 1000;
  if (hasFewRings(polygon) || hierarchyIfBuilt(polygon) == nullptr) return;
  polygon.starts_rent.pay(rings + kPerLocation * located);
}

}  // namespace tricover::detail
