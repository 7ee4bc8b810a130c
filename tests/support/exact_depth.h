// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/polygon.h"
#include "tricover/pose.h"

/// How far a part sticks out of an area, and how deep regions are in each other. The target's borders and where the
/// part is outside of it are exact; distances are long doubles.
namespace tricover::exact {

/// The truth is between them: a point of the part has the lower one, and no point the upper one. Both are 0 exactly
/// where no point of the part is outside of the target, and infinity where the part has no end.
struct Bracket {
  long double low, high;
};

/// How far the farthest point of the part is from the area: by halving triangles, best first.
Bracket excess(const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area);
/// How far the deepest point of the part is from the closure of what is outside of the region.
Bracket depthIn(const Polygon& part, const Pose& pose_part, const Polygon& region, const Pose& pose_region);
/// The larger one of either in the other.
Bracket depth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// The largest distance at a vertex or crossing, at a point of an edge equally far from two features of the border, or
/// at a point equally far from three: a lower bound that is the truth, without a proof. For some ten edges each.
long double excessByCandidates(const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area);
long double depthByCandidates(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// Whether a point of one region is in the other one's interior, which depths above 0 mean. Exact.
bool reachInto(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

}  // namespace tricover::exact
