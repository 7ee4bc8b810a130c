// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/hierarchy.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "hierarchy/small_polygon.h"
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

/// A shorter chord gives its box no direction, in units.
constexpr double kShortestChord = 0x1p-60;

struct FittedBox {
  Vec2 center, axis;
  double along, across;
};

/// A part of the polygon that one box stands for: rings order[begin, end), a chain of edges [begin, end) of one ring,
/// or edges tangled[begin, end).
struct Part {
  enum Kind { Rings, Chain, Edges } kind;
  std::size_t begin, end;
};

/// Long edges beside each other, as in a spiral's outer turns, are near each other but far along their chain. Rings of
/// at least this many edges are divided by where their edges lie if the boxes around eight edges of a chain cover more
/// than this times the box around all, and those around eight that lie together cover half as much.
constexpr std::size_t kMayTangle = 1024;
constexpr double kTangled = 2;

class Builder {
 public:
  Builder(const PolygonData& polygon, const std::vector<Vec2>& local, Hierarchy& hierarchy)
      : polygon_(polygon), local_(local), blocks_(hierarchy.blocks), order_(polygon.ringCount()) {
    std::iota(order_.begin(), order_.end(), 0u);
    const Part all = rings(0, order_.size());
    const Vec2& farthest = *std::max_element(
        local_.begin(), local_.end(), [](const Vec2& p, const Vec2& q) { return p.squaredNorm() < q.squaredNorm(); });
    hierarchy.root = rounded(fit(all, farthest), Vec2::Zero(), 1);
    hierarchy.root_spanned = all.kind == Part::Chain;
    addBlock(all);
  }

 private:
  /// A single ring is a chain, or edges.
  Part rings(std::size_t begin, std::size_t end) {
    if (end - begin > 1) return {Part::Rings, begin, end};
    const Part ring = {Part::Chain, polygon_.edgeBegin(order_[begin]), polygon_.edgeEnd(order_[begin])};
    return ring.end - ring.begin < kMayTangle ? ring : untangled(ring);
  }

  Part untangled(const Part& ring) {
    const double covered = coveredByLeaves(ring);
    if (!(covered > kTangled * area(fit(ring)))) return ring;
    const Part edges = {Part::Edges, tangled_.size(), tangled_.size() + ring.end - ring.begin};
    tangled_.resize(edges.end);
    std::iota(tangled_.begin() + static_cast<std::ptrdiff_t>(edges.begin), tangled_.end(),
              static_cast<std::uint32_t>(ring.begin));
    arrange(edges);
    if (coveredByLeaves(edges) < 0.5 * covered) return edges;
    tangled_.resize(edges.begin);
    return ring;
  }

  double coveredByLeaves(const Part& edges) const {
    if (edges.end - edges.begin <= kLanes) return area(fit(edges));
    double covered = 0;
    for (const Part& part : cut(edges)) covered += coveredByLeaves(part);
    return covered;
  }

  static double area(const FittedBox& box) { return box.along * box.across; }

  template <typename Visit>
  void forEachChain(const Part& part, Visit visit) const {
    if (part.kind == Part::Chain) return visit(part.begin, part.end);
    for (std::size_t i = part.begin; i < part.end; ++i) {
      if (part.kind == Part::Rings)
        visit(polygon_.edgeBegin(order_[i]), polygon_.edgeEnd(order_[i]));
      else
        visit(tangled_[i], tangled_[i] + 1);
    }
  }

  std::size_t edgeCount(const Part& part) const {
    if (part.kind != Part::Rings) return part.end - part.begin;
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

  /// A chain's box lies along its chord or, if that is smaller, along the sum of its edges, each taken the way round
  /// that makes the sum longer; so does the box of edges.
  FittedBox fit(const Part& part) const {
    if (part.kind == Part::Rings) return fit(part, Vec2(1, 0));
    if (part.kind == Part::Edges) return fit(part, sumOfEdges(part));
    const FittedBox along_chord = fit(part, local_[part.end] - local_[part.begin]);
    if (part.end - part.begin == 1) return along_chord;
    const FittedBox along_sum = fit(part, sumOfEdges(part));
    return area(along_sum) < area(along_chord) ? along_sum : along_chord;
  }

  Vec2 sumOfEdges(const Part& part) const {
    Vec2 sum = Vec2::Zero();
    forEachChain(part, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Vec2 edge = local_[i + 1] - local_[i];
        sum += edge.dot(sum) < 0 ? Vec2(-edge) : edge;
      }
    });
    return sum;
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

  /// Where one of a part's rings or edges is taken to be, twice.
  Vec2 placeOf(Part::Kind kind, std::uint32_t item) const {
    return kind == Part::Rings ? Vec2(2 * local_[polygon_.edgeBegin(item)]) : Vec2(local_[item] + local_[item + 1]);
  }

  /// Rings or edges parted at `mid`, along the longer side of their places' bounding box.
  void halve(const Part& whole, std::size_t mid) {
    std::vector<std::uint32_t>& items = whole.kind == Part::Rings ? order_ : tangled_;
    const auto place = [&](std::uint32_t item) { return placeOf(whole.kind, item); };
    Vec2 low = place(items[whole.begin]), high = low;
    for (std::size_t i = whole.begin; i < whole.end; ++i) {
      low = low.cwiseMin(place(items[i]));
      high = high.cwiseMax(place(items[i]));
    }
    const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
    const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(whole.begin), at(mid), at(whole.end),
                     [&](std::uint32_t r, std::uint32_t s) { return place(r)[axis] < place(s)[axis]; });
  }

  /// Up to kLanes parts. Rings are taken apart before any is cut.
  std::vector<Part> divideRings(const Part& whole) {
    std::vector<Part> parts = {whole};
    while (parts.size() < kLanes) {
      auto largest = parts.end();
      for (auto it = parts.begin(); it != parts.end(); ++it)
        if (it->kind == Part::Rings && edgeCount(*it) > kLanes &&
            (largest == parts.end() || edgeCount(*it) > edgeCount(*largest)))
          largest = it;
      if (largest == parts.end()) break;
      const Part halved = *largest;
      const std::size_t mid = (halved.begin + halved.end) / 2;
      halve(halved, mid);
      *largest = rings(halved.begin, mid);
      parts.push_back(rings(mid, halved.end));
    }
    return parts;
  }

  /// Edges evenly into as few parts, up to kLanes, as let the blocks below be full.
  static std::vector<Part> cut(const Part& edges) {
    const std::size_t n = edges.end - edges.begin;
    std::size_t below = kLanes;
    while (below * kLanes < n) below *= kLanes;
    const std::size_t k = (n + below - 1) / below;
    std::vector<Part> parts;
    for (std::size_t i = 0; i < k; ++i)
      parts.push_back({edges.kind, edges.begin + i * n / k, edges.begin + (i + 1) * n / k});
    return parts;
  }

  /// Puts edges in an order in which those that are cut apart lie apart.
  void arrange(const Part& edges) {
    const std::vector<Part> parts = cut(edges);
    if (parts.size() == 1) return;
    arrange(parts, 0, parts.size());
    for (const Part& part : parts) arrange(part);
  }
  void arrange(const std::vector<Part>& parts, std::size_t first, std::size_t last) {
    if (last - first == 1) return;
    const std::size_t mid = (first + last) / 2;
    halve({Part::Edges, parts[first].begin, parts[last - 1].end}, parts[mid].begin);
    arrange(parts, first, mid);
    arrange(parts, mid, last);
  }

  std::uint32_t addBlock(const Part& whole) {
    const bool leaf = edgeCount(whole) <= kLanes;
    std::vector<Part> parts;
    if (leaf) {
      forEachChain(whole, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) parts.push_back({Part::Chain, e, e + 1});
      });
    } else {
      parts = whole.kind == Part::Rings ? divideRings(whole) : cut(whole);
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
      if (parts[i].kind == Part::Chain) block.spanned = static_cast<std::uint8_t>(block.spanned | 1u << i);
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
  std::vector<std::uint32_t> order_, tangled_;
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
  small = makeSmallPolygon(polygon, local);
  small_convex = small && convexityOf(polygon).is_strict ? small.get() : nullptr;
}

const Hierarchy& buildHierarchy(const PolygonData& polygon) {
  return *static_cast<const Hierarchy*>(
      polygon.hierarchy.built([&] { return std::make_unique<const Hierarchy>(polygon); }));
}

}  // namespace tricover::detail
