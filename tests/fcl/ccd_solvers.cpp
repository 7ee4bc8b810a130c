// SPDX-License-Identifier: BSD-3-Clause
// fcl::continuousCollide with each ccd_solver_type.
#include <fcl/geometry/shape/box.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ask.h"
#include "tricover/trajectory.h"

namespace tricover_fcl::test {
namespace {

/// FCL's default solver looks ten times on the way and sees nothing, and two others know no polygons.
TEST(Solvers, areAllExactOfPolygons) {
  const Shape<double> square = rectangular(-0.5, -0.5, 0.5, 0.5);
  const Shape<double> wall = rectangular(-0.025, -5, 0.025, 5);
  const fcl::Boxd box_wall(0.05, 10, 1);
  const fcl::Transform3d begin = lifted(0, -20, 0), end = lifted(0, 20, 0), here = lifted(0, 0, 0);
  const auto passes = std::make_shared<fcl::TranslationMotiond>(begin, end),
             rests = std::make_shared<fcl::TranslationMotiond>(here, here);
  const fcl::CollisionObjectd object(square, begin), beside(wall, here);
  const fcl::ContinuousCollisionObjectd moving(square, passes), resting(wall, rests);
  using Request = fcl::ContinuousCollisionRequestd;
  std::vector<Request> requests = {{}};
  for (const fcl::CCDSolverType solver :
       {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDC_RAY_SHOOTING, fcl::CCDC_POLYNOMIAL_SOLVER}) {
    for (const fcl::GJKSolverType gjk : kSolvers) requests.push_back({1, 1e-4, fcl::CCDM_TRANS, gjk, solver});
    requests.push_back({10, 0.9, fcl::CCDM_LINEAR, fcl::GST_LIBCCD, solver});
  }
  for (const Request& request : requests) {
    SCOPED_TRACE(request.ccd_solver_type);
    fcl::ContinuousCollisionResultd results[7];
    fcl::continuousCollide(square.get(), begin, end, wall.get(), here, here, request, results[0]);
    fcl::continuousCollide(wall.get(), here, here, square.get(), begin, end, request, results[1]);
    fcl::continuousCollide<double>(square.get(), passes.get(), wall.get(), rests.get(), request, results[2]);
    fcl::continuousCollide(&object, end, &beside, here, request, results[3]);
    fcl::collide(&moving, &resting, request, results[4]);
    fcl::continuousCollide<double>(square.get(), passes.get(), &box_wall, rests.get(), request, results[5]);
    fcl::continuousCollide<double>(&box_wall, rests.get(), square.get(), passes.get(), request, results[6]);
    for (const fcl::ContinuousCollisionResultd& result : results) {
      ASSERT_TRUE(result.is_collide);
      EXPECT_LE(result.time_of_contact, 0.486875 + 1e-12);
      EXPECT_GE(result.time_of_contact, 0.486875 - request.toc_err);
    }
    EXPECT_NEAR(results[0].contact_tf1.translation().x(), 40 * results[0].time_of_contact - 20, 1e-12);
  }
}

/// FCL would take the motion for one that stands still, and a body that is absent for one that rests: wherever the two
/// are, also where they overlap at time 0, of which FCL asks no motion.
TEST(Solvers, sampleATrajectoryMotionBesideFclsOwnPairsOrRefuseIt) {
  const fcl::Boxd box(1, 1, 1);
  const auto still = [](double x) { return tricover::Motion::still(tricover::support::turnedAndMoved(0, x, 0)); };
  const fcl::TranslationMotiond rests(lifted(0, 0, 0), lifted(0, 0, 0));
  for (const double x : {0.0, 9.0}) {
    const tricover::Trajectory early({{-2, -1, still(x)}}), late({{0.5, 2, still(x)}}), first({{0, 0.5, still(x)}});
    for (const fcl::CCDSolverType solver :
         {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDC_POLYNOMIAL_SOLVER}) {
      SCOPED_TRACE(testing::Message() << x << ", " << solver);
      fcl::ContinuousCollisionRequestd request;
      request.ccd_solver_type = solver;
      const auto ask = [&](const tricover::Trajectory& trajectory, bool absent_outside, bool swapped, bool ours) {
        const TrajectoryMotiond motion(trajectory, 0, 1, 0, absent_outside);
        const fcl::MotionBase<double>*one = &motion, *other = &rests;
        if (swapped) std::swap(one, other);
        fcl::ContinuousCollisionResultd result;
        if (ours)
          tricover_fcl::continuousCollide<double>(&box, one, &box, other, request, result);
        else
          fcl::continuousCollide<double>(&box, one, &box, other, request, result);
        return result.is_collide;
      };
      for (const bool swapped : {false, true}) {
        for (const bool ours : {false, true}) {
          for (const tricover::Trajectory* absent : {&early, &late, &first})
            EXPECT_THROW(ask(*absent, true, swapped, ours), std::logic_error);
          if (solver == fcl::CCDC_NAIVE) {
            EXPECT_EQ(ask(early, false, swapped, ours), x == 0);
            EXPECT_EQ(ask(tricover::Trajectory({{-1, 3, still(x)}}), true, swapped, ours), x == 0);
          } else {
            EXPECT_NE(thrownBy<std::logic_error>([&] { ask(early, false, swapped, ours); }).find("CCDC_NAIVE"),
                      std::string::npos);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace tricover_fcl::test
