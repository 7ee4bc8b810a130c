// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <Eigen/Geometry>
#include <optional>

#include "shadow/slab_cut.h"
#include "tricover/polygon.h"

namespace tricover_fcl {

/// The part of a round geometry in a slab, seen along z, where that is a disc or a stadium: all points within `radius`
/// of the segment from center - half_length * direction to center + half_length * direction.
struct Stadium {
  bool in_slab;  ///< nothing is, otherwise
  tricover::Vec2 center, direction;
  double half_length;  ///< 0 for a disc
  double radius;
  Slab heights;  ///< those that the geometry and the slab share

  /// The segment along x around the origin, of its length; setPose() puts it where it lies.
  tricover::Polygon segment() const;
  static const tricover::Polygon& point();  ///< the segment of all discs: the origin
  void setPose(tricover::Pose& pose) const;

  /// Of the error documented for round geometries, by how much of its reach a shadow may be taken for a stadium around
  /// it: a tilt, or a height, by a rounding.
  static constexpr double kError = 1e-10;
};

/// Of a sphere, wherever it is, a cylinder that stands upright, a capsule that stands or lies, or that is between the
/// slab's sides as far as its axis goes; of others nothing. `center` and `axis` (of the geometry's z) are in the slab's
/// frame. Points that they give are right to `rounding` in the plane, and heights to `rounding_z`: the stadium holds
/// the true shadow, and is no larger where both are 0 and the slab holds the axis.
template <typename S>
std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<S>& geometry, const Eigen::Vector3d& center,
                                 const Eigen::Vector3d& axis, const Slab& slab, double rounding, double rounding_z);

}  // namespace tricover_fcl
