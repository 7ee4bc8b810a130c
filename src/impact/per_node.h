// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "impact/moving_pair.h"

namespace tricover::detail {

/// Something of the nodes of a mover's hierarchy, each made when it is first asked for.
template <typename Value>
class PerNode {
 public:
  explicit PerNode(const Mover& mover) : slots_(mover.tree->blocks.size() * kLanes + 1, 0) {}

  /// make(): the value of a node that has none yet. The reference holds until the next call.
  template <typename Make>
  const Value& of(std::uint32_t index, Make make) {
    std::uint32_t& slot = slots_[index == kRootNode ? slots_.size() - 1 : index];
    if (slot == 0) {
      values_.push_back(make());
      slot = static_cast<std::uint32_t>(values_.size());
    }
    return values_[slot - 1];
  }

 private:
  std::vector<std::uint32_t> slots_;  ///< of blocks' lanes and the root, one more than where in values_; 0: not yet
  std::vector<Value> values_;
};

}  // namespace tricover::detail
