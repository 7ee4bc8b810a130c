// SPDX-License-Identifier: BSD-3-Clause
// Prisms: polygons with an interval of heights.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <gmpxx.h>

#include <cmath>
#include <limits>

#include "ask.h"

namespace tricover_fcl::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
const tricover::Polygon kSquare({rectangle(0, 0, 1, 1)});

Shape<double> prism(double z_low, double z_high, const tricover::Polygon& polygon = kSquare) {
  return std::make_shared<PolygonShaped>(polygon, PolygonOptions{0, z_low, z_high});
}

fcl::Transform3d at(double z, double x = 0) { return lifted(0, x, 0, z); }

TEST(Heights, touchingCounts) {
  const Shape<double> low = prism(-1, 2), high = prism(2, 3), flat = shapeOf(kSquare);
  EXPECT_TRUE(meet(low, at(0), high, at(0)));
  EXPECT_FALSE(meet(low, at(0), high, at(1e-300)));
  EXPECT_TRUE(meet(low, at(0), flat, at(2)));
  EXPECT_TRUE(meet(low, at(0), flat, at(-1)));
  EXPECT_FALSE(meet(low, at(0), flat, at(nudged(2, 1))));
  EXPECT_FALSE(meet(low, at(0), high, at(0, 2)));  // apart in the plane
  EXPECT_TRUE(meet(prism(0.5, 0.5), at(0), flat, at(0.5)));
}

TEST(Heights, sumsAreExact) {
  // Rounded, both sums are 0.30000000000000004.
  EXPECT_EQ(0.1 + 0.2, 0.3 + 0x1p-54);
  EXPECT_FALSE(meet(prism(0, 0.2), at(0.1), shapeOf(kSquare), at(0.1 + 0.2)));
  EXPECT_TRUE(meet(prism(0, 0.2), at(0.1), shapeOf(kSquare), at(0.3)));

  Random random(31);
  int hits = 0;
  const int count = scaledCount(20000);
  for (int i = 0; i < count; ++i) {
    const double z = random.real(-1, 1) * std::ldexp(1, random.integer(-40, 3)), top = random.real(0, 1);
    const double bottom = random.real(-1, 1);
    const double other = nudged((z + top) - bottom, random.integer(-1, 1));
    const bool expected = mpq_class(z) + mpq_class(top) >= mpq_class(other) + mpq_class(bottom);
    ASSERT_EQ(meet(prism(-9, top), at(z), prism(bottom, 9), at(other)), expected) << i;
    hits += expected;
  }
  EXPECT_GT(hits, count * 3 / 10);
  EXPECT_LT(hits, count * 7 / 10);
}

TEST(Heights, hugeSumsDoNotOverflow) {
  const double huge = 1.7e308;
  EXPECT_TRUE(meet(prism(0, huge), at(huge), prism(0, huge), at(huge)));
  EXPECT_FALSE(meet(prism(0, 1), at(-huge), prism(huge, huge), at(huge)));
  EXPECT_TRUE(meet(prism(huge, huge), at(huge), prism(huge, huge), at(huge)));
  EXPECT_FALSE(meet(prism(huge, huge), at(huge), prism(huge, huge), at(nudged(huge, 1))));
  fcl::DistanceResultd result;
  EXPECT_EQ(fcl::distance<double>(prism(0, 1).get(), at(-huge), prism(huge, huge).get(), at(huge),
                                  fcl::DistanceRequestd(), result),
            std::numeric_limits<double>::max());
}

TEST(Heights, posesUpsideDownTurnTheInterval) {
  fcl::Transform3d upside_down(fcl::AngleAxis<double>(kPi, fcl::Vector3d::UnitX()));
  const tricover::Polygon centred({rectangle(-1, -1, 1, 1)});
  const Shape<double> a = prism(1, 2, centred), flat = shapeOf(centred);
  for (const double z : {-2.0, -1.5, -1.0}) EXPECT_TRUE(meet(a, upside_down, flat, at(z)));
  for (const double z : {-2.1, -0.9, 1.0, 1.5}) EXPECT_FALSE(meet(a, upside_down, flat, at(z)));
  upside_down.translation().z() = 5;
  EXPECT_TRUE(meet(a, upside_down, flat, at(3)));
  EXPECT_FALSE(meet(a, upside_down, flat, at(6)));
}

TEST(Heights, distanceIsThatInSpace) {
  const Shape<double> low = prism(0, 1), high = prism(0, 1);
  for (const fcl::GJKSolverType solver : kSolvers) {
    fcl::DistanceRequestd request;
    request.gjk_solver_type = solver;
    fcl::DistanceResultd slanted, above, beside;
    EXPECT_EQ(fcl::distance(low.get(), at(0), high.get(), at(5, 4), request, slanted), 5);  // 3 along x, 4 along z
    EXPECT_EQ(slanted.nearest_points[0].x(), 1);
    EXPECT_EQ(slanted.nearest_points[0].z(), 1);
    EXPECT_EQ(slanted.nearest_points[1].x(), 4);
    EXPECT_EQ(slanted.nearest_points[1].z(), 5);
    EXPECT_EQ((slanted.nearest_points[0] - slanted.nearest_points[1]).norm(), 5);

    EXPECT_EQ(fcl::distance(high.get(), at(5, 0.5), low.get(), at(0), request, above), 4);
    EXPECT_EQ(above.nearest_points[0].z(), 5);
    EXPECT_EQ(above.nearest_points[1].z(), 1);
    EXPECT_EQ(above.nearest_points[0].head<2>(), above.nearest_points[1].head<2>());

    EXPECT_EQ(fcl::distance(low.get(), at(0), high.get(), at(0.5, 4), request, beside), 3);
    EXPECT_EQ(beside.nearest_points[0].z(), 0.75);
    EXPECT_EQ(beside.nearest_points[1].z(), 0.75);
  }
  // The gap that only exact sums see.
  fcl::DistanceResultd tiny;
  EXPECT_EQ(fcl::distance<double>(prism(0, 0.2).get(), at(0.1), shapeOf(kSquare).get(), at(0.1 + 0.2),
                                  fcl::DistanceRequestd(), tiny),
            (0.1 + 0.2) - 0.2 - 0.1);
}

TEST(Heights, contactsAndCostsAreWhereTheIntervalsOverlap) {
  fcl::CollisionRequestd request(1, true, 1, true);
  fcl::CollisionResultd result;
  ASSERT_EQ(fcl::collide<double>(prism(0, 3).get(), at(0), prism(0, 3).get(), at(1, 0.5), request, result), 1u);
  EXPECT_EQ(result.getContact(0).pos.z(), 2);
  EXPECT_EQ(result.getContact(0).normal.z(), 0);
  EXPECT_NEAR(result.getContact(0).penetration_depth, 0.5, 1e-12);
  std::vector<fcl::CostSourced> costs;
  result.getCostSources(costs);
  ASSERT_EQ(costs.size(), 1u);
  EXPECT_EQ(costs[0].total_cost, 0.5 * 1 * 2);
  EXPECT_EQ(costs[0].aabb_min.z(), 1);
  EXPECT_EQ(costs[0].aabb_max.z(), 3);
}

TEST(Heights, broadphaseFindsWhatTouches) {
  Random random(32);
  int hits = 0, pairs = 0;
  for (int scene = 0; scene < scaledCount(40); ++scene) {
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
    for (int i = 0; i < 12; ++i) {
      const double low = random.integer(-2, 2) * 0.1, high = low + random.integer(0, 3) * 0.1;
      tricover::Pose pose = randomPose(random, 1.5);
      if (random.coin()) pose.linear().setIdentity();
      objects.push_back(std::make_unique<fcl::CollisionObjectd>(prism(low, high, randomPolygon(random, 1)),
                                                                lifted(pose, random.integer(-4, 4) * 0.1)));
    }
    fcl::DynamicAABBTreeCollisionManagerd manager;
    for (const auto& object : objects) manager.registerObject(object.get());
    manager.setup();
    fcl::DefaultCollisionData<double> data;
    data.request.num_max_contacts = 1000;
    manager.collide(&data, fcl::DefaultCollisionFunction<double>);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        fcl::CollisionResultd result;
        expected += fcl::collide(objects[i].get(), objects[j].get(), fcl::CollisionRequestd(), result);
        ++pairs;
      }
    }
    ASSERT_EQ(data.result.numContacts(), expected) << scene;
    hits += static_cast<int>(expected);
  }
  EXPECT_GT(hits, pairs / 10);
  EXPECT_LT(hits, pairs * 9 / 10);
}

TEST(Heights, allOfThemMeetWhateverZ) {
  const auto planar = [](double margin = 0) {
    return std::make_shared<PolygonShaped>(kSquare, PolygonOptions::atAllHeights(margin));
  };
  const Shape<double> a = planar(), b = planar(0.5), flat = shapeOf(kSquare);
  fcl::Transform3d upside_down(fcl::AngleAxis<double>(kPi, fcl::Vector3d::UnitX()));
  for (const double z : {0.0, 1e-9, -7.0, 1e300}) {
    EXPECT_TRUE(meet(a, at(z), a, at(0, 1)));
    EXPECT_FALSE(meet(a, at(z), a, at(0, 1.25)));
    EXPECT_TRUE(meet(a, at(z), b, at(0, 1.25)));
    EXPECT_TRUE(meet(a, at(z), flat, at(-z, 1)));
    EXPECT_TRUE(meet(a, at(z), prism(1, 2), at(-z, 1)));
    upside_down.translation().z() = z;
    EXPECT_TRUE(meet(a, upside_down, a, at(0)));
    fcl::DistanceResultd result;
    EXPECT_EQ(fcl::distance<double>(a.get(), at(z), flat.get(), at(3, 4), fcl::DistanceRequestd(), result), 3);
    EXPECT_EQ(result.nearest_points[0].z(), 3);
    EXPECT_EQ(result.nearest_points[1].z(), 3);
  }
  fcl::CollisionRequestd request(1, true, 1, true);
  fcl::CollisionResultd result;
  ASSERT_EQ(fcl::collide<double>(a.get(), at(2), a.get(), at(4, 0.5), request, result), 1u);
  EXPECT_EQ(result.getContact(0).pos.z(), 3);
  std::vector<fcl::CostSourced> costs;
  result.getCostSources(costs);
  ASSERT_EQ(costs.size(), 1u);
  EXPECT_TRUE(costs[0].aabb_min.allFinite() && costs[0].aabb_max.allFinite());
}

TEST(Heights, allOfThemAreFiniteForAManager) {
  // Some turned, some not, at slightly different z.
  Random random(33);
  int hits = 0, pairs = 0;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  for (int i = 0; i < 60; ++i) {
    tricover::Pose pose = randomPose(random, 5);
    if (random.coin()) pose.linear().setIdentity();
    const auto shape = std::make_shared<PolygonShaped>(randomPolygon(random, 1), PolygonOptions::atAllHeights(0.1));
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(shape, lifted(pose, random.real(-0.5, 0.5))));
    ASSERT_LT(shape->aabb_radius, 2);
    manager.registerObject(objects.back().get());
  }
  manager.setup();
  fcl::DefaultCollisionData<double> data;
  data.request.num_max_contacts = 10000;
  manager.collide(&data, fcl::DefaultCollisionFunction<double>);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j, ++pairs) {
      fcl::CollisionResultd result;
      hits += static_cast<int>(fcl::collide(objects[i].get(), objects[j].get(), fcl::CollisionRequestd(), result));
    }
  }
  EXPECT_EQ(data.result.numContacts(), static_cast<std::size_t>(hits));
  EXPECT_GT(hits, pairs / 50);
  EXPECT_LT(hits, pairs / 2);
}

TEST(Heights, badIntervalsAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto refusal = [](double low, double high) {
    return thrownBy<std::invalid_argument>([&] { PolygonShaped(kSquare, {0, low, high}); });
  };
  EXPECT_NE(refusal(1, 0.5).find("z_high"), std::string::npos);
  EXPECT_NE(refusal(0, nan).find("z_high"), std::string::npos);
  EXPECT_NE(refusal(0, infinity).find("z_high"), std::string::npos);
  EXPECT_NE(refusal(-infinity, 0).find("z_low"), std::string::npos);
  EXPECT_NE(refusal(nan, nan).find("z_low"), std::string::npos);
  EXPECT_EQ(refusal(-2, -1), "");
}

}  // namespace
}  // namespace tricover_fcl::test
