// SPDX-License-Identifier: BSD-3-Clause
// Shapes that are points with a margin: most of what is asked about two of them is told without the kernel.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ask.h"
#include "exact_reference.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

template <typename S = double>
Shape<S> disc(double margin, const Vec2& center = Vec2::Zero(), double z_low = -1, double z_high = 1) {
  return shapeOf<S>(tricover::Polygon::point(center), {margin, z_low, z_high});
}

/// Of a result that has already found something as near as the limit.
template <typename S>
fcl::DistanceResult<S> distanceOf(const Shape<S>& a, const fcl::Transform3<S>& tf_a, const Shape<S>& b,
                                  const fcl::Transform3<S>& tf_b, double limit = 1e300) {
  fcl::DistanceResult<S> result(static_cast<S>(std::min(limit, static_cast<double>(std::numeric_limits<S>::max()))));
  fcl::distance<S>(a.get(), tf_a, b.get(), tf_b, fcl::DistanceRequest<S>(true), result);
  return result;
}

/// Turned about z, mirrored or upside down, by rounded numbers, and tilted within the tolerance.
template <typename S>
fcl::Transform3<S> randomPlace(Random& random, double size) {
  Pose pose =
      tricover::support::turnedAndMoved(random.real(-4, 4), size * random.real(-1, 1), size * random.real(-1, 1));
  if (random.oneIn(4)) pose = mirrored(pose);
  fcl::Transform3<S> place = lifted<S>(pose, random.real(-0.4, 0.4));
  if (random.oneIn(4)) place.matrix()(2, 2) = -1;
  if (random.oneIn(4)) place.matrix()(random.integer(0, 1), 2) = static_cast<S>(random.real(-1e-6, 1e-6));
  if (random.oneIn(4)) place.matrix()(2, random.integer(0, 1)) = static_cast<S>(random.real(-1e-6, 1e-6));
  return place;
}

template <typename S>
void expectExact(std::uint64_t seed) {
  Random random(seed);
  const int count = scaledCount(3000);
  int hits = 0, near = 0;
  for (int i = 0; i < count; ++i) {
    // Some so small that squares lose digits, some so large that they overflow.
    const double size = std::is_same_v<S, float> ? 1 : std::ldexp(1, random.oneIn(4) ? random.integer(-1000, 1000) : 0);
    // Centres that aren't the origins are the kernel's.
    const Vec2 center_a = random.oneIn(8) ? Vec2(size * random.unit(), size) : Vec2::Zero();
    const fcl::Transform3<S> tf_a = randomPlace<S>(random, size), tf_b = randomPlace<S>(random, size);
    const Pose pose_a = flat(tf_a), pose_b = flat(tf_b);
    const Polygon a = tricover::Polygon::point(center_a), b = tricover::Polygon::point(Vec2::Zero());
    const mpq_class square = tricover::exact::distanceSquared(a, pose_a, b, pose_b);
    const double gap = tricover::exact::distanceBelow(square);
    const int steps = random.integer(-12, 12);
    const double reach = random.coin() ? nudged(gap, steps) : gap * random.real(0, 2);
    const double of_a = reach * random.unit(), of_b = reach - of_a;
    const bool expected = tricover::exact::within(square, mpq_class(of_a + of_b));
    const Shape<S> disc_a = disc<S>(of_a, center_a), disc_b = disc<S>(of_b);
    ASSERT_EQ(meet(disc_a, tf_a, disc_b, tf_b), expected) << i;
    hits += expected;
    near += std::abs(of_a + of_b - gap) <= 13 * std::numeric_limits<double>::epsilon() * gap;

    const fcl::DistanceResult<S> result = distanceOf(disc_a, tf_a, disc_b, tf_b);
    tricover::DistanceOptions options;
    options.margin = of_a + of_b;
    const double truth = tricover::distance(a, pose_a, b, pose_b, options).distance;
    // What is too small for S doesn't become a touch.
    const S rounded = std::max(static_cast<S>(truth), truth > 0 ? std::numeric_limits<S>::denorm_min() : S(0));
    if (truth > 0) {
      ASSERT_EQ(result.min_distance, rounded) << i;
    } else if (tricover::exact::within(square, (1 - 1e-12) * (of_a + of_b) - double{std::numeric_limits<S>::min()})) {
      ASSERT_EQ(result.min_distance, -1) << i;
    } else if (!tricover::exact::within(square, (1 - 1e-14) * (of_a + of_b))) {
      ASSERT_EQ(result.min_distance, 0) << i;
    }
    ASSERT_EQ(distanceOf(disc_b, tf_b, disc_a, tf_a).min_distance, result.min_distance) << i;
    if (truth > 0 && std::is_same_v<S, double>) {
      const fcl::Vector3<S> on_a = result.nearest_points[0], on_b = result.nearest_points[1];
      ASSERT_EQ(on_a.z(), on_b.z()) << i;
      ASSERT_LE(std::abs(static_cast<double>(on_a.z())), 1.4) << i;
      const double rounding =
          1e-14 * (pose_a.translation().stableNorm() + center_a.stableNorm() + pose_b.translation().stableNorm());
      const Vec2 p = on_a.template head<2>().template cast<double>(),
                 q = on_b.template head<2>().template cast<double>();
      ASSERT_NEAR((p - pose_a * center_a).stableNorm(), of_a, rounding) << i;
      ASSERT_NEAR((q - pose_b.translation()).stableNorm(), of_b, rounding) << i;
      ASSERT_NEAR((q - p).stableNorm(), truth, rounding) << i;
      ASSERT_EQ(result.b1, 0);
      ASSERT_EQ(result.b2, 0);
    }
  }
  EXPECT_GT(hits, count / 4);
  EXPECT_LT(hits, count * 3 / 4);
  EXPECT_GT(near, count / 3);
}

TEST(Discs, areExact) {
  expectExact<double>(1);
  expectExact<float>(2);
}

/// Centres as far apart as the hypotenuses of Pythagorean triangles are long, whose squares no double holds.
TEST(Discs, thatTouchAreNotApartByARoundedRoot) {
  Random random(3);
  int rounded = 0;
  for (int i = 0; i < 1000; ++i) {
    const double m = random.integer(1 << 24, 1 << 25), n = random.integer(1, 1 << 24);
    const double x = m * m - n * n, y = 2 * m * n, apart = m * m + n * n;
    const Shape<double> a = disc(apart - 1), b = disc(1);
    const Transform here = kHere, there = lifted(0, x, y);
    ASSERT_TRUE(meet(a, here, b, there)) << i;
    ASSERT_EQ(distanceOf(a, here, b, there).min_distance, 0) << i;
    rounded += std::sqrt(x * x + y * y) > apart;
  }
  EXPECT_GT(rounded, 3);
}

TEST(Discs, arePointsAtTheOrigin) {
  EXPECT_TRUE(disc(1)->isDisc());
  EXPECT_TRUE(disc(0, {-0.0, 0.0})->isDisc());
  EXPECT_FALSE(disc(1, {0, 1e-300})->isDisc());
  EXPECT_FALSE(shapeOf(tricover::Polygon::segment({0, 0}, {1, 0}))->isDisc());
  EXPECT_FALSE(shapeOf(Polygon({{{0, 0}, {0, 0}, {0, 0}}, {{1, 0}, {2, 0}, {1, 1}}}))->isDisc());
}

TEST(Discs, meetAtSharedHeightsAlone) {
  const Shape<double> low = disc(2), high = disc(1, Vec2::Zero(), 1, 4);
  const auto at = [](double x, double z) { return lifted(0, x, 0, z); };
  EXPECT_TRUE(meet(low, at(0, 0), high, at(2, 0)));
  EXPECT_FALSE(meet(low, at(0, 0), high, at(2, nudged(0, 1))));
  EXPECT_FALSE(meet(high, at(2, 5), low, at(0, 0)));
  // Upside down it reaches from -4 to -1.
  Transform below = at(2, 0);
  below.matrix()(2, 2) = -1;
  EXPECT_TRUE(meet(high, below, disc(1, Vec2::Zero(), -9, -4), at(0, 0)));
  EXPECT_FALSE(meet(high, below, disc(1, Vec2::Zero(), 1, 4), at(0, 0)));
}

TEST(Discs, whatIsFoundFartherAwayIsNoNews) {
  const Shape<double> a = disc(1), b = disc(1);
  const Transform place = lifted(0, 5, 0);
  EXPECT_EQ(distanceOf(a, kHere, b, place, 3.5).min_distance, 3);
  const auto known = distanceOf(a, kHere, b, place, 2.5);
  EXPECT_EQ(known.min_distance, 2.5);
  EXPECT_EQ(known.o1, nullptr);
}

TEST(Discs, contactsAndOccupancyAreThoseOfPolygons) {
  const Shape<double> a = disc(1), b = disc(2);
  const Transform place = lifted(0, 2, 0);
  fcl::CollisionResultd result;
  ASSERT_EQ(fcl::collide(a.get(), kHere, b.get(), place, fcl::CollisionRequestd(1, true), result), 1u);
  EXPECT_EQ(result.getContact(0).normal, Vec3::UnitX());
  EXPECT_TRUE(meet(a, kHere, b, place));
  b->cost_density = 0;
  EXPECT_FALSE(meet(a, kHere, b, place));
}

TEST(Discs, optionsCount) {
  const Shape<double> a = disc(1), b = disc(1);
  const Transform place = lifted(0, 5, 0);
  fcl::CollisionResultd near, nearer;
  const fcl::CollisionRequestd request;
  EXPECT_EQ(tricover_fcl::collide<double>(a.get(), kHere, b.get(), place, request, {3}, near), 1u);
  EXPECT_EQ(tricover_fcl::collide<double>(a.get(), kHere, b.get(), place, request, {2.9}, nearer), 0u);
}

}  // namespace
}  // namespace tricover_fcl::test
