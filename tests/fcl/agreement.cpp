// SPDX-License-Identifier: BSD-3-Clause
// The laws that collide, distance and continuousCollide share, along random walks, and the managers' distance.
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <functional>

#include "managers.h"
#include "scene.h"

namespace tricover_fcl::test {
namespace {

bool collide(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b, fcl::GJKSolverType solver) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = solver;
  fcl::CollisionResultd result;
  return fcl::collide(&a, &b, request, result) > 0;
}

double distance(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b, fcl::GJKSolverType solver,
                bool is_signed) {
  fcl::DistanceRequestd request;
  request.gjk_solver_type = solver;
  request.enable_signed_distance = is_signed;
  fcl::DistanceResultd result;
  fcl::distance(&a, &b, request, result);
  return result.min_distance;
}

/// From where the objects are, straight to where they are: only the begin can be a contact.
double timeOfContact(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b, fcl::GJKSolverType solver) {
  const fcl::ContinuousCollisionRequestd request(10, 1e-6, fcl::CCDM_TRANS, solver, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  fcl::ContinuousCollisionResultd result;
  const double time = fcl::continuousCollide(&a, a.getTransform(), &b, b.getTransform(), request, result);
  EXPECT_EQ(result.is_collide, time < 1);
  return time;
}

TEST(Agreement, alongWalks) {
  Random random(71);
  int hits = 0, queries = 0;
  for (int walk = 0; walk < scaledCount(150); ++walk) {
    const double heights[3] = {0, random.real(0, 0.2), 0};
    const auto shape = [&](double height) {
      return std::make_shared<PolygonShaped>(randomPolygon(random, 1), PolygonOptions{0, 0, height});
    };
    fcl::CollisionObjectd a(shape(heights[walk % 3])), b(shape(heights[(walk + 1) % 3]));
    tricover::Vec2 place(random.real(-2, 2), random.real(-2, 2));
    double angle = 0, z = 0;
    for (int step = 0; step < 100; ++step) {
      const double stride = random.oneIn(30) ? 1 : 0.05;
      angle += stride * random.real(-1, 1);
      place = 0.98 * place + stride * tricover::Vec2(random.real(-1, 1), random.real(-1, 1));
      if (random.oneIn(10)) z = random.coin() ? 0 : random.real(-0.3, 0.3);
      a.setTransform(lifted(tricover::support::turnedAndMoved(angle, place.x(), place.y()), z));
      a.computeAABB();
      const bool hit = collide(a, b, fcl::GST_LIBCCD);
      ASSERT_TRUE(!hit || a.getAABB().overlap(b.getAABB()));
      ASSERT_EQ(collide(b, a, fcl::GST_INDEP), hit);
      const double apart = distance(a, b, fcl::GST_LIBCCD, false);
      ASSERT_EQ(apart <= 0, hit) << walk << " " << step;
      ASSERT_EQ(distance(b, a, fcl::GST_INDEP, false), apart);
      // Copies' poses are at other places: nothing is remembered of them.
      ASSERT_EQ(distance(fcl::CollisionObjectd(a), fcl::CollisionObjectd(b), fcl::GST_INDEP, false), apart);
      const double time = timeOfContact(a, b, fcl::GST_LIBCCD);
      ASSERT_EQ(time == 0, hit) << walk << " " << step;
      ASSERT_EQ(timeOfContact(b, a, fcl::GST_INDEP), time);
      if (step % 10 == 0) {
        const double with_sign = distance(a, b, fcl::GST_LIBCCD, true);
        ASSERT_EQ(distance(b, a, fcl::GST_INDEP, true), with_sign) << walk << " " << step;
        ASSERT_TRUE(hit ? with_sign <= 0 : with_sign == apart);
      }
      hits += hit;
      ++queries;
    }
  }
  EXPECT_GT(hits, queries * 2 / 10);
  EXPECT_LT(hits, queries * 8 / 10);
}

TEST(Agreement, managersFindTheLeastDistance) {
  Random random(72);
  int apart = 0, scenes = scaledCount(60);
  for (int scene = 0; scene < scenes; ++scene) {
    const double spread = random.coin() ? 6 : 18;
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
    std::vector<fcl::CollisionObjectd*> registered;
    for (int i = 0; i < 12; ++i) {
      const double height = random.oneIn(3) ? 0.5 : 0;
      const auto shape = std::make_shared<PolygonShaped>(randomPolygon(random, random.real(0.5, 1.5)),
                                                         PolygonOptions{random.oneIn(3) ? 0.3 : 0, 0, height});
      objects.push_back(
          std::make_unique<fcl::CollisionObjectd>(shape, lifted(randomPose(random, spread), random.oneIn(4) ? 1 : 0)));
      registered.push_back(objects.back().get());
    }
    const fcl::CollisionObjectd& probe = *objects.back();
    registered.pop_back();

    const fcl::GJKSolverType solver = scene % 2 ? fcl::GST_INDEP : fcl::GST_LIBCCD;
    double all = std::numeric_limits<double>::max(), from_probe = all;
    for (std::size_t i = 0; i < registered.size(); ++i) {
      from_probe = std::min(from_probe, distance(*registered[i], probe, solver, false));
      for (std::size_t j = 0; j < i; ++j) all = std::min(all, distance(*registered[i], *registered[j], solver, false));
    }
    for (const auto& [name, manager] : managersOfEveryKind()) {
      SCOPED_TRACE(name);
      manager->registerObjects(registered);
      manager->setup();
      for (const auto callback : {fcl::DefaultDistanceFunction<double>, defaultDistanceFunction<double>}) {
        fcl::DefaultDistanceData<double> of_all, of_probe;
        of_all.request.gjk_solver_type = of_probe.request.gjk_solver_type = solver;
        manager->distance(&of_all, callback);
        manager->distance(objects.back().get(), &of_probe, callback);
        // Of pairs that are in contact, any may be found first.
        if (all > 0) {
          EXPECT_EQ(of_all.result.min_distance, all) << scene;
        } else {
          EXPECT_LE(of_all.result.min_distance, 0) << scene;
        }
        if (from_probe > 0) {
          EXPECT_EQ(of_probe.result.min_distance, from_probe) << scene;
        } else {
          EXPECT_LE(of_probe.result.min_distance, 0) << scene;
        }
      }
    }
    apart += all > 0;
  }
  EXPECT_GT(apart, scenes / 10);
  EXPECT_LT(apart, scenes * 9 / 10);
}

}  // namespace
}  // namespace tricover_fcl::test
