// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>

#include <cmath>
#include <typeinfo>

#include "shadow/shadow.h"
#include "shape/errors.h"

namespace tricover_fcl {
namespace {

template <typename S>
SmoothBody bodyOf(const fcl::CollisionGeometry<S>& shape) {
  const auto ball = [](S radius) { return Eigen::Vector3d::Constant(static_cast<double>(radius)).eval(); };
  const auto disc = [](S radius) {
    return Eigen::Vector3d(static_cast<double>(radius), static_cast<double>(radius), 0);
  };
  const auto half = [](S length) { return 0.5 * static_cast<double>(length); };
  switch (shape.getNodeType()) {
    case fcl::GEOM_SPHERE: {
      const auto& sphere = static_cast<const fcl::Sphere<S>&>(shape);
      return {0, ball(sphere.radius), ball(sphere.radius)};
    }
    case fcl::GEOM_ELLIPSOID: {
      const Eigen::Vector3d radii = static_cast<const fcl::Ellipsoid<S>&>(shape).radii.template cast<double>();
      return {0, radii, radii};
    }
    case fcl::GEOM_CAPSULE: {
      const auto& capsule = static_cast<const fcl::Capsule<S>&>(shape);
      return {half(capsule.lz), ball(capsule.radius), ball(capsule.radius)};
    }
    case fcl::GEOM_CONE: {
      const auto& cone = static_cast<const fcl::Cone<S>&>(shape);
      return {half(cone.lz), disc(cone.radius), Eigen::Vector3d::Zero()};
    }
    default: {
      const auto& cylinder = static_cast<const fcl::Cylinder<S>&>(shape);
      return {half(cylinder.lz), disc(cylinder.radius), disc(cylinder.radius)};
    }
  }
}

}  // namespace

template <typename S>
std::optional<Shadow> makeSmoothShadow(const fcl::CollisionGeometry<S>& shape, const View& view) {
  const SmoothBody body = bodyOf(shape);
  if (!(std::isfinite(body.half_height) && body.bottom.allFinite() && body.top.allFinite()))
    refuse(className(typeid(shape)), "a radius or its length is not finite");
  const double rounding = mappingError(view.to_polygon, body.reach());
  const Slab slab = grown(view.slab, rounding);
  const Eigen::Vector3d up = view.to_polygon.linear().row(2).transpose();
  const double top = (view.to_polygon * body.support(up)).z(), bottom = (view.to_polygon * body.support(-up)).z();
  if (bottom > slab.high || top < slab.low) return std::nullopt;
  return Shadow(SmoothShadow(body, view.to_polygon, slab, rounding));
}

template std::optional<Shadow> makeSmoothShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeSmoothShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
