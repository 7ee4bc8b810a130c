// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ask.h"
#include "families.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/penetration.h"
#include "tricover/segment.h"

namespace tricover_fcl::test {
namespace {

fcl::DistanceRequestd requestFor(fcl::GJKSolverType solver, bool is_signed = false) {
  fcl::DistanceRequestd request;
  request.gjk_solver_type = solver;
  request.enable_signed_distance = is_signed;
  return request;
}

tricover::Vec2 flat(const fcl::Vector3d& point) { return point.head<2>(); }

TEST(Distance, isTheCoresOnEveryFamily) {
  for (const tricover::support::Family& family : tricover::support::families()) {
    SCOPED_TRACE(family.name);
    int overlaps = 0;
    // The first of some families all overlap.
    const int count = std::max(20, scaledCount(60));
    for (int i = 0; i < count; ++i) {
      const tricover::support::Case c = family.make(static_cast<std::uint64_t>(i));
      const double truth = tricover::distance(c.a, c.pose_a, c.b, c.pose_b).distance;
      if (!(truth < std::numeric_limits<double>::max())) continue;
      const Shape<double> a = shapeOf(c.a), b = shapeOf(c.b);
      const fcl::CollisionObjectd object_a(a, lifted(c.pose_a)), object_b(b, lifted(c.pose_b));
      for (const fcl::GJKSolverType solver : kSolvers) {
        fcl::DistanceResultd geometries, swapped, objects, ours;
        const double answer = fcl::distance(a.get(), object_a.getTransform(), b.get(), object_b.getTransform(),
                                            requestFor(solver), geometries);
        ASSERT_EQ(answer, geometries.min_distance);
        if (truth > 0) {
          ASSERT_EQ(answer, truth) << reproduction(c);
        } else {
          ASSERT_TRUE(answer == 0 || answer == -1) << reproduction(c);
        }
        ASSERT_EQ(fcl::distance(b.get(), object_b.getTransform(), a.get(), object_a.getTransform(), requestFor(solver),
                                swapped),
                  answer)
            << reproduction(c);
        ASSERT_EQ(fcl::distance(&object_a, &object_b, requestFor(solver), objects), answer) << reproduction(c);
        ASSERT_EQ(tricover_fcl::distance(&object_b, &object_a, requestFor(solver), ours), answer) << reproduction(c);
        ASSERT_EQ(geometries.o1, a.get());
        ASSERT_EQ(geometries.o2, b.get());
        ASSERT_EQ(swapped.o1, b.get());
        ASSERT_EQ(geometries.nearest_points[0].z(), 0);
        // As far apart as is said, but for the rounding of coordinates.
        const double extent = geometries.nearest_points[0].norm() + geometries.nearest_points[1].norm();
        if (extent < 1e150) {
          ASSERT_NEAR((geometries.nearest_points[0] - geometries.nearest_points[1]).stableNorm(), std::max(answer, 0.0),
                      1e-320 + 1e-14 * (extent + std::max(answer, 0.0) + c.a.radius() + c.b.radius() +
                                        c.pose_a.translation().norm()))
              << reproduction(c);
        }
      }
      overlaps += truth == 0;
    }
    EXPECT_GT(overlaps, 0);
    EXPECT_LT(overlaps, count);
  }
}

TEST(Distance, tellsTouchFromOverlap) {
  const Shape<double> square = rectangular(0, 0, 1, 1);
  for (const fcl::GJKSolverType solver : kSolvers)
    for (const bool is_signed : {false, true})
      for (const double x : {1.0, nudged(1, -1), nudged(1, 1)}) {
        const auto result = distanceOf<double>(solver, is_signed, *square, lifted(0, 0, 0), *square, lifted(0, x, 0));
        const double answer = result.min_distance;
        if (x >= 1) {
          EXPECT_EQ(answer, x - 1);
        } else if (is_signed) {
          EXPECT_LT(answer, 0);
          EXPECT_GE(answer, -1e-12);
        } else {
          EXPECT_EQ(answer, -1);
        }
        EXPECT_NEAR(result.nearest_points[0].x(), 1, 1e-12);
      }
}

TEST(Distance, signedIsMinusTheShortestWayOut) {
  Random random(51);
  int hits = 0;
  const int count = scaledCount(200);
  for (int i = 0; i < count; ++i) {
    const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const tricover::Pose pose_a = randomPose(random, 1);
    const tricover::Pose pose_b = randomPose(random, 1);
    const Shape<double> shape_a = shapeOf(a), shape_b = shapeOf(b);
    const auto penetration = tricover::penetration(a, pose_a, b, pose_b);
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto result = distanceOf<double>(solver, true, *shape_a, lifted(pose_a, 2), *shape_b, lifted(pose_b, 2));
      const double answer = result.min_distance;
      if (!penetration) {
        ASSERT_GT(answer, 0);
        continue;
      }
      ASSERT_EQ(answer, -penetration->depth) << i;
      const tricover::Vec2 middle = (penetration->point_a + penetration->point_b) / 2;
      // INDEP asks collide again, and puts the contact's place in.
      const bool places = solver == fcl::GST_INDEP;
      ASSERT_NEAR((flat(result.nearest_points[0]) - (places ? middle : penetration->point_a)).norm(), 0, 1e-15) << i;
      ASSERT_NEAR((flat(result.nearest_points[1]) - (places ? middle : penetration->point_b)).norm(), 0, 1e-15) << i;
      ASSERT_EQ(result.nearest_points[0].z(), 2);
      const auto contacts = contactsOf(*shape_a, lifted(pose_a), *shape_b, lifted(pose_b), 1);
      ASSERT_EQ(contacts.at(0).penetration_depth, -answer);
    }
    hits += penetration.has_value();
  }
  EXPECT_GT(hits, count * 3 / 10);
  EXPECT_LT(hits, count);
}

TEST(Distance, resultKeepsTheLeast) {
  const Shape<double> square = rectangular(0, 0, 1, 1);
  const Shape<double> other = shapeOf(tricover::Polygon({{{1, 1}, {0, 1}, {0, 0}, {1, 0}}}));  // other numbers of edges
  for (const fcl::GJKSolverType solver : kSolvers) {
    fcl::DistanceResultd result;
    const auto ask = [&](const Shape<double>& b, double x) {
      return fcl::distance(square.get(), fcl::Transform3d::Identity(), b.get(), lifted(0, x, 0), requestFor(solver),
                           result);
    };
    EXPECT_EQ(ask(square, 4), 3);
    const auto edge = result.b2;
    EXPECT_EQ(ask(other, 9), 3);
    EXPECT_EQ(ask(other, 4), 3);  // no nearer
    EXPECT_EQ(result.o2, square.get());
    EXPECT_EQ(result.b2, edge);
    EXPECT_EQ(ask(other, 3), 2);
    EXPECT_EQ(result.o2, other.get());
    EXPECT_EQ(result.nearest_points[1].x(), 3);
    expectOnEdge(*square, result.b1, flat(result.nearest_points[0]));
    expectOnEdge(*other, result.b2, flat(result.nearest_points[1]) - tricover::Vec2(3, 0));
    EXPECT_EQ(ask(square, 0.5), -1);
    EXPECT_EQ(result.o2, square.get());
    // Satisfied: not even the poses are looked at.
    fcl::Transform3d nowhere = fcl::Transform3d::Identity();
    nowhere.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(fcl::distance(square.get(), nowhere, other.get(), nowhere, requestFor(solver), result), -1);
  }
}

TEST(Distance, badPosesAreRefusedHoweverFarApart) {
  const Shape<double> square = rectangular(0, 0, 1, 1);
  fcl::Transform3d scaled = lifted(0, 5, 0, 100), tilted(fcl::AngleAxis<double>(1, fcl::Vector3d::UnitX()));
  scaled.matrix()(0, 0) = 2;
  fcl::DistanceResultd result(1);
  for (const fcl::Transform3d& bad : {scaled, tilted}) {
    const std::string text = thrownBy<std::invalid_argument>([&] {
      fcl::distance(square.get(), fcl::Transform3d::Identity(), square.get(), bad, fcl::DistanceRequestd(), result);
    });
    EXPECT_NE(text.find("pose_b"), std::string::npos) << text;
  }
  fcl::DistanceRequestd negative;
  negative.rel_err = -1;
  EXPECT_THROW(
      fcl::distance(square.get(), fcl::Transform3d::Identity(), square.get(), lifted(0, 1.5, 0), negative, result),
      std::invalid_argument);
}

TEST(Distance, errorsStayWithinWhatTheRequestAllows) {
  Random random(52);
  int inexact = 0, apart = 0;
  for (int i = 0; i < scaledCount(500); ++i) {
    const tricover::Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const tricover::Pose pose_a = randomPose(random, 1);
    const tricover::Pose pose_b = randomPose(random, 4);
    const double truth = tricover::distance(a, pose_a, b, pose_b).distance, z = random.coin() ? 0 : 1.5;
    fcl::DistanceRequestd request = requestFor(kSolvers[i % 2]);
    request.rel_err = 0.2;
    request.abs_err = 0.05;
    fcl::DistanceResultd result;
    const double answer =
        fcl::distance<double>(shapeOf(a).get(), lifted(pose_a), shapeOf(b).get(), lifted(pose_b, z), request, result);
    const double exact = std::hypot(truth, z);
    ASSERT_EQ(answer > 0, exact > 0);
    if (!(exact > 0)) continue;
    ASSERT_GE(answer, exact * (1 - 1e-14));
    ASSERT_LE(answer, exact * 1.2 + 0.05);
    inexact += answer > exact * (1 + 1e-12);
    ++apart;
  }
  EXPECT_GT(apart, 0);
  EXPECT_GT(inexact, 0);
}

TEST(Distance, signedOfWhatIsNotOccupiedDoesNotAbort) {
  const Shape<double> square = rectangular(0, 0, 1, 1);
  square->cost_density = 0.5;
  const auto ask = [&](fcl::GJKSolverType solver, double x) {
    return distanceOf<double>(solver, true, *square, lifted(0, 0, 0), *square, lifted(0, x, 0)).min_distance;
  };
  EXPECT_NEAR(ask(fcl::GST_LIBCCD, 0.75), -0.25, 1e-12);
  EXPECT_THROW(ask(fcl::GST_INDEP, 0.75), std::logic_error);
  EXPECT_EQ(ask(fcl::GST_INDEP, 1.5), 0.5);
}

TEST(Distance, otherPairsGoToFcl) {
  const auto sphere = std::make_shared<fcl::Sphered>(1);
  const fcl::CollisionObjectd a(sphere), b(sphere, fcl::Matrix3d::Identity(), fcl::Vector3d(5, 0, 0));
  fcl::DistanceResultd result;
  EXPECT_NEAR(tricover_fcl::distance(&a, &b, fcl::DistanceRequestd(), result), 3, 1e-6);
}

/// Without margins, -1 says exactly that interiors meet: how little doesn't matter.
TEST(DistanceOfTouches, areMinusOneExactlyWhereInteriorsMeet) {
  registerNarrowphase();
  const auto ask = [](const tricover::Polygon& a, const tricover::Polygon& b, double x, double y) {
    const Shape<double> first = shapeOf(a), second = shapeOf(b);
    fcl::DistanceResultd result, swapped;
    const fcl::Transform3d here = lifted(0, 0, 0), there = lifted(0, x, y);
    const double found = distanceOf<double>(fcl::GST_LIBCCD, false, *first, here, *second, there).min_distance;
    EXPECT_EQ(distanceOf<double>(fcl::GST_LIBCCD, false, *second, there, *first, here).min_distance, found);
    return found;
  };
  const tricover::Polygon square({rectangle(-1, -1, 0, 1)}), other({rectangle(0, -1, 1, 1)}),
      diamond({{{0, 0}, {1, 1}, {2, 0}, {1, -1}}});
  for (const tricover::Polygon& beside : {other, diamond}) {
    EXPECT_EQ(ask(square, beside, 0, 0), 0);
    EXPECT_EQ(ask(square, beside, -1e-17, 0), -1);
    EXPECT_EQ(ask(square, beside, -1e-300, 0), -1);
    EXPECT_EQ(ask(square, beside, 1e-300, 0), 1e-300);
  }
  // A square that fills a hole touches it all around.
  const tricover::Polygon frame({rectangle(-3, -3, 3, 3), rectangle(-1, -1, 1, 1)});
  EXPECT_EQ(ask(frame, tricover::Polygon({rectangle(-1, -1, 1, 1)}), 0, 0), 0);
  EXPECT_EQ(ask(frame, tricover::Polygon({rectangle(-1, -1, 1, 1)}), 1e-17, 0), -1);
  // Segments and points have no interior. They overlap where they have a depth.
  EXPECT_EQ(ask(tricover::segment({-1, 0}, {1, 0}), tricover::segment({0, -1}, {0, 1}), 0, 0), -1);
  EXPECT_EQ(ask(tricover::segment({-1, 0}, {0, 0}), tricover::segment({0, -1}, {0, 1}), 0, 0), 0);
  EXPECT_EQ(ask(square, tricover::point({0, 0}), -0.5, 0), -1);
  EXPECT_EQ(ask(square, tricover::point({0, 0}), 0, 0), 0);
}

}  // namespace
}  // namespace tricover_fcl::test
