// SPDX-License-Identifier: BSD-3-Clause
// Safety distances: of shapes, and of tricover_fcl::collide's options.
#include <algorithm>
#include <cmath>

#include "ask.h"
#include "tricover/collide.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"
#include "tricover/prepare.h"

namespace tricover_fcl::test {
namespace {

const Polygon kSquare({rectangle(0, 0, 1, 1)});

TEST(Margin, touchesToTheLastBit) {
  const Shape<double> a = withMargin(kSquare, 1.25), b = withMargin(kSquare, 1.75), plain = shapeOf(kSquare);
  const auto at = [](double x) { return lifted(0, x, 0); };
  EXPECT_TRUE(meet(a, at(0), b, at(4)));
  EXPECT_FALSE(meet(a, at(0), b, at(nudged(4, 1))));
  EXPECT_TRUE(meet(a, at(0), plain, at(2.25)));
  EXPECT_FALSE(meet(plain, at(nudged(2.25, 1)), a, at(0)));
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
    const Polygon a({star(random, 200, 0.9, 1)}), b({star(random, 200, 0.9, 1)});
    tricover::prepare(a);
    tricover::prepare(b);
    const Pose pose_a = randomPose(random, 0.3), pose_b = randomPose(random, 2.2);
    fcl::CollisionResultd result;
    const bool exact = collides(shapeOf(a), lifted(pose_a), shapeOf(b), lifted(pose_b));
    const bool tolerant = tricover_fcl::collide<double>(shapeOf(a).get(), lifted(pose_a), shapeOf(b).get(),
                                                        lifted(pose_b), {}, {0, 0.2}, result) > 0;
    ASSERT_TRUE(tolerant || !exact) << i;
    if (tolerant && !exact) {
      ASSERT_LE(tricover::distance(a, pose_a, b, pose_b).distance, 0.2);
      ++alarms;
    }
    hits += exact;
  }
  EXPECT_GT(hits, count / 10);
  EXPECT_LT(hits, count * 9 / 10);
  EXPECT_GT(alarms, 0);
}

TEST(Margin, contactOfANearMissIsBetweenTheGrownSurfaces) {
  const Shape<double> a = withMargin(kSquare, 1), b = withMargin(kSquare, 0);
  for (const std::size_t most : {1U, 5U}) {
    const auto found = contactsOf(a, lifted(0, 0, 0, 3), b, lifted(0, 1.5, 0.25, 3), most);
    ASSERT_EQ(found.size(), std::min<std::size_t>(most, 2));
    for (const fcl::Contactd& contact : found) {
      EXPECT_EQ(contact.penetration_depth, 0.5);
      EXPECT_EQ(contact.normal, Vec3::UnitX());
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
      ASSERT_EQ(tricover_fcl::collide<double>(a.get(), kHere, plain.get(), lifted(0, 0.75, 0),
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
      return are_convex ? Polygon({star(random, random.integer(3, 9), 1, 1)}) : randomPolygon(random, 1);
    };
    const double of_a = random.coin() ? random.real(0, 0.5) : 0, of_b = random.real(0.01, 0.5), both = of_a + of_b;
    const Shape<double> a = withMargin(polygon(), of_a), b = withMargin(polygon(), of_b);
    const Pose pose_a = randomPose(random, 0.5), pose_b = randomPose(random, random.coin() ? 1 : 3);
    const double gap = tricover::distance(a->polygon(), pose_a, b->polygon(), pose_b).distance;
    if (gap >= both) continue;
    const auto moved = [&](const Vec2& way) {
      Pose there = pose_b;
      there.translation() += way;
      return there;
    };

    const auto found = contactsOf(a, lifted(pose_a), b, lifted(pose_b), 1);
    ASSERT_EQ(found.size(), 1U);
    const fcl::Contactd& contact = found[0];
    const Vec2 normal = contact.normal.head<2>();
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
        const Vec2 way = part * depth * Vec2(std::cos(angle), std::sin(angle));
        ASSERT_TRUE(tricover::collide(a->polygon(), pose_a, b->polygon(), moved(way), {both}));
      }

    const auto overlap = distanceOf(fcl::GST_LIBCCD, true, a, lifted(pose_a), b, lifted(pose_b));
    EXPECT_EQ(overlap.min_distance, -depth);
    const Vec2 on_a = overlap.nearest_points[0].head<2>(), on_b = overlap.nearest_points[1].head<2>();
    ASSERT_LT((on_a - on_b - depth * normal).norm(), kError);
    ASSERT_LT((contact.pos.head<2>() - (on_a + on_b) / 2).norm(), kError);
    ASSERT_NEAR(tricover::distance(a->polygon(), pose_a, tricover::Polygon::point(on_a), Pose::Identity()).distance,
                of_a, kError);
    ASSERT_NEAR(tricover::distance(b->polygon(), pose_b, tricover::Polygon::point(on_b), Pose::Identity()).distance,
                of_b, kError);
  }
  EXPECT_GT(near, count / 20);
  EXPECT_GT(deep, count / 10);
}

TEST(Margin, badLengthsAreRefusedByName) {
  // A shape's margin doesn't make good for it.
  const Shape<double> a = withMargin(kSquare, 1);
  const auto ask = [&](const tricover::CollideOptions& options) {
    fcl::CollisionResultd result;
    tricover_fcl::collide<double>(a.get(), lifted(0, 0, 0, 1), a.get(), kHere, {}, options, result);
  };
  for (const double bad : {-kInfinity, kNaN, kInfinity}) {
    expectRefused({"margin"}, [&] { PolygonShapef(kSquare, {bad, 0, 0}); });
    expectRefused({"margin"}, [&] { ask({bad, 0}); });
    expectRefused({"tolerance"}, [&] { ask({0, bad}); });
  }
}

}  // namespace
}  // namespace tricover_fcl::test
