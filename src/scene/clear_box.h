// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>

#include "hierarchy/axis_boxes.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// What a body that is large beside the queries learns from them, until it moves: a box along the world's axes that no
/// point of it is in, as large as it finds one. A container's hole is such a box, and what is asked about in it needs
/// no look at the container.
class ClearBox {
 public:
  ClearBox() = default;
  ClearBox(const ClearBox&) {}  // a copy learns anew
  ClearBox(ClearBox&& other) noexcept : known_(other.known_.exchange(nullptr)), tries_(other.tries_.load()) {}
  ClearBox& operator=(ClearBox&& other) noexcept {
    delete known_.exchange(other.known_.exchange(nullptr));
    tries_ = other.tries_.load();
    return *this;
  }
  ~ClearBox() { delete known_.load(); }

  void forget() {
    if (known_.load(std::memory_order_relaxed) != nullptr) delete known_.exchange(nullptr);
    tries_.store(0, std::memory_order_relaxed);
  }

  /// Whether what is in `box` can't meet the body.
  bool holds(const Bounds& box) const {
    const Bounds* known = known_.load(std::memory_order_acquire);
    return known != nullptr && known->min_x < box.min_x && box.max_x < known->max_x && known->min_y < box.min_y &&
           box.max_y < known->max_y;
  }

  /// Whether learn() may be of use.
  bool mayLearn() const {
    return known_.load(std::memory_order_relaxed) == nullptr && tries_.load(std::memory_order_relaxed) < kTries;
  }
  /// Of a body: a polygon with a margin, in a box. Something in the box `seed`, its margin included, was found not to
  /// meet it. Any number of threads may tell.
  void learn(const PolygonData& polygon, const Pose& pose, double margin, const Bounds& body, const Bounds& seed) const;

 private:
  /// So many tries are worth it.
  static constexpr unsigned char kTries = 8;

  mutable std::atomic<const Bounds*> known_{nullptr};
  mutable std::atomic<unsigned char> tries_{0};
};

}  // namespace tricover::detail
