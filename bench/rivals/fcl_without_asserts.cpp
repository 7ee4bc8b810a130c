// SPDX-License-Identifier: BSD-3-Clause
// The packaged libfcl has its asserts on. These definitions, compiled with our flags, come before libfcl's when the
// program is linked, so that the rivals run without them: all that is a template on their ways, from the call down.
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/epa.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk_libccd.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_box.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_sphere.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_conservative_advancement_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>

namespace fcl {

template class CollisionObject<double>;
template struct CollisionRequest<double>;
template struct CollisionResult<double>;
template struct Contact<double>;

// GJK and MPR
template class Convex<double>;
template struct detail::GJK<double>;
template struct detail::MinkowskiDiff<double>;
template class detail::Project<double>;
template class detail::GJKInitializer<double, Convex<double>>;
template bool detail::GJKCollide<double>(void*, ccd_support_fn, ccd_center_fn, void*, ccd_support_fn, ccd_center_fn,
                                         unsigned int, double, Vector3d*, double*, Vector3d*);
template bool detail::GJKDistance<double>(void*, ccd_support_fn, void*, ccd_support_fn, unsigned int, double, double*,
                                          Vector3d*, Vector3d*);

// round shapes and boxes
#define TRICOVER_INSTANTIATE(Shape) \
  template class Shape<double>;     \
  template class detail::GJKInitializer<double, Shape<double>>;
TRICOVER_INSTANTIATE(Box)
TRICOVER_INSTANTIATE(Capsule)
TRICOVER_INSTANTIATE(Cylinder)
TRICOVER_INSTANTIATE(Sphere)
#undef TRICOVER_INSTANTIATE
template struct detail::EPA<double>;
template bool detail::sphereSphereIntersect(const Sphere<double>&, const Transform3<double>&, const Sphere<double>&,
                                            const Transform3<double>&, std::vector<ContactPoint<double>>*);
template bool detail::sphereSphereDistance(const Sphere<double>&, const Transform3<double>&, const Sphere<double>&,
                                           const Transform3<double>&, double*, Vector3<double>*, Vector3<double>*);
template bool detail::sphereBoxIntersect(const Sphere<double>&, const Transform3<double>&, const Box<double>&,
                                         const Transform3<double>&, std::vector<ContactPoint<double>>*);
template bool detail::sphereBoxDistance(const Sphere<double>&, const Transform3<double>&, const Box<double>&,
                                        const Transform3<double>&, double*, Vector3<double>*, Vector3<double>*);

// motions
template class InterpMotion<double>;

// BVH
template class OBB<double>;
template class RSS<double>;
template class OBBRSS<double>;
template bool obbDisjoint(const Matrix3<double>&, const Vector3<double>&, const Vector3<double>&,
                          const Vector3<double>&);
template class detail::Intersect<double>;
template class detail::TraversalNodeBase<double>;
template class detail::CollisionTraversalNodeBase<double>;
template class detail::MeshCollisionTraversalNodeOBBRSS<double>;
template bool detail::initialize(MeshCollisionTraversalNodeOBBRSS<double>&, const BVHModel<OBBRSS<double>>&,
                                 const Transform3<double>&, const BVHModel<OBBRSS<double>>&, const Transform3<double>&,
                                 const CollisionRequest<double>&, CollisionResult<double>&);
template void detail::collide(CollisionTraversalNodeBase<double>*, BVHFrontList*);
template void detail::collisionRecurse(CollisionTraversalNodeBase<double>*, int, int, BVHFrontList*);

// distances and conservative advancement of BVH
template double rectDistance(const Matrix3<double>&, const Vector3<double>&, const double[2], const double[2],
                             Vector3<double>*, Vector3<double>*);
template class detail::TriangleDistance<double>;
template class detail::DistanceTraversalNodeBase<double>;
template class detail::MeshDistanceTraversalNodeRSS<double>;
template bool detail::initialize(MeshDistanceTraversalNodeRSS<double>&, const BVHModel<RSS<double>>&,
                                 const Transform3<double>&, const BVHModel<RSS<double>>&, const Transform3<double>&,
                                 const DistanceRequest<double>&, DistanceResult<double>&);
template class detail::MeshConservativeAdvancementTraversalNodeRSS<double>;
template class detail::MeshConservativeAdvancementTraversalNodeOBBRSS<double>;
template class TriangleMotionBoundVisitor<double>;
template void detail::distance(DistanceTraversalNodeBase<double>*, BVHFrontList*, int);
template void detail::distanceRecurse(DistanceTraversalNodeBase<double>*, int, int, BVHFrontList*);
}  // namespace fcl
