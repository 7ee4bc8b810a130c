// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/advance_mixed.h"

#include <cmath>

#include "mixed/mixed_pair.h"
#include "shape/motion_in_plane.h"
#include "tricover/time_of_impact.h"

namespace tricover_fcl {
namespace {

/// How far the motion takes anything that is within `radius` of `center` at time 0.
double reach(const tricover::Motion& motion, const tricover::Vec2& center, double radius) {
  const double turn = std::abs(motion.angle) + std::abs(motion.angle_2) + std::abs(motion.angle_3);
  return motion.shift.norm() + motion.shift_2.norm() + motion.shift_3.norm() +
         std::min(turn, 2.0) * ((center - motion.pivot).norm() + radius);
}

}  // namespace

template <typename S>
S advanceMixed(const fcl::CollisionGeometry<S>& o1, const fcl::MotionBase<S>& motion1,
               const fcl::CollisionGeometry<S>& o2, const fcl::MotionBase<S>& motion2,
               const fcl::ContinuousCollisionRequest<S>& request, fcl::ContinuousCollisionResult<S>& result) {
  MixedPair<S> pair = mixedPair("conservative advancement", o1, poseAt(motion1, S(0)), o2, poseAt(motion2, S(0)));
  const tricover::Motion along1 = motionInPlane(motion1, pair.plane, "motion_a");
  const tricover::Motion along2 = motionInPlane(motion2, pair.plane, "motion_b");
  const tricover::Motion& of_polygon = pair.polygon_first ? along1 : along2;
  const tricover::Motion& of_other = pair.polygon_first ? along2 : along1;

  // Both stay in the plane, so the shadow of the start moves with its geometry. It must hold what of an unbounded one
  // the polygon comes to.
  const tricover::Vec2 center = pair.view.around.center();
  const double radius = pair.view.around.diagonal().norm() / 2;
  const double own_way = reach(of_polygon, center, radius);
  const double way = own_way + reach(of_other, center, radius + own_way);
  const double margin = pair.shape.options().margin;
  pair.view.around.min().array() -= way + margin;
  pair.view.around.max().array() += way + margin;
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);

  result.is_collide = false;
  result.time_of_contact = S(1);
  if (!shadow || !o1.isOccupied() || !o2.isOccupied()) return result.time_of_contact;
  tricover::ImpactOptions options;
  options.time_error = static_cast<double>(request.toc_err);
  options.margin = margin;
  if (const auto impact = tricover::timeOfImpact(pair.polygon(), of_polygon, shadow->outline(), of_other, options)) {
    result.is_collide = true;
    result.time_of_contact = static_cast<S>(impact->time);
    // Rounded to S it mustn't be later.
    if (static_cast<double>(result.time_of_contact) > impact->time)
      result.time_of_contact = std::nextafter(result.time_of_contact, S(0));
  }
  return result.time_of_contact;
}

template float advanceMixed(const fcl::CollisionGeometry<float>&, const fcl::MotionBase<float>&,
                            const fcl::CollisionGeometry<float>&, const fcl::MotionBase<float>&,
                            const fcl::ContinuousCollisionRequest<float>&, fcl::ContinuousCollisionResult<float>&);
template double advanceMixed(const fcl::CollisionGeometry<double>&, const fcl::MotionBase<double>&,
                             const fcl::CollisionGeometry<double>&, const fcl::MotionBase<double>&,
                             const fcl::ContinuousCollisionRequest<double>&, fcl::ContinuousCollisionResult<double>&);

}  // namespace tricover_fcl
