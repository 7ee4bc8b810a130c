// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shadow/shadow.h"
#include "shape/planar_pair.h"
#include "shape/plane.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// A polygon and a geometry of FCL's own, as a row gets them. The polygon may have any pose in space: queries are
/// answered in its own frame, where the other one is seen as its shadow.
template <typename S>
struct MixedPair {
  const PolygonShape<S>& shape;
  const fcl::CollisionGeometry<S>& other;
  bool polygon_first;
  Plane from_polygon;  ///< the polygon's pose
  View view;

  const tricover::Polygon& polygon() const { return shape.polygon(); }
  /// Maps points of the polygon's frame at that height, as z = 0, to the world.
  Plane planeOf(double height) const { return from_polygon * planeAt(height); }
};

/// A polygon and a shadow in its frame; `of_both` is the margin.
inline PlanarPair pairOf(const tricover::Polygon& polygon, const Shadow& shadow, double of_polygon, double of_both) {
  PlanarPair pair(polygon, shadow.region(), of_polygon, 0, of_both);
  pair.pose_a = pair.pose_b = tricover::Pose::Identity();
  pair.has_faces = !shadow.isRound();
  return pair;
}

/// Throws std::invalid_argument, naming it, for a pose that isn't rigid within tricover::kRigidTolerance or isn't
/// finite.
template <typename S>
Plane rigidPose(const fcl::Transform3<S>& transform, const char* name);

/// Throws std::logic_error, naming the operation, if the other geometry isn't one that FCL knows, and
/// what rigidPose() throws of pose_a (the first geometry's) or pose_b.
template <typename S>
MixedPair<S> mixedPair(const char* operation, const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                       const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2);

}  // namespace tricover_fcl
