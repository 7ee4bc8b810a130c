// SPDX-License-Identifier: BSD-3-Clause
#include "queries/planar_pair.h"

#include <fcl/geometry/shape/sphere.h>

#include <cmath>
#include <limits>
#include <utility>

#include "shadow/shadow.h"
#include "shadow/stadium.h"
#include "shape/errors.h"
#include "tricover/polygon.h"

namespace tricover_fcl {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A ball that tilts by less is as rigid as it is in the plane, but for the square of that.
constexpr double kNoTilt = 1e-9;

/// Whether it turns about z alone, or upside down, to the last bit, and lifts by what is finite: then the plane's
/// coordinates can be the world's.
template <typename S>
bool isUpright(const fcl::Transform3<S>& pose) {
  return tiltOf(pose) == 0;
}

template <typename S>
void requireRigidPose(const MixedGeometries<S>& both, bool of_polygon) {
  requireRigid(of_polygon ? both.ofPolygon() : both.ofOther(), of_polygon == both.polygon_first ? "pose_a" : "pose_b");
}

/// From the other geometry's frame.
template <typename S>
Eigen::Affine3d toPolygon(const MixedGeometries<S>& both) {
  return Eigen::Affine3d(seenFrom(planeOf(both.ofPolygon()), planeOf(both.ofOther())).matrix());
}

/// The polygon in its own frame.
template <typename S>
void placeInOwnFrame(PlanarPair& pair, const MixedGeometries<S>& both) {
  Region& polygon = pair.of(both.polygon_first);
  const PolygonOptions& options = both.polygon().options();
  polygon.polygon = &both.polygon().polygon();
  polygon.pose = tricover::Pose::Identity();
  polygon.margin = options.margin;
  polygon.heights = {0, {options.z_low, options.z_high}};
  pair.frame = planeOf(both.ofPolygon());
}

/// The polygon in the world's plane, at its height.
template <typename S>
void placeInWorld(PlanarPair& pair, const MixedGeometries<S>& both, const Heights& heights) {
  Region& polygon = pair.of(both.polygon_first);
  polygon.polygon = &both.polygon().polygon();
  polygon.margin = both.polygon().options().margin;
  polygon.heights = heights;
  setPlanarPart(polygon.pose, both.ofPolygon());
}

/// The disc or stadium is there, beside the polygon.
template <typename S>
void finishStadium(PlanarPair& pair, const MixedGeometries<S>& both, double radius) {
  const double beside = both.more + both.polygon().options().margin;
  pair.margin = radius + beside;
  if (beside != 0) pair.margin += std::abs(pair.margin) * 0x1p-52;
  if (hasFewEdges(both.polygon().polygon())) return;  // it is sooner tested than a certificate is found
  pair.place_a = &both.tf1;
  pair.place_b = &both.tf2;
}

/// Places a ball whose centre is between the heights of a polygon with axis along z, if it is: all of stadiumOf() that
/// it needs. In the plane it may turn with its pose, so that the kernel checks that.
template <typename S>
bool placeBall(PlanarPair& pair, const MixedGeometries<S>& both, double radius) {
  if (!(isUpright(both.ofPolygon()) && tiltOf(both.ofOther()) <= kNoTilt && radius >= 0 &&
        radius <= std::numeric_limits<double>::max()))
    return false;
  const Heights heights = heightsOf(both.polygon().options(), both.ofPolygon());
  const double rise = static_cast<double>(both.ofOther().matrix()(2, 3)) - heights.of_pose;
  if (!(rise >= heights.of_shape.low && rise <= heights.of_shape.high)) return false;
  placeInWorld(pair, both, heights);
  Region& ball = pair.of(!both.polygon_first);
  pair.other = &ball;
  ball.polygon = &originPoint();
  ball.margin = radius;
  ball.heights = {heights.of_pose, {rise - radius, rise + radius}};
  setPlanarPart(ball.pose, both.ofOther());
  finishStadium(pair, both, radius);
  return true;
}

}  // namespace

template <typename S>
bool placeStadium(PlanarPair& pair, const MixedGeometries<S>& both, bool may_be_level) {
  const fcl::NODE_TYPE type = both.other().getNodeType();
  if (type != fcl::GEOM_SPHERE && type != fcl::GEOM_CYLINDER && type != fcl::GEOM_CAPSULE) return false;
  if (type == fcl::GEOM_SPHERE && may_be_level &&
      placeBall(pair, both, static_cast<double>(static_cast<const fcl::Sphere<S>&>(both.other()).radius)))
    return true;
  requireRigidPose(both, false);
  Eigen::Vector3d center, axis;
  double rounding = 0, rounding_z = 0;
  if (may_be_level && isUpright(both.ofPolygon())) {
    const Heights heights = heightsOf(both.polygon().options(), both.ofPolygon());
    placeInWorld(pair, both, heights);
    const auto& m = both.ofOther().matrix();
    center = m.col(3).template head<3>().template cast<double>();
    axis = m.col(2).template head<3>().template cast<double>();
    rounding_z = 0x1p-50 * (std::abs(heights.of_pose) + std::abs(center.z()));
    center.z() -= heights.of_pose;
  } else {
    requireRigidPose(both, true);
    placeInOwnFrame(pair, both);
    const Eigen::Affine3d to_polygon = toPolygon(both);
    center = to_polygon.translation();
    axis = to_polygon.linear().col(2);
    rounding = rounding_z = mappingError(to_polygon, 0);
  }
  const Region& polygon = pair.of(both.polygon_first);
  const std::optional<Stadium> stadium =
      stadiumOf(both.other(), center, axis, polygon.heights.of_shape, rounding, rounding_z);
  if (!stadium) return false;
  tricover::detail::requireRigid(polygon.pose, both.polygon_first ? "pose_a" : "pose_b");
  Region& other = pair.of(!both.polygon_first);
  other = stadium->region;
  other.heights.of_pose = polygon.heights.of_pose;
  if (other.heights.of_shape.isNone()) pair.apart = kInfinity;
  if (const double half = stadium->half_length; half > 0) {
    pair.shadow.emplace().made = tricover::Polygon::segment({-half, 0}, {half, 0});
    other.polygon = &pair.shadow->polygon();
  }
  pair.other = &other;
  finishStadium(pair, both, other.margin);
  return true;
}

template <typename S>
bool placeShadow(PlanarPair& pair, const MixedGeometries<S>& both, bool at_all_heights, bool only_near, double around) {
  placeInOwnFrame(pair, both);
  const Region& polygon = pair.of(both.polygon_first);
  if (polygon.polygon->isComplement())
    refuseQuestion(
        "polygon",
        "a complement does not meet " + className(typeid(both.other())) +
            ": it meets polygons, and at its heights spheres, cylinders that stand, capsules that stand or lie",
        "make the other geometry a PolygonShape");
  pair.margin = both.more + polygon.margin;
  pair.place_a = pair.place_b = nullptr;
  const Slab slab = at_all_heights ? Slab{-kInfinity, kInfinity} : polygon.heights.of_shape;
  // As far as the margin reaches; where an overlap is allowed, as far as what is so deep in the other one.
  const double near = std::abs(pair.margin) + around;
  const View view{toPolygon(both), slab, grown(boundsOf(*polygon.polygon), near), only_near, pair.margin < 0};
  pair.shadow = makeShadow(both.other(), view);
  pair.apart = pair.shadow ? 0 : kInfinity;
  if (!pair.shadow) return false;
  Region& other = pair.of(!both.polygon_first);
  other = {&pair.shadow->polygon(), pair.shadow->pose, 0, pair.shadow->heights};
  pair.other = &other;
  pair.rounding = pair.shadow->rounding;
  return true;
}

template <typename S>
void requireMixed(const char* operation, const MixedGeometries<S>& both) {
  if (!castsShadow(both.other())) refusePair(operation, both.o1, both.o2);
  requireRigidPose(both, both.polygon_first);
  requireRigidPose(both, !both.polygon_first);
}

template <typename S>
bool placeMixed(PlanarPair& pair, const char* operation, const MixedGeometries<S>& both, bool only_near) {
  if (placeStadium(pair, both, true)) return true;
  requireMixed(operation, both);
  placeShadow(pair, both, false, only_near);
  return false;
}

#define TRICOVER_INSTANTIATE(S)                                                          \
  template bool placeStadium(PlanarPair&, const MixedGeometries<S>&, bool);              \
  template bool placeShadow(PlanarPair&, const MixedGeometries<S>&, bool, bool, double); \
  template void requireMixed(const char*, const MixedGeometries<S>&);                    \
  template bool placeMixed(PlanarPair&, const char*, const MixedGeometries<S>&, bool);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
