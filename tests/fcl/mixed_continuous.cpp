// SPDX-License-Identifier: BSD-3-Clause
// Conservative advancement of a polygon and FCL's own geometries that move within the polygon's plane.
#include <fcl/math/motion/spline_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <cmath>
#include <stdexcept>

#include "mixed_scene.h"
#include "tricover/segment.h"

namespace tricover_fcl::test {
namespace {

using Vec3 = fcl::Vector3<double>;

class MixedContinuous : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { registerNarrowphase(); }

  /// The time of contact, or 2 if there is none.
  static double time(const fcl::CollisionGeometryd& a, const fcl::Transform3d& a0, const fcl::Transform3d& a1,
                     const fcl::CollisionGeometryd& b, const fcl::Transform3d& b0, const fcl::Transform3d& b1,
                     fcl::CCDMotionType type = fcl::CCDM_LINEAR,
                     fcl::CCDSolverType solver = fcl::CCDC_CONSERVATIVE_ADVANCEMENT) {
    double times[2];
    for (const fcl::GJKSolverType gjk : kSolvers) {
      fcl::ContinuousCollisionRequestd request(1000, 1e-6, type, gjk, solver);
      fcl::ContinuousCollisionResultd result;
      // FCL's own function leaves the point of linear motions that goes straight uninitialised.
      if (type == fcl::CCDM_LINEAR)
        tricover_fcl::continuousCollide(&a, a0, a1, &b, b0, b1, request, result);
      else
        fcl::continuousCollide(&a, a0, a1, &b, b0, b1, request, result);
      times[gjk] = result.is_collide ? result.time_of_contact : 2;
    }
    EXPECT_EQ(times[0], times[1]);
    return times[0];
  }

  static constexpr double kEarliest = 3e-6;
};

TEST_F(MixedContinuous, aTipMeetsEveryGeometryOnTime) {
  Random random(64);
  for (const Known<double>& known : knownGeometries<double>()) {
    SCOPED_TRACE(known.name);
    const Vec3 at(random.real(-3, 3), random.real(-3, 3), random.real(-3, 3));
    const fcl::Transform3d moved = known.grazing ? shifted<double>(1, 2, 3) : placed<double>(at, turned(2, at));
    const fcl::Transform3d still = moved * known.pose;
    const auto place = [&](double gap) { return fcl::Transform3d(moved * shifted<double>(known.right + gap, 0, 0)); };
    for (const fcl::CCDMotionType type : {fcl::CCDM_TRANS, fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
      const double truth = 5.0 / 6;
      for (const double found : {time(*tip<double>(), place(5), place(-1), *known.geometry, still, still, type),
                                 time(*known.geometry, still, still, *tip<double>(), place(5), place(-1), type)}) {
        EXPECT_LE(found, truth + 1e-12) << type;
        EXPECT_GE(found, truth - kEarliest) << type;
      }
      EXPECT_EQ(time(*tip<double>(), place(5), place(1e-3), *known.geometry, still, still, type), 2) << type;
      // The other one moves.
      const fcl::Transform3d away = moved * shifted<double>(6, 0, 0) * known.pose;
      const double found = time(*tip<double>(), place(5), place(5), *known.geometry, still, away, type);
      EXPECT_NEAR(found, truth, kEarliest) << type;
    }
    EXPECT_EQ(time(*tip<double>(), place(-0.001), place(5), *known.geometry, still, still), 0);
  }
}

TEST_F(MixedContinuous, aMarginMeetsEveryGeometryBeforeTheTipDoes) {
  PolygonOptions options = tip<double>()->options();
  options.margin = 0.5;
  const PolygonShaped wide(tip<double>()->polygon(), options);
  for (const Known<double>& known : knownGeometries<double>()) {
    SCOPED_TRACE(known.name);
    const auto place = [&](double gap) { return shifted<double>(known.right + gap, 0, 0); };
    const double found = time(wide, place(5), place(-1), *known.geometry, known.pose, known.pose, fcl::CCDM_TRANS);
    EXPECT_LE(found, 4.5 / 6 + 1e-12);
    const auto collidesAt = [&](double at) {
      return meet<double>(wide, place(5 - 6 * at), *known.geometry, known.pose);
    };
    EXPECT_FALSE(found > 0 && collidesAt(found - kEarliest));
    EXPECT_TRUE(collidesAt(found + kEarliest));
  }
}

TEST_F(MixedContinuous, aSplineCarriesATipToABox) {
  const fcl::Boxd box(2, 2, 2);
  const Shape<double> shape = tip<double>();
  const Vec3 none = Vec3::Zero();
  // From x = 5 by a cubic: the control points are evenly spaced, so the way is straight and even.
  const auto straight = [&](double from, double step) {
    return fcl::SplineMotion<double>({from - step, 0, 0}, {from, 0, 0}, {from + step, 0, 0}, {from + 2 * step, 0, 0},
                                     none, none, none, none);
  };
  const fcl::SplineMotion<double> comes = straight(5, -8), rests = straight(0, 0);
  fcl::ContinuousCollisionRequestd request(1000, 1e-6, fcl::CCDM_SPLINE, fcl::GST_LIBCCD,
                                           fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
  for (const bool polygon_first : {true, false}) {
    fcl::ContinuousCollisionResultd result;
    const fcl::CollisionGeometryd *tip_geometry = shape.get(), *box_geometry = &box;
    if (polygon_first)
      fcl::continuousCollide<double>(tip_geometry, &comes, box_geometry, &rests, request, result);
    else
      fcl::continuousCollide<double>(box_geometry, &rests, tip_geometry, &comes, request, result);
    EXPECT_TRUE(result.is_collide);
    EXPECT_LE(result.time_of_contact, 0.5 + 1e-12);
    EXPECT_GE(result.time_of_contact, 0.5 - kEarliest);
  }
}

TEST_F(MixedContinuous, aRodTurnsIntoASphere) {
  const PolygonShaped rod(tricover::Polygon({rectangle(0, -0.1, 3, 0)}));
  const fcl::Sphered sphere(0.5);
  const double end = 3 * M_PI / 4, truth = (M_PI / 2 - std::asin(0.25)) / end;
  const fcl::Transform3d start = fcl::Transform3d::Identity(),
                         finish = placed<double>({0, 0, 0}, turned(end, Vec3::UnitZ()));
  for (const fcl::CCDMotionType type : {fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
    const fcl::Transform3d there = shifted<double>(0, 2, 0.0);
    EXPECT_NEAR(time(rod, start, finish, sphere, there, there, type), truth, kEarliest);
    EXPECT_EQ(time(rod, start, finish, sphere, shifted<double>(0, -2, 0), shifted<double>(0, -2, 0), type), 2);
    EXPECT_NEAR(time(rod, start, finish, fcl::Planed(0, 1, 0, 2), start, start, type), std::asin(2.0 / 3) / end,
                kEarliest);
  }
}

/// A round outline stands at most 1e-4 of its size off.
TEST_F(MixedContinuous, aSpheroidIsRoundAllAround) {
  const PolygonShaped dot(tricover::point({0, 0}));
  const fcl::Ellipsoidd spheroid(1, 1, 2);
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.37 * i;
    const double found = time(dot, shifted<double>(5 * std::cos(angle), 5 * std::sin(angle), 0), here, spheroid, here,
                              here, fcl::CCDM_TRANS);
    EXPECT_NEAR(found, 0.8, 1e-4 * 2 / 5 + kEarliest) << i;
    EXPECT_LE(found, 0.8 + 1e-12) << i;
  }
}

TEST_F(MixedContinuous, nothingTunnels) {
  const PolygonShaped bullet(tricover::Polygon({rectangle(0, 0, 1e-3, 1e-3)}));
  const fcl::Boxd wall(1e-3, 10, 10);
  const double found = time(bullet, shifted<double>(-500, 0, 0), shifted<double>(500, 0, 0), wall,
                            shifted<double>(1, 0, 0), shifted<double>(1, 0, 0), fcl::CCDM_TRANS);
  const double truth = (501 - 1.5e-3) / 1000;
  EXPECT_LE(found, truth + 1e-12);
  EXPECT_GE(found, truth - kEarliest);
}

/// What has no end is there wherever a polygon comes, however far along it.
TEST_F(MixedContinuous, aLongWayToAHalfspaceEndsThere) {
  const PolygonShaped square(tricover::Polygon({rectangle(-1, -1, 1, 1)}));
  const fcl::Transform3d start = fcl::Transform3d::Identity(), up = shifted<double>(0, 0.5, 0);
  for (const double side : {-1.0, 1.0}) {
    const fcl::Halfspaced ground(0, -side, 0, -50);  // beyond y = 50 side
    const double found =
        time(square, start, shifted<double>(1000, 100 * side, 0), ground, start, start, fcl::CCDM_TRANS);
    EXPECT_NEAR(found, 0.49, kEarliest);
    EXPECT_LE(found, 0.49 + 1e-12);
    const double comes = time(square, start, start, ground, start, shifted<double>(0, -100 * side, 0), fcl::CCDM_TRANS);
    EXPECT_NEAR(comes, 0.49, kEarliest);
  }
  EXPECT_EQ(time(square, start, up, fcl::Halfspaced(0, -1, 0, -50), start, start, fcl::CCDM_TRANS), 2);
}

TEST_F(MixedContinuous, contactAtTheEndCounts) {
  const fcl::Boxd box(2, 2, 2);
  EXPECT_NEAR(time(*tip<double>(), shifted<double>(3, 0, 0), shifted<double>(1, 0, 0), box, shifted<double>(0, 0, 0),
                   shifted<double>(0, 0, 0)),
              1, kEarliest);
}

TEST_F(MixedContinuous, everySolverIsExact) {
  const fcl::Sphered sphere(1);
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  for (const fcl::CCDSolverType solver : {fcl::CCDC_NAIVE, fcl::CCDC_RAY_SHOOTING, fcl::CCDC_POLYNOMIAL_SOLVER}) {
    const double found = time(*tip<double>(), shifted<double>(5000, 0, 0), shifted<double>(-5000, 0, 0), sphere, here,
                              here, fcl::CCDM_TRANS, solver);
    EXPECT_LE(found, 0.4999 + 1e-12);
    EXPECT_GE(found, 0.4999 - kEarliest);
    // Poses alone would not tell what a pair that tilts meets.
    EXPECT_NE(thrownBy<std::invalid_argument>([&] {
                time(*tip<double>(), shifted<double>(5, 0, 0), placed<double>({0, 0, 0}, turned(1, Vec3::UnitX())),
                     sphere, here, here, fcl::CCDM_SCREW, solver);
              }).find("leaves the polygon's plane"),
              std::string::npos);
  }
}

TEST_F(MixedContinuous, motionsThatLeaveThePlaneThrow) {
  const fcl::Sphered sphere(1);
  const fcl::Transform3d here = fcl::Transform3d::Identity();
  const auto text = [&](const fcl::Transform3d& polygon, const fcl::Transform3d& other) {
    return thrownBy<std::invalid_argument>(
        [&] { time(*tip<double>(), here, polygon, sphere, here, other, fcl::CCDM_LINEAR); });
  };
  const fcl::Transform3d lifted_up = shifted<double>(0, 0, 1),
                         tilted = placed<double>({0, 0, 0}, turned(0.1, Vec3::UnitX()));
  for (const fcl::Transform3d& bad : {lifted_up, tilted}) {
    EXPECT_NE(text(bad, here).find("motion_a"), std::string::npos);
    EXPECT_NE(text(here, bad).find("motion_b"), std::string::npos);
  }
}

}  // namespace
}  // namespace tricover_fcl::test
