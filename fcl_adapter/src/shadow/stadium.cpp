// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/stadium.h"

#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <cmath>

#include "shape/errors.h"
#include "shape/planar_pose.h"
#include "tricover/segment.h"

namespace tricover_fcl {
namespace {

using Vec3 = Eigen::Vector3d;
using tricover::Polygon;
using tricover::Pose;
using tricover::Vec2;

struct RoundPlace {
  const Vec3 &center, &axis;
  const Slab& slab;
  double rounding, rounding_z;

  /// How far heights within `rise` of the centre's are from the slab, at least; 0 if it may hold one.
  double outside(double rise) const {
    return std::max({slab.low - center.z() - rise - rounding_z, center.z() - rise - slab.high - rounding_z, 0.0});
  }
  /// The heights within `rise` of the centre's that the slab shares.
  Slab heights(double rise) const { return Slab{center.z() - rise, center.z() + rise}.sharedWith(slab); }
};

/// The radius of a ball's section at `height` from its centre; exactly `radius` at 0.
double section(double radius, double height) {
  return height == 0 ? radius : std::sqrt((radius - height) * (radius + height)) * (1 + 0x1p-50);
}

/// Around all balls of that radius with centres on the axis, as far as half_length from the geometry's own.
std::optional<Stadium> ofBalls(double radius, double half_length, const RoundPlace& place) {
  const Vec3 &center = place.center, &axis = place.axis;
  if (half_length == 0) {
    const double least = place.outside(0);
    return Stadium{least <= radius,      center.head<2>(), Vec2::UnitX(), 0, section(radius, least) + place.rounding,
                   place.heights(radius)};
  }
  const double rise = half_length * std::abs(axis.z()), slope = axis.head<2>().norm(), run = half_length * slope;
  const double finest = Stadium::kError * (radius + half_length);
  const double least = place.outside(rise);
  if (!(least <= radius)) return Stadium{false, Vec2::Zero(), Vec2::UnitX(), 0, 0, {}};
  const double widest = section(radius, least);
  const Slab heights = place.heights(rise + radius);
  if (run <= finest) return Stadium{true, center.head<2>(), Vec2::UnitX(), 0, widest + run + place.rounding, heights};

  const bool in_slab = center.z() - rise >= place.slab.low && center.z() + rise <= place.slab.high;
  const bool lies = rise <= finest;
  if (!in_slab && !lies) return std::nullopt;
  // All sections of what lies are alike, but for its rise.
  const double most = least + 2 * rise + 2 * place.rounding_z;
  if (least > 0 && !(most < radius && widest - section(radius, most) <= finest)) return std::nullopt;
  // The axis as it is written is as long as the poses' errors leave it: the length stays that of the geometry.
  const bool level = lies && std::abs(slope - 1) <= 0.49 * tricover::kRigidTolerance;
  return Stadium{true,
                 center.head<2>(),
                 level ? Vec2(axis.head<2>()) : Vec2(axis.head<2>() / slope),
                 level ? half_length : run,
                 widest + place.rounding + (level ? 0 : 0x1p-50 * run),
                 heights};
}

/// If it stands upright.
std::optional<Stadium> ofCylinder(double radius, double half_length, const RoundPlace& place) {
  const double slope = place.axis.head<2>().norm();
  if (slope * (half_length + radius) > Stadium::kError * (radius + half_length)) return std::nullopt;
  const double rise = half_length * std::abs(place.axis.z()) + slope * radius;
  return Stadium{
      place.outside(rise) == 0, place.center.head<2>(), Vec2::UnitX(), 0, radius + slope * half_length + place.rounding,
      place.heights(rise)};
}

}  // namespace

void Stadium::setPose(Pose& pose) const {
  const Vec2 across(-direction.y(), direction.x());
  setColumns(pose, direction.data(), across.data(), center.data());
}

const Polygon& Stadium::point() {
  // Never destroyed: destructors of static objects may still ask.
  static const Polygon& point = *new Polygon(tricover::point(Vec2::Zero()));
  return point;
}

Polygon Stadium::segment() const {
  return half_length == 0 ? point() : tricover::segment({-half_length, 0}, {half_length, 0});
}

template <typename S>
std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<S>& geometry, const Vec3& center, const Vec3& axis,
                                 const Slab& slab, double rounding, double rounding_z) {
  const RoundPlace place{center, axis, slab, rounding, rounding_z};
  const auto sizes = [&](S radius, S length) {
    const Vec2 both(static_cast<double>(radius), 0.5 * static_cast<double>(length));
    if (!both.allFinite()) refuse(className(typeid(geometry)), "a radius or its length is not finite");
    return both;
  };
  switch (geometry.getNodeType()) {
    case fcl::GEOM_SPHERE: {
      const Vec2 size = sizes(static_cast<const fcl::Sphere<S>&>(geometry).radius, 0);
      return ofBalls(size.x(), 0, place);
    }
    case fcl::GEOM_CAPSULE: {
      const auto& capsule = static_cast<const fcl::Capsule<S>&>(geometry);
      const Vec2 size = sizes(capsule.radius, capsule.lz);
      return ofBalls(size.x(), size.y(), place);
    }
    case fcl::GEOM_CYLINDER: {
      const auto& cylinder = static_cast<const fcl::Cylinder<S>&>(geometry);
      const Vec2 size = sizes(cylinder.radius, cylinder.lz);
      return ofCylinder(size.x(), size.y(), place);
    }
    default:
      return std::nullopt;
  }
}

template std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<float>&, const Vec3&, const Vec3&, const Slab&,
                                          double, double);
template std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<double>&, const Vec3&, const Vec3&, const Slab&,
                                          double, double);

}  // namespace tricover_fcl
