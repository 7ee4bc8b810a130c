// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/spline_motion.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "tricover_fcl/tricover_fcl.h"

namespace {

TEST(Documentation, RegisterNarrowphase) {
  //! [register]
  tricover_fcl::registerNarrowphase();  // once, before the first query

  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  fcl::CollisionObjectd still(square), moved(square, Eigen::Matrix3d::Identity(), fcl::Vector3d(3, 1, 0));
  fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  EXPECT_EQ(fcl::collide(&still, &moved, request, result), 1u);  // FCL's own function
  //! [register]
}

TEST(Documentation, FclLayout) {
  //! [layout]
  tricover_fcl::checkFclLayout();  // registerNarrowphase() does that, too
  tricover_fcl::FclLayout patched;
  patched.sphere += 8;
  EXPECT_THROW(tricover_fcl::checkFclLayout(patched), std::logic_error);
  //! [layout]
}

TEST(Documentation, PolygonShape) {
  //! [shape]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const tricover_fcl::PolygonShaped flat(square);
  EXPECT_TRUE(flat.isFlat());

  tricover_fcl::PolygonOptions options;
  options.z_high = 2;     // a prism, from 0 to 2
  options.margin = 0.25;  // kept free around it
  const tricover_fcl::PolygonShaped box(square, options);
  EXPECT_FALSE(box.isFlat());
  EXPECT_EQ(box.polygon().id(), square.id());  // shares the polygon and what is derived from it

  const tricover_fcl::PolygonShaped planar(square, tricover_fcl::PolygonOptions::atAllHeights());  // z doesn't matter
  EXPECT_TRUE(planar.isAtAllHeights());

  const fcl::AABBd around = box.boxAt(fcl::Transform3d(fcl::Translation3d(10, 0, 0)));
  EXPECT_NEAR(around.min_.x(), 9.75, 1e-6);
  EXPECT_NEAR(around.max_.z(), 2, 1e-6);
  //! [shape]
}

TEST(Documentation, PolygonObject) {
  //! [object]
  const auto bar = std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}}));
  tricover_fcl::PolygonObjectd upright(bar);
  upright.setRotation(Eigen::AngleAxisd(std::acos(0.0), fcl::Vector3d::UnitZ()).toRotationMatrix());
  upright.computeAABB();
  EXPECT_NEAR(upright.getAABB().width(), 1, 1e-12);  // an fcl::CollisionObject's box is 18 wide

  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&upright);
  manager.setup();
  //! [object]
  EXPECT_EQ(manager.size(), 1u);
}

TEST(Documentation, SceneManager) {
  //! [scene manager]
  const auto bar = std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}}));
  fcl::CollisionObjectd lying(bar), beside(bar, Eigen::Matrix3d::Identity(), fcl::Vector3d(0, 2, 0));
  fcl::CollisionObjectd ball(std::make_shared<fcl::Sphered>(1), Eigen::Matrix3d::Identity(), fcl::Vector3d(0, 9, 0));
  tricover_fcl::SceneManagerd manager;  // in place of any of FCL's managers
  manager.registerObjects({&lying, &beside, &ball});
  manager.setup();
  fcl::DefaultCollisionData<double> data;
  manager.collide(&data, fcl::DefaultCollisionFunction<double>);
  EXPECT_FALSE(data.result.isCollision());

  beside.setTranslation(fcl::Vector3d(0, 1, 0));
  beside.computeAABB();
  manager.update(&beside);
  manager.collide(&data, fcl::DefaultCollisionFunction<double>);
  EXPECT_TRUE(data.result.isCollision());

  manager.setIgnored(&lying, &beside);  // they may touch
  fcl::DefaultCollisionData<double> again;
  manager.collide(&again, fcl::DefaultCollisionFunction<double>);
  EXPECT_FALSE(again.result.isCollision());
  //! [scene manager]
}

TEST(Documentation, FclCollide) {
  //! [fcl collide]
  const tricover_fcl::PolygonShaped square(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  fcl::Transform3d still = fcl::Transform3d::Identity(), moved = still;
  moved.translation() << 3, 1, 0;
  fcl::CollisionRequestd request;
  request.enable_contact = true;
  fcl::CollisionResultd result;
  EXPECT_EQ(tricover_fcl::collide(&square, still, &square, moved, request, result), 1u);
  EXPECT_NEAR(result.getContact(0).penetration_depth, 1, 1e-12);
  EXPECT_NEAR(result.getContact(0).normal.x(), 1, 1e-12);

  // A geometry of FCL's own meets the polygon in its plane, z = 0.
  const fcl::Sphered ball(1);
  moved.translation() << 2, 2, 0.5;
  fcl::CollisionResultd with_ball;
  EXPECT_EQ(tricover_fcl::collide<double>(&square, still, &ball, moved, request, with_ball), 1u);
  //! [fcl collide]
}

TEST(Documentation, FclCollideWithOptions) {
  //! [fcl collide with options]
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  const fcl::CollisionObjectd still(square), moved(square, Eigen::Matrix3d::Identity(), fcl::Vector3d(4.5, 0, 0));
  tricover::CollideOptions options;
  options.margin = 0.5;
  fcl::CollisionResultd result;
  EXPECT_EQ(tricover_fcl::collide(&still, &moved, fcl::CollisionRequestd(), options, result), 1u);
  //! [fcl collide with options]
}

TEST(Documentation, FclCollideCallback) {
  //! [fcl collide callback]
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  fcl::CollisionObjectd still(square), moved(square, Eigen::Matrix3d::Identity(), fcl::Vector3d(3, 1, 0));
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&still);
  manager.setup();
  fcl::DefaultCollisionData<double> data;
  manager.collide(&moved, &data, tricover_fcl::defaultCollisionFunction<double>);
  EXPECT_TRUE(data.result.isCollision());
  //! [fcl collide callback]
}

TEST(Documentation, FclDistance) {
  //! [fcl distance]
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  const fcl::CollisionObjectd still(square), moved(square, Eigen::Matrix3d::Identity(), fcl::Vector3d(7, 1, 0));
  fcl::DistanceResultd result;
  EXPECT_EQ(tricover_fcl::distance(&still, &moved, fcl::DistanceRequestd(), result), 3);
  EXPECT_EQ(result.nearest_points[0].x(), 4);

  const fcl::CollisionObjectd inside(square, Eigen::Matrix3d::Identity(), fcl::Vector3d(3, 0, 0));
  fcl::DistanceRequestd signed_too;
  signed_too.enable_signed_distance = true;
  fcl::DistanceResultd depth;
  EXPECT_NEAR(tricover_fcl::distance(&still, &inside, signed_too, depth), -1, 1e-12);
  //! [fcl distance]
}

TEST(Documentation, FclDistanceCallback) {
  //! [fcl distance callback]
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  fcl::CollisionObjectd still(square), moved(square, Eigen::Matrix3d::Identity(), fcl::Vector3d(7, 1, 0));
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObject(&still);
  manager.setup();
  fcl::DefaultDistanceData<double> data;
  manager.distance(&moved, &data, tricover_fcl::defaultDistanceFunction<double>);
  EXPECT_EQ(data.result.min_distance, 3);
  //! [fcl distance callback]
}

TEST(Documentation, FclContinuousCollide) {
  //! [fcl continuous collide]
  const tricover_fcl::PolygonShaped square(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  const fcl::Transform3d still = fcl::Transform3d::Identity();
  fcl::Transform3d begin = still, end = still;
  begin.translation() << 14, 0, 0;
  end.translation() << -6, 0, 0;
  fcl::ContinuousCollisionRequestd request;
  request.ccd_motion_type = fcl::CCDM_TRANS;
  fcl::ContinuousCollisionResultd result;
  const double time =
      tricover_fcl::continuousCollide<double>(&square, still, still, &square, begin, end, request, result);
  EXPECT_TRUE(result.is_collide);
  EXPECT_LE(time, 0.5);  // never later than the first contact
  EXPECT_GE(time, 0.5 - request.toc_err);
  //! [fcl continuous collide]
}

TEST(Documentation, FclTrajectory) {
  //! [fcl trajectory]
  const tricover_fcl::PolygonShaped robot(tricover::Polygon({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}));
  const auto at = [](double x, double y) {
    tricover::Pose pose = tricover::Pose::Identity();
    pose.translation() << x, y;
    return pose;
  };
  // Seconds: one robot waits on the crossing from 10 to 20; the other one follows two of FCL's splines past there.
  const auto waits = tricover::Trajectory::through({{0, at(-10, 0)}, {10, at(0, 0)}, {20, at(0, 0)}, {30, at(10, 0)}});
  const fcl::Vector3d zero = fcl::Vector3d::Zero(), step(0, 10, 0);  // of evenly spaced control points: straight on
  const auto comes = std::make_shared<fcl::SplineMotion<double>>(-2 * step, -step, zero, step, zero, zero, zero, zero);
  const auto goes = std::make_shared<fcl::SplineMotion<double>>(-step, zero, step, 2 * step, zero, zero, zero, zero);
  const tricover_fcl::TrajectoryMotiond one(waits, 0, 40), other({{6, 16, comes}, {16, 26, goes}}, 0, 40);
  fcl::ContinuousCollisionRequestd request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  request.toc_err = 1e-6;
  fcl::ContinuousCollisionResultd result;
  tricover_fcl::continuousCollide<double>(&robot, &one, &robot, &other, request, result);
  EXPECT_TRUE(result.is_collide);
  EXPECT_NEAR(one.clockAt(result.time_of_contact), 14, 1e-4);
  //! [fcl trajectory]
}

TEST(Documentation, FclCollideOfMovingObjects) {
  //! [fcl collide of moving objects]
  const auto square =
      std::make_shared<tricover_fcl::PolygonShaped>(tricover::Polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  const fcl::Vector3d zero = fcl::Vector3d::Zero(), step(10, 0, 0);  // of evenly spaced control points: straight on
  fcl::ContinuousCollisionObjectd still(
      square, std::make_shared<fcl::SplineMotion<double>>(zero, zero, zero, zero, zero, zero, zero, zero));
  fcl::ContinuousCollisionObjectd comes(
      square, std::make_shared<fcl::SplineMotion<double>>(-2 * step, -step, zero, step, zero, zero, zero, zero));
  fcl::DefaultContinuousCollisionData<double> data;
  data.request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  tricover_fcl::defaultContinuousCollisionFunction<double>(&still, &comes, &data);
  EXPECT_NEAR(data.result.time_of_contact, 0.6, data.request.toc_err);
  fcl::ContinuousCollisionResultd result;
  EXPECT_EQ(tricover_fcl::collide(&still, &comes, data.request, result), data.result.time_of_contact);
  //! [fcl collide of moving objects]
}

}  // namespace
