// SPDX-License-Identifier: BSD-3-Clause
// A call for each \throws of the adapter's headers, as throws.cpp has them for the core's.
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/triangle_p.h>
#include <fcl/math/motion/tbv_motion_bound_visitor.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/math/motion/triangle_motion_bound_visitor.h>

#include <limits>
#include <memory>
#include <vector>

#include "throws.h"
#include "tricover/tricover.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover_fcl {
namespace {

using fcl::Transform3d, fcl::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
const tricover::Polygon square = tricover::Polygon::box(2, 2);
const Transform3d here = Transform3d::Identity(), nowhere(fcl::Translation3d(kNaN, 0, 0));
const Transform3d tilted(Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
const PolygonShaped flat(square), outside(square.complement());
const fcl::TrianglePd triangle(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY());
const fcl::Boxd box(1, 1, 1);

FclLayout patched() {
  FclLayout layout;
  layout.sphere += 8;
  return layout;
}

/// By 1 along x, with a bound of the user's own.
class OwnMotion : public fcl::MotionBase<double> {
 public:
  explicit OwnMotion(double bound) : bound_(bound) {}
  bool integrate(double time) const override {
    time_ = time;
    return true;
  }
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>&) const override { return bound_; }
  double computeMotionBound(const fcl::TriangleMotionBoundVisitor<double>&) const override { return bound_; }
  void getCurrentTransform(Transform3d& pose) const override { pose = fcl::Translation3d(time_, 0, 0); }
  void getTaylorModel(fcl::TMatrix3<double>&, fcl::TVector3<double>&) const override {}

 private:
  double bound_;
  mutable double time_ = 0;
};

TEST(Throws, Shapes) {
  THROWS(fcl_layout.h, checkFclLayout, std::logic_error, checkFclLayout(patched()));
  THROWS(registration.h, filledTables, std::logic_error, detail::filledTables<double>(patched()));
  THROWS(polygon_shape.h, PolygonShape::PolygonShape, std::logic_error,
         PolygonShaped(square, {}, detail::filledTables<double>(patched())));
  for (const PolygonOptions& bad : std::vector<PolygonOptions>{{kNaN}, {0, 1, 0}, {0, 0, kInfinity}, {0, kNaN, 0}})
    THROWS(polygon_shape.h, PolygonShape::PolygonShape, std::invalid_argument, PolygonShaped(square, bad));
  THROWS(polygon_object.h, PolygonObject::PolygonObject, std::invalid_argument, PolygonObjectd(nullptr));
}

TEST(Throws, Collisions) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  for (const Transform3d& bad : {tilted, nowhere})
    THROWS(collide.h, collide, std::invalid_argument, tricover_fcl::collide(&flat, here, &flat, bad, request, result));
  THROWS(collide.h, collide, std::invalid_argument,
         tricover_fcl::collide<double>(&flat, nowhere, &box, here, request, result));
  THROWS(collide.h, collide, std::logic_error,
         tricover_fcl::collide<double>(&flat, here, &triangle, here, request, result));
  THROWS(collide.h, collide, std::logic_error,
         tricover_fcl::collide<double>(&outside, here, &box, here, request, result));
  THROWS(collide.h, collide, std::logic_error,
         tricover_fcl::collide<double>(&box, here, &box, here, request, {0.1}, result));
  THROWS(collide.h, collide, std::invalid_argument,
         tricover_fcl::collide(&flat, here, &flat, here, request, {kNaN}, result));
  for (const double bad : {kNaN, kInfinity, -1.0})
    THROWS(collide.h, collide, std::invalid_argument,
           tricover_fcl::collide(&flat, here, &flat, here, request, {0, bad}, result));
}

TEST(Throws, Distances) {
  const PolygonShaped shrunk(square, {-0.1});
  fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  THROWS(distance.h, distance, std::invalid_argument,
         tricover_fcl::distance(&flat, here, &flat, tilted, request, result));
  THROWS(distance.h, distance, std::invalid_argument,
         tricover_fcl::distance(&shrunk, here, &flat, here, request, result));
  THROWS(distance.h, distance, std::logic_error,
         tricover_fcl::distance<double>(&flat, here, &triangle, here, request, result));
  PolygonShaped free(square);
  free.cost_density = 0;
  request.enable_signed_distance = true;
  request.gjk_solver_type = fcl::GST_INDEP;
  THROWS(distance.h, distance, std::logic_error,
         tricover_fcl::distance<double>(&free, here, &box, here, request, result));
}

TEST(Throws, Motions) {
  fcl::ContinuousCollisionRequestd request;
  fcl::ContinuousCollisionResultd result;
  const fcl::TranslationMotion<double> still(here, here), leaves(here, Transform3d(fcl::Translation3d(0, 0, 1)));
  const OwnMotion endless(kInfinity), own(1);
  const fcl::Halfspaced below(Vector3d::UnitY(), -5);
  THROWS(continuous_collide.h, continuousCollide, std::invalid_argument,
         tricover_fcl::continuousCollide<double>(&flat, &still, &flat, &leaves, request, result));
  THROWS(continuous_collide.h, continuousCollide, std::logic_error,
         tricover_fcl::continuousCollide<double>(&flat, &still, &flat, &endless, request, result));
  THROWS(continuous_collide.h, continuousCollide, std::logic_error,
         tricover_fcl::continuousCollide<double>(&flat, &still, &below, &own, request, result));
  request.ccd_motion_type = fcl::CCDM_SPLINE;
  THROWS(continuous_collide.h, continuousCollide, std::logic_error,
         tricover_fcl::continuousCollide<double>(&flat, here, here, &flat, here, here, request, result));
}

TEST(Throws, Trajectories) {
  using Legs = std::vector<TimedMotion<double>>;
  const tricover::Trajectory path({{0, 1, tricover::Motion::still(tricover::Pose::Identity())}});
  const auto still = std::make_shared<fcl::TranslationMotion<double>>(here, here);
  const auto leaves = std::make_shared<fcl::TranslationMotion<double>>(here, Transform3d(fcl::Translation3d(0, 0, 1)));
  const Legs backwards{{1, 0, still}}, out_of_plane{{0, 1, leaves}}, of_own{{0, 1, std::make_shared<OwnMotion>(1)}};
  THROWS(trajectory_motion.h, TrajectoryMotion::TrajectoryMotion, std::invalid_argument, TrajectoryMotiond(path, 1, 1));
  THROWS(trajectory_motion.h, TrajectoryMotion::TrajectoryMotion, std::invalid_argument,
         TrajectoryMotiond(path, 0, 1, kNaN));
  for (const Legs& bad : {Legs{}, backwards, out_of_plane, of_own})
    THROWS(trajectory_motion.h, TrajectoryMotion::TrajectoryMotion, std::invalid_argument,
           TrajectoryMotiond(bad, 0, 1));
  const TrajectoryMotiond motion(path, 0, 1);
  const fcl::TBVMotionBoundVisitor<fcl::RSS<double>> of_box(fcl::RSS<double>(), Vector3d::UnitX());
  const fcl::TriangleMotionBoundVisitor<double> of_triangle(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(),
                                                            Vector3d::UnitZ());
  fcl::TMatrix3<double> turn;
  fcl::TVector3<double> shift;
  THROWS(trajectory_motion.h, TrajectoryMotion::computeMotionBound, std::logic_error,
         motion.computeMotionBound(of_box));
  THROWS(trajectory_motion.h, TrajectoryMotion::computeMotionBound, std::logic_error,
         motion.computeMotionBound(of_triangle));
  THROWS(trajectory_motion.h, TrajectoryMotion::getTaylorModel, std::logic_error, motion.getTaylorModel(turn, shift));
}

TEST(Throws, Managers) {
  SceneManagerd manager;
  fcl::CollisionObjectd* const no_object = nullptr;
  fcl::CollisionObjectd bare(nullptr);
  SceneManagerd* const no_manager = nullptr;
  fcl::DefaultCollisionData<double> data;
  fcl::DefaultDistanceData<double> gap;
  const auto callback = fcl::DefaultCollisionFunction<double>;
  const auto measure = fcl::DefaultDistanceFunction<double>;
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.registerObject(no_object));
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.registerObject(&bare));
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.setIgnored(&bare, no_object));
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.collide(no_object, &data, callback));
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.collide(no_manager, &data, callback));
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.distance(no_object, &gap, measure));
  THROWS(scene_manager.h, SceneManager, std::invalid_argument, manager.distance(no_manager, &gap, measure));
}

}  // namespace
}  // namespace tricover_fcl
