// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/continuous_collision_request.h>
#include <fcl/narrowphase/continuous_collision_result.h>

#include "tricover/export.h"
#include "tricover_fcl/fcl_layout.h"

namespace fcl {
/// FCL's function. For float it is a template that each program instantiates. Files that include this header call
/// tricover's copy instead, which follows polygons, because FCL's default solver samples.
template <typename S>
FCL_EXPORT S continuousCollide(const CollisionGeometry<S>*, const MotionBase<S>*, const CollisionGeometry<S>*,
                               const MotionBase<S>*, const ContinuousCollisionRequest<S>&,
                               ContinuousCollisionResult<S>&);
extern template FCL_EXPORT float continuousCollide(const CollisionGeometry<float>*, const MotionBase<float>*,
                                                   const CollisionGeometry<float>*, const MotionBase<float>*,
                                                   const ContinuousCollisionRequest<float>&,
                                                   ContinuousCollisionResult<float>&);
}  // namespace fcl

namespace tricover_fcl {

namespace detail {
/// The library's part of tricover_fcl::registerNarrowphase().
TRICOVER_EXPORT void registerNarrowphase();
/// Says that FCL's function tables for S have our rows, and that the caller sees FCL's types as tricover does.
template <typename S>
struct FilledTables {};

/// The first call fills the tables. From any thread.
/// \throws std::logic_error as checkFclLayout() does
template <typename S>
FilledTables<S> filledTables(const FclLayout& seen);
template <>
TRICOVER_EXPORT FilledTables<float> filledTables(const FclLayout& seen);
template <>
TRICOVER_EXPORT FilledTables<double> filledTables(const FclLayout& seen);
}  // namespace detail

/// Makes fcl::collide, fcl::distance and fcl::continuousCollide answer for PolygonShape: geometries and
/// CollisionObjects, both GJK solver types, both orders, and so every broadphase manager. The first
/// PolygonShape does so by itself, for float the first PolygonShapef. This function adds a check: it queries FCL's
/// public entry points about known polygons. They do not reach tricover, and would answer "free", where libfcl comes
/// before tricover, as in a plugin whose host links libfcl. tricover_fcl::collide, distance and continuousCollide work
/// there, too, and making a PolygonShape doesn't throw. Call it once, from any thread; more calls cost next to nothing.
///
/// Polygons meet polygons in the world's plane, and every other geometry that FCL knows (box, sphere, ellipsoid,
/// capsule, cone, cylinder, convex, plane, halfspace, meshes of all bounding volumes, octrees) in the polygon's own
/// plane, wherever that lies in space: see "other geometries" at collide, distance and continuousCollide.
/// These functions refuse a polygon where FCL would print and answer "free": beside geometries of no type that FCL
/// knows, and fcl::TriangleP, which shares the node type. Pairs without a polygon are answered as by FCL alone.
///
/// \throws std::logic_error as checkFclLayout() does, and if FCL's entry points don't reach tricover. The text says how
/// to link.
///
/// \snippet fcl.cpp register
inline void registerNarrowphase() {
  checkFclLayout();
  detail::registerNarrowphase();
}

}  // namespace tricover_fcl
