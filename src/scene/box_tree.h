// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "numbers/rounding.h"
#include "scene/bounds.h"

namespace tricover::detail {

/// A ray as boxes are asked about it. It passes the coordinate x of an axis at the fraction x * inverse - c, with c =
/// from * inverse: boxes are entered after x * inverse - enter and left before x * inverse - leave.
///
/// Error. Beside 6U of a fraction, which kEarlier pays for where that is at most 1: 4U |c|, because x * inverse rounds
/// by U of itself, and that is at most 2 |c| or half of it is left. Along an axis where the way is shorter than `least`
/// it is taken for that: the ray stays within 1 in these fractions of where it begins, and sides are moved by 2. A way
/// that overflows tells nothing.
struct BoxRay {
  static constexpr double kEarlier = 4e-13;

  BoxRay(const Vec2& from, const Vec2& to) {
    for (const int axis : {0, 1}) {
      const double way = to[axis] - from[axis], least = std::max(1e-290, 0x1p-60 * std::abs(from[axis]));
      const bool known = std::isfinite(way);
      inverse[axis] = std::copysign(known ? 1 / std::max(std::abs(way), least) : 1e-307, way);
      const double c = from[axis] * inverse[axis], room = 8 * kUnitRoundoff * std::abs(c) + kEarlier;
      const double slack = !known ? std::numeric_limits<double>::infinity() : std::abs(way) < least ? room + 2 : room;
      enter[axis] = c + slack;
      leave[axis] = c - slack;
    }
  }

  double inverse[2], enter[2], leave[2];
};

/// A tree of boxes that come, move and go: an R-tree (Guttman 1984) of eight boxes a node, which are asked side by
/// side. Each box is an item's; items are numbered by its user.
class BoxTree {
 public:
  /// No item is in the tree twice. Throws before anything has changed.
  void insert(std::uint32_t item, const Bounds& bounds);
  void remove(std::uint32_t item);
  /// Another box for an item.
  void move(std::uint32_t item, const Bounds& bounds);
  Bounds boundsOf(std::uint32_t item) const { return nodes_[places_[item] / kLanes].at(places_[item] % kLanes); }

  /// Calls visit(item) for every item whose box meets `bounds`, until it returns false. Returns whether it never did.
  template <typename Visit>
  bool visit(const Bounds& bounds, const Visit& visit) const {
    if (nodes_.empty()) return true;
    std::uint32_t stack[kStack];
    int top = 0;
    stack[top++] = root_;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      for (unsigned met = node.meeting(bounds); met != 0; met &= met - 1) {
        const std::uint32_t child = node.child[__builtin_ctz(met)];
        if (!node.leaf)
          stack[top++] = child;
        else if (!visit(child))
          return false;
      }
    }
    return true;
  }

  /// Shows every item, those whose boxes have a small bound first: bound(Bounds) is at most what visit(item) is about,
  /// NaN never. visit returns the largest bound that is still of interest.
  template <typename Bound, typename Visit>
  void visitInOrder(double most, const Bound& bound, const Visit& visit) const;

  /// Shows every item whose box the ray meets before the fraction `most`, those that it enters first roughly first.
  /// visit returns the largest fraction that is still of interest. A box counts as entered by kEarlier earlier.
  template <typename Visit>
  void visitOnRay(const BoxRay& ray, double most, const Visit& visit) const;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr Bounds kNothing = {kNaN, kNaN, kNaN, kNaN};  ///< meets nothing, not even what is infinite
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr int kLeast = 2;  ///< boxes a node, but for the root
  /// A node has two children at least, so that a tree of 2^28 items has fewer than 32 levels.
  static constexpr int kStack = 32 * (kLanes - 1) + 1;

  struct alignas(64) Node {
    double min_x[kLanes], min_y[kLanes], max_x[kLanes], max_y[kLanes];
    std::uint32_t child[kLanes];  ///< nodes, or a leaf's items
    std::uint32_t parent, lane;   ///< kNone of the root; which of the parent's boxes is around this node
    std::uint8_t count;
    bool leaf;

    /// Bit per lane. Lanes beyond the count hold kNothing.
    unsigned meeting(const Bounds& bounds) const;
    /// The same, and lower bounds of the fractions at which the ray enters them.
    unsigned meeting(const BoxRay& ray, double most, double (&least)[kLanes]) const;
    Bounds at(unsigned i) const { return {min_x[i], min_y[i], max_x[i], max_y[i]}; }
    void set(unsigned i, const Bounds& bounds) {
      min_x[i] = bounds.min_x, min_y[i] = bounds.min_y, max_x[i] = bounds.max_x, max_y[i] = bounds.max_y;
    }
    Bounds all() const;
  };

  struct Entry {
    Bounds bounds;
    std::uint32_t child;
  };

  std::uint32_t newNode(bool leaf);
  void freeNode(std::uint32_t index);
  void put(std::uint32_t index, unsigned lane, const Entry& entry);
  std::uint32_t leafFor(const Bounds& bounds);
  void addTo(std::uint32_t index, const Entry& entry);
  void split(std::uint32_t index, const Entry& entry);
  void takeFrom(std::uint32_t index, unsigned lane);
  void tighten(std::uint32_t index);
  void reserveFor(std::uint32_t item);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> places_;  ///< node and lane of each item, as one number
  std::uint32_t root_ = kNone;
};

inline unsigned BoxTree::Node::meeting(const Bounds& bounds) const {
  unsigned bits = 0;
  for (int i = 0; i < kLanes; i += 2) {
    const Bits2 met = (load2(min_x + i) <= bounds.max_x - Double2{}) & (bounds.min_x - Double2{} <= load2(max_x + i)) &
                      (load2(min_y + i) <= bounds.max_y - Double2{}) & (bounds.min_y - Double2{} <= load2(max_y + i));
    bits |= bitsOf(met) << i;
  }
  return bits;
}

inline unsigned BoxTree::Node::meeting(const BoxRay& ray, double most, double (&least)[kLanes]) const {
  const bool right = ray.inverse[0] > 0, up = ray.inverse[1] > 0;
  const double *near_x = right ? min_x : max_x, *far_x = right ? max_x : min_x;
  const double *near_y = up ? min_y : max_y, *far_y = up ? max_y : min_y;
  unsigned bits = 0;
  for (int i = 0; i < kLanes; i += 2) {
    const Double2 begin_x = load2(near_x + i) * ray.inverse[0] - ray.enter[0];
    const Double2 begin_y = load2(near_y + i) * ray.inverse[1] - ray.enter[1];
    const Double2 end_x = load2(far_x + i) * ray.inverse[0] - ray.leave[0];
    const Double2 end_y = load2(far_y + i) * ray.inverse[1] - ray.leave[1];
    const Double2 begin = larger(larger(begin_x, begin_y), -BoxRay::kEarlier - Double2{});
    const Double2 end = smaller(smaller(end_x, end_y), most - Double2{});
    store2(least + i, begin);
    bits |= bitsOf(begin <= end) << i;
  }
  return bits & ((1u << count) - 1);
}

template <typename Visit>
void BoxTree::visitOnRay(const BoxRay& ray, double most, const Visit& visit) const {
  struct Waiting {
    double least;
    std::uint32_t child;
    bool item;
  };
  if (nodes_.empty()) return;
  Waiting stack[kStack];  // of each node the first on top
  int top = 0;
  stack[top++] = {0, root_, false};
  while (top > 0) {
    const Waiting next = stack[--top];
    if (next.least > most) continue;
    if (next.item) {
      most = visit(next.child);
      continue;
    }
    const Node& node = nodes_[next.child];
    double least[kLanes];
    const int first = top;
    for (unsigned met = node.meeting(ray, most, least); met != 0; met &= met - 1) {
      const int i = __builtin_ctz(met);
      int at = top++;
      for (; at > first && stack[at - 1].least < least[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {least[i], node.child[i], node.leaf};
    }
  }
}

template <typename Bound, typename Visit>
void BoxTree::visitInOrder(double most, const Bound& bound, const Visit& visit) const {
  struct Waiting {
    double bound;
    std::uint32_t child;
    bool node;
    bool operator<(const Waiting& other) const { return bound > other.bound; }  // for a heap, least first
  };
  if (nodes_.empty()) return;
  std::vector<Waiting> heap{{-kInfinity, root_, true}};
  while (!heap.empty() && heap.front().bound <= most) {
    const Waiting next = heap.front();
    std::pop_heap(heap.begin(), heap.end());
    heap.pop_back();
    if (!next.node) {
      most = visit(next.child);
      continue;
    }
    const Node& node = nodes_[next.child];
    for (unsigned i = 0; i < node.count; ++i) {
      const double least = bound(node.at(i));
      if (!(least <= most)) continue;
      heap.push_back({least, node.child[i], !node.leaf});
      std::push_heap(heap.begin(), heap.end());
    }
  }
}

}  // namespace tricover::detail
