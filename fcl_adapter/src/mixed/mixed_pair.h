// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "shadow/shadow.h"
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
  Plane plane;  ///< maps points of the polygon, the middle of its heights being z = 0, to the world
  View view;

  const tricover::Polygon& polygon() const { return shape.polygon(); }
};

/// A polygon and a shadow in its frame, as contactsOf() and overlapOf() ask.
struct ShadowPair {
  const tricover::Polygon& polygon;
  const Shadow& shadow;
  const double margin_a;  ///< the polygon's
  const double margin;    ///< and what else was asked for
  static constexpr double margin_b = 0;

  std::optional<tricover::Penetration> penetration() const { return shadow.penetration(polygon, margin); }
  std::vector<tricover::Contact> contacts(std::size_t most) const { return shadow.contacts(polygon, margin, most); }
  tricover::DistanceResult nearest() const {
    return *shadow.distance(polygon, std::numeric_limits<double>::infinity(), {});
  }
  /// A surface that is met is overlapped, if only touched.
  bool areWithin(double length) const { return shadow.isSurface() || shadow.meets(polygon, length); }
  bool areDeeper(double depth, const tricover::DistanceResult&) const;
};

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
