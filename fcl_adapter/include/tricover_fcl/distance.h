// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance_request.h>
#include <fcl/narrowphase/distance_result.h>

#include "tricover/export.h"

namespace tricover_fcl {

/// fcl::distance, reaching tricover however the program is linked; other pairs than polygons are handed to FCL. For
/// float and double.
///
/// The distance in space of two flat polygons or prisms: tricover::distance in the plane, whose errors it shares, and
/// the gap between their heights. The polygons, and the nearest points, are those grown by their margins. It is 0 or
/// below exactly where collide() is true. request.rel_err and abs_err are what it may be above the truth by, 0 unless
/// set; distance_tolerance and the solver change nothing. Margins that overlap by less than 1e-13 of themselves count as
/// touching.
/// - result keeps the least of the distances that it is given, with its geometries, its nearest points in the world
///   (nearest_points[0] on o1, always filled), and edges in b1 and b2 (tricover::DistanceResult). Returned is
///   result.min_distance. A pair that is farther apart than that already costs little, and changes nothing.
/// - Polygons that only touch have distance 0, and such as overlap -1 or, with enable_signed_distance, minus the length
///   of the shortest translation in the plane that parts them (tricover::penetration), and as nearest points those on
///   the outlines that part last. (Under GST_INDEP FCL puts their middle in place of both.)
///
/// Other geometries: the distance, less the margin, within the polygon's plane (of a prism, from what its heights cut
/// out, seen along z), which is at least the distance in space, and the same for geometries that stand upright on the
/// plane. It is 0 or below exactly where collide() is true; right to 1e-13 of size and distance, and at most 1e-9 of a
/// round geometry's size above the truth where that isn't a disc or a stadium (see collide()). nearest_points lie in
/// the plane (in the middle of a prism's heights). A geometry that doesn't reach the plane has no such distance: result
/// stays as it was, min_distance at FCL's largest number. Depths are those of collide()'s contacts; up to their error
/// an overlap counts as a touch, except of surfaces (mesh, plane), which without enable_signed_distance answer -1
/// wherever they meet the polygon.
///
/// Throws std::invalid_argument as collide() does, and std::logic_error where FCL would abort: signed distance under
/// GST_INDEP, or to a mesh or octree, of geometries that overlap and aren't both occupied.
///
/// \snippet fcl.cpp fcl distance
template <typename S>
TRICOVER_EXPORT S distance(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                           const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                           const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result);

/// The same for two objects, where they are.
template <typename S>
TRICOVER_EXPORT S distance(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                           const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result);

/// fcl::DefaultDistanceFunction on top of it, for any broadphase manager: `data` is an fcl::DefaultDistanceData<S>.
/// \snippet fcl.cpp fcl distance callback
template <typename S>
TRICOVER_EXPORT bool defaultDistanceFunction(fcl::CollisionObject<S>* o1, fcl::CollisionObject<S>* o2, void* data,
                                             S& distance);

}  // namespace tricover_fcl
