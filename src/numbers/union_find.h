// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tricover::detail {

/// Disjoint sets of numbers, each named by its least one. Paths are halved.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size = 0) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t size() const { return parent_.size(); }
  void reserve(std::size_t size) { parent_.reserve(size); }
  /// A number more, in a set of its own.
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.size() - 1;
  }
  std::size_t find(std::size_t p) {
    while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
    return p;
  }
  void join(std::size_t p, std::size_t q) {
    p = find(p);
    q = find(q);
    parent_[std::max(p, q)] = std::min(p, q);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace tricover::detail
