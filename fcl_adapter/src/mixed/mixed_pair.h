// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

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
  Plane plane;  ///< maps points of the polygon, the middle of its heights being z = 0, to the world
  View view;

  const tricover::Polygon& polygon() const { return shape.polygon(); }
};

/// A polygon and a shadow in its frame.
struct ShadowPair final : RegionPair {
  ShadowPair(const tricover::Polygon& polygon_, const Shadow& shadow_, double of_polygon, double of_both)
      : RegionPair(of_polygon, 0, of_both), polygon(polygon_), shadow(shadow_) {}

  std::optional<tricover::Penetration> penetration() const override { return shadow.penetration(polygon, margin); }
  std::vector<tricover::Contact> contacts(std::size_t most) const override {
    return shadow.contacts(polygon, margin, most);
  }
  tricover::DistanceResult nearest() const override {
    return *shadow.distance(polygon, std::numeric_limits<double>::infinity(), {});
  }
  bool areWithin(double length) const override { return shadow.isSurface() || shadow.meets(polygon, length); }
  bool areDeeper(double depth, const tricover::DistanceResult&) const override {
    return shadow.isDeeper(polygon, margin, depth);
  }

  const tricover::Polygon& polygon;
  const Shadow& shadow;
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
