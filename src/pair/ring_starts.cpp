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
  starts_.reserve(count);
  for (std::uint32_t r = 0; r < polygon.ringCount(); ++r)
    if (connected.find(r) == r) starts_.push_back({polygon.path[polygon.edgeBegin(r)], r});
  arrange(0, starts_.size(), 0);
}

void RingStarts::arrange(std::size_t begin, std::size_t end, int axis) {
  if (end - begin < 2) return;
  const auto at = [&](std::size_t i) { return starts_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end),
                   [&](const Start& p, const Start& q) { return p.at[axis] < q.at[axis]; });
  arrange(begin, middle, 1 - axis);
  arrange(middle + 1, end, 1 - axis);
}

template <typename Show>
void RingStarts::visit(std::size_t begin, std::size_t end, int axis, const Vec2& low, const Vec2& high,
                       Show show) const {
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const Start& start = starts_[middle];
    const bool below = start.at[axis]<low[axis], above = start.at[axis]> high[axis];  // false for NaN
    if (!below && !above && !(start.at[1 - axis] < low[1 - axis]) && !(start.at[1 - axis] > high[1 - axis]))
      show(start.ring);
    axis = 1 - axis;
    if (!below && !above) visit(begin, middle, axis, low, high, show);
    (above ? end : begin) = above ? middle : middle + 1;
  }
}

std::vector<std::uint32_t> RingStarts::within(const Vec2& low, const Vec2& high) const {
  std::vector<std::uint32_t> rings;
  visit(0, starts_.size(), 0, low, high, [&](std::uint32_t ring) { rings.push_back(ring); });
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
