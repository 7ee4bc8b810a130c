// SPDX-License-Identifier: BSD-3-Clause
// FCL's entry points for float are templates: this file instantiates them and their tables, as a user's code does.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>

#include "families.h"
#include "scene.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover_fcl::test {
namespace {

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
}

}  // namespace
}  // namespace tricover_fcl::test
