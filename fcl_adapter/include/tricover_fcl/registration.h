// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover_fcl/fcl_layout.h"

namespace tricover_fcl {

namespace detail {
/// What the library does of it.
TRICOVER_EXPORT void registerNarrowphase();
/// That FCL's function tables for S have our rows.
template <typename S>
struct FilledTables {};

/// Sees to that, once, and redirects calls that would go past tricover. From any thread.
template <typename S>
FilledTables<S> filledTables();
template <>
TRICOVER_EXPORT FilledTables<float> filledTables();
template <>
TRICOVER_EXPORT FilledTables<double> filledTables();
}  // namespace detail

/// Makes fcl::collide, fcl::distance and fcl::continuousCollide answer for PolygonShape: geometries and
/// CollisionObjects, both GJK solver types, both orders, and so every broadphase manager. The first
/// PolygonShape does so by itself, for float the first PolygonShapef, also where libfcl comes first, as in a plugin
/// whose host links it (Linux on x86-64 and AArch64: what was loaded since is seen to by the next PolygonShape, or by
/// this); what this adds is a check. It asks FCL's public entry points about known polygons and throws
/// std::logic_error, which says how to link, if they don't reach tricover: they would say "free" then.
/// (tricover_fcl::collide, distance and continuousCollide work regardless.) Call it once, from any thread; more calls
/// cost next to nothing.
///
/// Polygons meet polygons in the world's plane, and every other geometry that FCL knows (box, sphere, ellipsoid,
/// capsule, cone, cylinder, convex, plane, halfspace, meshes of all bounding volumes, octrees) in the polygon's own
/// plane, wherever that lies in space: see "other geometries" at collide, distance and continuousCollide.
/// std::logic_error, naming both types, is thrown of a polygon where FCL would print and answer "free": beside
/// geometries of no type that FCL knows, and fcl::TriangleP, which shares the node type. Pairs without a polygon are
/// answered as by FCL alone.
///
/// Calls checkFclLayout() first, which throws std::logic_error if this was compiled with another FCL than tricover.
///
/// \snippet fcl.cpp register
inline void registerNarrowphase() {
  checkFclLayout();
  detail::registerNarrowphase();
}

}  // namespace tricover_fcl
