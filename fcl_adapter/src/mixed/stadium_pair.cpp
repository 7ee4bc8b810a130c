// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/stadium_pair.h"

#include <cmath>

#include "mixed/mixed_pair.h"
#include "shadow/stadium.h"
#include "shape/is_polygon.h"
#include "shape/planar_pose.h"

namespace tricover_fcl {
namespace {

using Vec3 = Eigen::Vector3d;
using tricover::Pose;

/// Whether it turns about z alone, or upside down, to the last bit: then the plane's coordinates can be the world's.
template <typename S>
bool isUpright(const fcl::Transform3<S>& pose) {
  const auto& m = pose.matrix();
  return m(2, 0) == 0 && m(2, 1) == 0 && m(0, 2) == 0 && m(1, 2) == 0 && std::abs(m(2, 2)) == 1;
}

/// Where both are: in the world's coordinates, exactly, if the polygon lies level, otherwise in its own.
struct Setting {
  Plane plane = Plane::Identity();
  Pose pose = Pose::Identity();
  Slab slab;
  Vec3 center, axis;
  double rounding, rounding_z;
};

template <typename S>
Setting settingOf(const PolygonOptions& options, const fcl::Transform3<S>& of_polygon, const Plane& of_other,
                  const char* name) {
  Setting setting;
  setting.slab = {options.z_low, options.z_high};
  if (isUpright(of_polygon)) {
    const PlanarPose planar = planarPose(of_polygon, name);
    setting.pose = planar.pose;
    if (planar.upside_down) setting.slab = {-options.z_high, -options.z_low};
    setting.plane.translation().z() = planar.z + setting.slab.middle();
    setting.center = of_other.translation();
    setting.center.z() -= planar.z;
    setting.axis = of_other.linear().col(2);
    setting.rounding = 0;
    setting.rounding_z = 0x1p-50 * (std::abs(planar.z) + std::abs(of_other.translation().z()));
  } else {
    const Plane from = checkedPose(of_polygon, name);
    const Eigen::Matrix3d inverse = from.linear().inverse();
    setting.plane = from * planeAt(setting.slab.middle());
    setting.center = inverse * (of_other.translation() - from.translation());
    setting.axis = inverse * of_other.linear().col(2);
    setting.rounding = setting.rounding_z = kMappingError * setting.center.stableNorm() + 0x1p-1066;
  }
  return setting;
}

}  // namespace

template <typename S>
StadiumCase stadiumPair(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                        const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                        std::optional<StadiumPair<S>>& pair) {
  const bool polygon_first = isPolygon(o1);
  const fcl::CollisionGeometry<S>& other = polygon_first ? o2 : o1;
  const fcl::NODE_TYPE type = other.getNodeType();
  if (type != fcl::GEOM_SPHERE && type != fcl::GEOM_CYLINDER && type != fcl::GEOM_CAPSULE) return StadiumCase::None;

  const auto& shape = static_cast<const PolygonShape<S>&>(polygon_first ? o1 : o2);
  const Plane of_other = checkedPose(polygon_first ? tf2 : tf1, polygon_first ? "pose_b" : "pose_a");
  const Setting setting =
      settingOf(shape.options(), polygon_first ? tf1 : tf2, of_other, polygon_first ? "pose_a" : "pose_b");
  const std::optional<Stadium> stadium =
      stadiumOf(other, setting.center, setting.axis, setting.slab, setting.rounding, setting.rounding_z);
  if (!stadium) return StadiumCase::None;
  tricover::checkPose(setting.pose, polygon_first ? "pose_a" : "pose_b");
  if (!stadium->in_slab) return StadiumCase::OutOfSlab;

  pair.emplace(StadiumPair<S>{shape, polygon_first, setting.plane, setting.pose, stadium->pose(), stadium->segment(),
                              stadium->radius});
  return StadiumCase::Pair;
}

#define TRICOVER_INSTANTIATE(S)                                                                 \
  template StadiumCase stadiumPair(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                   const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                   std::optional<StadiumPair<S>>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
