// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <optional>

#include "shadow/stadium.h"
#include "shape/planar_pair.h"
#include "shape/plane.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// What becomes of a question about a polygon and another geometry: that is no stadium in the polygon's plane, or it
/// doesn't reach the polygon's heights.
enum class StadiumCase { None, OutOfSlab, Pair };

/// A polygon, `a`, and a geometry that is a disc or a stadium in the polygon's plane, as a segment, `b`, with a margin,
/// its radius: so the kernel answers, exactly, without an outline.
template <typename S>
class StadiumPair : public PlanarPair {
 public:
  /// `more` is a length added to the margin, upwards. Throws what mixedPair() throws for a pose.
  StadiumPair(bool is_polygon_first, const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2, double more = 0);

  StadiumPair(const StadiumPair&) = delete;  // b is its own
  StadiumPair& operator=(const StadiumPair&) = delete;

  /// The plane in which both poses are, at the middle of the heights that both share.
  Plane plane() const { return is_level_ ? planeAt(height_) : plane_; }
  Eigen::Vector3d inWorld(const tricover::Vec2& p) const {
    return is_level_ ? Eigen::Vector3d(p.x(), p.y(), height_)
                     : Eigen::Vector3d(plane_ * Eigen::Vector3d(p.x(), p.y(), 0));
  }

  const bool polygon_first;
  const PolygonShape<S>& shape;
  StadiumCase found = StadiumCase::None;  ///< what follows is there for a pair alone

 private:
  StadiumPair(bool is_polygon_first, const PolygonShape<S>& polygon, const fcl::Transform3<S>& of_polygon,
              const fcl::Transform3<S>& of_other, double more)
      : PlanarPair(polygon.polygon(), Stadium::point(), polygon.options().margin, 0, more),
        polygon_first(is_polygon_first),
        shape(polygon),
        of_polygon_(of_polygon),
        of_other_(of_other) {}

  /// Where the other one is: in the world's coordinates, exactly, if the polygon lies level, otherwise in its own.
  struct Other {
    Slab slab;  ///< the polygon's
    Eigen::Vector3d center, axis;
    double rounding, rounding_z;  ///< as stadiumOf() has them
  };
  Other place();

  const fcl::Transform3<S>&of_polygon_, &of_other_;
  std::optional<tricover::Polygon> segment_;  ///< none for a disc
  bool is_level_ = true;
  double height_ = 0;  ///< of the plane, if it is level
  Plane plane_;        ///< otherwise; until the heights are known, the polygon's pose
};

}  // namespace tricover_fcl
