// SPDX-License-Identifier: BSD-3-Clause
// The packaged libfcl has its asserts on. These definitions, compiled with our flags, come before libfcl's when the
// program is linked, so that the rivals run without them.
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk_libccd.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>

template struct fcl::detail::GJK<double>;
template struct fcl::detail::MinkowskiDiff<double>;
template class fcl::detail::GJKInitializer<double, fcl::Convex<double>>;
template bool fcl::detail::GJKCollide<double>(void*, ccd_support_fn, ccd_center_fn, void*, ccd_support_fn,
                                              ccd_center_fn, unsigned int, double, fcl::Vector3d*, double*,
                                              fcl::Vector3d*);
template class fcl::detail::Intersect<double>;
template class fcl::OBB<double>;
template class fcl::detail::MeshCollisionTraversalNodeOBBRSS<double>;
