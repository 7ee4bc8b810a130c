// SPDX-License-Identifier: BSD-3-Clause
// A polygon against spheres, capsules and cylinders that are discs or stadiums in its plane: exact ones.
#include <cmath>

#include "exact_reference.h"
#include "mixed_scene.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

/// As it is, or with all of it carried elsewhere in space.
Transform carriedElsewhere(Random& random) {
  const Vec3 elsewhere = anyPoint(random, 9);
  return placed(elsewhere, turned(random.real(0, 6), elsewhere));
}

TEST(MixedRound, isExactOnEveryFamily) {
  Random random(81);
  int cases = 0, found = 0;
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    for (int i = 0; i < scaledCount(30); ++i) {
      const Case c = family.make(static_cast<std::uint64_t>(i));
      const Vec2 center = c.pose_b * c.b.coveringOrigin();
      if (!(center.norm() < 1e300)) continue;
      Pose place = Pose::Identity();
      place.translation() = center;
      const double angle = random.real(-3, 3), size = random.coin() ? 0 : (c.pose_b.linear() * c.b.edgeStart(0)).norm();
      const Vec2 axis(std::cos(angle), std::sin(angle));
      place.linear() << axis.x(), -axis.y(), axis.y(), axis.x();
      const Polygon segment =
          size == 0 ? tricover::Polygon::point({0, 0}) : tricover::Polygon::segment({-size / 2, 0}, {size / 2, 0});
      const mpq_class square = tricover::exact::distanceSquared(c.a, c.pose_a, segment, place);
      const double gap = tricover::exact::distanceBelow(square);
      if (!(gap > 1e-300 && gap < 1e300 && size < 1e300)) continue;
      // The prism's heights hold the axis.
      const Shape<double> shape =
          shapeOf(c.a, random.coin() ? PolygonOptions{0, -1, 2} : PolygonOptions::atAllHeights());
      const Transform pose = lifted(c.pose_a, 5);
      const Vec3 at(center.x(), center.y(), 5.5);
      for (const int steps : {-1, 0, 1}) {
        const double radius = nudged(gap, steps);
        const bool expected = tricover::exact::within(square, radius);
        const auto expectExact = [&](const Body& round, const Transform& there) {
          ASSERT_EQ(meet(shape, pose, round, there), expected) << reproduction(c);
          ASSERT_EQ(distanceOf(fcl::GST_LIBCCD, false, shape, pose, round, there).min_distance <= 0, expected)
              << reproduction(c);
        };
        ASSERT_NO_FATAL_FAILURE(
            expectExact(fcl::Capsuled(radius, size), size == 0 ? shifted(at.x(), at.y(), at.z()) : lying(axis, at)));
        if (size == 0) {
          ASSERT_NO_FATAL_FAILURE(expectExact(fcl::Sphered(radius), shifted(at.x(), at.y(), at.z())));
          ASSERT_NO_FATAL_FAILURE(expectExact(fcl::Cylinderd(radius, 1), shifted(at.x(), at.y(), at.z())));
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
  std::shared_ptr<Body> geometry;
  Transform pose;
  Polygon segment =
      tricover::Polygon::point({0, 0});  ///< what it leaves in the plane, in the world, and how far around
  double radius = 0;                     ///< negative: it doesn't reach the heights
  double low = 0, high = 0;              ///< its own heights
};

/// A sphere, capsule or cylinder near heights from `low` to `high`, whose section is known.
Scene anyRound(Random& random, double low, double high) {
  const double r = random.real(0.2, 2), length = random.real(0.1, 3), z = random.real(low - 3, high + 3);
  const Vec3 at(random.real(-4, 4), random.real(-4, 4), z);
  const double angle = random.real(-3, 3);
  const Vec2 center = at.head<2>(), axis(std::cos(angle), std::sin(angle)), half = length / 2 * axis;
  const auto section = [&](double rise) {
    const double outside = std::max({low - z - rise, z - rise - high, 0.0});
    return outside < r ? std::sqrt(r * r - outside * outside) : -1;
  };
  const auto capsule = std::make_shared<fcl::Capsuled>(r, length);
  const Transform standing = placed(at, turned(angle, Vec3::UnitZ())), any = placed(at, turned(angle, {1, 2, 3}));
  const Polygon point = tricover::Polygon::point(center);
  const double upright = low - z <= length / 2 && z - high <= length / 2 ? r : -1, rise = length / 2;
  switch (random.integer(0, 3)) {
    case 0:
      return {std::make_shared<fcl::Sphered>(r), any, point, section(0), z - r, z + r};
    case 1:
      return {std::make_shared<fcl::Cylinderd>(r, length), standing, point, upright, z - rise, z + rise};
    case 2:
      return {capsule, standing, point, section(rise), z - rise - r, z + rise + r};
    default:
      return {capsule,    lying(axis, at), tricover::Polygon::segment(center - half, center + half),
              section(0), z - r,           z + r};
  }
}

TEST(MixedRound, sectionsDistancesAndNearestPoints) {
  Random random(82);
  const int cases = scaledCount(2000);
  int found = 0, apart = 0, away = 0;
  for (int i = 0; i < cases; ++i) {
    const double low = random.coin() ? 0 : random.real(-2, 0), high = low == 0 ? 0 : random.real(0, 2),
                 margin = random.coin() ? 0 : random.real(0, 1);
    const Shape<double> shape = shapeOf(randomPolygon(random, 2), {margin, low, high});
    const Scene scene = anyRound(random, low, high);
    const Pose pose = randomPose(random, 2);
    const Pose identity = Pose::Identity();
    const double gap = tricover::distance(shape->polygon(), pose, scene.segment, identity).distance;
    const double left = gap - scene.radius - margin;
    const Transform carried = carriedElsewhere(random);
    for (const Transform& by : {kHere, carried}) {
      const Transform there = by * lifted(pose), other = by * scene.pose;
      const auto result = distanceOf(fcl::GST_LIBCCD, false, shape, there, scene.geometry, other);
      if (scene.radius < 0) {
        ASSERT_FALSE(meet(shape, there, scene.geometry, other)) << i;
        ASSERT_GT(result.min_distance, 0) << i;
        ++away;
        continue;
      }
      if (std::abs(left) < 1e-10) continue;
      ASSERT_EQ(meet(shape, there, scene.geometry, other), left < 0) << i << ": " << left;
      ASSERT_NEAR(result.min_distance, left > 0 ? left : -1, 1e-11) << i;
      const Transform back = by.inverse();
      const Vec3 on_shape = back * result.nearest_points[0], on_other = back * result.nearest_points[1];
      ASSERT_NEAR((on_shape - on_other).norm(), std::max(left, 0.0), 1e-11) << i;
      const auto off = [&](const Polygon& polygon, const Pose& where, const Vec3& point) {
        return tricover::distance(polygon, where, tricover::Polygon::point(point.head<2>()), identity).distance;
      };
      ASSERT_LE(off(shape->polygon(), pose, on_shape), margin + 1e-11) << i;
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
  const Vec2 v = segment.edgeStart(0), w = segment.edgeEnd(0);
  const double turn = v == w ? 0 : std::atan2((w - v).y(), (w - v).x());
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * M_PI * (i + 0.5) / vertices - M_PI / 2;
    const Vec2 out(std::cos(angle + turn), std::sin(angle + turn));
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
    const Shape<double> shape = shapeOf(
        is_convex ? Polygon({star(random, random.integer(3, 9), 2, 2)}) : randomPolygon(random, 2), {margin, 0, 0});
    const Scene scene = anyRound(random, 0, 0);
    const Pose pose = randomPose(random, 2), identity = Pose::Identity();
    if (scene.radius < 0) continue;
    const double both = scene.radius + margin;  // parts the polygon from the segment
    const double gap = tricover::distance(shape->polygon(), pose, scene.segment, identity).distance;
    if (!(gap < both - 1e-9)) continue;
    const Transform by = random.coin() ? kHere : carriedElsewhere(random);
    const Transform tf_shape = by * lifted(pose), tf_other = by * scene.pose;
    const auto one = contactsOf(scene.geometry, tf_other, shape, tf_shape, 1);
    ASSERT_EQ(one.size(), 1u);
    const fcl::Contactd& contact = one[0];
    const double depth = contact.penetration_depth, error = 3e-6 * (both + 2);  // reaches are up to 4
    const auto outermost = tricover::penetration(
        shape->polygon(), pose, around(scene.segment, both / std::cos(M_PI / corners), corners), identity);
    const auto innermost =
        tricover::penetration(shape->polygon(), pose, around(scene.segment, both, corners), identity);
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
    const double left = tricover::distance(shape->polygon(), pose, scene.segment, moved).distance;
    ASSERT_GE(left, both - error);
    if (is_convex) {
      ASSERT_LE(left, both + error);
    }
    const auto result = distanceOf(fcl::GST_LIBCCD, true, shape, tf_shape, scene.geometry, tf_other);
    ASSERT_NEAR(result.min_distance, depth > error ? -depth : 0, error);
    if (result.min_distance < 0 && is_convex) {
      ASSERT_LT((result.nearest_points[0] - result.nearest_points[1] - depth * -contact.normal).norm(), error);
    }
    // Each part's own, which isn't the way out.
    const auto all = contactsOf(scene.geometry, tf_other, shape, tf_shape, 10);
    ASSERT_GE(all.size(), 1u);
    for (const fcl::Contactd& part : all) {
      ASSERT_NEAR(part.normal.norm(), 1, 1e-12);
      ASSERT_GE(part.penetration_depth, 0);
    }
    // A stadium's side has both of its ends.
    whole += all.size() == 1 || (all.size() == 2 && all[0].normal == all[1].normal);
    const bool is_direct = gap > 0 && std::abs(depth - (both - gap)) < 1e-9;
    if (is_direct) {  // in the middle of what they share
      const Polygon there = tricover::Polygon::point((by.inverse() * contact.pos).head<2>());
      ASSERT_NEAR(tricover::distance(scene.segment, identity, there, identity).distance,
                  std::abs(scene.radius - depth / 2), 1e-9);
      ASSERT_LE(std::abs(tricover::distance(shape->polygon(), pose, there, identity).distance - margin),
                depth / 2 + 1e-9);
    }
    ++(is_direct ? direct : searched);
  }
  EXPECT_GT(direct, cases / 4);
  EXPECT_GT(searched, cases / 10);
  EXPECT_GT(whole, cases / 4);
}

}  // namespace
}  // namespace tricover_fcl::test
