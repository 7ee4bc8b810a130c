// SPDX-License-Identifier: BSD-3-Clause
// Distance of a polygon and FCL's own geometries: measured in the polygon's plane.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mixed_scene.h"

namespace tricover_fcl::test {
namespace {

using Vec3 = fcl::Vector3<double>;

template <typename S>
class MixedDistance : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { registerNarrowphase(); }
  static constexpr double kError = std::is_same_v<S, float> ? 2e-6 : 1e-8;
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MixedDistance, Scalars);

TYPED_TEST(MixedDistance, ofATipIsWhatItIsAlongX) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    for (const double gap : {2.0, 1e-3}) {
      const fcl::Transform3<S> pose = shifted<S>(known.right + gap, 0, 0);
      const Vec3 on_tip(known.right + gap, 0, 0), on_other(known.right, 0, 0);
      for (const fcl::GJKSolverType solver : kSolvers) {
        const auto first = distanceOf<S>(solver, false, *tip<S>(), pose, *known.geometry, known.pose);
        const auto second = distanceOf<S>(solver, true, *known.geometry, known.pose, *tip<S>(), pose);
        for (const auto& result : {first, second}) {
          EXPECT_NEAR(result.min_distance, gap, this->kError);
          const int polygon = result.o1 == known.geometry.get() ? 1 : 0;
          const auto error = [&](int which, const Vec3& truth) {
            return (result.nearest_points[which].template cast<double>() - truth).norm();
          };
          EXPECT_LT(error(polygon, on_tip), 10 * this->kError);
          // Where a round outline is flat, 1e-9 of distance is 1e-4 of place.
          EXPECT_LT(error(1 - polygon, on_other), 1e-3);
        }
      }
    }
  }
}

TYPED_TEST(MixedDistance, ofAnOverlapIsMinusOneOrTheDepth) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    // Near a tip or an edge-on face the way out is a shorter one.
    if (known.name.find("tip") != std::string::npos || known.name.find("convex") != std::string::npos) continue;
    const double depth = 1e-3;
    const fcl::Transform3<S> pose = shifted<S>(known.right - depth, 0, 0);
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto meeting = distanceOf<S>(solver, false, *tip<S>(), pose, *known.geometry, known.pose);
      EXPECT_EQ(meeting.min_distance, S(-1));
      EXPECT_LT((meeting.nearest_points[0] - meeting.nearest_points[1]).norm(), 5e-6);
      EXPECT_EQ(distanceOf<S>(solver, false, *known.geometry, known.pose, *tip<S>(), pose).min_distance, S(-1));
      EXPECT_NEAR(distanceOf<S>(solver, true, *tip<S>(), pose, *known.geometry, known.pose).min_distance, -depth, 5e-6);
      EXPECT_NEAR(distanceOf<S>(solver, true, *known.geometry, known.pose, *tip<S>(), pose).min_distance, -depth, 5e-6);
    }
  }
}

/// Above or below the polygon's heights it is that of two prisms, and never uninitialised.
TYPED_TEST(MixedDistance, besideTheHeightsIsThatOfPrisms) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    const fcl::NODE_TYPE type = known.geometry->getNodeType();
    if (type == fcl::GEOM_PLANE || type == fcl::GEOM_HALFSPACE) continue;  // they go everywhere
    const fcl::Transform3<S> pose = shifted<S>(70, 0, 60);
    const auto result = distanceOf<S>(fcl::GST_LIBCCD, false, *tip<S>(), pose, *known.geometry, known.pose);
    const auto swapped = distanceOf<S>(fcl::GST_INDEP, true, *known.geometry, known.pose, *tip<S>(), pose);
    EXPECT_LT(result.min_distance, S(100));
    EXPECT_GT(result.min_distance, S(1));
    EXPECT_EQ(result.min_distance, swapped.min_distance);
    const auto between = (result.nearest_points[0] - result.nearest_points[1]).template cast<double>();
    EXPECT_NEAR(between.norm(), static_cast<double>(result.min_distance), 20 * this->kError);
    EXPECT_FALSE(collides(*tip<S>(), pose, *known.geometry, known.pose));
  }
}

TEST(MixedDistanceLaws, aboveAPolygonIsTheGapInSpace) {
  registerNarrowphase();
  const Shape<double> square = rectangular(-1, -1, 1, 1);
  const PolygonShaped prism(square->polygon(), PolygonOptions{0.5, -1, 2});
  const fcl::Transform3d moved = placed<double>({5, -6, 7}, turned(1, Vec3(1, 2, 3)));
  const auto above = [&](const fcl::CollisionGeometryd& a, const fcl::CollisionGeometryd& b, double x, double z) {
    const auto here =
        distanceOf<double>(fcl::GST_LIBCCD, false, a, fcl::Transform3d::Identity(), b, shifted<double>(x, 0, z));
    const auto there = distanceOf<double>(fcl::GST_INDEP, true, b, moved * shifted<double>(x, 0, z), a, moved);
    EXPECT_NEAR(there.min_distance, here.min_distance, 1e-12);
    const int here_a = here.o1 == &a ? 0 : 1,
              there_a = there.o1 == &a ? 0 : 1;  // FCL hands a mesh's row the mesh first
    EXPECT_NEAR((moved * here.nearest_points[here_a] - there.nearest_points[there_a]).norm(), 0, 1e-12);
    EXPECT_NEAR((here.nearest_points[0] - here.nearest_points[1]).norm(), here.min_distance, 1e-12);
    return here.min_distance;
  };
  const fcl::Boxd box(1, 1, 1);
  EXPECT_NEAR(above(*square, box, 0, 3.5), 3, 1e-12);    // right above
  EXPECT_NEAR(above(*square, box, 5.5, 3.5), 5, 1e-12);  // 4 aside, 3 above
  EXPECT_NEAR(above(prism, box, 6, 5.5), 5, 1e-12);      // 4.5 less the margin aside, 3 above
  EXPECT_NEAR(above(prism, box, 6, -4.5), 5, 1e-12);     // as much below
  EXPECT_NEAR(above(*square, fcl::Cylinderd(1, 2), 0, 4), 3, 1e-12);
  EXPECT_NEAR(above(*square, fcl::Sphered(1), 0, 4), 3, 1e-12);
  EXPECT_NEAR(above(*square, fcl::Halfspaced(0, 0, -1, 0), 0, 4), 4, 1e-12);
  EXPECT_NEAR(above(*square, fcl::Planed(0, 0, 1, 0), 0, -4), 4, 1e-12);
  EXPECT_NEAR(above(*square, *boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5}), 0, 3.5), 3, 1e-12);

  // Cells above and below, none between the polygon's heights: the prism around both is never farther than the nearer.
  const auto scattered = std::make_shared<octomap::OcTree>(0.5);
  for (const float z : {3.2f, -0.8f}) scattered->updateNode(octomap::point3d(0.2f, 0.2f, z), true);
  const fcl::OcTreed cells{std::shared_ptr<const octomap::OcTree>(scattered)};
  const auto either = distanceOf<double>(fcl::GST_LIBCCD, false, *square, fcl::Transform3d::Identity(), cells,
                                         fcl::Transform3d::Identity());
  EXPECT_GT(either.min_distance, 0);
  EXPECT_LE(either.min_distance, 0.5);

  // There is nothing to be near to: the distance stays FCL's largest number, and the points are no numbers.
  const auto free = std::make_shared<octomap::OcTree>(0.5);
  free->updateNode(octomap::point3d(0.2f, 0.2f, 0.2f), false);
  const fcl::OcTreed tree{std::shared_ptr<const octomap::OcTree>(free)};
  const auto none = distanceOf<double>(fcl::GST_LIBCCD, false, *square, fcl::Transform3d::Identity(), tree,
                                       fcl::Transform3d::Identity());
  EXPECT_EQ(none.min_distance, std::numeric_limits<double>::max());
  for (const Vec3& point : none.nearest_points) EXPECT_TRUE(point.array().isNaN().all());
}

TEST(MixedDistanceLaws, zeroIfAndOnlyIfTheyCollideAndSwapsWithTheArguments) {
  registerNarrowphase();
  Random random(63);
  int hits = 0, cases = 0;
  const auto geometries = knownGeometries<double>();
  for (int i = 0; i < scaledCount(2000); ++i) {
    const Known<double>& known = geometries[static_cast<std::size_t>(i) % geometries.size()];
    SCOPED_TRACE(known.name + " " + std::to_string(i));
    const Shape<double> polygon = shapeOf(randomPolygon(random, random.real(0.2, 2)));
    const auto anywhere = [&random](double reach) {
      const Vec3 axis(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
      const Vec3 at(random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach));
      return placed<double>(at, turned(random.real(0, 6), axis));
    };
    const fcl::Transform3d tf_polygon = anywhere(1.5), tf_other = anywhere(1.5);
    fcl::CollisionResultd collision;
    const bool hit = fcl::collide(polygon.get(), tf_polygon, known.geometry.get(), tf_other, fcl::CollisionRequestd(),
                                  collision) > 0;
    const auto result = distanceOf<double>(fcl::GST_LIBCCD, false, *polygon, tf_polygon, *known.geometry, tf_other);
    const auto swapped = distanceOf<double>(fcl::GST_INDEP, false, *known.geometry, tf_other, *polygon, tf_polygon);
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
TEST(MixedDistanceLaws, isFarAwayWhatItIsHere) {
  registerNarrowphase();
  Random random(75);
  const Vec3 far(std::ldexp(1, 33), -std::ldexp(3, 32), 0);
  const fcl::Boxd box(1, 2, 3);
  const auto bar = shapeOf<double>(tricover::Polygon({rectangle(-2, -0.5, 2, 0.5)}));
  const auto onGrid = [&] { return std::ldexp(random.integer(-(1 << 20), 1 << 20), -18); };
  int apart = 0;
  const int asked = scaledCount(200);
  for (int i = 0; i < asked; ++i) {
    const fcl::Matrix3<double> turn = turned(random.real(-3, 3), Vec3::UnitZ()),
                               turn_of_box = turned(random.real(-3, 3), Vec3(1, 2, 3));
    const Vec3 at(onGrid(), onGrid(), 0), at_of_box(onGrid(), onGrid(), 0);
    const auto here = distanceOf<double>(fcl::GST_LIBCCD, false, *bar, placed<double>(at, turn), box,
                                         placed<double>(at_of_box, turn_of_box));
    const auto there = distanceOf<double>(fcl::GST_LIBCCD, false, *bar, placed<double>(at + far, turn), box,
                                          placed<double>(at_of_box + far, turn_of_box));
    EXPECT_NEAR(there.min_distance, here.min_distance, 1e-13);
    apart += here.min_distance > 0;
  }
  EXPECT_GT(apart, asked / 2);
  EXPECT_LT(apart, asked);
}

/// A surface has no inside to be deep in: where it is met it is overlapped, if only touched.
TEST(MixedDistanceLaws, ofATouchedSurfaceIsThatOfAnOverlap) {
  registerNarrowphase();
  const auto square = shapeOf<double>(tricover::Polygon({rectangle(-1, -1, 1, 1)}));
  const auto mesh = boxMesh<fcl::OBBRSSd>({1, 1, 1});
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  const auto at = [&](double x) {
    return distanceOf<double>(fcl::GST_LIBCCD, false, *square, here, *mesh, shifted<double>(x, 0, 0)).min_distance;
  };
  EXPECT_EQ(at(1.5), -1);
  EXPECT_EQ(at(2), -1);
  EXPECT_NEAR(at(2 + 1e-6), 1e-6, 1e-13);
}

TEST(MixedDistanceLaws, contactUpToRoundingHasNearestPointsBelowAnyLimit) {
  registerNarrowphase();
  // A million from the polygon's origin, rounding counts a gap of 1e-9 as contact.
  const Shape<double> square = rectangular(0, -1, 1, 1);
  const fcl::Boxd box(2e6, 2, 2);
  const fcl::Transform3d pose = shifted<double>(1 + 1e6 + 1e-9, 0, 0);
  for (const bool box_first : {false, true}) {
    fcl::DistanceResultd result;
    result.min_distance = 1e-12;  // of another pair, nearer than the gap
    if (box_first) {
      fcl::distance<double>(&box, pose, square.get(), fcl::Transform3d::Identity(), fcl::DistanceRequestd(), result);
    } else {
      fcl::distance<double>(square.get(), fcl::Transform3d::Identity(), &box, pose, fcl::DistanceRequestd(), result);
    }
    EXPECT_EQ(result.min_distance, 0);
    for (const Vec3& point : result.nearest_points) {
      EXPECT_NEAR(point.x(), 1, 2e-9);
      EXPECT_LE(std::abs(point.y()), 1);
      EXPECT_EQ(point.z(), 0);
    }
  }
}

TEST(MixedDistanceLaws, depthOfWhatIsFarInside) {
  registerNarrowphase();
  // A square whose left side is 1.6 from the round outline's rightmost point, and farther from any other.
  const Shape<double> square = rectangular(0.4, -0.1, 0.6, 0.1);
  const fcl::Sphered sphere(2.5);  // a disc of 2 at this height
  const fcl::Cylinderd cylinder(2, 4);
  for (const double angle : {0.0, 0.3, 2.0}) {
    const fcl::Transform3d pose = placed<double>({0, 0, 0}, turned(angle, Vec3::UnitZ()));
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto in_sphere = distanceOf<double>(solver, true, *square, pose, sphere, shifted<double>(0, 0, 1.5));
      const auto in_cylinder = distanceOf<double>(solver, true, *square, pose, cylinder, shifted<double>(0, 0, 1.5));
      EXPECT_NEAR(in_sphere.min_distance, -1.6, 1e-5);
      EXPECT_NEAR(in_cylinder.min_distance, -1.6, 1e-5);
    }
  }
}

TEST(MixedDistanceLaws, signedWhereFclWouldAbortThrows) {
  registerNarrowphase();
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  fcl::Boxd box(2, 2, 2);
  const Geometry<double> mesh = boxMesh<fcl::OBBRSSd>({0.5, 0.5, 0.5});
  box.cost_density = mesh->cost_density = 0.5;  // uncertain: collide has no contact for them
  EXPECT_LT(distanceOf<double>(fcl::GST_LIBCCD, true, *tip<double>(), here, box, here).min_distance, 0);
  EXPECT_THROW(distanceOf<double>(fcl::GST_INDEP, true, *tip<double>(), here, box, here), std::logic_error);
  EXPECT_THROW(distanceOf<double>(fcl::GST_INDEP, true, *tip<double>(), here, *mesh, here), std::logic_error);
  EXPECT_THROW(distanceOf<double>(fcl::GST_LIBCCD, true, *mesh, here, *tip<double>(), here), std::logic_error);
  EXPECT_EQ(distanceOf<double>(fcl::GST_INDEP, false, *tip<double>(), here, box, here).min_distance, -1);
}

TEST(MixedDistanceLaws, planesParallelToThePolygonAreLeftAlongTheirNormal) {
  registerNarrowphase();
  const fcl::Halfspaced below(0, 0, 1, 0);
  for (const fcl::GJKSolverType solver : kSolvers) {
    const auto result = distanceOf<double>(solver, true, *tip<double>(), shifted<double>(0, 0, -0.25), below,
                                           fcl::Transform3d::Identity());
    EXPECT_NEAR(result.min_distance, -0.25, 1e-12);
    const auto touch =
        distanceOf<double>(solver, true, *tip<double>(), shifted<double>(0, 0, 0), below, fcl::Transform3d::Identity());
    EXPECT_EQ(touch.min_distance, 0);
  }
}

}  // namespace
}  // namespace tricover_fcl::test
