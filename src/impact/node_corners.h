// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "impact/moving_pair.h"
#include "impact/per_node.h"
#include "impact/window_cutter.h"

namespace tricover::detail {

/// The vertices below the nodes of a mover, in its frame from S: each node's are gathered when they are first asked
/// for; all of them together cost O(n log n).
class NodeCorners {
 public:
  explicit NodeCorners(const Mover& mover) : mover_(mover), corners_(mover) {}

  /// The reference holds until the next call.
  const std::vector<Vec2>& below(std::uint32_t index);

 private:
  const Mover& mover_;
  PerNode<std::vector<Vec2>> corners_;
};

/// An axis of length 1 that parts what two nodes hold at a window's begin by nearly their hulls' distance; none if that
/// isn't above `least`. By GJK, from a guess on.
std::optional<Vec2> axisBetween(const std::vector<Vec2>& a, const Places& places_a, const std::vector<Vec2>& b,
                                const Places& places_b, const Vec2& guess, double least);

/// The gap of two nodes' corners along an axis at both ends of the window.
Double2 gapAlong(const GapCutter::Axis& axis, const std::vector<Vec2>& a, const Places& places_a,
                 const std::vector<Vec2>& b, const Places& places_b);

}  // namespace tricover::detail
