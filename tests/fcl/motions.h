// SPDX-License-Identifier: BSD-3-Clause
// Motions: classes that FCL doesn't have, and the law of every first contact.
#pragma once

#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/translation_motion.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "ask.h"
#include "tricover_fcl/trajectory_motion.h"

namespace tricover_fcl::test {

using Slide = fcl::TranslationMotiond;
using Spline = fcl::SplineMotion<double>;

inline const Slide kRests(kHere, kHere);

/// Answers nothing but where it is and how fast; counts how often it is asked for the former.
template <typename S>
class OwnMotion : public fcl::MotionBase<S> {
 public:
  S computeMotionBound(const fcl::BVMotionBoundVisitor<S>&) const override { return bound_; }
  S computeMotionBound(const fcl::TriangleMotionBoundVisitor<S>&) const override {
    throw std::runtime_error("no bound of triangles");
  }
  void getTaylorModel(fcl::TMatrix3<S>&, fcl::TVector3<S>&) const override {
    throw std::runtime_error("no Taylor model");
  }
  bool integrate(S time) const override {
    time_ = time;
    return ++asked > 0;
  }

  mutable int asked = 0;

 protected:
  explicit OwnMotion(S bound) : bound_(bound) {}

  mutable S time_ = 0;

 private:
  S bound_;
};

/// As open-rmf/rmf_traffic has it.
class StaticMotion : public OwnMotion<double> {
 public:
  explicit StaticMotion(const Transform& pose) : OwnMotion(0), pose_(pose) {}
  void getCurrentTransform(Transform& pose) const override { pose = pose_; }

 private:
  Transform pose_;
};

/// A class of its own around one of FCL's, whose bound is that one's: nothing is to spare.
template <class Inner>
class Handing : public OwnMotion<double> {
 public:
  explicit Handing(const Inner& inner) : OwnMotion(0), inner_(inner) {}
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>& visitor) const override {
    return visitor.visit(inner_);
  }
  void getCurrentTransform(Transform& pose) const override {
    inner_.integrate(time_);
    inner_.getCurrentTransform(pose);
  }

 private:
  Inner inner_;
};

inline Handing<Slide> straight(const Transform& begin, const Vec3& way) {
  return Handing<Slide>(Slide(begin, Eigen::Translation3d(way) * begin));
}

/// A turn about a point of the moving frame, which goes straight on.
inline fcl::InterpMotion<double> turning(const Transform& from, const Transform& to, const Vec2& about) {
  return {from.linear(), from.translation(), to.linear(), to.translation(), Vec3(about.x(), about.y(), 0)};
}

/// Of four control points of places and turns, both drawn.
template <typename Place, typename Turn>
Spline splineOf(const Place& place, const Turn& turn) {
  const Vec3 p0 = place(), p1 = place(), p2 = place(), p3 = place(), t0 = turn(), t1 = turn(), t2 = turn(), t3 = turn();
  return {p0, p1, p2, p3, t0, t1, t2, t3};
}

/// How near a contact is where it is found.
struct Nearness {
  double more = 0;                 ///< some margin, with which they meet within the error after it; or
  double speed = 0;                ///< of the fastest point: they are no farther apart than that goes in the error
  bool is_swapped_exactly = true;  ///< the other order's time is the same; else it is within the error
};

/// The first contact: no sample before it meets, and it isn't later than it may be. Fatal failures if so.
template <typename S>
void expectFirst(const fcl::CollisionGeometry<S>& a, const fcl::MotionBase<S>& motion_a,
                 const fcl::CollisionGeometry<S>& b, const fcl::MotionBase<S>& motion_b, S error,
                 const Nearness& nearness, fcl::ContinuousCollisionResult<S>& result,
                 fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  const fcl::ContinuousCollisionRequest<S> request(1, error, fcl::CCDM_TRANS, solver,
                                                   fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  fcl::ContinuousCollisionResult<S> swapped;
  if constexpr (std::is_same_v<S, double>)
    result = impactOf(a, motion_a, b, motion_b, request);
  else
    tricover_fcl::continuousCollide(&a, &motion_a, &b, &motion_b, request, result);
  tricover_fcl::continuousCollide(&b, &motion_b, &a, &motion_a, request, swapped);
  const double time = static_cast<double>(result.time_of_contact), error_in_time = static_cast<double>(error);
  ASSERT_EQ(swapped.is_collide, result.is_collide);
  ASSERT_NEAR(static_cast<double>(swapped.time_of_contact), time, nearness.is_swapped_exactly ? 0 : error_in_time);

  const auto collide = [&](double t, double more) {
    fcl::CollisionResult<S> there;
    return tricover_fcl::collide<S>(&a, at(motion_a, t), &b, at(motion_b, t), {}, {more}, there) > 0;
  };
  ASSERT_EQ(result.is_collide && time == 0, collide(0, 0));
  for (int k = 1; k < 200; ++k) ASSERT_FALSE(time > 0 && collide(time * k / 200, 0)) << k;
  for (double ahead = std::is_same_v<S, float> ? 1e-7 : 1e-10; ahead < 1e-2; ahead *= 10)
    ASSERT_FALSE(time > ahead && collide(time - ahead, 0)) << ahead;
  if (!result.is_collide) {
    ASSERT_FALSE(collide(1, 0));
    return;
  }
  ASSERT_TRUE(result.contact_tf1.isApprox(at(motion_a, time)) && result.contact_tf2.isApprox(at(motion_b, time)));
  if (nearness.speed > 0) {
    fcl::DistanceResult<S> distance;
    tricover_fcl::distance<S>(&a, result.contact_tf1, &b, result.contact_tf2, fcl::DistanceRequest<S>(), distance);
    ASSERT_LE(static_cast<double>(distance.min_distance), nearness.speed * error_in_time);
    return;
  }
  bool found = false;
  for (int k = 0; k <= 20 && !found; ++k) found = collide(std::min(1.0, time + k * error_in_time / 20), nearness.more);
  ASSERT_TRUE(found) << "nothing within the error after " << time;
}

}  // namespace tricover_fcl::test
