// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

/// Where a part lies outside of a target region, on exact numbers: by a sweep over the pieces between the crossings of
/// all edges. Shares nothing with the kernel but the types.
namespace tricover::exact {

struct WorldPoint {
  mpq_class x, y;
};
bool operator==(const WorldPoint& p, const WorldPoint& q);

struct WorldSegment {
  WorldPoint v, w;
};

/// The target that distances are measured from.
enum class Target {
  Region,  ///< The region itself, with all its edges.
  Outside  ///< The closure of what is outside of the region, which slits are no part of.
};

struct Overlay {
  /// Triangles that fill the closure of the part less the target; the two ends of a piece of the part's edges there,
  /// the last one twice; a point of the part, three times.
  std::vector<std::array<WorldPoint, 3>> cells;
  /// Outside of the target, the nearest of these is as near as the target.
  std::vector<WorldSegment> border;
  bool is_infinite;  ///< The part is unbounded where the target is bounded.
};

Overlay overlay(const Polygon& part, const Pose& pose_part, const Polygon& region, const Pose& pose_region,
                Target target);

}  // namespace tricover::exact
