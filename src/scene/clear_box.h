// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "hierarchy/axis_boxes.h"
#include "polygon/polygon_data.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// A box along the world's axes that no point of a body is in, as large as queries find it. Queries that miss a large
/// body teach it, until it moves. A container's hole is such a box, and queries inside it need no test of the
/// container.
class ClearBox {
 public:
  ClearBox() = default;
  ClearBox(const ClearBox&) {}  // a copy learns afresh
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

  /// Whether no point in `box` is a point of the body.
  bool holds(const Bounds& box) const {
    const Bounds* known = known_.load(std::memory_order_acquire);
    return known != nullptr && known->min_x < box.min_x && box.max_x < known->max_x && known->min_y < box.min_y &&
           box.max_y < known->max_y;
  }

  /// Whether a query that doesn't meet the body, of this shape, may still teach it.
  bool learnsOf(const PolygonData& polygon) const {
    return polygon.path.size() <= kMostEdges && known_.load(std::memory_order_relaxed) == nullptr &&
           tries_.load(std::memory_order_relaxed) < kTries;
  }
  /// Learns from a query that doesn't meet the body. `seed` is the query's box with its margin, `body` the body's box
  /// with the body's own. A body that isn't large beside the query learns nothing. Any number of threads may call this.
  void learn(const PolygonData& polygon, const Pose& pose, double margin, const Bounds& body, const Bounds& seed) const;

 private:
  /// A body stops learning after this number of tries.
  static constexpr unsigned char kTries = 8;
  /// A body of more edges doesn't learn.
  static constexpr std::size_t kMostEdges = 1000;

  mutable std::atomic<const Bounds*> known_{nullptr};
  mutable std::atomic<unsigned char> tries_{0};
};

}  // namespace tricover::detail
