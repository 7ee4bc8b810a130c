// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/common/types.h>

namespace tricover_fcl {

/// A plane in space with coordinates of its own: maps (x, y, 0) to the world.
using Plane = fcl::Transform3<double>;

/// The world's plane at height z.
inline Plane planeAt(double z) { return Plane(fcl::Translation3<double>(0, 0, z)); }

/// The plane z = 0 of a posed body.
template <typename S>
Plane planeOf(const fcl::Transform3<S>& pose) {
  return Plane(pose.matrix().template cast<double>().eval());
}

/// A place in space in the coordinates of a plane. The difference first: far from the world's origin the two may still
/// be near each other.
inline Plane seenFrom(const Plane& plane, const Plane& place) {
  const Eigen::Matrix3d inverse = plane.linear().inverse();
  Plane seen = Plane::Identity();
  seen.linear() = inverse * place.linear();
  seen.translation() = inverse * (place.translation() - plane.translation());
  return seen;
}

}  // namespace tricover_fcl
