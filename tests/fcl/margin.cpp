// SPDX-License-Identifier: BSD-3-Clause
// Safety distances: of shapes, and of tricover_fcl::collide's options.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ask.h"
#include "exact_reference.h"
#include "families.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/prepare.h"
#include "tricover/segment.h"

namespace tricover_fcl::test {
namespace {

Shape<double> withMargin(const tricover::Polygon& polygon, double margin) {
  return std::make_shared<PolygonShaped>(polygon, PolygonOptions{margin, 0, 0});
}

const tricover::Polygon kSquare({rectangle(0, 0, 1, 1)});

TEST(Margin, touchesToTheLastBit) {
  const Shape<double> a = withMargin(kSquare, 1.25), b = withMargin(kSquare, 1.75), plain = shapeOf(kSquare);
  const auto at = [](double x) { return lifted(0, x, 0); };
  EXPECT_TRUE(meet(a, at(0), b, at(4)));
  EXPECT_FALSE(meet(a, at(0), b, at(nudged(4, 1))));
  EXPECT_TRUE(meet(a, at(0), plain, at(2.25)));
  EXPECT_FALSE(meet(plain, at(nudged(2.25, 1)), a, at(0)));
}

TEST(Margin, isExactOnEveryFamily) {
  int hits = 0, cases = 0, apart_hits = 0;
  for (const tricover::support::Family& family : tricover::support::families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < scaledCount(40); ++i) {
      const tricover::support::Case c = family.make(static_cast<std::uint64_t>(i));
      const mpq_class square = tricover::exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
      const double gap = tricover::exact::distanceBelow(square);
      if (!(gap < 1e300)) continue;
      // The largest double that isn't above the distance, and its neighbours, in two parts that add up exactly.
      for (const int steps : {-1, 0, 1}) {
        const double margin = gap > 0 ? nudged(gap, steps) : 0;
        const double of_a = margin / 2, of_b = margin - of_a;
        const bool expected = tricover::exact::within(square, mpq_class(of_a + of_b));
        const Shape<double> a = withMargin(c.a, of_a), b = withMargin(c.b, of_b);
        const fcl::Transform3d tf_a = lifted(c.pose_a), tf_b = lifted(c.pose_b);
        ASSERT_EQ(meet(a, tf_a, b, tf_b), expected) << reproduction(c);
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
  const fcl::CollisionObjectd object_a(a), object_b(b, lifted(0, 2, 0));
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
  const int count = std::max(100, scaledCount(1000));  // few are alarms
  for (int i = 0; i < count; ++i) {
    // Of many edges, so that boxes around several are thinner than the tolerance; which are asked once they are there.
    const tricover::Polygon a({star(random, 200, 0.9, 1)});
    const tricover::Polygon b({star(random, 200, 0.9, 1)});
    tricover::prepare(a);
    tricover::prepare(b);
    const tricover::Pose pose_a = randomPose(random, 0.3);
    const tricover::Pose pose_b = randomPose(random, 2.2);
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
  for (const std::size_t most : {1U, 5U}) {
    const auto found = contactsOf(*a, lifted(0, 0, 0, 3), *b, lifted(0, 1.5, 0.25, 3), most);
    ASSERT_EQ(found.size(), std::min<std::size_t>(most, 2));
    for (const fcl::Contactd& contact : found) {
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
  for (const std::size_t most : {1U, 5U}) {
    for (const double of_options : {0.0, 0.5}) {
      fcl::CollisionResultd result;
      ASSERT_EQ(
          tricover_fcl::collide<double>(a.get(), lifted(tricover::Pose::Identity()), plain.get(), lifted(0, 0.75, 0),
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
  const int count = scaledCount(300);
  int near = 0, deep = 0;
  while (near + deep < count) {
    SCOPED_TRACE(near + deep);
    const bool are_convex = random.coin();
    const auto polygon = [&] {
      return are_convex ? tricover::Polygon({star(random, random.integer(3, 9), 1, 1)}) : randomPolygon(random, 1);
    };
    const double of_a = random.coin() ? random.real(0, 0.5) : 0, of_b = random.real(0.01, 0.5), both = of_a + of_b;
    const Shape<double> a = withMargin(polygon(), of_a), b = withMargin(polygon(), of_b);
    const tricover::Pose pose_a = randomPose(random, 0.5), pose_b = randomPose(random, random.coin() ? 1 : 3);
    const double gap = tricover::distance(a->polygon(), pose_a, b->polygon(), pose_b).distance;
    if (gap >= both) continue;
    const auto moved = [&](const tricover::Vec2& way) {
      tricover::Pose there = pose_b;
      there.translation() += way;
      return there;
    };

    const auto found = contactsOf(*a, lifted(pose_a), *b, lifted(pose_b), 1);
    ASSERT_EQ(found.size(), 1U);
    const fcl::Contactd& contact = found[0];
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

    const auto overlap = distanceOf<double>(fcl::GST_LIBCCD, true, *a, lifted(pose_a), *b, lifted(pose_b));
    EXPECT_EQ(overlap.min_distance, -depth);
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
  const auto at = [](double x) { return lifted(0, x, 0); };
  for (const fcl::GJKSolverType solver : kSolvers) {
    const auto ask = [&](double x, bool is_signed) {
      return distanceOf<double>(solver, is_signed, *a, at(0), *b, at(x));
    };
    const auto apart = ask(5, true);
    EXPECT_EQ(apart.min_distance, 1);
    EXPECT_EQ(apart.nearest_points[0].x(), 2);
    EXPECT_EQ(apart.nearest_points[1].x(), 3);
    // The grown polygons touch.
    for (const bool is_signed : {false, true}) {
      const auto touch = ask(4, is_signed);
      EXPECT_EQ(touch.min_distance, 0);
      EXPECT_NEAR(touch.nearest_points[0].x(), 2, 1e-15);
      EXPECT_EQ(touch.nearest_points[0], touch.nearest_points[1]);
    }
    // They overlap, the polygons don't, and do. Unsigned, both points are one that the grown polygons share.
    for (const double x : {2.5, 0.75}) {
      const auto overlap = ask(x, false), depth = ask(x, true);
      EXPECT_EQ(overlap.min_distance, -1);
      EXPECT_EQ(overlap.nearest_points[0], overlap.nearest_points[1]);
      EXPECT_GE(overlap.nearest_points[0].x(), x - 2);
      EXPECT_LE(overlap.nearest_points[0].x(), 2);
      EXPECT_NEAR(depth.min_distance, x - 4, 1e-12);
      if (solver == fcl::GST_INDEP) continue;  // puts their middle in place of both
      EXPECT_NEAR(depth.nearest_points[0].x(), 2, 1e-12);
      EXPECT_NEAR(depth.nearest_points[1].x(), x - 2, 1e-12);
    }
  }
}

/// Though they add up to nothing.
TEST(Margin, nearestPointsAreThoseOfEachMargin) {
  const Shape<double> a = withMargin(kSquare, 0.5), b = withMargin(kSquare, -0.5), c = withMargin(kSquare, 1.5);
  const auto ask = [](const Shape<double>& first, double x, const Shape<double>& second, double y) {
    return distanceOf<double>(fcl::GST_LIBCCD, false, *first, lifted(0, x, 0), *second, lifted(0, y, 0));
  };
  const auto apart = ask(a, 0, b, 3), swapped = ask(b, 3, a, 0);
  EXPECT_EQ(apart.min_distance, 2);
  EXPECT_EQ(apart.nearest_points[0].x(), 1.5);
  EXPECT_EQ(apart.nearest_points[1].x(), 3.5);
  EXPECT_EQ(swapped.nearest_points[0].x(), 3.5);
  EXPECT_EQ(swapped.nearest_points[1].x(), 1.5);
  // From 1 + 1.5 back to 1.5 + 0.5, where both are.
  for (const auto& overlap : {ask(c, 0, b, 1.5), ask(b, 1.5, c, 0)}) {
    EXPECT_EQ(overlap.nearest_points[0], overlap.nearest_points[1]);
    EXPECT_GE(overlap.nearest_points[0].x(), 2);
    EXPECT_LE(overlap.nearest_points[0].x(), 2.5);
  }
  EXPECT_TRUE(ask(a, 0, b, 1).nearest_points[0].allFinite());  // they touch
}

TEST(Margin, badLengthsAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto refusal = [](const PolygonOptions& options) {
    return thrownBy<std::invalid_argument>([&] { PolygonShapef(kSquare, options); });
  };
  for (const double bad : {-infinity, nan, infinity}) {
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
