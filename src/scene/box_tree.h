// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hierarchy/axis_boxes.h"
#include "hierarchy/descend.h"

namespace tricover::detail {

/// A tree of boxes that are added, moved and removed: an R-tree (Guttman 1984) of eight boxes a node, which SIMD lanes
/// compare at once. Each box belongs to an item; the caller numbers the items.
class BoxTree {
 public:
  struct Entry {
    Bounds bounds;
    std::uint32_t child;  ///< an item, or a node
  };

  /// Replaces all items by these and packs them, so that each node is around boxes that lie together. Throws before
  /// anything has changed.
  void pack(const std::vector<Entry>& entries);
  /// Adds an item that isn't in the tree. Throws before anything has changed.
  void insert(std::uint32_t item, const Bounds& bounds);
  void remove(std::uint32_t item);
  /// Reserves memory for the next move(), which doesn't throw then.
  void prepareMove() {
    if (free_.size() < kLevels) reserveFor(0);
  }
  /// Changes the box of an item.
  void move(std::uint32_t item, const Bounds& bounds);
  bool holds(std::uint32_t item) const { return item < places_.size() && places_[item] != kNone; }
  /// Returns how many boxes have been inserted or changed nodes since the tree was packed. They make it worse.
  std::size_t changes() const { return changes_; }
  Bounds boundsOf(std::uint32_t item) const { return nodes_[places_[item] / kLanes].at(places_[item] % kLanes); }

  /// Calls visit(item) for every item whose box meets `bounds`, until it returns false.
  template <typename Visit>
  void visit(const Bounds& bounds, const Visit& visit) const {
    if (root_ == kNone) return;
    descend<false, double>(
        nodes_.data(), root_, [](double) { return true; },
        [&](const Node& node, double*) { return boxesMeeting(node, bounds); },
        [&](const Node& node, unsigned lanes, const double*) {
          for (; lanes != 0; lanes &= lanes - 1)
            if (!visit(node.child[__builtin_ctz(lanes)])) return false;
          return true;
        });
  }

  /// Calls visit(item) for every item whose box is no farther from `bounds` than `most`, near nodes and items first.
  /// visit returns the largest distance that is still of interest.
  template <typename Visit>
  void visitNear(const Bounds& bounds, double most, const Visit& visit) const {
    visitInOrder(
        gapSquareAbove(most),
        [&](const EightBoxes& boxes, double limit, double* at) { return boxesNear(boxes, bounds, limit, at); },
        [&](std::uint32_t item) { return gapSquareAbove(visit(item)); });
  }

  /// Calls visit(item) for every item whose box the ray enters before the fraction `most`, the first nodes and items
  /// first. visit returns the largest fraction that is still of interest. A box counts as entered by kEarlier earlier.
  template <typename Visit>
  void visitOnRay(const BoxRay& ray, double most, const Visit& visit) const {
    visitInOrder(
        most, [&](const EightBoxes& boxes, double limit, double* at) { return boxesOnRay(boxes, ray, limit, at); },
        visit);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr Bounds kNothing = {kNaN, kNaN, kNaN, kNaN};  ///< meets nothing, not even what is infinite
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  /// A split leaves at most six boxes in a node, so that the node takes three more before its next split. Hence fewer
  /// than 3^31 insertions make fewer levels than this.
  static constexpr int kLevels = 32;
  static_assert(kLevels <= kMaxDepth);

  /// Boxes beyond the count are kNothing.
  struct Node : EightBoxes {
    std::uint32_t child[kLanes];  ///< nodes, or a leaf's items
    std::uint32_t parent, lane;   ///< kNone for the root; the index of this node among the parent's boxes
    std::uint8_t count;
    bool leaf;

    Bounds all() const;
  };

  /// The middle of an entry's box.
  struct Middle {
    double x, y;
    std::uint32_t entry;
  };

  /// Calls visit(item), which returns the new `most`, of each leaf the nearest first. near(boxes, most, at) says which
  /// boxes of a node may be within `most`, and how near they are at least.
  template <typename Near, typename Visit>
  void visitInOrder(double most, const Near& near, const Visit& visit) const {
    if (root_ == kNone) return;
    descend<true, double>(
        nodes_.data(), root_, [&](double at) { return !(at > most); },
        [&](const Node& node, double* at) { return near(node, most, at); },
        [&](const Node& node, unsigned left, const double* at) {
          while (left != 0) {
            int first = __builtin_ctz(left);
            for (unsigned others = left & (left - 1); others != 0; others &= others - 1) {
              const int i = __builtin_ctz(others);
              first = at[i] < at[first] ? i : first;
            }
            if (at[first] > most) break;
            left ^= 1u << first;
            most = visit(node.child[first]);
          }
          return true;
        });
  }

  std::uint32_t packed(Middle* first, std::size_t count, int height, const std::vector<Entry>& entries);
  void packGroups(std::uint32_t node, Middle* first, std::size_t count, std::size_t groups, int height,
                  const std::vector<Entry>& entries);

  std::uint32_t newNode(bool leaf);
  void freeNode(std::uint32_t index);
  void put(std::uint32_t index, unsigned lane, const Entry& entry);
  std::uint32_t leafFor(const Bounds& bounds);
  void addTo(std::uint32_t index, const Entry& entry);
  void split(std::uint32_t index, const Entry& entry);
  void takeFrom(std::uint32_t index, unsigned lane);
  void tighten(std::uint32_t index);
  void reserveNodes(std::size_t more);
  void reserveFor(std::uint32_t item);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> places_;  ///< node and lane of each item, as one number
  std::uint32_t root_ = kNone;
  std::size_t changes_ = 0;
};

}  // namespace tricover::detail
