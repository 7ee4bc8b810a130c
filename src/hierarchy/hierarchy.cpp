// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/hierarchy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "hierarchy/inner_discs.h"
#include "hierarchy/small_ring.h"
#include "numbers/rounding.h"

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

/// A shorter chord gives its box no direction, in units.
constexpr double kShortestChord = 0x1p-60;

struct FittedBox {
  Vec2 center, axis;
  double along, across;
};

/// A part of the polygon that one box stands for: rings order[begin, end), or edges [begin, end) of one ring.
struct Part {
  bool rings;
  std::size_t begin, end;
};

class Builder {
 public:
  Builder(const PolygonData& polygon, const std::vector<Vec2>& local, Hierarchy& hierarchy)
      : polygon_(polygon), local_(local), blocks_(hierarchy.blocks), order_(polygon.ringCount()) {
    std::iota(order_.begin(), order_.end(), 0u);
    const Part all = part(0, order_.size());
    const Vec2& farthest = *std::max_element(
        local_.begin(), local_.end(), [](const Vec2& p, const Vec2& q) { return p.squaredNorm() < q.squaredNorm(); });
    hierarchy.root = rounded(fit(all, farthest), Vec2::Zero(), 1);
    hierarchy.root_spanned = !all.rings;
    addBlock(all);
  }

 private:
  Part part(std::size_t begin, std::size_t end) const {
    if (end - begin > 1) return {true, begin, end};
    return {false, polygon_.edgeBegin(order_[begin]), polygon_.edgeEnd(order_[begin])};
  }

  template <typename Visit>
  void forEachChain(const Part& part, Visit visit) const {
    if (!part.rings) return visit(part.begin, part.end);
    for (std::size_t i = part.begin; i < part.end; ++i)
      visit(polygon_.edgeBegin(order_[i]), polygon_.edgeEnd(order_[i]));
  }

  std::size_t edgeCount(const Part& part) const {
    std::size_t count = 0;
    forEachChain(part, [&](std::size_t begin, std::size_t end) { count += end - begin; });
    return count;
  }

  FittedBox fit(const Part& part, const Vec2& direction) const {
    const double length = direction.norm();
    const Vec2 axis = length > kShortestChord ? Vec2(direction / length) : Vec2(1, 0);
    double low_u = std::numeric_limits<double>::infinity(), high_u = -low_u, low_v = low_u, high_v = -low_u;
    forEachChain(part, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i <= end; ++i) {
        const double u = local_[i].x() * axis.x() + local_[i].y() * axis.y();
        const double v = local_[i].y() * axis.x() - local_[i].x() * axis.y();
        low_u = std::min(low_u, u);
        high_u = std::max(high_u, u);
        low_v = std::min(low_v, v);
        high_v = std::max(high_v, v);
      }
    });
    const double u = 0.5 * (low_u + high_u), v = 0.5 * (low_v + high_v);
    return {{u * axis.x() - v * axis.y(), u * axis.y() + v * axis.x()},
            axis,
            0.5 * (high_u - low_u),
            0.5 * (high_v - low_v)};
  }

  /// A chain's box lies along its chord.
  FittedBox fit(const Part& part) const {
    return fit(part, part.rings ? Vec2(1, 0) : Vec2(local_[part.end] - local_[part.begin]));
  }

  static Box rounded(const FittedBox& box, const Vec2& origin, double inverse) {
    const Vec2 center = (box.center - origin) * inverse;
    return {static_cast<float>(center.x()),
            static_cast<float>(center.y()),
            static_cast<float>(box.axis.x()),
            static_cast<float>(box.axis.y()),
            static_cast<float>(box.along * inverse + kOutwards),
            static_cast<float>(box.across * inverse + kOutwards)};
  }

  /// Whether a lane's box holds its part, and has room to spare.
  [[maybe_unused]] bool holds(const Block& block, std::size_t i, const Part& part) const {
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

  /// Rings order[begin, end) halved along the longer side of their first vertices' bounding box.
  std::size_t halveRings(std::size_t begin, std::size_t end) {
    const auto first = [&](std::uint32_t ring) -> const Vec2& { return local_[polygon_.edgeBegin(ring)]; };
    Vec2 low = first(order_[begin]), high = low;
    for (std::size_t i = begin; i < end; ++i) {
      low = low.cwiseMin(first(order_[i]));
      high = high.cwiseMax(first(order_[i]));
    }
    const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
    const std::size_t mid = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(mid), at(end),
                     [&](std::uint32_t r, std::uint32_t s) { return first(r)[axis] < first(s)[axis]; });
    return mid;
  }

  /// Up to kLanes parts. Rings are taken apart before any is cut. A chain is cut evenly into as few parts as let the
  /// blocks below be full.
  std::vector<Part> divide(const Part& whole) {
    std::vector<Part> parts;
    if (whole.rings) {
      parts.push_back(whole);
      while (parts.size() < kLanes) {
        auto largest = parts.end();
        for (auto it = parts.begin(); it != parts.end(); ++it)
          if (it->rings && edgeCount(*it) > kLanes && (largest == parts.end() || edgeCount(*it) > edgeCount(*largest)))
            largest = it;
        if (largest == parts.end()) break;
        const Part halved = *largest;
        const std::size_t mid = halveRings(halved.begin, halved.end);
        *largest = part(halved.begin, mid);
        parts.push_back(part(mid, halved.end));
      }
      return parts;
    }
    const std::size_t n = whole.end - whole.begin;
    std::size_t below = kLanes;
    while (below * kLanes < n) below *= kLanes;
    const std::size_t k = (n + below - 1) / below;
    for (std::size_t i = 0; i < k; ++i)
      parts.push_back({false, whole.begin + i * n / k, whole.begin + (i + 1) * n / k});
    return parts;
  }

  std::uint32_t addBlock(const Part& whole) {
    const bool leaf = edgeCount(whole) <= kLanes;
    std::vector<Part> parts;
    if (leaf) {
      forEachChain(whole, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) parts.push_back({false, e, e + 1});
      });
    } else {
      parts = divide(whole);
    }
    std::vector<FittedBox> boxes;
    boxes.reserve(parts.size());
    for (const Part& p : parts) boxes.push_back(fit(p));

    Vec2 low = boxes[0].center, high = low;
    for (const FittedBox& box : boxes) {
      low = low.cwiseMin(box.center);
      high = high.cwiseMax(box.center);
    }
    const Vec2 origin = 0.5 * (low + high);
    double size = kSmallestSize;
    for (const FittedBox& box : boxes)
      size = std::max(size, (box.center - origin).lpNorm<Eigen::Infinity>() + box.along + box.across);
    const double scale = std::ldexp(1, std::ilogb(size) + 1);

    Block block{};
    block.origin_x = origin.x();
    block.origin_y = origin.y();
    block.scale = static_cast<float>(scale);
    block.inverse = static_cast<float>(1 / scale);
    block.leaf = leaf;
    block.count = static_cast<std::uint8_t>(parts.size());
    for (std::size_t i = 0; i < kLanes; ++i) {
      const Box box = i < parts.size() ? rounded(boxes[i], origin, 1 / scale) : Box{0, 0, 1, 0, -1e30f, -1e30f};
      block.x[i] = box.x;
      block.y[i] = box.y;
      block.ux[i] = box.ux;
      block.uy[i] = box.uy;
      block.along[i] = box.along;
      block.across[i] = box.across;
      if (i >= parts.size()) continue;
      assert(!polygon_.fitsUnit() || holds(block, i, parts[i]));
      if (!parts[i].rings) block.spanned = static_cast<std::uint8_t>(block.spanned | 1u << i);
      if (leaf) block.child[i] = static_cast<std::uint32_t>(parts[i].begin);
    }
    const std::size_t index = blocks_.size();
    blocks_.push_back(block);
    if (!leaf)
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::uint32_t child = addBlock(parts[i]);
        blocks_[index].child[i] = child;
      }
    return static_cast<std::uint32_t>(index);
  }

  const PolygonData& polygon_;
  const std::vector<Vec2>& local_;
  std::vector<Block>& blocks_;
  std::vector<std::uint32_t> order_;
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
  std::vector<Vec2> local;
  local.reserve(polygon.path.size());
  for (const Vec2& p : polygon.path) local.push_back(polygon.inUnits(p));
  blocks.reserve(polygon.path.size() / (kLanes / 2) + 1);
  const Builder builder(polygon, local, *this);
  blocks.shrink_to_fit();
  assert(isTree(*this, polygon));
  findInnerDiscs(polygon, local, *this);
  small_ring = makeSmallRing(polygon, local);
  small_convex = small_ring && small_ring->convex ? small_ring.get() : nullptr;
}

const Hierarchy& buildHierarchy(const PolygonData& polygon) {
  return *static_cast<const Hierarchy*>(
      polygon.derived.built([&] { return std::make_unique<const Hierarchy>(polygon); }));
}

}  // namespace tricover::detail
