// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <optional>

#include "polygons/pair_cache_table.h"
#include "shape/plane.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// A polygon and a geometry that is a disc or a stadium in the polygon's plane, as a segment with a radius: so the
/// kernel answers, exactly, without an outline.
template <typename S>
struct StadiumPair {
  const PolygonShape<S>& shape;
  bool polygon_first;
  Plane plane;  ///< maps the plane in which both poses are to the world, at the middle of the polygon's heights
  tricover::Pose pose, pose_of_segment;
  tricover::Polygon segment;
  double radius;

  const tricover::Polygon& polygon() const { return shape.polygon(); }

  /// `more` is a length added to the radius, upwards.
  double grown(double more) const { return more == 0 ? radius : (radius + more) * (1 + 0x1p-52); }

  /// Calls ask() with what this thread remembers of the pair at those places, the row's, or without it.
  template <typename Cache, typename Ask>
  auto remembering(const void* place1, const void* place2, const Ask& ask) const {
    Cache* const cache =
        pairCache<Cache>(polygon_first ? polygon() : segment, place1, polygon_first ? segment : polygon(), place2);
    return cache != nullptr ? ask(*cache) : ask();
  }
};

/// What becomes of the question: the other geometry is no stadium there, or it doesn't reach the polygon's heights.
enum class StadiumCase { None, OutOfSlab, Pair };

/// Fills `pair` in the last case. Throws as mixedPair() does.
template <typename S>
StadiumCase stadiumPair(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                        const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                        std::optional<StadiumPair<S>>& pair);

}  // namespace tricover_fcl
