// SPDX-License-Identifier: BSD-3-Clause
// A polygon against every geometry of FCL's own: rows are geometries (mixed_scene.cpp), each test is a query of all of
// them. A body meets a polygon in the polygon's plane, and is as far from it as it is there.
#include <fcl/math/motion/spline_motion.h>

#include <cmath>
#include <type_traits>

#include "mixed_scene.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

template <typename S>
class Mixed : public ::testing::Test {
 protected:
  static constexpr bool kIsFloat = std::is_same_v<S, float>;
  /// How near the answers are asked for: below, the poses' own rounding decides.
  static constexpr double kStep = kIsFloat ? 1e-5 : 1e-8, kError = kIsFloat ? 2e-6 : 1e-8;
};

using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Mixed, Scalars);

TYPED_TEST(Mixed, collide) {
  using S = TypeParam;
  Random random(61);
  const Shape<S> large = rectangular<S>(-50, -50, 50, 50);
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    const auto meets = [&](double beside) {
      return meet(tip<S>(), shifted<S>(known.right + beside, 0, 0), known.geometry, known.pose);
    };
    EXPECT_FALSE(meets(1));
    for (const double step : {1e-3, this->kStep}) {
      EXPECT_FALSE(meets(step)) << step;
      EXPECT_TRUE(meets(-step)) << step;
    }

    // The same anywhere in space. A float pose lifts what grazes the plane off it.
    const Vec3 at = anyPoint(random, 9);
    const Transform moved = placed(at, turned(random.real(0, 6), at));
    for (const double side : {-1, 1}) {
      if (known.grazing && this->kIsFloat) continue;
      const auto rounded = [&](const Transform& local) {
        return fcl::Transform3<S>((moved * local).matrix().cast<S>());
      };
      const Transform pose(known.pose.matrix().template cast<double>());
      const fcl::Transform3<S> beside = rounded(shifted(known.right + side * 20 * this->kStep, 0, 0));
      EXPECT_EQ(meet(tip<S>(), beside, known.geometry, rounded(pose)), side < 0);
    }

    if (isEndless(*known.geometry)) continue;
    for (const double z : {0.0, 60.0, -60.0})
      EXPECT_EQ(meet(large, shifted<S>(0, 0, z), known.geometry, known.pose), z == 0);
  }
}

TYPED_TEST(Mixed, distance) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    for (const double gap : {2.0, 1e-3}) {
      const fcl::Transform3<S> pose = shifted<S>(known.right + gap, 0, 0);
      for (const fcl::GJKSolverType solver : kSolvers) {
        for (const auto& result : {distanceOf(solver, false, tip<S>(), pose, known.geometry, known.pose),
                                   distanceOf(solver, true, known.geometry, known.pose, tip<S>(), pose)}) {
          EXPECT_NEAR(result.min_distance, gap, this->kError);
          const int polygon = result.o1 == known.geometry.get() ? 1 : 0;
          const auto error = [&](int which, double x) {
            return (result.nearest_points[which].template cast<double>() - Vec3(x, 0, 0)).norm();
          };
          EXPECT_LT(error(polygon, known.right + gap), 10 * this->kError);
          // Where a round outline is flat, 1e-9 of distance is 1e-4 of place.
          EXPECT_LT(error(1 - polygon, known.right), 1e-3);
        }
      }
    }
  }
}

TYPED_TEST(Mixed, distanceOfAnOverlapIsMinusOneOrTheDepth) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    // Near a tip or an edge-on face the way out is a shorter one.
    if (known.name.find("tip") != std::string::npos || known.name.find("convex") != std::string::npos) continue;
    const double depth = 1e-3;
    const fcl::Transform3<S> pose = shifted<S>(known.right - depth, 0, 0);
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto ask = [&](bool is_signed, bool swapped) {
        return swapped ? distanceOf(solver, is_signed, known.geometry, known.pose, tip<S>(), pose)
                       : distanceOf(solver, is_signed, tip<S>(), pose, known.geometry, known.pose);
      };
      const auto meeting = ask(false, false);
      EXPECT_LT((meeting.nearest_points[0] - meeting.nearest_points[1]).norm(), 5e-6);
      for (const bool swapped : {false, true}) {
        EXPECT_EQ(ask(false, swapped).min_distance, S(-1));
        EXPECT_NEAR(ask(true, swapped).min_distance, -depth, 5e-6);
      }
    }
  }
}

/// Above or below the polygon's heights it is that of two prisms, and never uninitialised.
TYPED_TEST(Mixed, distanceBesideTheHeightsIsThatOfPrisms) {
  using S = TypeParam;
  for (const Known<S>& known : knownGeometries<S>()) {
    SCOPED_TRACE(known.name);
    if (isEndless(*known.geometry)) continue;
    const fcl::Transform3<S> pose = shifted<S>(70, 0, 60);
    const auto result = distanceOf(fcl::GST_LIBCCD, false, tip<S>(), pose, known.geometry, known.pose);
    const auto swapped = distanceOf(fcl::GST_INDEP, true, known.geometry, known.pose, tip<S>(), pose);
    EXPECT_LT(result.min_distance, S(100));
    EXPECT_GT(result.min_distance, S(1));
    EXPECT_EQ(result.min_distance, swapped.min_distance);
    const auto between = (result.nearest_points[0] - result.nearest_points[1]).template cast<double>();
    EXPECT_NEAR(between.norm(), static_cast<double>(result.min_distance), 20 * this->kError);
    EXPECT_FALSE(collides(tip<S>(), pose, known.geometry, known.pose));
  }
}

constexpr double kEarliest = 3e-6;

void expectOnTime(double found, double truth, double early = kEarliest) {
  EXPECT_LE(found, truth + 1e-12);
  EXPECT_GE(found, truth - early);
}

TEST(MixedMotions, aTipMeetsEveryGeometryOnTime) {
  Random random(64);
  for (const Known<double>& known : knownGeometries<double>()) {
    SCOPED_TRACE(known.name);
    const Vec3 at = anyPoint(random, 3);
    const Transform moved = known.grazing ? shifted(1, 2, 3) : placed(at, turned(2, at));
    const Transform still = moved * known.pose, away = moved * shifted(6, 0, 0) * known.pose;
    const auto place = [&](double gap) { return Transform(moved * shifted(known.right + gap, 0, 0)); };
    for (const fcl::CCDMotionType type : {fcl::CCDM_TRANS, fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
      SCOPED_TRACE(type);
      expectOnTime(timeOf(tip(), place(5), place(-1), known.geometry, still, still, type), 5.0 / 6);
      expectOnTime(timeOf(known.geometry, still, still, tip(), place(5), place(-1), type), 5.0 / 6);
      EXPECT_EQ(timeOf(tip(), place(5), place(1e-3), known.geometry, still, still, type), 2);
      // The other one moves.
      EXPECT_NEAR(timeOf(tip(), place(5), place(5), known.geometry, still, away, type), 5.0 / 6, kEarliest);
    }
    EXPECT_EQ(timeOf(tip(), place(-0.001), place(5), known.geometry, still, still), 0);
  }
}

TEST(MixedMotions, aMarginMeetsEveryGeometryBeforeTheTipDoes) {
  const Shape<double> wide = tip({0.5, 0, 0});
  for (const Known<double>& known : knownGeometries<double>()) {
    SCOPED_TRACE(known.name);
    const auto place = [&](double gap) { return shifted(known.right + gap, 0, 0); };
    const double found = timeOf(wide, place(5), place(-1), known.geometry, known.pose, known.pose, fcl::CCDM_TRANS);
    EXPECT_LE(found, 4.5 / 6 + 1e-12);
    const auto collidesAt = [&](double at) { return meet(wide, place(5 - 6 * at), known.geometry, known.pose); };
    EXPECT_FALSE(found > 0 && collidesAt(found - kEarliest));
    EXPECT_TRUE(collidesAt(found + kEarliest));
  }
}

/// What no row of the table is: `a` goes from a pose to another one, and so may `b`.
struct Passing {
  const char* what;
  Geometry<double> a;
  Transform a0, a1;
  Geometry<double> b;
  Transform b0, b1;
  fcl::CCDMotionType type;
  double truth;  ///< the time of contact, or 2
  double early = kEarliest, error = 1e-6;
};

TEST(MixedMotions, meetOnTime) {
  const Shape<double> square = rectangular(-1, -1, 1, 1), rod = rectangular(0, -0.1, 3, 0);
  const auto at = [](double x, double y) { return shifted(x, y, 0); };
  const double end = 3 * M_PI / 4;
  const Transform far = at(5000, 0), turned_rod = placed({0, 0, 0}, turned(end, Vec3::UnitZ()));
  const auto sphere = [](double radius) { return std::make_shared<fcl::Sphered>(radius); };
  const auto box = [](double x, double y) { return std::make_shared<fcl::Boxd>(x, y, y); };
  const auto plane = std::make_shared<fcl::Planed>(0, 1, 0, 2);
  std::vector<Passing> rows = {
      {"nothing tunnels", rectangular(0, 0, 1e-3, 1e-3), at(-500, 0), at(500, 0), box(1e-3, 10), at(1, 0), at(1, 0),
       fcl::CCDM_TRANS, (501 - 1.5e-3) / 1000},
      {"contact at the end", tip(), at(3, 0), at(1, 0), box(2, 2), kHere, kHere, fcl::CCDM_LINEAR, 1}};
  for (const fcl::CCDMotionType type : {fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
    rows.push_back({"a rod turns into a sphere", rod, kHere, turned_rod, sphere(0.5), at(0, 2), at(0, 2), type,
                    (M_PI / 2 - std::asin(0.25)) / end});
    rows.push_back({"and away from one", rod, kHere, turned_rod, sphere(0.5), at(0, -2), at(0, -2), type, 2});
    rows.push_back({"into a plane", rod, kHere, turned_rod, plane, kHere, kHere, type, std::asin(2.0 / 3) / end});
  }
  for (int i = 0; i < 12; ++i) {  // a round outline stands at most 1e-4 of its size off
    rows.push_back({"a spheroid is round", shapeOf(tricover::Polygon::point({0, 0})),
                    at(5 * std::cos(0.37 * i), 5 * std::sin(0.37 * i)), kHere,
                    std::make_shared<fcl::Ellipsoidd>(1, 1, 2), kHere, kHere, fcl::CCDM_TRANS, 0.8,
                    1e-4 * 2 / 5 + kEarliest});
  }
  for (const double side : {-1.0, 1.0}) {  // what has no end is there wherever a polygon comes
    const auto ground = std::make_shared<fcl::Halfspaced>(0, -side, 0, -50);  // beyond y = 50 side
    rows.push_back({"a long way", square, kHere, at(1000, 100 * side), ground, kHere, kHere, fcl::CCDM_TRANS, 0.49});
    rows.push_back({"it comes", square, kHere, kHere, ground, kHere, at(0, -100 * side), fcl::CCDM_TRANS, 0.49});
    rows.push_back({"a short way", square, kHere, at(0, 0.5 * side), ground, kHere, kHere, fcl::CCDM_TRANS, 2});
  }
  // A corner goes straight to a stadium's end, and past it by less than its radius. A grazing root of 1e-12 is 1e-6.
  const auto capsule = std::make_shared<fcl::Capsuled>(0.5, 2);
  const Transform level = lying({1, 0}, {0, 0, 0.3});
  for (const double aside : {0.0, 0.3999, 0.4, 0.4001}) {
    const double truth = aside <= 0.4 ? (10 - 1 - std::sqrt(0.4 * 0.4 - aside * aside)) / 10 : 2;
    rows.push_back({"a stadium's end", rectangular(0, 0, 1, 1), at(10, aside), at(0, aside), capsule, level, level,
                    fcl::CCDM_TRANS, truth, 1e-6, 1e-9});
  }
  // It turns by a quarter about its middle, far from every origin, until its tip meets a wall.
  const Vec3 middle(5, 7, 0);
  const Transform of_wall = at(middle.x() + 1.3, middle.y());
  rows.push_back({"a stadium turns about its own pivot", rectangular(0, -3, 1, 3), of_wall, of_wall, capsule,
                  lying({0, 1}, middle), lying({1, 0}, middle), fcl::CCDM_SCREW, std::asin(1.3 - 0.5) / (M_PI / 2),
                  1e-8, 1e-9});
  for (const Passing& row : rows) {
    SCOPED_TRACE(row.what);
    const auto solver = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    const double found = timeOf(row.a, row.a0, row.a1, row.b, row.b0, row.b1, row.type, solver, row.error);
    expectOnTime(found, row.truth, row.early);
    EXPECT_EQ(timeOf(row.b, row.b0, row.b1, row.a, row.a0, row.a1, row.type, solver, row.error), found);
  }
  for (const fcl::CCDSolverType solver : {fcl::CCDC_NAIVE, fcl::CCDC_RAY_SHOOTING, fcl::CCDC_POLYNOMIAL_SOLVER}) {
    expectOnTime(timeOf(tip(), far, at(-5000, 0), sphere(1), kHere, kHere, fcl::CCDM_TRANS, solver), 0.4999);
    // Poses alone would not tell what a pair that tilts meets.
    const Transform tilts = placed({0, 0, 0}, turned(1, Vec3::UnitX()));
    expectRefused({"leaves the polygon's plane"},
                  [&] { timeOf(tip(), at(5, 0), tilts, sphere(1), kHere, kHere, fcl::CCDM_SCREW, solver); });
  }
}

TEST(MixedMotions, aSplineCarriesATipToABox) {
  // From x = 5 by a cubic: the control points are evenly spaced, so the way is straight and even.
  const Vec3 none = Vec3::Zero();
  const auto straight = [&](double from, double step) {
    return fcl::SplineMotion<double>({from - step, 0, 0}, {from, 0, 0}, {from + step, 0, 0}, {from + 2 * step, 0, 0},
                                     none, none, none, none);
  };
  const fcl::Boxd box(2, 2, 2);
  const fcl::SplineMotion<double> comes = straight(5, -8), rests = straight(0, 0);
  const auto request = advancing(1e-6, fcl::CCDM_SPLINE);
  for (const Impact& result :
       {impactOf(tip(), comes, box, rests, request), impactOf(box, rests, tip(), comes, request)}) {
    EXPECT_TRUE(result.is_collide);
    expectOnTime(result.time_of_contact, 0.5);
  }
}

TEST(MixedMotions, thatLeaveThePlaneThrow) {
  const fcl::Sphered sphere(1);
  for (const Transform& bad : {shifted(0, 0, 1), placed({0, 0, 0}, turned(0.1, Vec3::UnitX()))}) {
    expectRefused({"motion_a"}, [&] { timeOf(tip(), kHere, bad, sphere, kHere, kHere); });
    expectRefused({"motion_b"}, [&] { timeOf(tip(), kHere, kHere, sphere, kHere, bad); });
  }
}

}  // namespace
}  // namespace tricover_fcl::test
