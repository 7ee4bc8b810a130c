// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/stadium_pair.h"

#include <fcl/geometry/shape/sphere.h>

#include <cmath>
#include <limits>

#include "mixed/mixed_pair.h"
#include "shape/planar_pose.h"

namespace tricover_fcl {
namespace {

using Vec3 = Eigen::Vector3d;
using tricover::Pose;
using tricover::detail::requireRigid;

/// Whether it turns about z alone, or upside down, to the last bit, and lifts by what is finite: then the plane's
/// coordinates can be the world's.
template <typename S>
bool isUpright(const fcl::Transform3<S>& pose) {
  return tiltOf(pose) == 0;
}

/// A ball that tilts by less is as rigid as it is in the plane, but for the square of that.
constexpr double kNoTilt = 1e-9;

template <typename S>
Vec3 column(const fcl::Transform3<S>& transform, int i) {
  return transform.matrix().col(i).template head<3>().template cast<double>();
}

/// The heights of a shape whose pose is upright.
template <typename S>
Slab slabOf(const PolygonOptions& shape, const fcl::Transform3<S>& pose) {
  if (pose.matrix()(2, 2) < 0) return {-shape.z_high, -shape.z_low};
  return {shape.z_low, shape.z_high};
}

bool isRound(fcl::NODE_TYPE type) {
  return type == fcl::GEOM_SPHERE || type == fcl::GEOM_CYLINDER || type == fcl::GEOM_CAPSULE;
}

}  // namespace

template <typename S>
void StadiumPair<S>::requireRigidPoses() const {
  tricover_fcl::requireRigid(of_other_, polygon_first ? "pose_b" : "pose_a");
  tricover_fcl::requireRigid(of_polygon_, polygon_first ? "pose_a" : "pose_b");
}

template <typename S>
typename StadiumPair<S>::Other StadiumPair<S>::place() {
  const PolygonOptions& options = shape.options();
  Other other{{options.z_low, options.z_high}, column(of_other_, 3), column(of_other_, 2), 0, 0};
  is_level_ = isUpright(of_polygon_);
  if (is_level_) {
    const auto z = static_cast<double>(of_polygon_.matrix()(2, 3));
    setPlanarPart(pose_a, of_polygon_);
    other.slab = slabOf(options, of_polygon_);
    height_ = z;
    other.rounding_z = 0x1p-50 * (std::abs(z) + std::abs(other.center.z()));
    other.center.z() -= z;
  } else {
    const Plane from = rigidPose(of_polygon_, polygon_first ? "pose_a" : "pose_b");
    const Eigen::Matrix3d inverse = from.linear().inverse();
    plane_ = from;
    pose_a = Pose::Identity();
    other.center = inverse * (other.center - from.translation());
    other.axis = inverse * other.axis;
    other.rounding = other.rounding_z = kMappingError * other.center.stableNorm() + 0x1p-1066;
  }
  return other;
}

template <typename S>
bool StadiumPair<S>::placeBall(double of_radius) {
  // In the plane it may turn with its pose, so that the kernel checks that.
  if (!(isUpright(of_polygon_) && tiltOf(of_other_) <= kNoTilt && of_radius >= 0 &&
        of_radius <= std::numeric_limits<double>::max()))
    return false;
  const Slab slab = slabOf(shape.options(), of_polygon_);
  const auto z = static_cast<double>(of_polygon_.matrix()(2, 3)),
             rise = static_cast<double>(of_other_.matrix()(2, 3)) - z;
  if (!(rise >= slab.low && rise <= slab.high)) return false;
  found = StadiumCase::Pair;
  setPlanarPart(pose_a, of_polygon_);
  setPlanarPart(pose_b, of_other_);
  height_ = z + Slab{rise - of_radius, rise + of_radius}.sharedWith(slab).middle();
  setRadius(of_radius);
  return true;
}

template <typename S>
void StadiumPair<S>::setRadius(double radius) {
  margin_b = radius;
  const double beside = margin + margin_a;
  margin = beside == 0 ? radius : (radius + beside) * (1 + 0x1p-52);
}

template <typename S>
StadiumPair<S>::StadiumPair(bool is_polygon_first, const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2, double more)
    : StadiumPair(is_polygon_first, static_cast<const PolygonShape<S>&>(is_polygon_first ? o1 : o2),
                  is_polygon_first ? tf1 : tf2, is_polygon_first ? tf2 : tf1, more) {
  const fcl::CollisionGeometry<S>& other = polygon_first ? o2 : o1;
  const fcl::NODE_TYPE type = other.getNodeType();
  if (!isRound(type)) return;
  if (!hasFewEdges(*a)) {  // beside few edges a disc is sooner tested than a certificate is found
    place_a = &of_polygon_;
    place_b = &of_other_;
  }
  if (type == fcl::GEOM_SPHERE && placeBall(static_cast<double>(static_cast<const fcl::Sphere<S>&>(other).radius)))
    return;
  tricover_fcl::requireRigid(of_other_, polygon_first ? "pose_b" : "pose_a");
  const Other seen = place();
  const std::optional<Stadium> stadium =
      stadiumOf(other, seen.center, seen.axis, seen.slab, seen.rounding, seen.rounding_z);
  if (!stadium) return;
  requireRigid(pose_a, polygon_first ? "pose_a" : "pose_b");
  found = stadium->in_slab ? StadiumCase::Pair : StadiumCase::OutOfSlab;
  stadium->setPose(pose_b);
  setRadius(stadium->radius);
  if (is_level_)
    height_ += stadium->heights.middle();
  else
    plane_ = plane_ * planeAt(stadium->heights.middle());
  if (stadium->half_length > 0) b = &segment_.emplace(stadium->segment());
}

template class StadiumPair<float>;
template class StadiumPair<double>;

}  // namespace tricover_fcl
