// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/hierarchy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "numbers/float4.h"
#include "numbers/power_of_two.h"
#include "numbers/rounding.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

/// Blocks aren't scaled below twice this, in units.
constexpr double kSmallestSize = 0x1p-27;

/// What a float box is grown by, in its block's scale, to hold its chain, all of which is within 1 there:
///   the centre's coordinates are rounded by 2^-25 each, so that in no direction it moves by more than
constexpr double kOfCenter = 0x1p-24;
///   nor does the axis, of length 1, and with it nothing that is within 1 of the centre;
constexpr double kOfAxis = 0x1p-24;
///   an extent, grown beyond 1 perhaps, is rounded by
constexpr double kOfExtent = 0x1p-24;
///   the doubles that the box was fitted with are wrong by up to 13U units: a projection by 2 roundings and by the
///   axis' length (3U), the middle and the extent by 1 each, the centre in any direction by 3 and again by that length.
constexpr double kOfFit = (2 + 3 + 1 + 1 + 3 + 3) * kUnitRoundoff / (2 * kSmallestSize);
constexpr double kOutwards = 0x1p-21;
/// What must be left, for what is computed with the box's axis.
constexpr double kSpared = 0x1p-23;
static_assert(kOfCenter + kOfAxis + kOfExtent + kOfFit + kSpared <= kOutwards);

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A shorter chord gives its box no direction, in units.
constexpr double kShortestChord = 0x1p-60;

struct FittedBox {
  Double2 center, axis, extents;  ///< half of what it is along and across its axis
};

/// A part of the polygon that one box stands for: rings order[begin, end), or a chain of edges [begin, end) of one
/// ring.
struct Content {
  enum Kind { Rings, Chain } kind;
  std::size_t begin, end;
};

/// What a part is divided into.
struct Contents {
  void add(const Content& part) { all[count++] = part; }

  Content all[kLanes];
  std::size_t count = 0;
};

/// A polygon's path in units, from S.
std::vector<Vec2> pathInUnits(const PolygonData& polygon) {
  std::vector<Vec2> path;
  path.reserve(polygon.path.size());
  for (const Vec2& p : polygon.path) path.push_back(polygon.inUnits(p));
  return path;
}

class Builder {
 public:
  Builder(const PolygonData& polygon, const std::vector<Vec2>& local) : polygon_(polygon), local_(local) {
    if (polygon.ringCount() > 1) {
      order_.resize(polygon.ringCount());
      std::iota(order_.begin(), order_.end(), 0u);
    }
    all_ = rings(0, polygon.ringCount());
  }

  void fitRoot(Hierarchy& hierarchy) const {
    constexpr float kWithoutEnd = std::numeric_limits<float>::infinity();
    hierarchy.root = hierarchy.region = rounded(fitAll(all_), Double2{}, 1);
    if (polygon_.fill.is_complement) hierarchy.region.along = hierarchy.region.across = kWithoutEnd;
    hierarchy.root_spanned = all_.kind == Content::Chain;
  }

  std::vector<Block> blocks() {
    addBlock(all_);
    blocks_.shrink_to_fit();
    return std::move(blocks_);
  }

 private:
  /// Along the line from S to its farthest vertex or, if that box is smaller, along the longest edge.
  FittedBox fitAll(const Content& all) const {
    Double2 farthest{}, longest{};
    double most = -1, most_along = -1;
    forEachChain(all, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Double2 p = load2(local_[i].data()), edge = load2(local_[i + 1].data()) - p;
        const double square = dot(p, p), along = dot(edge, edge);
        if (square > most) most = square, farthest = p;
        if (along > most_along) most_along = along, longest = edge;
      }
    });
    const FittedBox by_vertex = fit(all, farthest), by_edge = fit(all, longest);
    if (!(area(by_edge) < area(by_vertex))) return by_vertex;
    // Its longer side comes first.
    const bool turned = by_edge.extents[1] > by_edge.extents[0];
    return turned ? fit(all, Double2{-longest[1], longest[0]}) : by_edge;
  }

  /// A single ring is a chain.
  Content rings(std::size_t begin, std::size_t end) const {
    if (end - begin > 1) return {Content::Rings, begin, end};
    const std::size_t one = order_.empty() ? 0 : order_[begin];
    return {Content::Chain, polygon_.edgeBegin(one), polygon_.edgeEnd(one)};
  }

  static double area(const FittedBox& box) { return box.extents[0] * box.extents[1]; }

  template <typename Visit>
  void forEachChain(const Content& part, Visit visit) const {
    if (part.kind == Content::Chain) return visit(part.begin, part.end);
    for (std::size_t i = part.begin; i < part.end; ++i)
      visit(polygon_.edgeBegin(order_[i]), polygon_.edgeEnd(order_[i]));
  }

  std::size_t edgeCount(const Content& part) const {
    std::size_t count = 0;
    forEachChain(part, [&](std::size_t begin, std::size_t end) { count += end - begin; });
    return count;
  }

  FittedBox fit(const Content& part, Double2 direction) const {
    const double length = std::sqrt(dot(direction, direction));
    const Double2 axis = length > kShortestChord ? direction / length : Double2{1, 0};
    // Along and across: the product of a point and the axis, and their cross product.
    const Double2 of_x{axis[0], -axis[1]}, of_y{axis[1], axis[0]};
    Double2 low{kInfinity, kInfinity}, high = -low;
    forEachChain(part, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i <= end; ++i) {
        const Double2 at = local_[i].x() * of_x + local_[i].y() * of_y;
        low = smaller(at, low);
        high = larger(at, high);
      }
    });
    const Double2 middle = 0.5 * (low + high), extents = 0.5 * (high - low);
    return {middle[0] * axis + middle[1] * Double2{-axis[1], axis[0]}, axis, extents};
  }

  /// An edge's box is the edge itself: off by the middle's rounding and the axis', which are less than kOfFit.
  FittedBox fitEdge(std::size_t edge) const {
    const Double2 v = load2(local_[edge].data()), w = load2(local_[edge + 1].data()), along = w - v;
    const double length = std::sqrt(dot(along, along));
    const bool is_short = !(length > kShortestChord);
    return {0.5 * (v + w), is_short ? Double2{1, 0} : along / length,
            Double2{0.5 * length, is_short ? 0.5 * length : 0}};
  }

  /// A chain's box lies along its chord or, if that is smaller, along the sum of its edges, each taken the way round
  /// that makes the sum longer.
  FittedBox fit(const Content& part) const {
    if (part.kind == Content::Rings) return fit(part, Double2{1, 0});
    if (part.end - part.begin == 1) return fitEdge(part.begin);
    const FittedBox along_chord = fit(part, load2(local_[part.end].data()) - load2(local_[part.begin].data()));
    const FittedBox along_sum = fit(part, sumOfEdges(part));
    return area(along_sum) < area(along_chord) ? along_sum : along_chord;
  }

  Double2 sumOfEdges(const Content& chain) const {
    Double2 sum{};
    for (std::size_t i = chain.begin; i < chain.end; ++i) {
      const Double2 edge = load2(local_[i + 1].data()) - load2(local_[i].data());
      sum = dot(edge, sum) < 0 ? sum - edge : sum + edge;
    }
    return sum;
  }

  static Box rounded(const FittedBox& box, Double2 origin, double inverse) {
    const Float2 center = narrowed((box.center - origin) * inverse), axis = narrowed(box.axis);
    const Float2 extents = narrowed(box.extents * inverse + kOutwards);
    return {center[0], center[1], axis[0], axis[1], extents[0], extents[1]};
  }

  /// Whether a lane's box holds its part, and has room to spare.
  [[maybe_unused]] bool holds(const Block& block, std::size_t i, const Content& part) const {
    const double ux = block.ux[i], uy = block.uy[i], length = std::hypot(ux, uy);
    bool all = true;
    forEachChain(part, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k <= end; ++k) {
        const double x = (local_[k].x() - block.origin_x) * block.inverse - block.x[i];
        const double y = (local_[k].y() - block.origin_y) * block.inverse - block.y[i];
        all = all && std::abs(x * ux + y * uy) <= (block.along[i] - kSpared) * length &&
              std::abs(y * ux - x * uy) <= (block.across[i] - kSpared) * length;
      }
    });
    return all;
  }

  /// Divides rings at `mid`, along the longer side of the bounding box of their starts.
  void halve(const Content& whole, std::size_t mid) {
    const auto start = [&](std::uint32_t ring) -> const Vec2& { return local_[polygon_.edgeBegin(ring)]; };
    Vec2 low = start(order_[whole.begin]), high = low;
    for (std::size_t i = whole.begin; i < whole.end; ++i) {
      low = low.cwiseMin(start(order_[i]));
      high = high.cwiseMax(start(order_[i]));
    }
    const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(whole.begin), at(mid), at(whole.end),
                     [&](std::uint32_t r, std::uint32_t s) { return start(r)[axis] < start(s)[axis]; });
  }

  /// How many edges a ring takes the place of: small ones share a leaf, as many as fit, and a large one's blocks are
  /// its own.
  std::size_t roomOf(std::uint32_t ring) const {
    const std::size_t edges = polygon_.edgeEnd(ring) - polygon_.edgeBegin(ring);
    return edges <= kLanes ? kLanes / (kLanes / edges) : kLanes * roomBelow(edges);
  }
  std::size_t roomOf(const Content& part) const {
    std::size_t room = 0;
    for (std::size_t i = part.begin; i < part.end; ++i) room += roomOf(order_[i]);
    return room;
  }

  /// Up to kLanes parts, so that the blocks below are full if the rings are alike. Rings are taken apart before any is
  /// cut.
  Contents divideRings(const Content& whole) {
    std::size_t room[kLanes] = {roomOf(whole)};
    const std::size_t below = roomBelow(room[0]);
    Contents parts;
    parts.add(whole);
    while (parts.count < kLanes) {
      std::size_t largest = parts.count, most = below;
      for (std::size_t i = 0; i < parts.count; ++i)
        if (parts.all[i].kind == Content::Rings && room[i] > most) largest = i, most = room[i];
      if (largest == parts.count) break;
      const Content halved = parts.all[largest];
      const std::size_t count = halved.end - halved.begin, groups = (most + below - 1) / below;
      const std::size_t mid = halved.begin + std::max<std::size_t>(count * (groups / 2) / groups, 1);
      halve(halved, mid);
      room[parts.count] = roomOf({Content::Rings, mid, halved.end});
      room[largest] = most - room[parts.count];
      parts.all[largest] = rings(halved.begin, mid);
      parts.add(rings(mid, halved.end));
    }
    return parts;
  }

  /// What a child has room for in the lowest tree that has room for so many edges.
  static std::size_t roomBelow(std::size_t edges) {
    std::size_t below = kLanes;
    while (below * kLanes < edges) below *= kLanes;
    return below;
  }

  /// A chain evenly into as few parts, up to kLanes, as let the blocks below be full.
  static Contents cut(const Content& chain) {
    const std::size_t n = chain.end - chain.begin;
    const std::size_t below = roomBelow(n), k = (n + below - 1) / below;
    Contents parts;
    for (std::size_t i = 0; i < k; ++i)
      parts.add({Content::Chain, chain.begin + i * n / k, chain.begin + (i + 1) * n / k});
    return parts;
  }

  Contents edgesOf(const Content& part) const {
    Contents edges;
    forEachChain(part, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) edges.add({Content::Chain, e, e + 1});
    });
    return edges;
  }

  std::uint32_t addBlock(const Content& whole) {
    const bool leaf = edgeCount(whole) <= kLanes;
    const Contents parts = leaf ? edgesOf(whole) : whole.kind == Content::Rings ? divideRings(whole) : cut(whole);
    FittedBox boxes[kLanes];
    for (std::size_t i = 0; i < parts.count; ++i) boxes[i] = leaf ? fitEdge(parts.all[i].begin) : fit(parts.all[i]);
    Double2 low{kInfinity, kInfinity}, high = -low;
    for (std::size_t i = 0; i < parts.count; ++i) {
      low = smaller(boxes[i].center, low);
      high = larger(boxes[i].center, high);
    }
    const Double2 origin = 0.5 * (low + high);
    double size = kSmallestSize;
    for (std::size_t i = 0; i < parts.count; ++i) {
      const Double2 away = absolute(boxes[i].center - origin);
      size = std::max(size, std::max(away[0], away[1]) + boxes[i].extents[0] + boxes[i].extents[1]);
    }
    const double scale = powerOfTwo(exponentOf(size) + 1);

    Block block{};
    block.origin_x = origin[0];
    block.origin_y = origin[1];
    block.scale = static_cast<float>(scale);
    block.inverse = static_cast<float>(1 / scale);
    block.leaf = leaf;
    block.count = static_cast<std::uint8_t>(parts.count);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const Box box = i < parts.count ? rounded(boxes[i], origin, 1 / scale) : Box{0, 0, 1, 0, -1e30f, -1e30f};
      block.x[i] = box.x;
      block.y[i] = box.y;
      block.ux[i] = box.ux;
      block.uy[i] = box.uy;
      block.along[i] = box.along;
      block.across[i] = box.across;
      if (i >= parts.count) continue;
      assert(!polygon_.fitsUnit() || holds(block, i, parts.all[i]));
      if (parts.all[i].kind == Content::Chain) block.spanned = static_cast<std::uint8_t>(block.spanned | 1u << i);
      if (leaf) block.child[i] = static_cast<EdgePosition>(parts.all[i].begin);
    }
    const std::size_t index = blocks_.size();
    blocks_.push_back(block);
    if (!leaf)
      for (std::size_t i = 0; i < parts.count; ++i) {
        const std::uint32_t child = addBlock(parts.all[i]);
        blocks_[index].child[i] = child;
      }
    return static_cast<std::uint32_t>(index);
  }

  const PolygonData& polygon_;
  const std::vector<Vec2>& local_;
  Content all_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> order_;  ///< of rings, unless there is one alone
};

/// Whether every block but the first is the child of one before it, and every lane of a leaf an edge of its own.
[[maybe_unused]] bool isTree(const Hierarchy& hierarchy, const PolygonData& polygon) {
  std::vector<bool> is_child(hierarchy.blocks.size(), false), has_leaf(polygon.path.size(), false);
  std::size_t children = 0, edges = 0;
  for (std::size_t k = 0; k < hierarchy.blocks.size(); ++k) {
    const Block& block = hierarchy.blocks[k];
    if (block.count < 1 || block.count > kLanes) return false;
    for (int i = 0; i < block.count; ++i) {
      const std::size_t child = block.child[i];
      std::vector<bool>& met = block.leaf ? has_leaf : is_child;
      if (child >= met.size() || met[child] || (!block.leaf && child <= k)) return false;
      met[child] = true;
      ++(block.leaf ? edges : children);
    }
  }
  return children + 1 == hierarchy.blocks.size() && edges == polygon.path.size() - polygon.ringCount();
}

}  // namespace

Hierarchy::Hierarchy(const PolygonData& polygon) {
  const std::vector<Vec2> local = pathInUnits(polygon);
  Builder builder(polygon, local);
  builder.fitRoot(*this);
  small = makeSmallPolygon(polygon, local.data());
  if (small == nullptr) blocks = builder.blocks();
  assert(small != nullptr || isTree(*this, polygon));
  // Its corners may be few if it has no more than one vertex more on each side.
  const bool may_be_small = polygon.path.size() <= 2 * SmallPolygon::kMost + 1;
  const PolygonData* corners = may_be_small ? cornersOf(polygon) : nullptr;
  if (corners != nullptr) small_convex = (corners == &polygon ? *this : topOf(*corners)).small.get();
}

const Hierarchy& buildTop(const PolygonData& polygon) { return polygon.hierarchy.made<Hierarchy>(polygon); }

const Hierarchy& buildHierarchy(const PolygonData& polygon) {
  const Hierarchy& hierarchy = topOf(polygon);
  if (!hierarchy.hasBlocks())
    hierarchy.few_blocks.built([&] {
      auto are_there = std::make_unique<const Derived::Thing>();
      hierarchy.blocks = Builder(polygon, pathInUnits(polygon)).blocks();
      assert(isTree(hierarchy, polygon));
      return are_there;
    });
  return hierarchy;
}

}  // namespace tricover::detail
