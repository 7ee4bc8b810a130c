// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/location.h"
#include "tricover/point_cache.h"
#include "tricover/polygon.h"

namespace tricover {

/// Where `point`, in the polygon's own frame, lies. Exact for every finite point.
///
/// This is the paper's Algorithm 1: the signs of the covering triangles that hold the point are summed, and the
/// polygon's fill rule says what the sum means. The first few points ask all edges, O(n); then a hierarchy is built,
/// and typically it takes O(log n + k), where k counts the edges near a ray from the point.
///
/// \throws std::invalid_argument for a point that is not finite
///
/// \snippet locate.cpp locate
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point);

/// The same answer, with coherence. The location changes at edges alone: while the point has moved by less than it was
/// away from them, the inclusion test is skipped. (The paper's Algorithm 2 compares the signs against all edges' lines
/// instead, which costs O(n) a call and is left behind as soon as the point crosses any of them.)
///
/// \snippet locate.cpp locate with cache
TRICOVER_EXPORT Location locate(const Polygon& polygon, const Vec2& point, PointCache& cache);

}  // namespace tricover
