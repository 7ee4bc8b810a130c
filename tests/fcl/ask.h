// SPDX-License-Identifier: BSD-3-Clause
// How tests ask FCL about two geometries.
#pragma once

#include <fcl/math/motion/motion_base.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "scene.h"

// float_scalar.cpp has them: each file that instantiates them takes minutes.
extern template std::size_t fcl::collide(const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                         const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                         const fcl::CollisionRequestf&, fcl::CollisionResultf&);
extern template float fcl::distance(const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                    const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                    const fcl::DistanceRequestf&, fcl::DistanceResultf&);

namespace tricover_fcl::test {

/// A question takes a geometry as a reference or as a pointer that shares it.
template <typename S>
const fcl::CollisionGeometry<S>& bodyOf(const fcl::CollisionGeometry<S>& body) {
  return body;
}

template <typename Geometry>
const Geometry& bodyOf(const std::shared_ptr<Geometry>& body) {
  return *body;
}

template <typename S, typename A, typename B>
bool collides(const A& a, const fcl::Transform3<S>& tf_a, const B& b, const fcl::Transform3<S>& tf_b,
              fcl::GJKSolverType solver = fcl::GST_LIBCCD, bool enable_contact = false) {
  fcl::CollisionRequest<S> request(1, enable_contact);
  request.gjk_solver_type = solver;
  fcl::CollisionResult<S> result;
  return fcl::collide<S>(&bodyOf(a), tf_a, &bodyOf(b), tf_b, request, result) > 0;
}

/// The same in both orders and under both solvers, with contacts and without.
template <typename S, typename A, typename B>
bool meet(const A& a, const fcl::Transform3<S>& tf_a, const B& b, const fcl::Transform3<S>& tf_b) {
  const bool hit = collides<S>(a, tf_a, b, tf_b);
  EXPECT_EQ(collides<S>(a, tf_a, b, tf_b, fcl::GST_INDEP, true), hit);
  EXPECT_EQ(collides<S>(b, tf_b, a, tf_a, fcl::GST_LIBCCD, true), hit);
  EXPECT_EQ(collides<S>(b, tf_b, a, tf_a, fcl::GST_INDEP), hit);
  return hit;
}

template <typename A, typename B>
std::vector<fcl::Contactd> contactsOf(const A& a, const Transform& tf_a, const B& b, const Transform& tf_b,
                                      std::size_t most) {
  fcl::CollisionResultd result;
  const std::size_t count =
      fcl::collide<double>(&bodyOf(a), tf_a, &bodyOf(b), tf_b, fcl::CollisionRequestd(most, true), result);
  std::vector<fcl::Contactd> all;
  result.getContacts(all);
  EXPECT_EQ(all.size(), count);
  return all;
}

template <typename S, typename A, typename B>
fcl::DistanceResult<S> distanceOf(fcl::GJKSolverType solver, bool is_signed, const A& a, const fcl::Transform3<S>& tf_a,
                                  const B& b, const fcl::Transform3<S>& tf_b) {
  fcl::DistanceRequest<S> request;
  request.gjk_solver_type = solver;
  request.enable_nearest_points = true;
  request.enable_signed_distance = is_signed;
  fcl::DistanceResult<S> result;
  EXPECT_EQ(fcl::distance<S>(&bodyOf(a), tf_a, &bodyOf(b), tf_b, request, result), result.min_distance);
  return result;
}

inline fcl::ContinuousCollisionRequestd advancing(double error, fcl::CCDMotionType type = fcl::CCDM_TRANS,
                                                  fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  return fcl::ContinuousCollisionRequestd(10, error, type, solver, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
}

using Impact = fcl::ContinuousCollisionResultd;
using Motion = fcl::MotionBase<double>;

/// Of two motions: FCL's function says what tricover's does.
template <typename A, typename B>
Impact impactOf(const A& a, const Motion& motion_a, const B& b, const Motion& motion_b,
                const fcl::ContinuousCollisionRequestd& request = advancing(1e-9)) {
  Impact result, ours;
  const Body &body_a = bodyOf(a), &body_b = bodyOf(b);
  const double time = fcl::continuousCollide<double>(&body_a, &motion_a, &body_b, &motion_b, request, result);
  EXPECT_EQ(time, result.time_of_contact);
  EXPECT_TRUE(result.is_collide || time == 1);
  EXPECT_EQ(tricover_fcl::continuousCollide<double>(&body_a, &motion_a, &body_b, &motion_b, request, ours), time);
  EXPECT_EQ(ours.is_collide, result.is_collide);
  return result;
}

/// From poses to poses. FCL's own function leaves the point of linear motions that goes straight uninitialised.
template <typename A, typename B>
Impact impactOf(const A& a, const Transform& a0, const Transform& a1, const B& b, const Transform& b0,
                const Transform& b1, const fcl::ContinuousCollisionRequestd& request) {
  Impact result;
  const Body &body_a = bodyOf(a), &body_b = bodyOf(b);
  const double time = request.ccd_motion_type == fcl::CCDM_LINEAR
                          ? tricover_fcl::continuousCollide<double>(&body_a, a0, a1, &body_b, b0, b1, request, result)
                          : fcl::continuousCollide<double>(&body_a, a0, a1, &body_b, b0, b1, request, result);
  EXPECT_EQ(time, result.time_of_contact);
  return result;
}

/// By both solvers: when the two meet, from poses to poses; 2 if they don't.
template <typename A, typename B>
double timeOf(const A& a, const Transform& a0, const Transform& a1, const B& b, const Transform& b0,
              const Transform& b1, fcl::CCDMotionType type = fcl::CCDM_LINEAR,
              fcl::CCDSolverType solver = fcl::CCDC_CONSERVATIVE_ADVANCEMENT, double error = 1e-6) {
  double times[2];
  for (const fcl::GJKSolverType gjk : kSolvers) {
    const Impact result = impactOf(a, a0, a1, b, b0, b1, {1000, error, type, gjk, solver});
    times[gjk] = result.is_collide ? result.time_of_contact : 2;
  }
  EXPECT_EQ(times[0], times[1]);
  return times[0];
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
