// SPDX-License-Identifier: BSD-3-Clause
// Prisms: polygons with an interval of heights.
#include <gmpxx.h>

#include <cmath>
#include <limits>

#include "ask.h"

namespace tricover_fcl::test {
namespace {

const Polygon kSquare({rectangle(0, 0, 1, 1)});

Shape<double> prism(double z_low, double z_high, const Polygon& polygon = kSquare) {
  return shapeOf(polygon, {0, z_low, z_high});
}

Transform at(double z, double x = 0) { return lifted(0, x, 0, z); }

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
  Transform upside_down(fcl::AngleAxis<double>(M_PI, Vec3::UnitX()));
  const Polygon centred({rectangle(-1, -1, 1, 1)});
  const Shape<double> a = prism(1, 2, centred), flat = shapeOf(centred);
  for (const double z : {-2.0, -1.5, -1.0}) EXPECT_TRUE(meet(a, upside_down, flat, at(z)));
  for (const double z : {-2.1, -0.9, 1.0, 1.5}) EXPECT_FALSE(meet(a, upside_down, flat, at(z)));
  upside_down.translation().z() = 5;
  EXPECT_TRUE(meet(a, upside_down, flat, at(3)));
  EXPECT_FALSE(meet(a, upside_down, flat, at(6)));
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

TEST(Heights, allOfThemMeetWhateverZ) {
  const auto planar = [](double margin = 0) { return shapeOf(kSquare, PolygonOptions::atAllHeights(margin)); };
  const Shape<double> a = planar(), b = planar(0.5), flat = shapeOf(kSquare);
  Transform upside_down(fcl::AngleAxis<double>(M_PI, Vec3::UnitX()));
  for (const double z : {0.0, 1e-9, -7.0, 1e300}) {
    EXPECT_TRUE(meet(a, at(z), a, at(0, 1)));
    EXPECT_FALSE(meet(a, at(z), a, at(0, 1.25)));
    EXPECT_TRUE(meet(a, at(z), b, at(0, 1.25)));
    EXPECT_TRUE(meet(a, at(z), flat, at(-z, 1)));
    EXPECT_TRUE(meet(a, at(z), prism(1, 2), at(-z, 1)));
    upside_down.translation().z() = z;
    EXPECT_TRUE(meet(a, upside_down, a, at(0)));
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

TEST(Heights, badIntervalsAreRefusedByName) {
  const auto make = [](double low, double high) { return [=] { PolygonShaped(kSquare, {0, low, high}); }; };
  for (const auto& [low, high] : {std::pair(1.0, 0.5), {0.0, kNaN}, {0.0, kInfinity}})
    expectRefused({"z_high"}, make(low, high));
  for (const auto& [low, high] : {std::pair(-kInfinity, 0.0), {kNaN, kNaN}}) expectRefused({"z_low"}, make(low, high));
  EXPECT_NO_THROW(make(-2, -1)());
}

}  // namespace
}  // namespace tricover_fcl::test
