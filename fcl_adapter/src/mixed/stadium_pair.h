// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <optional>
#include <stdexcept>

#include "shadow/stadium.h"
#include "shape/planar_pair.h"
#include "shape/plane.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Says how a query about a polygon and another geometry goes on: that is no stadium in the polygon's plane, or it
/// doesn't reach the polygon's heights.
enum class StadiumCase { None, OutOfSlab, Pair };

/// A polygon, `a`, and a geometry that is a disc or a stadium in the polygon's plane, as a segment, `b`, with a margin,
/// its radius: so the kernel answers, exactly, without an outline.
template <typename S>
class StadiumPair : public PlanarPair {
 public:
  /// `more` is a length added to the margin, upwards. Throws as mixedPair() does, if not before the two are asked.
  StadiumPair(bool is_polygon_first, const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2, double more = 0);

  StadiumPair(const StadiumPair&) = delete;  // b is its own
  StadiumPair& operator=(const StadiumPair&) = delete;

  bool collide() const {
    return named([&] { return PlanarPair::collide(); });
  }
  std::optional<tricover::DistanceResult> distanceWithin(double limit, const tricover::DistanceOptions& options) const {
    return named([&] { return PlanarPair::distanceWithin(limit, options); });
  }
  /// Of both geometries, named in the caller's order.
  void requireRigidPoses() const;

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

  /// The kernel checks both poses, the polygon's being its first.
  template <typename Ask>
  auto named(Ask ask) const {
    try {
      return ask();
    } catch (const std::invalid_argument&) {
      requireRigidPoses();
      throw;
    }
  }

  /// Where the other one is: in the world's coordinates, exactly, if the polygon lies level, otherwise in its own.
  struct Other {
    Slab slab;  ///< the polygon's
    Eigen::Vector3d center, axis;
    double rounding, rounding_z;  ///< as stadiumOf() has them
  };
  /// Of a ball whose centre is between the heights of a polygon that lies level, if it is: all of place() and
  /// stadiumOf() that it needs.
  bool placeBall(double of_radius);
  Other place();
  void setRadius(double radius);

  const fcl::Transform3<S>&of_polygon_, &of_other_;
  std::optional<tricover::Polygon> segment_;  ///< none for a disc
  bool is_level_ = true;
  double height_ = 0;  ///< of the plane, if it is level
  Plane plane_;        ///< otherwise; until the heights are known, the polygon's pose
};

}  // namespace tricover_fcl
