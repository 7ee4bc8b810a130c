// SPDX-License-Identifier: BSD-3-Clause
// How tests ask FCL about two geometries.
#pragma once

#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>
#include <vector>

#include "scene.h"

namespace tricover_fcl::test {

constexpr fcl::GJKSolverType kSolvers[] = {fcl::GST_LIBCCD, fcl::GST_INDEP};

/// FCL's entry points for double; for float, which are templates that take minutes to instantiate (float_scalar.cpp has
/// them), tricover's own.
template <typename S>
std::size_t askCollide(const fcl::CollisionGeometry<S>& a, const fcl::Transform3<S>& tf_a,
                       const fcl::CollisionGeometry<S>& b, const fcl::Transform3<S>& tf_b,
                       const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if constexpr (std::is_same_v<S, double>)
    return fcl::collide(&a, tf_a, &b, tf_b, request, result);
  else
    return tricover_fcl::collide(&a, tf_a, &b, tf_b, request, result);
}

template <typename S>
S askDistance(const fcl::CollisionGeometry<S>& a, const fcl::Transform3<S>& tf_a, const fcl::CollisionGeometry<S>& b,
              const fcl::Transform3<S>& tf_b, const fcl::DistanceRequest<S>& request, fcl::DistanceResult<S>& result) {
  if constexpr (std::is_same_v<S, double>)
    return fcl::distance(&a, tf_a, &b, tf_b, request, result);
  else
    return tricover_fcl::distance(&a, tf_a, &b, tf_b, request, result);
}

template <typename S>
bool collides(const fcl::CollisionGeometry<S>& a, const fcl::Transform3<S>& tf_a, const fcl::CollisionGeometry<S>& b,
              const fcl::Transform3<S>& tf_b, fcl::GJKSolverType solver = fcl::GST_LIBCCD,
              bool enable_contact = false) {
  fcl::CollisionRequest<S> request(1, enable_contact);
  request.gjk_solver_type = solver;
  fcl::CollisionResult<S> result;
  return askCollide<S>(a, tf_a, b, tf_b, request, result) > 0;
}

/// The same in both orders and under both solvers, with contacts and without.
template <typename S>
bool meet(const fcl::CollisionGeometry<S>& a, const fcl::Transform3<S>& tf_a, const fcl::CollisionGeometry<S>& b,
          const fcl::Transform3<S>& tf_b) {
  const bool hit = collides<S>(a, tf_a, b, tf_b);
  EXPECT_EQ(collides<S>(a, tf_a, b, tf_b, fcl::GST_INDEP, true), hit);
  EXPECT_EQ(collides<S>(b, tf_b, a, tf_a, fcl::GST_LIBCCD, true), hit);
  EXPECT_EQ(collides<S>(b, tf_b, a, tf_a, fcl::GST_INDEP), hit);
  return hit;
}

template <typename S>
bool meet(const Shape<S>& a, const fcl::Transform3<S>& tf_a, const Shape<S>& b, const fcl::Transform3<S>& tf_b) {
  return meet<S>(*a, tf_a, *b, tf_b);
}

inline std::vector<fcl::Contactd> contactsOf(const fcl::CollisionGeometryd& a, const fcl::Transform3d& tf_a,
                                             const fcl::CollisionGeometryd& b, const fcl::Transform3d& tf_b,
                                             std::size_t most) {
  fcl::CollisionResultd result;
  const std::size_t count = fcl::collide(&a, tf_a, &b, tf_b, fcl::CollisionRequestd(most, true), result);
  std::vector<fcl::Contactd> all;
  result.getContacts(all);
  EXPECT_EQ(all.size(), count);
  return all;
}

template <typename S>
fcl::DistanceResult<S> distanceOf(fcl::GJKSolverType solver, bool is_signed, const fcl::CollisionGeometry<S>& a,
                                  const fcl::Transform3<S>& tf_a, const fcl::CollisionGeometry<S>& b,
                                  const fcl::Transform3<S>& tf_b) {
  fcl::DistanceRequest<S> request;
  request.gjk_solver_type = solver;
  request.enable_nearest_points = true;
  request.enable_signed_distance = is_signed;
  fcl::DistanceResult<S> result;
  askDistance<S>(a, tf_a, b, tf_b, request, result);
  return result;
}

inline fcl::ContinuousCollisionRequestd advancing(double error, fcl::CCDMotionType type = fcl::CCDM_TRANS,
                                                  fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  return fcl::ContinuousCollisionRequestd(10, error, type, solver, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
}

/// Where a motion is at a time.
template <typename S>
fcl::Transform3<S> at(const fcl::MotionBase<S>& motion, double time) {
  fcl::Transform3<S> transform;
  motion.integrate(static_cast<S>(time));
  motion.getCurrentTransform(transform);
  return transform;
}

}  // namespace tricover_fcl::test
