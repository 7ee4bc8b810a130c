// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <Eigen/Geometry>
#include <optional>

#include "shape/region.h"

namespace tricover_fcl {

/// The polygon of all discs: the origin.
const tricover::Polygon& originPoint();

/// The sizes of a sphere, capsule, cone or cylinder.
struct RoundSize {
  double radius, half_height;
};

/// Throws std::invalid_argument, naming the class, unless both are finite.
template <typename S>
RoundSize roundSizeOf(const fcl::CollisionGeometry<S>& geometry);

/// The part of a round geometry in a slab, seen along z, where that is a disc or a stadium: a point or a segment with a
/// margin. The heights are those that the geometry and the slab share, kNoHeights where there is none.
struct Stadium {
  Region region;       ///< without a polygon for a segment: that along x around the origin
  double half_length;  ///< of the segment; 0 for a disc
};

/// Of a sphere, wherever it is, a cylinder that stands upright, a capsule that stands or lies, or that is between the
/// slab's sides as far as its axis goes; of others nothing. `center` and `axis` (of the geometry's z) are in the slab's
/// frame. Points that they give are right to `rounding` in the plane, and heights to `rounding_z`: the stadium holds
/// the true shadow, and is no larger where both are 0 and the slab holds the axis.
template <typename S>
std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<S>& geometry, const Eigen::Vector3d& center,
                                 const Eigen::Vector3d& axis, const Slab& slab, double rounding, double rounding_z);

}  // namespace tricover_fcl
