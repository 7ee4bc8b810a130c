// SPDX-License-Identifier: BSD-3-Clause
// A polygon against spheres, capsules and cylinders that are discs or stadiums in its plane: exact ones.
#include <cmath>

#include "exact_reference.h"
#include "families.h"
#include "mixed_scene.h"
#include "reproduction.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/segment.h"

namespace tricover_fcl::test {
namespace {

using tricover::Polygon;
using tricover::Pose;
using Vec3 = fcl::Vector3<double>;

double distance(const fcl::CollisionGeometryd& a, const fcl::Transform3d& tf_a, const fcl::CollisionGeometryd& b,
                const fcl::Transform3d& tf_b) {
  fcl::DistanceResultd result;
  return fcl::distance(&a, tf_a, &b, tf_b, fcl::DistanceRequestd(), result);
}

/// An axis in the plane, which is that of a lying capsule.
fcl::Transform3d lying(const tricover::Vec2& axis, const Vec3& at) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.linear() << -axis.y(), 0, axis.x(), axis.x(), 0, axis.y(), 0, 1, 0;
  pose.translation() = at;
  return pose;
}

TEST(MixedRound, isExactOnEveryFamily) {
  Random random(81);
  int cases = 0, found = 0;
  for (const tricover::support::Family& family : tricover::support::families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < scaledCount(30); ++i) {
      const tricover::support::Case c = family.make(static_cast<std::uint64_t>(i));
      const tricover::Vec2 center = c.pose_b * c.b.origin();
      if (!(center.norm() < 1e300)) continue;
      Pose place = Pose::Identity();
      place.translation() = center;
      const double angle = random.real(-3, 3), size = random.coin() ? 0 : (c.pose_b.linear() * c.b.edgeStart(0)).norm();
      const tricover::Vec2 axis(std::cos(angle), std::sin(angle));
      place.linear() << axis.x(), -axis.y(), axis.y(), axis.x();
      const Polygon segment = size == 0 ? tricover::point({0, 0}) : tricover::segment({-size / 2, 0}, {size / 2, 0});
      const mpq_class square = tricover::exact::distanceSquared(c.a, c.pose_a, segment, place);
      const double gap = tricover::exact::distanceBelow(square);
      if (!(gap > 1e-300 && gap < 1e300 && size < 1e300)) continue;
      // The prism's heights hold the axis.
      const PolygonShaped shape(c.a, random.coin() ? PolygonOptions{0, -1, 2} : PolygonOptions::atAllHeights());
      const fcl::Transform3d pose = lifted(c.pose_a, 5);
      const Vec3 at(center.x(), center.y(), 5.5);
      for (const int steps : {-1, 0, 1}) {
        const double radius = nudged(gap, steps);
        const bool expected = tricover::exact::within(square, radius);
        if (size == 0) {
          const fcl::Transform3d there = placed<double>(at, fcl::Matrix3d::Identity());
          ASSERT_EQ(meet<double>(shape, pose, fcl::Sphered(radius), there), expected) << reproduction(c);
          ASSERT_EQ(meet<double>(shape, pose, fcl::Cylinderd(radius, 1), there), expected) << reproduction(c);
          ASSERT_EQ(meet<double>(shape, pose, fcl::Capsuled(radius, 0), there), expected) << reproduction(c);
          ASSERT_EQ(distance(shape, pose, fcl::Sphered(radius), there) <= 0, expected) << reproduction(c);
        } else {
          ASSERT_EQ(meet<double>(shape, pose, fcl::Capsuled(radius, size), lying(axis, at)), expected)
              << reproduction(c);
          ASSERT_EQ(distance(shape, pose, fcl::Capsuled(radius, size), lying(axis, at)) <= 0, expected)
              << reproduction(c);
        }
        ++cases;
        found += expected;
      }
    }
  }
  EXPECT_GT(found, cases / 5);
  EXPECT_LT(found, cases * 4 / 5);
}

struct Scene {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  fcl::Transform3d pose;
  Polygon segment = tricover::point({0, 0});  ///< what it leaves in the plane, in the world, and how far around
  double radius = 0;                          ///< negative: it doesn't reach the heights
  double low = 0, high = 0;                   ///< its own heights
};

/// A sphere, capsule or cylinder near heights from `low` to `high`, whose section is known.
Scene anyRound(Random& random, double low, double high) {
  const double r = random.real(0.2, 2), length = random.real(0.1, 3), z = random.real(low - 3, high + 3);
  const Vec3 at(random.real(-4, 4), random.real(-4, 4), z);
  const double angle = random.real(-3, 3);
  const tricover::Vec2 center = at.head<2>(), axis(std::cos(angle), std::sin(angle));
  const auto section = [&](double rise) {
    const double outside = std::max({low - z - rise, z - rise - high, 0.0});
    return outside < r ? std::sqrt(r * r - outside * outside) : -1;
  };
  const fcl::Transform3d standing = placed<double>(at, turned(angle, Vec3::UnitZ()));
  switch (random.integer(0, 3)) {
    case 0:
      return {std::make_shared<fcl::Sphered>(r),
              placed<double>(at, turned(angle, {1, 2, 3})),
              tricover::point(center),
              section(0),
              z - r,
              z + r};
    case 1:
      return {std::make_shared<fcl::Cylinderd>(r, length),
              standing,
              tricover::point(center),
              low - z <= length / 2 && z - high <= length / 2 ? r : -1,
              z - length / 2,
              z + length / 2};
    case 2:
      return {std::make_shared<fcl::Capsuled>(r, length),
              standing,
              tricover::point(center),
              section(length / 2),
              z - length / 2 - r,
              z + length / 2 + r};
    default:
      return {std::make_shared<fcl::Capsuled>(r, length),
              lying(axis, at),
              tricover::segment(center - length / 2 * axis, center + length / 2 * axis),
              section(0),
              z - r,
              z + r};
  }
}

TEST(MixedRound, sectionsDistancesAndNearestPoints) {
  Random random(82);
  const int cases = scaledCount(2000);
  int found = 0, apart = 0, away = 0;
  for (int i = 0; i < cases; ++i) {
    const double low = random.coin() ? 0 : random.real(-2, 0), high = low == 0 ? 0 : random.real(0, 2),
                 margin = random.coin() ? 0 : random.real(0, 1);
    const PolygonShaped shape(randomPolygon(random, 2), PolygonOptions{margin, low, high});
    const Scene scene = anyRound(random, low, high);
    const Pose pose = randomPose(random, 2);
    const Pose identity = Pose::Identity();
    const double gap = tricover::distance(shape.polygon(), pose, scene.segment, identity).distance;
    const double left = gap - scene.radius - margin;
    // As it is, and with all of it carried elsewhere in space.
    const Vec3 elsewhere(random.real(-9, 9), random.real(-9, 9), random.real(-9, 9));
    const fcl::Transform3d carried = placed<double>(elsewhere, turned(random.real(0, 6), elsewhere));
    for (const fcl::Transform3d& by : {fcl::Transform3d(fcl::Transform3d::Identity()), carried}) {
      const fcl::Transform3d there = by * lifted(pose), other = by * scene.pose;
      if (scene.radius < 0) {
        ASSERT_FALSE(meet<double>(shape, there, *scene.geometry, other)) << i;
        ASSERT_GT(distance(shape, there, *scene.geometry, other), 0) << i;
        ++away;
        continue;
      }
      if (std::abs(left) < 1e-10) continue;
      ASSERT_EQ(meet<double>(shape, there, *scene.geometry, other), left < 0) << i << ": " << left;
      fcl::DistanceResultd result;
      const double measured =
          fcl::distance<double>(&shape, there, scene.geometry.get(), other, fcl::DistanceRequestd(), result);
      ASSERT_NEAR(measured, left > 0 ? left : -1, 1e-11) << i;
      const fcl::Transform3d back = by.inverse();
      const Vec3 on_shape = back * result.nearest_points[0], on_other = back * result.nearest_points[1];
      ASSERT_NEAR((on_shape - on_other).norm(), std::max(left, 0.0), 1e-11) << i;
      const auto off = [&](const Polygon& polygon, const Pose& where, const Vec3& point) {
        return tricover::distance(polygon, where, tricover::point(point.head<2>()), identity).distance;
      };
      ASSERT_LE(off(shape.polygon(), pose, on_shape), margin + 1e-11) << i;
      ASSERT_LE(off(scene.segment, identity, on_other), scene.radius + 1e-11) << i;
      ASSERT_NEAR(on_shape.z(), (std::max(low, scene.low) + std::min(high, scene.high)) / 2, 1e-11);
      found += left < 0;
      apart += left > 0;
    }
  }
  EXPECT_GT(found, cases / 4);
  EXPECT_GT(apart, cases / 4);
  EXPECT_GT(away, cases / 20);
}

/// A polygon with its vertices at that distance from the segment.
Polygon around(const Polygon& segment, double radius, int vertices) {
  const tricover::Vec2 v = segment.edgeStart(0), w = segment.edgeEnd(0);
  const double turn = v == w ? 0 : std::atan2((w - v).y(), (w - v).x());
  tricover::Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / vertices - M_PI / 2;
    const tricover::Vec2 out(std::cos(angle + turn), std::sin(angle + turn));
    ring.push_back((std::cos(angle) > 0 ? w : v) + radius * out);
  }
  return Polygon({ring});
}

TEST(MixedRound, contactsPartThemByTheShortestWay) {
  Random random(83);
  const int cases = scaledCount(300), corners = 48;
  int direct = 0, searched = 0, whole = 0;
  while (direct + searched < cases) {
    SCOPED_TRACE(direct + searched);
    const double margin = random.coin() ? 0 : random.real(0, 1);
    const bool is_convex = random.coin();
    const PolygonShaped shape(
        is_convex ? Polygon({star(random, random.integer(3, 9), 2, 2)}) : randomPolygon(random, 2),
        PolygonOptions{margin, 0, 0});
    const Scene scene = anyRound(random, 0, 0);
    const Pose pose = randomPose(random, 2), identity = Pose::Identity();
    if (scene.radius < 0) continue;
    const double both = scene.radius + margin;  // parts the polygon from the segment
    const double gap = tricover::distance(shape.polygon(), pose, scene.segment, identity).distance;
    if (!(gap < both - 1e-9)) continue;
    const Vec3 elsewhere(random.real(-9, 9), random.real(-9, 9), random.real(-9, 9));
    const fcl::Transform3d by = random.coin() ? fcl::Transform3d(fcl::Transform3d::Identity())
                                              : placed<double>(elsewhere, turned(random.real(0, 6), elsewhere));
    fcl::CollisionResultd one, all;
    const auto ask = [&](std::size_t most, fcl::CollisionResultd& result) {
      const fcl::CollisionRequestd request(most, true);
      return fcl::collide<double>(scene.geometry.get(), by * scene.pose, &shape, by * lifted(pose), request, result);
    };
    ASSERT_EQ(ask(1, one), 1u);
    const fcl::Contactd& contact = one.getContact(0);
    const double depth = contact.penetration_depth, error = 3e-6 * (both + 2);  // reaches are up to 4
    const auto outermost = tricover::penetration(
        shape.polygon(), pose, around(scene.segment, both / std::cos(M_PI / corners), corners), identity);
    const auto innermost = tricover::penetration(shape.polygon(), pose, around(scene.segment, both, corners), identity);
    ASSERT_TRUE(outermost);
    // Otherwise the search is for the shortest translation of the segment, which goes straight on.
    if (is_convex) {
      ASSERT_LE(depth, outermost->depth + error);
    }
    ASSERT_GE(depth, (innermost ? innermost->depth : 0) - error);
    // From the shape, which is the second one here, to the other.
    const Vec3 normal = by.linear().transpose() * contact.normal;
    ASSERT_NEAR(normal.norm(), 1, 1e-12);
    Pose moved = identity;
    moved.translation() = -depth * normal.head<2>();
    const double left = tricover::distance(shape.polygon(), pose, scene.segment, moved).distance;
    ASSERT_GE(left, both - error);
    if (is_convex) {
      ASSERT_LE(left, both + error);
    }
    fcl::DistanceRequestd request;
    request.enable_signed_distance = true;
    fcl::DistanceResultd result;
    fcl::distance<double>(&shape, by * lifted(pose), scene.geometry.get(), by * scene.pose, request, result);
    ASSERT_NEAR(result.min_distance, depth > error ? -depth : 0, error);
    if (result.min_distance < 0 && is_convex) {
      ASSERT_LT((result.nearest_points[0] - result.nearest_points[1] - depth * -contact.normal).norm(), error);
    }
    // Each part's own, which isn't the way out.
    ASSERT_GE(ask(10, all), 1u);
    for (std::size_t i = 0; i < all.numContacts(); ++i) {
      ASSERT_NEAR(all.getContact(i).normal.norm(), 1, 1e-12);
      ASSERT_GE(all.getContact(i).penetration_depth, 0);
    }
    // A stadium's side has both of its ends.
    whole += all.numContacts() == 1 || (all.numContacts() == 2 && all.getContact(0).normal == all.getContact(1).normal);
    const bool is_direct = gap > 0 && std::abs(depth - (both - gap)) < 1e-9;
    if (is_direct) {  // in the middle of what they share
      const Polygon there = tricover::point((by.inverse() * contact.pos).head<2>());
      ASSERT_NEAR(tricover::distance(scene.segment, identity, there, identity).distance,
                  std::abs(scene.radius - depth / 2), 1e-9);
      ASSERT_LE(std::abs(tricover::distance(shape.polygon(), pose, there, identity).distance - margin),
                depth / 2 + 1e-9);
    }
    ++(is_direct ? direct : searched);
  }
  EXPECT_GT(direct, cases / 4);
  EXPECT_GT(searched, cases / 10);
  EXPECT_GT(whole, cases / 4);
}

TEST(MixedRound, contactsOfWhatTouchesLeadAway) {
  const PolygonShaped square(Polygon({rectangle(-1, -1, 1, 1)}));
  const auto contact = [&](const Vec3& center, double radius) {
    fcl::CollisionResultd result;
    const fcl::Sphered sphere(radius);
    fcl::collide<double>(&square, fcl::Transform3d::Identity(), &sphere,
                         placed<double>(center, fcl::Matrix3d::Identity()), fcl::CollisionRequestd(1, true), result);
    return result.getContact(0);
  };
  // Beside an edge, at a corner; with the centre on an edge, and at a corner, where either edge will do.
  EXPECT_LT((contact({2, 0, 0}, 1).normal - Vec3::UnitX()).norm(), 1e-12);
  EXPECT_EQ(contact({2, 0, 0}, 1).penetration_depth, 0);
  EXPECT_LT((contact({1.3, 1.4, 0}, 0.5).normal - Vec3(0.6, 0.8, 0)).norm(), 1e-9);
  EXPECT_LT((contact({0.5, -1, 0}, 0.25).normal + Vec3::UnitY()).norm(), 1e-12);
  EXPECT_EQ(contact({0.5, -1, 0}, 0.25).penetration_depth, 0.25);
  EXPECT_EQ(contact({0.5, -1, 0}, 0.25).pos, Vec3(0.5, -0.875, 0));
  const Vec3 at_corner = contact({1, 1, 0}, 0.25).normal;
  EXPECT_TRUE((at_corner - Vec3::UnitX()).norm() < 1e-12 || (at_corner - Vec3::UnitY()).norm() < 1e-12);
  // From within, across the nearest edge.
  EXPECT_EQ(contact({0.75, 0.5, 0}, 0.5).penetration_depth, 0.75);
  EXPECT_EQ(contact({0.75, 0.5, 0}, 0.5).pos, Vec3(0.625, 0.5, 0));
}

TEST(MixedRound, contactsAcrossTheNearestEdgeAtAnyScale) {
  for (const double size : {1e-200, 1.0, 1e200}) {
    const PolygonShaped square(Polygon({rectangle(-size, -size, size, size)}));
    const fcl::Sphered sphere(0.5 * size);
    fcl::CollisionResultd result;
    fcl::collide<double>(&square, fcl::Transform3d::Identity(), &sphere, shifted<double>(0.5 * size, 0.75 * size, 0),
                         fcl::CollisionRequestd(1, true), result);
    ASSERT_EQ(result.numContacts(), 1u);
    EXPECT_DOUBLE_EQ(result.getContact(0).penetration_depth, 0.75 * size);
    EXPECT_LT((result.getContact(0).normal - Vec3::UnitY()).norm(), 1e-12);
  }
}

TEST(MixedRound, contactsWhereManyWaysAreAsShort) {
  // From a needle's tip every way but back is.
  const PolygonShaped needle(Polygon({{{0, 0}, {1, -1.25}, {0.3, -0.375}, {0.7, -0.875}, {0.1, -0.125}}}));
  const fcl::Ellipsoidd spheroid(0.75, 0.75, 0.5);
  fcl::CollisionResultd result;
  fcl::collide<double>(&needle, fcl::Transform3d::Identity(), &spheroid, fcl::Transform3d::Identity(),
                       fcl::CollisionRequestd(1, true), result);
  ASSERT_EQ(result.numContacts(), 1u);
  EXPECT_NEAR(result.getContact(0).penetration_depth, 0.75, 1e-4 * 0.75);
}

/// The polygon's point that is nearest to the middle of a tiny cylinder's shadow rounds to that, without being it: no
/// way leads there.
TEST(MixedRound, aNearestPointThatRoundsToTheMiddle) {
  const PolygonShaped needle(Polygon({{{-0x1.7926829de359p-1, 0x1.4a02014a2183bp-1},
                                       {0x1.f6de037d2f216p-3, -0x1.b802ac62d75a4p-3},
                                       {0x1.f6de037d2f216p-1, -0x1.b802ac62d75a4p-1}}}),
                             PolygonOptions::atAllHeights());
  const fcl::Cylinderd cylinder(0x1.13cae9b42da9p-35, 0x1.df71f2447fd87p-35);
  fcl::Transform3d there, leaning;
  there.setIdentity();
  there.linear().topLeftCorner<2, 2>() << -0x1.d8868afea61bep-1, -0x1.8a46ec4aed5acp-2, -0x1.8a46ec4aed5acp-2,
      0x1.d8868afea61bep-1;
  there.linear()(2, 2) = -1;
  leaning.linear() << 0x1.f9609f900737ep-1, 0x1.47154aa3b3825p-3, 0x1.c9e246808e1cdp-7, -0x1.45270f06d177dp-3,
      0x1.f8c61c5f90922p-1, -0x1.b31f6eaea2adcp-5, -0x1.6cb24a5871ad6p-6, 0x1.9b520d2bd6dbp-5, 0x1.ff3a28eab1e36p-1;
  there.translation() = leaning.translation() = Vec3(-0x1.442c77ba80f16p+2, 0x1.c023f0f8d381p+0, 0);
  EXPECT_TRUE(meet<double>(needle, there, cylinder, leaning));
}

TEST(MixedRound, motionsMeetDiscsOnTime) {
  // A corner goes straight to a stadium's end, and past it by less than its radius.
  const PolygonShaped square(Polygon({rectangle(0, 0, 1, 1)}));
  const fcl::Capsuled capsule(0.5, 2);
  const fcl::Transform3d still = lying({1, 0}, {0, 0, 0.3});
  const double section = 0.4;
  const fcl::ContinuousCollisionRequestd request = advancing(1e-9, fcl::CCDM_TRANS);
  for (const double aside : {0.0, 0.3999, 0.4, 0.4001}) {
    const auto place = [&](double x) { return shifted<double>(x, aside, 0); };
    const bool meets = aside <= section;
    const double truth = meets ? (10 - 1 - std::sqrt(section * section - aside * aside)) / 10 : 1;
    fcl::ContinuousCollisionResultd result, swapped;
    tricover_fcl::continuousCollide<double>(&square, place(10), place(0), &capsule, still, still, request, result);
    tricover_fcl::continuousCollide<double>(&capsule, still, still, &square, place(10), place(0), request, swapped);
    EXPECT_EQ(result.is_collide, meets) << aside;
    EXPECT_NEAR(result.time_of_contact, truth, 1e-6) << aside;  // a grazing root of 1e-12 is 1e-6
    EXPECT_LE(result.time_of_contact, truth + 1e-12) << aside;
    EXPECT_EQ(swapped.time_of_contact, result.time_of_contact) << aside;
  }
}

TEST(MixedRound, whatTurnsDoesSoAboutItsOwnPivot) {
  // A stadium turns by a quarter about its middle, far from every origin, until its tip meets a wall.
  const PolygonShaped wall(Polygon({rectangle(0, -3, 1, 3)}));
  const fcl::Capsuled capsule(0.5, 2);
  const Vec3 middle(5, 7, 0);
  const fcl::Transform3d place = shifted<double>(middle.x() + 1.3, middle.y(), 0);
  const fcl::ContinuousCollisionRequestd request = advancing(1e-9, fcl::CCDM_SCREW);
  const double truth = std::asin(1.3 - 0.5) / (M_PI / 2);
  fcl::ContinuousCollisionResultd result, swapped;
  const fcl::Transform3d begin = lying({0, 1}, middle), end = lying({1, 0}, middle);
  tricover_fcl::continuousCollide<double>(&wall, place, place, &capsule, begin, end, request, result);
  tricover_fcl::continuousCollide<double>(&capsule, begin, end, &wall, place, place, request, swapped);
  EXPECT_TRUE(result.is_collide);
  EXPECT_NEAR(result.time_of_contact, truth, 1e-8);
  EXPECT_LE(result.time_of_contact, truth + 1e-12);
  EXPECT_EQ(swapped.time_of_contact, result.time_of_contact);
}

TEST(MixedRound, prismsUpsideDownReachTheOtherWay) {
  const PolygonShaped prism(Polygon({rectangle(-1, -1, 1, 1)}), PolygonOptions{0, -1, 3});
  fcl::Transform3d upside_down = fcl::Transform3d::Identity();
  upside_down.linear().diagonal() << 1, -1, -1;
  const fcl::Sphered sphere(0.5);
  const auto at = [](double z) { return shifted<double>(0, 0, z); };
  EXPECT_TRUE(meet<double>(prism, fcl::Transform3d::Identity(), sphere, at(3.25)));
  EXPECT_FALSE(meet<double>(prism, fcl::Transform3d::Identity(), sphere, at(-3.25)));
  EXPECT_FALSE(meet<double>(prism, upside_down, sphere, at(3.25)));
  EXPECT_TRUE(meet<double>(prism, upside_down, sphere, at(-3.25)));
}

TEST(MixedRound, whatLeansIsNoDisc) {
  // A cylinder that leans by more than rounding has the section of one that leans.
  const PolygonShaped square(Polygon({rectangle(0, -1, 1, 1)}));
  const fcl::Cylinderd cylinder(1, 10);
  const double lean = 0.1, reach = 1 / std::cos(lean);
  const auto at = [&](double x, double by) { return placed<double>({x, 0, 0}, turned(by, Vec3::UnitY())); };
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  EXPECT_TRUE(meet<double>(square, here, cylinder, at(-1, 0)));
  EXPECT_FALSE(meet<double>(square, here, cylinder, at(-1 - 1e-8, 0)));
  EXPECT_TRUE(meet<double>(square, here, cylinder, at(-reach, lean)));
  EXPECT_FALSE(meet<double>(square, here, cylinder, at(-reach - 1e-6, lean)));
  EXPECT_TRUE(meet<double>(square, here, cylinder, at(-1, 1e-13)));
}

}  // namespace
}  // namespace tricover_fcl::test
