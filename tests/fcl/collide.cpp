// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/collide.h"

#include <fcl/narrowphase/collision.h>

#include <algorithm>

#include "families.h"
#include "reproduction.h"
#include "scene.h"

namespace tricover_fcl::test {
namespace {

fcl::CollisionRequestd requestFor(fcl::GJKSolverType solver) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = solver;
  return request;
}

/// Every way to ask FCL about the pair agrees with the core.
void expectEverywhere(const tricover::support::Case& c, bool expected) {
  const Shape<double> a = shapeOf(c.a), b = shapeOf(c.b);
  const fcl::Transform3d tf_a = lifted(c.pose_a), tf_b = lifted(c.pose_b);
  const fcl::CollisionObjectd object_a(a, tf_a), object_b(b, tf_b);
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    const fcl::CollisionRequestd request = requestFor(solver);
    fcl::CollisionResultd geometries, swapped, objects, swapped_objects, ours, our_objects;
    EXPECT_EQ(fcl::collide(a.get(), tf_a, b.get(), tf_b, request, geometries), std::size_t{expected});
    EXPECT_EQ(fcl::collide(b.get(), tf_b, a.get(), tf_a, request, swapped), std::size_t{expected});
    EXPECT_EQ(fcl::collide(&object_a, &object_b, request, objects), std::size_t{expected});
    EXPECT_EQ(fcl::collide(&object_b, &object_a, request, swapped_objects), std::size_t{expected});
    EXPECT_EQ(tricover_fcl::collide<double>(a.get(), tf_a, b.get(), tf_b, request, ours), std::size_t{expected});
    EXPECT_EQ(tricover_fcl::collide(&object_a, &object_b, request, our_objects), std::size_t{expected});
  }
  if (::testing::Test::HasFailure()) ADD_FAILURE() << reproduction(c);
}

TEST(Collide, agreesWithTheCoreOnEveryFamily) {
  for (const tricover::support::Family& family : tricover::support::families()) {
    SCOPED_TRACE(family.name);
    // The first of some families all overlap.
    const int count = std::max(20, scaledCount(200));
    int hits = 0;
    for (int i = 0; i < count; ++i) {
      const tricover::support::Case c = family.make(static_cast<std::uint64_t>(i));
      const bool expected = tricover::collide(c.a, c.pose_a, c.b, c.pose_b);
      expectEverywhere(c, expected);
      if (HasFailure()) return;
      hits += expected;
    }
    EXPECT_GT(hits, 0);
    EXPECT_LT(hits, count);
  }
}

TEST(Collide, ignoresToleranceAndCachedGuess) {
  // A gap of one ulp, where FCL's own solvers see what their tolerance lets them see.
  const Shape<double> square = rectangular(0, 0, 1, 1);
  for (const double x : {1.0, nudged(1.0, 1)}) {
    for (const double tolerance : {1e-15, 1e-6, 1.0}) {
      fcl::CollisionRequestd request;
      request.gjk_tolerance = tolerance;
      request.enable_cached_gjk_guess = true;
      request.cached_gjk_guess = fcl::Vector3d(-3, 1, 7);
      fcl::CollisionResultd result;
      EXPECT_EQ(fcl::collide(square.get(), lifted(0, 0, 0), square.get(), lifted(0, x, 0), request, result),
                std::size_t{x == 1.0});
    }
  }
}

TEST(Collide, handsOtherPairsToFcl) {
  const auto sphere = std::make_shared<fcl::Sphered>(1);
  const fcl::CollisionObjectd near(sphere), far(sphere, fcl::Matrix3d::Identity(), fcl::Vector3d(3, 0, 0));
  fcl::CollisionResultd hit, miss;
  EXPECT_EQ(tricover_fcl::collide(&near, &near, fcl::CollisionRequestd(), hit), 1u);
  EXPECT_EQ(tricover_fcl::collide(&near, &far, fcl::CollisionRequestd(), miss), 0u);
}

}  // namespace
}  // namespace tricover_fcl::test
