// SPDX-License-Identifier: BSD-3-Clause
#include "broadphase/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "shape/is_polygon.h"
#include "shape/planar_pose.h"

namespace tricover_fcl {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Footprint kAnywhere{std::nullopt, -kInfinity, kInfinity};

/// None for a pose that a query about two polygons refuses.
template <typename S>
std::optional<PlanarPose> planarPoseIfAny(const fcl::Transform3<S>& transform) {
  try {
    const PlanarPose pose = planarPose(transform, "pose");
    tricover::detail::requireRigid(pose.pose, "pose");
    return pose;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

template <typename S>
Footprint footprintOfPolygon(const PolygonShape<S>& shape, const fcl::Transform3<S>& transform,
                             const PlanarPose& pose) {
  const PolygonOptions& options = shape.options();
  const Eigen::Matrix3d r = transform.linear().template cast<double>();
  const double reach = static_cast<double>(shape.aabb_radius);  // at least the radius and the largest height
  // Two polygons leave out a tilt within the tolerance. To other geometries it moves the heights sideways, and the
  // polygon's points up and down.
  const double aside = r.topRightCorner<2, 1>().lpNorm<1>();
  Footprint print = kAnywhere;
  print.region.emplace(&shape.polygon(), pose.pose, std::max(options.margin, 0.0));
  if (aside > 0) print.region->margin += 2 * aside * reach;
  if (!std::isfinite(print.region->margin)) print.region.reset();
  if (!shape.isAtAllHeights()) {
    // The rest pays for rounding: of the sums, and where a box that only touches was rounded.
    const double rise = 2 * r.bottomLeftCorner<1, 2>().lpNorm<1>() + std::abs(std::abs(r(2, 2)) - 1);
    const double slack = (rise + 0x1p-48) * reach + 0x1p-48 * std::abs(pose.z);
    print.z_low = pose.z + (pose.upside_down ? -options.z_high : options.z_low) - slack;
    print.z_high = pose.z + (pose.upside_down ? -options.z_low : options.z_high) + slack;
  }
  return print;
}

/// Half the size of a polygon that rectangle() made.
tricover::Vec2 halfOf(const tricover::Polygon& rectangle) { return rectangle.edgeStart(2); }

tricover::Polygon rectangle(const tricover::Vec2& half) {
  return tricover::Polygon({{-half, {half.x(), -half.y()}, half, {-half.x(), half.y()}}});
}

template <typename S>
Footprint footprintOfBox(const fcl::CollisionObject<S>& object, const tricover::Polygon* last) {
  const fcl::AABB<S>&box = object.getAABB(), &local = object.collisionGeometry()->aabb_local;
  const Eigen::Vector3d low = box.min_.template cast<double>(), high = box.max_.template cast<double>();
  const Eigen::Vector3d center = low / 2 + high / 2, half = (high - center).cwiseMax(center - low);
  const double reach = std::max(local.min_.template cast<double>().norm(), local.max_.template cast<double>().norm());
  // FCL rounds boxes to the nearest, and where it takes a rotation for the identity, leaves out as much of it as is
  // below dummy_precision, entry by entry.
  const double pad =
      4 * static_cast<double>(Eigen::NumTraits<S>::dummy_precision()) * reach +
      16 * static_cast<double>(std::numeric_limits<S>::epsilon()) * (center.norm() + half.norm() + reach) +
      static_cast<double>(std::numeric_limits<S>::min());
  if (!(center.norm() + half.norm() + pad < 1e100)) return kAnywhere;
  const tricover::Vec2 need = half.head<2>().array() + pad;
  const bool fits = last != nullptr && (halfOf(*last).array() >= need.array()).all() &&
                    (halfOf(*last).array() <= need.array() + 4 * pad).all();
  tricover::Pose pose = tricover::Pose::Identity();
  pose.translation() = center.head<2>();
  Footprint print{Shadow(last, pose, 0), low.z() - pad, high.z() + pad};
  if (!fits) print.region->made = rectangle(need.array() + 2 * pad);
  return print;
}

}  // namespace

template <typename S>
Footprint footprintOf(const fcl::CollisionObject<S>& object, const tricover::Polygon* last) {
  const fcl::CollisionGeometry<S>& geometry = *object.collisionGeometry();
  if (!isPolygon(geometry)) return footprintOfBox(object, last);
  if (const auto pose = planarPoseIfAny(object.getTransform()))
    return footprintOfPolygon(static_cast<const PolygonShape<S>&>(geometry), object.getTransform(), *pose);
  const bool is_rigid = defectOf(object.getTransform()) <= tricover::kRigidTolerance;
  return is_rigid ? footprintOfBox(object, nullptr) : kAnywhere;
}

template Footprint footprintOf(const fcl::CollisionObject<float>&, const tricover::Polygon*);
template Footprint footprintOf(const fcl::CollisionObject<double>&, const tricover::Polygon*);

}  // namespace tricover_fcl
