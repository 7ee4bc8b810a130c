// SPDX-License-Identifier: BSD-3-Clause
// Safety distances: of shapes, and of tricover_fcl::collide's options.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact_reference.h"
#include "families.h"
#include "reproduction.h"
#include "scene.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/prepare.h"
#include "tricover/segment.h"

namespace tricover_fcl::test {
namespace {

using tricover::support::Random;

Shape<double> withMargin(const tricover::Polygon& polygon, double margin) {
  return std::make_shared<PolygonShaped>(polygon, PolygonOptions{margin, 0, 0});
}

std::size_t collide(const Shape<double>& a, const fcl::Transform3d& tf_a, const Shape<double>& b,
                    const fcl::Transform3d& tf_b, fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  fcl::CollisionRequestd request;
  request.gjk_solver_type = solver;
  fcl::CollisionResultd result;
  return fcl::collide(a.get(), tf_a, b.get(), tf_b, request, result);
}

const tricover::Polygon kSquare({tricover::support::rectangle(0, 0, 1, 1)});

TEST(Margin, touchesToTheLastBit) {
  const Shape<double> a = withMargin(kSquare, 1.25), b = withMargin(kSquare, 1.75), plain = shapeOf(kSquare);
  const auto at = [](double x) { return lifted(tricover::support::pose(0, x, 0)); };
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    EXPECT_EQ(collide(a, at(0), b, at(4), solver), 1u);
    EXPECT_EQ(collide(b, at(4), a, at(0), solver), 1u);
    EXPECT_EQ(collide(a, at(0), b, at(tricover::support::nudged(4, 1)), solver), 0u);
    EXPECT_EQ(collide(a, at(0), plain, at(2.25), solver), 1u);
    EXPECT_EQ(collide(plain, at(tricover::support::nudged(2.25, 1)), a, at(0), solver), 0u);
  }
}

TEST(Margin, isExactOnEveryFamily) {
  int hits = 0, cases = 0, apart_hits = 0;
  for (const tricover::support::Family& family : tricover::support::families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < tricover::support::scaledCount(40); ++i) {
      const tricover::support::Case c = family.make(static_cast<std::uint64_t>(i));
      const mpq_class square = tricover::exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
      const double gap = tricover::exact::distanceBelow(square);
      if (!(gap < 1e300)) continue;
      // The largest double that isn't above the distance, and its neighbours, in two parts that add up exactly.
      for (const int steps : {-1, 0, 1}) {
        const double margin = gap > 0 ? tricover::support::nudged(gap, steps) : 0;
        const double of_a = margin / 2, of_b = margin - of_a;
        const bool expected = tricover::exact::within(square, mpq_class(of_a + of_b));
        const Shape<double> a = withMargin(c.a, of_a), b = withMargin(c.b, of_b);
        const fcl::Transform3d tf_a = lifted(c.pose_a), tf_b = lifted(c.pose_b);
        ASSERT_EQ(collide(a, tf_a, b, tf_b), std::size_t{expected}) << reproduction(c);
        ASSERT_EQ(collide(b, tf_b, a, tf_a, fcl::GST_INDEP), std::size_t{expected}) << reproduction(c);
        fcl::CollisionResultd by_options;
        ASSERT_EQ(tricover_fcl::collide(shapeOf(c.a).get(), tf_a, b.get(), tf_b, fcl::CollisionRequestd(), {of_a},
                                        by_options),
                  std::size_t{expected})
            << reproduction(c);
        // The broadphase doesn't lose the pair.
        fcl::CollisionObjectd object_a(a, tf_a), object_b(b, tf_b);
        ASSERT_TRUE(!expected || object_a.getAABB().overlap(object_b.getAABB())) << reproduction(c);
        ++cases;
        hits += expected;
        apart_hits += expected && gap > 0;
      }
    }
  }
  EXPECT_LT(hits, cases * 9 / 10);
  EXPECT_GT(apart_hits, cases / 10);
}

TEST(Margin, ofShapesAndOptionsAddUp) {
  const Shape<double> a = withMargin(kSquare, 0.5), b = withMargin(kSquare, 0.25);
  const fcl::CollisionObjectd object_a(a), object_b(b, lifted(tricover::support::pose(0, 2, 0)));
  for (const double margin : {0.25, 0.2499999}) {
    fcl::CollisionResultd objects, geometries;
    EXPECT_EQ(tricover_fcl::collide(&object_a, &object_b, fcl::CollisionRequestd(), {margin}, objects),
              std::size_t{margin == 0.25});
    EXPECT_EQ(tricover_fcl::collide<double>(b.get(), object_b.getTransform(), a.get(), object_a.getTransform(),
                                            fcl::CollisionRequestd(), {margin}, geometries),
              std::size_t{margin == 0.25});
  }
}

TEST(Margin, toleranceNeverMisses) {
  Random random(5);
  int hits = 0, alarms = 0;
  const int count = std::max(100, tricover::support::scaledCount(1000));  // few are alarms
  for (int i = 0; i < count; ++i) {
    // Of many edges, so that boxes around several are thinner than the tolerance; which are asked once they are there.
    const tricover::Polygon a({tricover::support::star(random, 200, 0.9, 1)});
    const tricover::Polygon b({tricover::support::star(random, 200, 0.9, 1)});
    tricover::prepare(a);
    tricover::prepare(b);
    const tricover::Pose pose_a = tricover::support::randomPose(random, 0.3);
    const tricover::Pose pose_b = tricover::support::randomPose(random, 2.2);
    fcl::CollisionResultd exact, tolerant;
    fcl::collide(shapeOf(a).get(), lifted(pose_a), shapeOf(b).get(), lifted(pose_b), fcl::CollisionRequestd(), exact);
    tricover_fcl::collide(shapeOf(a).get(), lifted(pose_a), shapeOf(b).get(), lifted(pose_b), fcl::CollisionRequestd(),
                          {0, 0.2}, tolerant);
    ASSERT_TRUE(tolerant.isCollision() || !exact.isCollision()) << i;
    if (tolerant.isCollision() && !exact.isCollision()) {
      ASSERT_LE(tricover::distance(a, pose_a, b, pose_b).distance, 0.2);
      ++alarms;
    }
    hits += exact.isCollision();
  }
  EXPECT_GT(hits, count / 10);
  EXPECT_LT(hits, count * 9 / 10);
  EXPECT_GT(alarms, 0);
}

TEST(Margin, contactOfANearMissIsBetweenTheGrownSurfaces) {
  const Shape<double> a = withMargin(kSquare, 1), b = withMargin(kSquare, 0);
  for (const std::size_t most : {1u, 5u}) {
    fcl::CollisionResultd result;
    ASSERT_EQ(
        fcl::collide(a.get(), lifted(tricover::Pose::Identity(), 3), b.get(),
                     lifted(tricover::support::pose(0, 1.5, 0.25), 3), fcl::CollisionRequestd(most, true), result),
        std::min<std::size_t>(most, 2));
    for (std::size_t k = 0; k < result.numContacts(); ++k) {
      const fcl::Contactd& contact = result.getContact(k);
      EXPECT_EQ(contact.penetration_depth, 0.5);
      EXPECT_EQ(contact.normal, fcl::Vector3d::UnitX());
      EXPECT_NEAR(contact.pos.x(), 1.75, 1e-14);
      EXPECT_GE(contact.pos.y(), 0.25);
      EXPECT_LE(contact.pos.y(), 1);
      EXPECT_EQ(contact.pos.z(), 3);
      expectOnEdge(*a, contact.b1, {1, contact.pos.y()});
      expectOnEdge(*b, contact.b2, {0, contact.pos.y() - 0.25});
    }
  }
}

TEST(Margin, depthsAreThoseOfTheGrownPolygons) {
  const Shape<double> a = withMargin(kSquare, 1), plain = shapeOf(kSquare);
  for (const std::size_t most : {1u, 5u}) {
    for (const double of_options : {0.0, 0.5}) {
      fcl::CollisionResultd result;
      ASSERT_EQ(tricover_fcl::collide<double>(a.get(), lifted(tricover::Pose::Identity()), plain.get(),
                                              lifted(tricover::support::pose(0, 0.75, 0)),
                                              fcl::CollisionRequestd(most, true), {of_options}, result),
                std::min<std::size_t>(most, 2));
      EXPECT_NEAR(result.getContact(0).penetration_depth, 1.25 + of_options, 1e-12);
      EXPECT_NEAR(result.getContact(0).normal.x(), 1, 1e-12);
      EXPECT_NEAR(result.getContact(0).pos.x(), 0.875 + 0.5, 1e-12);
    }
  }
}

TEST(Margin, depthsAreTheShortestWaysOfTheGrownPolygons) {
  Random random(7);
  constexpr double kError = 1e-9;
  const int count = tricover::support::scaledCount(300);
  int near = 0, deep = 0;
  while (near + deep < count) {
    SCOPED_TRACE(near + deep);
    const bool are_convex = random.coin();
    const auto polygon = [&] {
      return are_convex ? tricover::Polygon({tricover::support::star(random, random.integer(3, 9), 1, 1)})
                        : randomPolygon(random, 1);
    };
    const double of_a = random.coin() ? random.real(0, 0.5) : 0, of_b = random.real(0.01, 0.5), both = of_a + of_b;
    const Shape<double> a = withMargin(polygon(), of_a), b = withMargin(polygon(), of_b);
    const tricover::Pose pose_a = tricover::support::randomPose(random, 0.5),
                         pose_b = tricover::support::randomPose(random, random.coin() ? 1 : 3);
    const double gap = tricover::distance(a->polygon(), pose_a, b->polygon(), pose_b).distance;
    if (gap >= both) continue;
    const auto moved = [&](const tricover::Vec2& way) {
      tricover::Pose there = pose_b;
      there.translation() += way;
      return there;
    };

    fcl::CollisionResultd result;
    ASSERT_EQ(fcl::collide(a.get(), lifted(pose_a), b.get(), lifted(pose_b), fcl::CollisionRequestd(1, true), result),
              1u);
    const fcl::Contactd& contact = result.getContact(0);
    const tricover::Vec2 normal = contact.normal.head<2>();
    const double depth = contact.penetration_depth;
    const double left = tricover::distance(a->polygon(), pose_a, b->polygon(), moved(depth * normal)).distance;
    ASSERT_GE(left, both - kError);
    ++(gap > 0 ? near : deep);
    if (!are_convex) continue;  // the search is for the shortest translation without margins, which goes straight on
    ASSERT_LE(left, both + kError);
    // No way that is shorter.
    for (int i = 0; i < 64; ++i)
      for (const double part : {0.3, 0.9, 0.999}) {
        const double angle = 2 * M_PI * (i + random.unit()) / 64;
        const tricover::Vec2 way = part * depth * tricover::Vec2(std::cos(angle), std::sin(angle));
        ASSERT_TRUE(tricover::collide(a->polygon(), pose_a, b->polygon(), moved(way), {both}));
      }

    fcl::DistanceRequestd request;
    request.enable_signed_distance = true;
    fcl::DistanceResultd overlap;
    EXPECT_EQ(fcl::distance(a.get(), lifted(pose_a), b.get(), lifted(pose_b), request, overlap), -depth);
    const tricover::Vec2 on_a = overlap.nearest_points[0].head<2>(), on_b = overlap.nearest_points[1].head<2>();
    ASSERT_LT((on_a - on_b - depth * normal).norm(), kError);
    ASSERT_LT((contact.pos.head<2>() - (on_a + on_b) / 2).norm(), kError);
    ASSERT_NEAR(tricover::distance(a->polygon(), pose_a, tricover::point(on_a), tricover::Pose::Identity()).distance,
                of_a, kError);
    ASSERT_NEAR(tricover::distance(b->polygon(), pose_b, tricover::point(on_b), tricover::Pose::Identity()).distance,
                of_b, kError);
  }
  EXPECT_GT(near, count / 20);
  EXPECT_GT(deep, count / 10);
}

TEST(Margin, distancesAreThoseOfTheGrownPolygons) {
  const Shape<double> a = withMargin(kSquare, 1), b = withMargin(kSquare, 2);
  const auto at = [](double x) { return lifted(tricover::support::pose(0, x, 0)); };
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    fcl::DistanceRequestd request;
    request.gjk_solver_type = solver;
    const auto ask = [&](double x, bool is_signed, fcl::DistanceResultd& result) {
      request.enable_signed_distance = is_signed;
      fcl::distance(a.get(), at(0), b.get(), at(x), request, result);
      return result.min_distance;
    };
    fcl::DistanceResultd apart;
    EXPECT_EQ(ask(5, true, apart), 1);
    EXPECT_EQ(apart.nearest_points[0].x(), 2);
    EXPECT_EQ(apart.nearest_points[1].x(), 3);
    // The grown polygons touch.
    for (const bool is_signed : {false, true}) {
      fcl::DistanceResultd touch;
      EXPECT_EQ(ask(4, is_signed, touch), 0);
      EXPECT_NEAR(touch.nearest_points[0].x(), 2, 1e-15);
      EXPECT_EQ(touch.nearest_points[0], touch.nearest_points[1]);
    }
    // They overlap, the polygons don't, and do. Unsigned, both points are one that the grown polygons share.
    for (const double x : {2.5, 0.75}) {
      fcl::DistanceResultd overlap, depth;
      EXPECT_EQ(ask(x, false, overlap), -1);
      EXPECT_EQ(overlap.nearest_points[0], overlap.nearest_points[1]);
      EXPECT_GE(overlap.nearest_points[0].x(), x - 2);
      EXPECT_LE(overlap.nearest_points[0].x(), 2);
      EXPECT_NEAR(ask(x, true, depth), x - 4, 1e-12);
      if (solver == fcl::GST_INDEP) continue;  // puts their middle in place of both
      EXPECT_NEAR(depth.nearest_points[0].x(), 2, 1e-12);
      EXPECT_NEAR(depth.nearest_points[1].x(), x - 2, 1e-12);
    }
    fcl::DistanceResultd nearer(0.5);
    EXPECT_EQ(ask(5, true, nearer), 0.5);
  }
}

TEST(Margin, badLengthsAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto refusal = [](const PolygonOptions& options) {
    return thrownBy<std::invalid_argument>([&] { PolygonShapef(kSquare, options); });
  };
  for (const double bad : {-1e-300, nan, infinity}) {
    EXPECT_NE(refusal({bad, 0, 0}).find("margin"), std::string::npos);
    // A shape's margin doesn't make good for it.
    const Shape<double> a = withMargin(kSquare, 1);
    for (const bool tolerance : {false, true}) {
      const tricover::CollideOptions options{tolerance ? 0 : bad, tolerance ? bad : 0};
      fcl::CollisionResultd result;
      const std::string text = thrownBy<std::invalid_argument>([&] {
        tricover_fcl::collide<double>(a.get(), lifted(tricover::Pose::Identity(), 1), a.get(),
                                      fcl::Transform3d::Identity(), fcl::CollisionRequestd(), options, result);
      });
      EXPECT_NE(text.find(tolerance ? "tolerance" : "margin"), std::string::npos) << text;
    }
  }
}

TEST(Margin, optionsOfOtherPairsAreRefused) {
  const fcl::Sphered sphere(1);
  fcl::CollisionResultd result;
  EXPECT_THROW(
      tricover_fcl::collide<double>(&sphere, fcl::Transform3d::Identity(), &sphere, fcl::Transform3d::Identity(),
                                    fcl::CollisionRequestd(), tricover::CollideOptions{}, result),
      std::logic_error);
}

}  // namespace
}  // namespace tricover_fcl::test
