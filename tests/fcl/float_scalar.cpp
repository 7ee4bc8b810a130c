// SPDX-License-Identifier: BSD-3-Clause
// FCL's entry points for float are templates: this file instantiates them and their tables, as a user's code does.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <limits>

#include "ask.h"

template std::size_t fcl::collide(const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                  const fcl::CollisionGeometryf*, const fcl::Transform3f&,
                                  const fcl::CollisionRequestf&, fcl::CollisionResultf&);
template std::size_t fcl::collide(const fcl::CollisionObjectf*, const fcl::CollisionObjectf*,
                                  const fcl::CollisionRequestf&, fcl::CollisionResultf&);
template float fcl::distance(const fcl::CollisionGeometryf*, const fcl::Transform3f&, const fcl::CollisionGeometryf*,
                             const fcl::Transform3f&, const fcl::DistanceRequestf&, fcl::DistanceResultf&);

namespace tricover_fcl::test {
namespace {

TEST(FloatScalar, broadphaseAndContact) {
  const Shape<float> square = rectangular<float>(0, 0, 1, 1);
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

TEST(FloatScalar, distancesBelowTheSmallestFloatAreNotZero) {
  const Shape<float> tiny = rectangular<float>(0, 0, 1e-60, 1e-60), other = rectangular<float>(3e-60, 0, 4e-60, 1e-60),
                     across = rectangular<float>(0, 0, 3.5e-60, 1e-60);
  const fcl::Transform3f here = fcl::Transform3f::Identity();
  for (const fcl::GJKSolverType solver : kSolvers) {
    EXPECT_EQ(distanceOf(solver, true, tiny, here, other, here).min_distance, std::numeric_limits<float>::denorm_min());
    EXPECT_EQ(distanceOf(solver, true, across, here, other, here).min_distance, 0);  // FCL asserts a depth
  }
}

TEST(FloatScalar, translationsCollide) {
  // The motions that compile; so does what takes motions, but not what takes transforms.
  const Shape<float> square = rectangular<float>(0, 0, 1, 1);
  const fcl::Transform3f begin = lifted<float>(0, -4, 0), end = lifted<float>(0, 4, 0),
                         here = fcl::Transform3f::Identity();
  const fcl::TranslationMotionf motion(begin, end), still(here, here);
  const fcl::TranslationMotionf flies(lifted<float>(0, -400, 0), lifted<float>(0, 400, 0));
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

}  // namespace
}  // namespace tricover_fcl::test
