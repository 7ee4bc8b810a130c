// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include <cstddef>

#include "tricover/collide.h"
#include "tricover/export.h"

namespace tricover_fcl {

/// fcl::collide, reaching tricover however the program is linked; other pairs than polygons are handed to FCL. For
/// float and double.
///
/// Exact: gjk_solver_type, gjk_tolerance and the cached guess change nothing. Two polygons at different z don't touch,
/// nor do prisms (PolygonOptions) whose intervals are apart: the doubles of poses and shapes, added and compared
/// exactly. Poses stay in the plane: entries of R that mix z with x or y, and |R_zz| - 1, are at most 1e-6. A half turn
/// about an axis in the plane is a legal, mirrored pose.
///
/// A hit adds fcl::Contacts as long as there are fewer than num_max_contacts: one without details, or with
/// enable_contact one for each connected part of the overlap (tricover::contacts), deepest first: what a step of a
/// simulation needs. pos is in the middle of that part and of the heights that the shapes share, and in the middle of
/// two faces that lie upon each other; normal, a unit vector in the plane, and penetration_depth are those of that part
/// and the edges around it (tricover::ContactDetail::LocalDepth); b1 and b2 are edges (tricover::Contact::edge_a,
/// edge_b). As long as num_max_contacts is above the number of parts, a part where two edges face each other along an
/// interval gives two contacts, the ends of that interval (tricover::Contact::points), and one more before them where
/// the part is deeper elsewhere: one of them has the part's depth. Where num_max_contacts is 1,
/// FCL's default, that contact is the way to part the polygons altogether (tricover::penetration), which costs more
/// unless both are convex. Depths are in the plane, and those of the polygons grown by their margins (and by
/// options.margin); so is pos. With margins, and beside discs and stadiums (below), that translation separates polygons
/// that aren't convex for certain, and may be longer than the shortest. Where only margins meet, it is between the
/// nearest points, along which the normal points.
///
/// Other geometries: a polygon may have any rigid pose in space, and so may a geometry of FCL's own. They collide if
/// and only if they share a point within the polygon's plane (a prism's heights), decided in the polygon's frame, where
/// the geometry is cut by them and seen along z. A geometry that touches is always a hit. A false alarm is possible
/// - for box, convex, plane, halfspace, triangles and octree cells, where they come within 1e-13 of their size and
///   distance: the relative pose is rounded, and its rounding counts as contact;
/// - for ellipsoid, cone, and tilted capsules and cylinders, where they come within 1e-4 of the geometry's size: they
///   are seen as one fixed polygon around their section, of a few hundred edges.
/// Spheres, cylinders upright on the polygon, and capsules that stand or lie on it (to 1e-10 of their size) or whose
/// axis is within the prism's heights are discs and stadiums: exact ones, if the polygon lies level in the world and
/// its heights hold the geometry's centre or axis; otherwise the section's radius is rounded up, and the relative pose
/// as above. A sphere is one whatever the rounding of its pose's rotation. Meshes are surfaces without an inside and
/// cost a pass over their triangles; of octrees the occupied cells count. Contacts are as above, in the middle of the
/// heights that the prism and the geometry share, `depth` at most 1e-4 of a round geometry's size above the truth where
/// it is no disc or stadium; b1 or b2 of a mesh is its triangle and of an octree its cell, otherwise NONE. A plane or
/// halfspace parallel to the polygon is left along its own normal. CollideOptions: margin and touching count, tolerance
/// changes nothing.
///
/// \throws std::invalid_argument for a pose that isn't rigid or finite, and for one of two polygons' that leaves the
/// plane. The text calls the first object's pose_a, the second's pose_b.
/// \throws std::logic_error for a polygon beside fcl::TriangleP, which shares its node type, or beside a geometry of no
/// type that FCL knows; and for a complement beside other geometries than polygons, spheres, cylinders and capsules
///
/// \snippet fcl.cpp fcl collide
template <typename S>
TRICOVER_EXPORT std::size_t collide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                                    const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result);

/// The same for two objects, where they are.
template <typename S>
TRICOVER_EXPORT std::size_t collide(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                                    const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result);

/// The same with what tricover::collide takes. The shapes' margins come on top of options.margin, and the sum decides:
/// either may be negative. Touching::Allowed is about the plane: heights that touch are shared, and beside geometries
/// whose relative pose is rounded (see above) what touches up to that rounding may count as either. A broadphase
/// manager knows nothing of options: its boxes include the shapes' own margins only.
///
/// \throws std::invalid_argument for a margin that is not finite, for a tolerance that is negative or not finite, and
/// for a value that Touching doesn't have \throws std::logic_error if neither is a polygon
///
/// \snippet fcl.cpp fcl collide with options
template <typename S>
TRICOVER_EXPORT std::size_t collide(const fcl::CollisionGeometry<S>* o1, const fcl::Transform3<S>& tf1,
                                    const fcl::CollisionGeometry<S>* o2, const fcl::Transform3<S>& tf2,
                                    const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                                    fcl::CollisionResult<S>& result);

/// The same for two objects, where they are.
template <typename S>
TRICOVER_EXPORT std::size_t collide(const fcl::CollisionObject<S>* o1, const fcl::CollisionObject<S>* o2,
                                    const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                                    fcl::CollisionResult<S>& result);

/// fcl::DefaultCollisionFunction on top of it, for any broadphase manager: `data` is an fcl::DefaultCollisionData<S>.
/// \snippet fcl.cpp fcl collide callback
template <typename S>
TRICOVER_EXPORT bool defaultCollisionFunction(fcl::CollisionObject<S>* o1, fcl::CollisionObject<S>* o2, void* data);

}  // namespace tricover_fcl
