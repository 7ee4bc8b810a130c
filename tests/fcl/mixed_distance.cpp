// SPDX-License-Identifier: BSD-3-Clause
// Distance of a polygon and FCL's own geometries: measured in the polygon's plane.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

TEST(MixedDistance, aboveAPolygonIsTheGapInSpace) {
  const Shape<double> square = rectangular(-1, -1, 1, 1), prism = shapeOf(square->polygon(), {0.5, -1, 2});
  const auto box = std::make_shared<fcl::Boxd>(1, 1, 1);
  struct Row {
    Shape<double> a;
    Geometry<double> b;
    double x, z, distance;
  };
  const Transform moved = placed({5, -6, 7}, turned(1, Vec3(1, 2, 3)));
  for (const Row& row : std::vector<Row>{{square, box, 0, 3.5, 3},    // right above
                                         {square, box, 5.5, 3.5, 5},  // 4 aside, 3 above
                                         {prism, box, 6, 5.5, 5},     // 4.5 less the margin aside, 3 above
                                         {prism, box, 6, -4.5, 5},    // as much below
                                         {square, std::make_shared<fcl::Cylinderd>(1, 2), 0, 4, 3},
                                         {square, std::make_shared<fcl::Sphered>(1), 0, 4, 3},
                                         {square, std::make_shared<fcl::Halfspaced>(0, 0, -1, 0), 0, 4, 4},
                                         {square, std::make_shared<fcl::Planed>(0, 0, 1, 0), 0, -4, 4},
                                         {square, boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5}), 0, 3.5, 3}}) {
    const Transform pose = shifted(row.x, 0, row.z);
    const auto here = distanceOf(fcl::GST_LIBCCD, false, row.a, kHere, row.b, pose);
    const auto there = distanceOf(fcl::GST_INDEP, true, row.b, Transform(moved * pose), row.a, moved);
    EXPECT_NEAR(here.min_distance, row.distance, 1e-12);
    EXPECT_NEAR(there.min_distance, here.min_distance, 1e-12);
    const auto point_a = [&](const fcl::DistanceResultd& result) {  // FCL hands a mesh's row the mesh first
      return result.nearest_points[result.o1 == row.a.get() ? 0 : 1];
    };
    EXPECT_NEAR((moved * point_a(here) - point_a(there)).norm(), 0, 1e-12);
    EXPECT_NEAR((here.nearest_points[0] - here.nearest_points[1]).norm(), here.min_distance, 1e-12);
  }

  // Cells above and below, none between the polygon's heights: the prism around both is never farther than the nearer.
  const auto scattered = octreeOf(0.5, {{0.2f, 0.2f, 3.2f}, {0.2f, 0.2f, -0.8f}}),
             free = octreeOf(0.5, {}, {{0.2f, 0.2f, 0.2f}});
  const auto either = distanceOf(fcl::GST_LIBCCD, false, square, kHere, scattered, kHere);
  EXPECT_GT(either.min_distance, 0);
  EXPECT_LE(either.min_distance, 0.5);
  // There is nothing to be near to: the distance stays FCL's largest number, and the points are no numbers.
  const auto none = distanceOf(fcl::GST_LIBCCD, false, square, kHere, free, kHere);
  EXPECT_EQ(none.min_distance, std::numeric_limits<double>::max());
  for (const Vec3& point : none.nearest_points) EXPECT_TRUE(point.array().isNaN().all());
}

TEST(MixedDistance, zeroIfAndOnlyIfTheyCollideAndSwapsWithTheArguments) {
  Random random(63);
  int hits = 0, cases = 0;
  const auto geometries = knownGeometries<double>();
  for (int i = 0; i < scaledCount(2000); ++i) {
    const Known<double>& known = geometries[static_cast<std::size_t>(i) % geometries.size()];
    SCOPED_TRACE(known.name + " " + std::to_string(i));
    const Shape<double> polygon = shapeOf(randomPolygon(random, random.real(0.2, 2)));
    const Transform tf_polygon = anywhere(random, 1.5), tf_other = anywhere(random, 1.5);
    const bool hit = collides(polygon, tf_polygon, known.geometry, tf_other);
    const auto result = distanceOf(fcl::GST_LIBCCD, false, *polygon, tf_polygon, *known.geometry, tf_other);
    const auto swapped = distanceOf(fcl::GST_INDEP, false, *known.geometry, tf_other, *polygon, tf_polygon);
    EXPECT_EQ(result.min_distance <= 0, hit);
    EXPECT_EQ(result.min_distance, swapped.min_distance);
    if (result.min_distance > 0 && result.min_distance < 1e300) {
      const Vec3 between = result.nearest_points[0] - result.nearest_points[1];
      EXPECT_NEAR(between.norm(), result.min_distance, 1e-9);
      const int of_polygon = result.o1 == polygon.get() ? 0 : 1;  // FCL hands a mesh's row the mesh first
      EXPECT_NEAR((tf_polygon.inverse() * result.nearest_points[of_polygon]).z(), 0, 1e-12);
    }
    hits += hit;
    ++cases;
  }
  EXPECT_GT(hits, cases * 2 / 10);
  EXPECT_LT(hits, cases * 8 / 10);
}

/// What both are away from the origin is taken off before anything is rounded.
TEST(MixedDistance, isFarAwayWhatItIsHere) {
  Random random(75);
  const Vec3 far(std::ldexp(1, 33), -std::ldexp(3, 32), 0);
  const fcl::Boxd box(1, 2, 3);
  const auto bar = shapeOf<double>(Polygon({rectangle(-2, -0.5, 2, 0.5)}));
  const auto onGrid = [&] { return std::ldexp(random.integer(-(1 << 20), 1 << 20), -18); };
  int apart = 0;
  const int asked = scaledCount(200);
  for (int i = 0; i < asked; ++i) {
    const fcl::Matrix3<double> turn = turned(random.real(-3, 3), Vec3::UnitZ()),
                               turn_of_box = turned(random.real(-3, 3), Vec3(1, 2, 3));
    const Vec3 at(onGrid(), onGrid(), 0), at_of_box(onGrid(), onGrid(), 0);
    const auto here = distanceOf(fcl::GST_LIBCCD, false, *bar, placed(at, turn), box, placed(at_of_box, turn_of_box));
    const auto there =
        distanceOf(fcl::GST_LIBCCD, false, *bar, placed(at + far, turn), box, placed(at_of_box + far, turn_of_box));
    EXPECT_NEAR(there.min_distance, here.min_distance, 1e-13);
    apart += here.min_distance > 0;
  }
  EXPECT_GT(apart, asked / 2);
  EXPECT_LT(apart, asked);
}

TEST(MixedDistance, ofOverlaps) {
  const Shape<double> square = rectangular(-1, -1, 1, 1), inner = rectangular(0.4, -0.1, 0.6, 0.1);
  const auto mesh = boxMesh<fcl::OBBRSSd>({1, 1, 1});
  const fcl::Halfspaced below(0, 0, 1, 0);
  for (const fcl::GJKSolverType solver : kSolvers) {
    // A surface has no inside to be deep in: where it is met it is overlapped, if only touched.
    const auto at = [&](double x) {
      return distanceOf(solver, false, square, kHere, mesh, shifted(x, 0, 0)).min_distance;
    };
    EXPECT_EQ(at(1.5), -1);
    EXPECT_EQ(at(2), -1);
    EXPECT_NEAR(at(2 + 1e-6), 1e-6, 1e-13);
    // A square whose left side is 1.6 from the round outline's rightmost point, and farther from any other; of the
    // sphere it is a disc of 2 at this height.
    for (const double angle : {0.0, 0.3, 2.0}) {
      const Transform pose = lifted(angle, 0, 0), above = shifted(0, 0, 1.5);
      EXPECT_NEAR(distanceOf(solver, true, inner, pose, fcl::Sphered(2.5), above).min_distance, -1.6, 1e-5);
      EXPECT_NEAR(distanceOf(solver, true, inner, pose, fcl::Cylinderd(2, 4), above).min_distance, -1.6, 1e-5);
    }
    // Planes parallel to the polygon are left along their normal.
    EXPECT_NEAR(distanceOf(solver, true, tip(), shifted(0, 0, -0.25), below, kHere).min_distance, -0.25, 1e-12);
    EXPECT_EQ(distanceOf(solver, true, tip(), kHere, below, kHere).min_distance, 0);
  }
}

TEST(MixedDistance, contactUpToRoundingHasNearestPointsBelowAnyLimit) {
  // A million from the polygon's origin, rounding counts a gap of 1e-9 as contact.
  const Shape<double> square = rectangular(0, -1, 1, 1);
  const fcl::Boxd box(2e6, 2, 2);
  const Transform pose = shifted(1 + 1e6 + 1e-9, 0, 0);
  for (const bool box_first : {false, true}) {
    fcl::DistanceResultd result;
    result.min_distance = 1e-12;  // of another pair, nearer than the gap
    if (box_first) {
      fcl::distance<double>(&box, pose, square.get(), kHere, fcl::DistanceRequestd(), result);
    } else {
      fcl::distance<double>(square.get(), kHere, &box, pose, fcl::DistanceRequestd(), result);
    }
    EXPECT_EQ(result.min_distance, 0);
    for (const Vec3& point : result.nearest_points) {
      EXPECT_NEAR(point.x(), 1, 2e-9);
      EXPECT_LE(std::abs(point.y()), 1);
      EXPECT_EQ(point.z(), 0);
    }
  }
}

TEST(MixedDistance, signedWhereFclWouldAbortThrows) {
  const Transform here = kHere;
  fcl::Boxd box(2, 2, 2);
  const Geometry<double> mesh = boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5});
  box.cost_density = mesh->cost_density = 0.5;  // uncertain: collide has no contact for them
  EXPECT_LT(distanceOf(fcl::GST_LIBCCD, true, *tip<double>(), here, box, here).min_distance, 0);
  EXPECT_THROW(distanceOf(fcl::GST_INDEP, true, *tip<double>(), here, box, here), std::logic_error);
  EXPECT_THROW(distanceOf(fcl::GST_INDEP, true, *tip<double>(), here, *mesh, here), std::logic_error);
  EXPECT_THROW(distanceOf(fcl::GST_LIBCCD, true, *mesh, here, *tip<double>(), here), std::logic_error);
  EXPECT_EQ(distanceOf(fcl::GST_INDEP, false, *tip<double>(), here, box, here).min_distance, -1);
}

}  // namespace
}  // namespace tricover_fcl::test
