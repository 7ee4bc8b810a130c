// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include "tricover/polygon.h"
#include "tricover/pose.h"

/// Penetration depths by brute force on rationals. Shares nothing with the library but the types.
namespace tricover::exact {

/// The length of the shortest translation of b that parts the regions, which overlap; at most `known`. All convolution
/// segments, none left out; of the projections of 0, ends and crossings of two, sorted by length, the first that the
/// exact reference finds a free translation beside: in a sector between the segments, nearer than any other segment and
/// at most 1e-9 of the polygons' size away. O(n^2 m^2) crossings: for small polygons. Segments within 1e-12 of the size
/// are taken for one.
double penetrationDepth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, double known);

/// Its square for two convex rings: the least support gap over the normals of all edges.
mpq_class convexPenetrationSquared(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// The depth of the two convex hulls, rounded: the least over the normals of the ways between any two vertices of one
/// polygon. O(n^3).
double hullDepth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

}  // namespace tricover::exact
