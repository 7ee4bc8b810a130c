// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/stadium.h"

#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <cmath>

#include "shape/errors.h"
#include "shape/planar_pose.h"
#include "tricover/polygon.h"

namespace tricover_fcl {
namespace {

using Vec3 = Eigen::Vector3d;
using tricover::Vec2;

/// A shadow is taken for the stadium around it if that is larger by at most this share of its reach: a tilt, or a
/// height, by a rounding. It is a part of the error that is documented for round geometries.
constexpr double kError = 1e-10;

struct RoundPlace {
  const Vec3 &center, &axis;
  const Slab& slab;
  double rounding, rounding_z;

  std::optional<Stadium> stadium(const Vec2& direction, double half_length, double radius, const Slab& heights) const {
    std::optional<Stadium> stadium(std::in_place);
    const Vec2 across(-direction.y(), direction.x());
    setColumns(stadium->region.pose, direction.data(), across.data(), center.data());
    stadium->region.polygon = half_length == 0 ? &originPoint() : nullptr;
    stadium->region.margin = radius;
    stadium->region.heights = {0, heights};
    stadium->half_length = half_length;
    return stadium;
  }
  std::optional<Stadium> disc(double radius, const Slab& heights) const {
    return stadium(Vec2::UnitX(), 0, radius, heights);
  }
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
  const double rise = half_length * std::abs(axis.z()), slope = axis.head<2>().norm(), run = half_length * slope;
  const double finest = kError * (radius + half_length);
  const double least = place.outside(rise);
  if (!(least <= radius)) return place.disc(0, kNoHeights);
  const double widest = section(radius, least);
  const Slab heights = place.heights(rise + radius);
  if (run <= finest) return place.disc(widest + run + place.rounding, heights);

  const bool in_slab = center.z() - rise >= place.slab.low && center.z() + rise <= place.slab.high;
  const bool lies = rise <= finest;
  if (!in_slab && !lies) return std::nullopt;
  // All sections of what lies are alike, but for its rise.
  const double most = least + 2 * rise + 2 * place.rounding_z;
  if (least > 0 && !(most < radius && widest - section(radius, most) <= finest)) return std::nullopt;
  // The axis as it is written is as long as the poses' errors leave it: the length stays that of the geometry.
  const bool level = lies && std::abs(slope - 1) <= 0.49 * tricover::kRigidTolerance;
  return place.stadium(level ? Vec2(axis.head<2>()) : Vec2(axis.head<2>() / slope), level ? half_length : run,
                       widest + place.rounding + (level ? 0 : 0x1p-50 * run), heights);
}

/// If it stands upright.
std::optional<Stadium> ofCylinder(double radius, double half_length, const RoundPlace& place) {
  const double slope = place.axis.head<2>().norm();
  if (slope * (half_length + radius) > kError * (radius + half_length)) return std::nullopt;
  const double rise = half_length * std::abs(place.axis.z()) + slope * radius;
  return place.disc(radius + slope * half_length + place.rounding,
                    place.outside(rise) == 0 ? place.heights(rise) : kNoHeights);
}

}  // namespace

const tricover::Polygon& originPoint() {
  // Never destroyed: destructors of static objects may still ask.
  static const tricover::Polygon& point = *new tricover::Polygon(tricover::Polygon::point(Vec2::Zero()));
  return point;
}

template <typename S>
RoundSize roundSizeOf(const fcl::CollisionGeometry<S>& geometry) {
  const auto size = [&](S radius, S length) -> RoundSize {
    if (!std::isfinite(radius) || !std::isfinite(length))
      refuse(className(typeid(geometry)), "a radius or its length is not finite");
    return {static_cast<double>(radius), 0.5 * static_cast<double>(length)};
  };
  const auto sizeOf = [&](const auto& shape) { return size(shape.radius, shape.lz); };
  switch (geometry.getNodeType()) {
    case fcl::GEOM_SPHERE:
      return size(static_cast<const fcl::Sphere<S>&>(geometry).radius, 0);
    case fcl::GEOM_CAPSULE:
      return sizeOf(static_cast<const fcl::Capsule<S>&>(geometry));
    case fcl::GEOM_CONE:
      return sizeOf(static_cast<const fcl::Cone<S>&>(geometry));
    default:
      return sizeOf(static_cast<const fcl::Cylinder<S>&>(geometry));
  }
}

template <typename S>
std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<S>& geometry, const Vec3& center, const Vec3& axis,
                                 const Slab& slab, double rounding, double rounding_z) {
  const RoundPlace place{center, axis, slab, rounding, rounding_z};
  const fcl::NODE_TYPE type = geometry.getNodeType();
  if (type != fcl::GEOM_SPHERE && type != fcl::GEOM_CAPSULE && type != fcl::GEOM_CYLINDER) return std::nullopt;
  const auto [radius, half_height] = roundSizeOf(geometry);
  return type == fcl::GEOM_CYLINDER ? ofCylinder(radius, half_height, place) : ofBalls(radius, half_height, place);
}

#define TRICOVER_INSTANTIATE(S)                                                                                      \
  template RoundSize roundSizeOf(const fcl::CollisionGeometry<S>&);                                                  \
  template std::optional<Stadium> stadiumOf(const fcl::CollisionGeometry<S>&, const Vec3&, const Vec3&, const Slab&, \
                                            double, double);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
