// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/mixed_pair.h"

#include "shape/bounds.h"
#include "shape/errors.h"
#include "shape/is_polygon.h"
#include "shape/planar_pose.h"

namespace tricover_fcl {

template <typename S>
Plane rigidPose(const fcl::Transform3<S>& transform, const char* name) {
  requireRigid(transform, name);
  return Plane(transform.matrix().template cast<double>().eval());
}

template <typename S>
MixedPair<S> mixedPair(const char* operation, const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2) {
  const bool polygon_first = isPolygon(o1);
  const auto& other = polygon_first ? o2 : o1;
  if (!castsShadow(other)) refusePair(operation, o1, o2);
  const Plane pose1 = rigidPose(tf1, "pose_a"), pose2 = rigidPose(tf2, "pose_b");
  const Plane &of_polygon = polygon_first ? pose1 : pose2, &of_other = polygon_first ? pose2 : pose1;

  const auto& shape = static_cast<const PolygonShape<S>&>(polygon_first ? o1 : o2);
  // The difference first: far from the world's origin the two may still be near each other.
  const Eigen::Matrix3d inverse = of_polygon.linear().inverse();
  Eigen::Affine3d to_polygon;
  to_polygon.linear() = inverse * of_other.linear();
  to_polygon.translation() = inverse * (of_other.translation() - of_polygon.translation());
  const Slab slab{shape.options().z_low, shape.options().z_high};
  return {shape, other, polygon_first, of_polygon, {to_polygon, slab, boundsOf(shape.polygon()), false}};
}

template Plane rigidPose(const fcl::Transform3<float>&, const char*);
template Plane rigidPose(const fcl::Transform3<double>&, const char*);
template MixedPair<float> mixedPair(const char*, const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                    const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&);
template MixedPair<double> mixedPair(const char*, const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                     const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&);

}  // namespace tricover_fcl
