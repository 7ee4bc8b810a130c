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
/// set; distance_tolerance and the solver change nothing.
/// - result keeps the least of the distances that it is given, with its geometries, its nearest points in the world
///   (nearest_points[0] on o1, always filled), and edges in b1 and b2 (tricover::DistanceResult). Returned is
///   result.min_distance. A pair that is farther apart than that already costs little, and changes nothing.
/// - Polygons that only touch have distance 0. Polygons that overlap have -1 or, with enable_signed_distance, minus the
///   length of the shortest translation in the plane that separates them (tricover::penetration), and as nearest points
///   those on the outlines that separate last. (Under GST_INDEP FCL puts their middle in place of both.)
/// - Without margins, -1 is exact: it says that the interiors meet, by however little (tricover::Touching::Allowed) or,
///   of points, segments and other polygons without an interior, that the depth isn't 0. Signed distances are right to
///   the precision of tricover::penetration: an overlap below it may be 0. Margins that overlap by less than 1e-13 of
///   themselves count as touching.
/// - Where no distance is found, because lengths overflow or the other geometry has no point at all (an octree without
///   occupied cells), min_distance stays FCL's largest number and nearest_points are NaN.
///
/// Other geometries that reach the polygon's heights: the distance, less the margin, within the polygon's plane, which
/// is at least the distance in space, and the same for geometries that stand upright on the plane. (Of a prism: from
/// the part of the geometry between its heights, seen along z.) It is 0 or below exactly where collide() is true. It is
/// right to 1e-13 of size and distance. Where a round geometry is neither a disc nor a stadium (see collide()), it is
/// at most 1e-4 of the geometry's size below the truth. nearest_points lie in the middle of the heights that both
/// share. Depths are those of collide()'s contacts; up to their error an overlap counts as a touch, except of surfaces
/// (mesh, plane), which without enable_signed_distance answer -1 wherever they meet the polygon.
///
/// Other geometries above or below the polygon's heights: the distance in space from an upright prism around the
/// geometry, which is its whole shadow along z between its lowest and its highest point. That is at most the distance
/// in space, and the same for geometries that stand upright. nearest_points are those of the two prisms.
///
/// \throws std::invalid_argument as collide() does, and for margins with a negative sum
/// \throws std::logic_error as collide() does, and where FCL would abort: for a signed distance under GST_INDEP, or to
/// a mesh or octree, of geometries that overlap and aren't both occupied
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
