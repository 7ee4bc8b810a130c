// SPDX-License-Identifier: BSD-3-Clause
// FCL's entry points for float are templates: this file instantiates them and their tables, as a user's code does.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <limits>

#include "families.h"
#include "scene.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

template std::size_t fcl::collide(const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                  const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                  const fcl::CollisionRequestf&, fcl::CollisionResultf&);
template float fcl::distance(const fcl::CollisionGeometryf*, const fcl::Transform3f&, const fcl::CollisionGeometryf*,
                             const fcl::Transform3f&, const fcl::DistanceRequestf&, fcl::DistanceResultf&);

namespace tricover_fcl::test {
namespace {

using tricover::support::Random;

TEST(FloatScalar, answersExactlyForTheFloatPoses) {
  int hits = 0, cases = 0;
  for (const tricover::support::Family& family : tricover::support::families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < tricover::support::scaledCount(100); ++i) {
      const tricover::support::Case c = family.make(static_cast<std::uint64_t>(i));
      const Shape<float> a = shapeOf<float>(c.a), b = shapeOf<float>(c.b);
      const fcl::Transform3f tf_a = lifted<float>(c.pose_a), tf_b = lifted<float>(c.pose_b);
      if (!tf_a.matrix().allFinite() || !tf_b.matrix().allFinite()) continue;  // beyond float
      const bool expected = tricover::collide(c.a, flat(tf_a), c.b, flat(tf_b));
      const fcl::CollisionObjectf object_a(a, tf_a), object_b(b, tf_b);
      for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
        fcl::CollisionRequestf request;
        request.gjk_solver_type = solver;
        fcl::CollisionResultf geometries, swapped, objects, ours, our_objects;
        ASSERT_EQ(fcl::collide(a.get(), tf_a, b.get(), tf_b, request, geometries), std::size_t{expected}) << i;
        ASSERT_EQ(fcl::collide(b.get(), tf_b, a.get(), tf_a, request, swapped), std::size_t{expected}) << i;
        ASSERT_EQ(fcl::collide(&object_a, &object_b, request, objects), std::size_t{expected}) << i;
        ASSERT_EQ(tricover_fcl::collide<float>(a.get(), tf_a, b.get(), tf_b, request, ours), std::size_t{expected});
        ASSERT_EQ(tricover_fcl::collide(&object_a, &object_b, request, our_objects), std::size_t{expected}) << i;
      }
      ++cases;
      hits += expected;
    }
  }
  EXPECT_GT(hits, cases * 2 / 10);
  EXPECT_LT(hits, cases * 8 / 10);
}

TEST(FloatScalar, broadphaseAndContact) {
  const Shape<float> square = shapeOf<float>(tricover::Polygon({tricover::support::rectangle(0, 0, 1, 1)}));
  fcl::CollisionObjectf standing(square), moving(square);
  fcl::DynamicAABBTreeCollisionManagerf manager;
  manager.registerObject(&standing);
  manager.setup();
  for (const float x : {0.5f, 1.0f, 1.0001f}) {
    moving.setTranslation(fcl::Vector3f(x, 0, 0));
    moving.computeAABB();
    fcl::DefaultCollisionData<float> data, our_data;
    data.request.enable_contact = true;
    manager.collide(&moving, &data, fcl::DefaultCollisionFunction<float>);
    manager.collide(&moving, &our_data, defaultCollisionFunction<float>);
    EXPECT_EQ(data.result.numContacts(), std::size_t{x <= 1});
    EXPECT_EQ(our_data.result.numContacts(), std::size_t{x <= 1});
    if (x <= 1) {
      const fcl::Contactf& contact = data.result.getContact(0);
      EXPECT_EQ(std::abs(contact.normal.x()), 1.0f);
      EXPECT_GE(contact.pos.x(), x);
      EXPECT_LE(contact.pos.x(), 1.0f);
    }
  }
}

TEST(FloatScalar, distancesAreRoundedExactOnes) {
  Random random(81);
  int apart = 0;
  const int count = tricover::support::scaledCount(300);
  for (int i = 0; i < count; ++i) {
    const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const fcl::Transform3f tf_a = lifted<float>(tricover::support::randomPose(random, 2), 1);
    const fcl::Transform3f tf_b = lifted<float>(tricover::support::randomPose(random, 2), 1);
    const Shape<float> shape_a = shapeOf<float>(a), shape_b = shapeOf<float>(b);
    const double truth = tricover::distance(a, flat(tf_a), b, flat(tf_b)).distance;
    const auto penetration = tricover::penetration(a, flat(tf_a), b, flat(tf_b));
    for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
      fcl::DistanceRequestf request;
      request.gjk_solver_type = solver;
      request.enable_signed_distance = true;
      fcl::DistanceResultf result, ours;
      const float answer = fcl::distance<float>(shape_a.get(), tf_a, shape_b.get(), tf_b, request, result);
      ASSERT_EQ(answer, static_cast<float>(penetration ? -penetration->depth : truth)) << i;
      ASSERT_EQ(result.min_distance, answer) << i;
      ASSERT_EQ(tricover_fcl::distance<float>(shape_b.get(), tf_b, shape_a.get(), tf_a, request, ours), answer) << i;
    }
    apart += truth > 0;
  }
  EXPECT_GT(apart, count / 10);
  EXPECT_LT(apart, count * 9 / 10);
}

TEST(FloatScalar, distancesBelowTheSmallestFloatAreNotZero) {
  const Shape<float> tiny = shapeOf<float>(tricover::Polygon({tricover::support::rectangle(0, 0, 1e-60, 1e-60)}));
  const Shape<float> other = shapeOf<float>(tricover::Polygon({tricover::support::rectangle(3e-60, 0, 4e-60, 1e-60)}));
  const Shape<float> across = shapeOf<float>(tricover::Polygon({tricover::support::rectangle(0, 0, 3.5e-60, 1e-60)}));
  const fcl::Transform3f pose = fcl::Transform3f::Identity();
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    fcl::DistanceRequestf request;
    request.gjk_solver_type = solver;
    request.enable_signed_distance = true;
    fcl::DistanceResultf apart, overlap;
    EXPECT_EQ(fcl::distance(tiny.get(), pose, other.get(), pose, request, apart),
              std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(fcl::distance(across.get(), pose, other.get(), pose, request, overlap), 0);  // FCL asserts a depth
  }
}

TEST(FloatScalar, translationsCollide) {
  // The motions that compile; so does what takes motions, but not what takes transforms.
  const Shape<float> square = shapeOf<float>(tricover::Polygon({tricover::support::rectangle(0, 0, 1, 1)}));
  const fcl::Transform3f begin = lifted<float>(tricover::support::turnedAndMoved(0, -4, 0)),
                         end = lifted<float>(tricover::support::turnedAndMoved(0, 4, 0)),
                         here = fcl::Transform3f::Identity();
  const fcl::TranslationMotionf motion(begin, end), still(here, here);
  const fcl::TranslationMotionf flies(lifted<float>(tricover::support::turnedAndMoved(0, -400, 0)),
                                      lifted<float>(tricover::support::turnedAndMoved(0, 400, 0)));
  const fcl::Spheref sphere(1);
  for (const fcl::CCDSolverType solver :
       {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDC_RAY_SHOOTING, fcl::CCDC_POLYNOMIAL_SOLVER}) {
    const fcl::ContinuousCollisionRequestf request(10, 1e-3f, fcl::CCDM_TRANS, fcl::GST_LIBCCD, solver);
    fcl::ContinuousCollisionResultf result, ours, passing, of_fcl;
    fcl::continuousCollide<float>(square.get(), &motion, square.get(), &still, request, result);
    EXPECT_TRUE(result.is_collide);
    EXPECT_LE(result.time_of_contact, 0.375f);
    EXPECT_GE(result.time_of_contact, 0.374f);
    fcl::continuousCollide<float>(square.get(), &flies, square.get(), &still, request, passing);
    EXPECT_TRUE(passing.is_collide);
    EXPECT_NEAR(passing.time_of_contact, 399 / 800.0f, 1e-3f);
    if (solver == fcl::CCDC_NAIVE || solver == fcl::CCDC_CONSERVATIVE_ADVANCEMENT) {
      fcl::continuousCollide<float>(&sphere, &motion, &sphere, &still, request, of_fcl);
      EXPECT_TRUE(of_fcl.is_collide);
    }
    tricover_fcl::continuousCollide<float>(square.get(), begin, end, square.get(), here, here, request, ours);
    EXPECT_TRUE(ours.is_collide);
    EXPECT_LE(ours.time_of_contact, 0.375f);
    EXPECT_GE(ours.time_of_contact, 0.374f);
    EXPECT_NEAR(ours.contact_tf1.translation().x(), -1, 0.01f);
  }
  fcl::ContinuousCollisionRequestf turning(10, 1e-3f, fcl::CCDM_LINEAR);
  fcl::ContinuousCollisionResultf result;
  EXPECT_THROW(
      tricover_fcl::continuousCollide<float>(square.get(), begin, end, square.get(), here, here, turning, result),
      std::logic_error);
}

TEST(FloatScalar, otherGeometriesMeetPolygonsOrGoToFcl) {
  const PolygonShapef polygon(tricover::Polygon({tricover::support::rectangle(0, 0, 1, 1)}));
  const fcl::Spheref sphere(1);
  const fcl::Transform3f pose = fcl::Transform3f::Identity();
  for (const float x : {1.99f, 2.01f}) {
    fcl::Transform3f moved = pose;
    moved.translation().x() = x;
    for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
      fcl::CollisionRequestf request;
      request.gjk_solver_type = solver;
      fcl::CollisionResultf result, swapped;
      EXPECT_EQ(fcl::collide(&polygon, pose, &sphere, moved, request, result), std::size_t{x < 2});
      EXPECT_EQ(fcl::collide(&sphere, moved, &polygon, pose, request, swapped), std::size_t{x < 2});
    }
  }
  fcl::CollisionResultf result;
  EXPECT_EQ(tricover_fcl::collide<float>(&sphere, pose, &sphere, pose, fcl::CollisionRequestf(), result), 1u);
  fcl::DistanceResultf distance;
  EXPECT_LE(tricover_fcl::distance<float>(&sphere, pose, &sphere, pose, fcl::DistanceRequestf(), distance), 0);
}

}  // namespace
}  // namespace tricover_fcl::test
