// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/location.h"
#include "tricover/polygon.h"

namespace tricover {

/// Where `point`, in the polygon's own frame, lies. Exact for every finite point.
///
/// This is the paper's Algorithm 1: the signs of the covering triangles that hold the point are summed, and the
/// polygon's fill rule says what the sum means. The first few points ask all edges, O(n); then a hierarchy is built,
/// and typically it takes O(log n + k), where k counts the edges near a ray from the point. After some thousand points
/// a polygon of 64 vertices and more has a field of influence lengths, of which a look, O(1), tells of a point that
/// isn't beside an edge. That serves all points, where the paper's Algorithm 2 compares a moving point's signs.
///
/// \throws std::invalid_argument for a point that is not finite
///
/// \snippet locate.cpp locate
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point);

/// Returns where `point`, in the world, lies in the polygon under a pose. Exact: turning the point back by hand would
/// round it.
///
/// \throws std::invalid_argument for a pose that checkPose() refuses, and for a point that is not finite
///
/// \snippet locate.cpp locate in the world
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Pose& pose, const Vec2& point);

}  // namespace tricover
