// SPDX-License-Identifier: BSD-3-Clause
#include "scene/box_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tricover::detail {
namespace {

/// The cost of a box: half its perimeter, because it meets other boxes in that proportion (Goldsmith and Salmon 1987).
/// Clamped, so that no difference of two is NaN.
double cost(const Bounds& b) { return std::min((b.max_x - b.min_x) + (b.max_y - b.min_y), 1e300); }

/// A box's middle along an axis; 0 of infinite boxes.
double middleOf(double low, double high) {
  const double sum = 0.5 * low + 0.5 * high;
  return std::isfinite(sum) ? sum : 0.0;
}

/// The largest number of items below a node that has `height` levels below it.
std::size_t capacityOf(int height) { return std::size_t{kLanes} << (3 * height); }
static_assert(kLanes == 1 << 3);

}  // namespace

Bounds BoxTree::Branch::all() const {
  Bounds bounds = at(0);
  for (unsigned i = 1; i < count; ++i) bounds = unite(bounds, at(i));
  return bounds;
}

std::uint32_t BoxTree::newNode(bool leaf) {
  const std::uint32_t index = free_.back();  // reserveFor() made room
  free_.pop_back();
  Branch& node = nodes_[index];
  node.parent = kNone;
  node.lane = 0;
  node.count = 0;
  node.leaf = leaf;
  for (unsigned i = 0; i < kLanes; ++i) node.set(i, kNothing);
  return index;
}

void BoxTree::put(std::uint32_t index, unsigned lane, const Entry& entry) {
  Branch& node = nodes_[index];
  node.set(lane, entry.bounds);
  node.child[lane] = entry.child;
  if (node.leaf) {
    places_[entry.child] = index * kLanes + lane;
  } else {
    nodes_[entry.child].parent = index;
    nodes_[entry.child].lane = lane;
  }
}

/// Returns the leaf whose boxes grow least, and inflates the boxes above it.
std::uint32_t BoxTree::leafFor(const Bounds& bounds) {
  std::uint32_t index = root_;
  while (!nodes_[index].leaf) {
    Branch& node = nodes_[index];
    unsigned best = 0;
    double least = kInfinity, size = kInfinity;
    for (unsigned i = 0; i < node.count; ++i) {
      const double now = cost(node.at(i)), growth = cost(unite(node.at(i), bounds)) - now;
      if (growth > least || (growth == least && now >= size)) continue;
      best = i;
      least = growth;
      size = now;
    }
    node.set(best, unite(node.at(best), bounds));
    index = node.child[best];
  }
  return index;
}

void BoxTree::addTo(std::uint32_t index, const Entry& entry) {
  Branch& node = nodes_[index];
  if (node.count == kLanes) return split(index, entry);
  put(index, node.count, entry);
  ++node.count;
}

/// Makes two nodes of nine boxes. They are sorted along x or y and divided where the two boxes around them cost least.
void BoxTree::split(std::uint32_t index, const Entry& entry) {
  constexpr int kAll = kLanes + 1, kFewest = 3;
  Entry entries[kAll], best[kAll];
  for (unsigned i = 0; i < kLanes; ++i) entries[i] = {nodes_[index].at(i), nodes_[index].child[i]};
  entries[kLanes] = entry;
  double least = kInfinity;
  int count = kAll / 2;
  for (const bool along_x : {true, false}) {
    const auto middle = [&](const Entry& e) {
      return along_x ? middleOf(e.bounds.min_x, e.bounds.max_x) : middleOf(e.bounds.min_y, e.bounds.max_y);
    };
    std::sort(entries, entries + kAll, [&](const Entry& p, const Entry& q) { return middle(p) < middle(q); });
    Bounds from_end[kAll];
    from_end[kAll - 1] = entries[kAll - 1].bounds;
    for (int i = kAll - 1; i-- > 0;) from_end[i] = unite(entries[i].bounds, from_end[i + 1]);
    Bounds from_start = entries[0].bounds;
    for (int i = 1; i < kAll; ++i) {
      const double sum = cost(from_start) + cost(from_end[i]);
      if (i >= kFewest && i <= kAll - kFewest && sum < least) {
        least = sum;
        count = i;
        std::copy(entries, entries + kAll, best);
      }
      from_start = unite(from_start, entries[i].bounds);
    }
  }
  const std::uint32_t other = newNode(nodes_[index].leaf);
  Branch &first = nodes_[index], &second = nodes_[other];
  for (unsigned i = 0; i < kLanes; ++i) first.set(i, kNothing);
  first.count = static_cast<std::uint8_t>(count);
  second.count = static_cast<std::uint8_t>(kAll - count);
  for (int i = 0; i < count; ++i) put(index, static_cast<unsigned>(i), best[i]);
  for (int i = count; i < kAll; ++i) put(other, static_cast<unsigned>(i - count), best[i]);
  if (index == root_) {
    root_ = newNode(false);
    nodes_[root_].count = 2;
    put(root_, 0, {first.all(), index});
    put(root_, 1, {second.all(), other});
  } else {
    nodes_[first.parent].set(first.lane, first.all());
    addTo(first.parent, {second.all(), other});
  }
}

/// Shrinks the boxes around a node, up to the root, after a box has been taken from it.
void BoxTree::tighten(std::uint32_t index) {
  while (index != root_) {
    const Branch& node = nodes_[index];
    const Bounds all = node.all(), was = nodes_[node.parent].at(node.lane);
    if (all.contains(was)) return;
    nodes_[node.parent].set(node.lane, all);
    index = node.parent;
  }
}

void BoxTree::takeFrom(std::uint32_t index, unsigned lane) {
  Branch& node = nodes_[index];
  const unsigned last = node.count - 1u;
  if (lane != last) put(index, lane, {node.at(last), node.child[last]});
  node.set(last, kNothing);
  --node.count;
  if (index == root_) {
    while (!nodes_[root_].leaf && nodes_[root_].count == 1) {
      const std::uint32_t old = root_;
      root_ = nodes_[old].child[0];
      nodes_[root_].parent = kNone;
      free_.push_back(old);
    }
    return;
  }
  if (node.count > 0) return tighten(index);
  const std::uint32_t parent = node.parent, own = node.lane;
  free_.push_back(index);
  takeFrom(parent, own);
}

void BoxTree::reserveNodes(std::size_t more) {
  const std::size_t before = nodes_.size();
  free_.reserve(before + more);
  nodes_.reserve(before + more);
  nodes_.resize(before + more);
  for (std::size_t i = before + more; i-- > before;) free_.push_back(static_cast<std::uint32_t>(i));
}

/// Reserves memory for an insertion, which makes at most one new node a level, so that nothing throws half-way.
void BoxTree::reserveFor(std::uint32_t item) {
  if (free_.size() < kLevels) reserveNodes(std::max<std::size_t>(kLevels, nodes_.size() / 2));
  if (item >= places_.size())
    places_.resize(std::max<std::size_t>(item + std::size_t{1}, places_.size() * 3 / 2), kNone);
}

void BoxTree::insert(std::uint32_t item, const Bounds& bounds) {
  reserveFor(item);
  ++changes_;
  if (root_ == kNone) root_ = newNode(true);
  addTo(leafFor(bounds), {bounds, item});
}

void BoxTree::remove(std::uint32_t item) {
  const std::uint32_t place = places_[item];
  places_[item] = kNone;
  takeFrom(place / kLanes, place % kLanes);
}

void BoxTree::move(std::uint32_t item, const Bounds& bounds) {
  const std::uint32_t index = places_[item] / kLanes, lane = places_[item] % kLanes;
  Branch& node = nodes_[index];
  if (index == root_ || nodes_[node.parent].at(node.lane).contains(bounds)) {
    node.set(lane, bounds);
    return;
  }
  reserveFor(item);
  ++changes_;
  takeFrom(index, lane);
  addTo(leafFor(bounds), {bounds, item});
}

/// Makes a node around the entries of these middles, with `height` levels below it. Rearranges the middles.
std::uint32_t BoxTree::packed(Middle* first, std::size_t count, int height, const std::vector<Entry>& entries) {
  if (free_.empty()) reserveNodes(nodes_.size() / 16 + 1);
  const std::uint32_t index = newNode(height == 0);
  if (height == 0) {
    for (std::size_t i = 0; i < count; ++i) addTo(index, entries[first[i].entry]);
    return index;
  }
  // The fewest children that hold all, of even sizes, so that each is about half full at least.
  const std::size_t most = capacityOf(height - 1);
  packGroups(index, first, count, (count + most - 1) / most, height, entries);
  return index;
}

/// Adds children around the entries to a node. Halves the entries along the longer side of the box around their middles
/// until each half is one child's.
void BoxTree::packGroups(std::uint32_t index, Middle* first, std::size_t count, std::size_t groups, int height,
                         const std::vector<Entry>& entries) {
  if (groups == 1) {
    const std::uint32_t child = packed(first, count, height - 1, entries);
    return addTo(index, {nodes_[child].all(), child});
  }
  Middle low = *first, high = *first;
  for (const Middle* at = first; at < first + count; ++at) {
    low.x = std::min(low.x, at->x), high.x = std::max(high.x, at->x);
    low.y = std::min(low.y, at->y), high.y = std::max(high.y, at->y);
  }
  const std::size_t half = groups / 2, before = count * half / groups;
  Middle* const middle = first + before;
  if (high.x - low.x > high.y - low.y)
    std::nth_element(first, middle, first + count, [](const Middle& p, const Middle& q) { return p.x < q.x; });
  else
    std::nth_element(first, middle, first + count, [](const Middle& p, const Middle& q) { return p.y < q.y; });
  packGroups(index, first, before, half, height, entries);
  packGroups(index, middle, count - before, groups - half, height, entries);
}

void BoxTree::pack(const std::vector<Entry>& entries) {
  BoxTree tree;
  if (!entries.empty()) {
    std::uint32_t last = 0;
    std::vector<Middle> middles;
    middles.reserve(entries.size());
    for (const Entry& entry : entries) {
      const Bounds& b = entry.bounds;
      middles.push_back(
          {middleOf(b.min_x, b.max_x), middleOf(b.min_y, b.max_y), static_cast<std::uint32_t>(middles.size())});
      last = std::max(last, entry.child);
    }
    int height = 0;
    while (capacityOf(height) < entries.size()) ++height;
    tree.places_.resize(last + std::size_t{1}, kNone);
    tree.reserveNodes(entries.size() / (kLanes - 1) + entries.size() / (kLanes * (kLanes - 2)) + 1);
    tree.root_ = tree.packed(middles.data(), middles.size(), height, entries);
  }
  *this = std::move(tree);
}

}  // namespace tricover::detail
