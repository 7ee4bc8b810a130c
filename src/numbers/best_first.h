// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace tricover::detail {

/// Best-first search for the least value: branch and bound. No value in an item is below item.least, and items are
/// ordered as in a std::priority_queue: the one with the smallest `least` is the largest.
template <typename Item>
class BestFirst {
 public:
  explicit BestFirst(double upper_bound) : upper(upper_bound) { items_.reserve(128); }

  void push(Item item) {
    if (item.least >= upper) return;
    items_.push_back(std::move(item));
    std::push_heap(items_.begin(), items_.end());
  }

  /// Expands the best item until the bounds are no farther apart than the error: expand(item) pushes what is left of it
  /// and lowers `upper`. Returns false if isSpent() says first that the budget has ended.
  template <typename IsSpent, typename Expand>
  bool run(double error, IsSpent isSpent, Expand expand) {
    while (!items_.empty() && upper - best().least > error) {
      if (isSpent()) return false;
      std::pop_heap(items_.begin(), items_.end());
      Item item = std::move(items_.back());
      items_.pop_back();
      expand(std::move(item));
    }
    return true;
  }

  double lower() const { return items_.empty() ? upper : std::min(upper, best().least); }
  const Item& best() const { return items_.front(); }
  std::size_t size() const { return items_.size(); }

  double upper;  ///< the least value that was found

 private:
  std::vector<Item> items_;
};

}  // namespace tricover::detail
