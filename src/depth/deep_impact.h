// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "depth/deepest_point.h"
#include "tricover/depth.h"
#include "tricover/motion.h"
#include "tricover/time_of_impact.h"

namespace tricover::detail {

/// Precisions by which an overlap that is reported may be smaller than the allowed one: what times of impact may take
/// for a touch.
constexpr double kDeepEnough = 1.25;

/// Two moving regions, and how deep points of either may be in the other one; or of b alone, in what a's edges are the
/// borders of.
struct DeepQuestion {
  const Polygon& a;
  const Motion& motion_a;
  const Polygon& b;
  const Motion& motion_b;
  const Polygon &borders_a, &borders_b;  ///< what pieces of the other one are to be apart from
  double allowed;                        ///< a world length, positive
  double precision;                      ///< how far points may be from where they are said to be, a world length
  double speed;                          ///< no point of one region moves faster against the other one
  bool asks_a = false, asks_b = false;   ///< whether points of that region may be deep in the other one

  /// The depth at a time.
  std::function<Depth(double time)> depth = nullptr;
  /// The deepest point of a polygon that moves with a, or with b, in the other region.
  std::function<DeepestPoint(const Polygon& piece, bool of_a, double time)> deepest = nullptr;
  /// The directions away from the edges of the other region that a piece touches: in the world, of length 1.
  std::function<std::vector<Vec2>(const Impact& touch, bool of_a, double time)> away = nullptr;
  /// Whether a polygon in the frame of b, apart from a there, is where none of its points is deep. Null: always.
  std::function<bool(const Polygon& piece, const Pose& pose)> is_free = nullptr;
};

/// The first time at which a point is as deep as is allowed, never late. Time runs from 0 to 1.
std::optional<Impact> findDeepImpact(const DeepQuestion& question);

}  // namespace tricover::detail
