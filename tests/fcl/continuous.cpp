// SPDX-License-Identifier: BSD-3-Clause
// Continuous collision through FCL: its motions, its solvers, and tricover_fcl::continuousCollide.
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <cmath>
#include <limits>
#include <vector>

#include "ask.h"
#include "tricover/distance.h"

namespace tricover_fcl::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

fcl::Transform3d placed(double angle, double x, double y, double z = 0) { return lifted(angle, x, y, z); }

using Motion = fcl::MotionBase<double>;

fcl::ContinuousCollisionResultd along(const Shape<double>& a, const Motion& motion_a, const Shape<double>& b,
                                      const Motion& motion_b, double error = 1e-9,
                                      fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  fcl::ContinuousCollisionResultd result;
  const double time =
      fcl::continuousCollide(a.get(), &motion_a, b.get(), &motion_b, advancing(error, fcl::CCDM_TRANS, solver), result);
  EXPECT_EQ(time, result.time_of_contact);
  EXPECT_TRUE(result.is_collide || time == 1);
  return result;
}

const Shape<double> kSquare = rectangular(-0.5, -0.5, 0.5, 0.5);

TEST(Continuous, bulletsDoNotTunnel) {
  const Shape<double> bullet = rectangular(-5e-4, -5e-4, 5e-4, 5e-4);
  const Shape<double> wall = rectangular(0, -1, 1e-3, 1);
  const fcl::Transform3d begin = placed(0, -500, 0), end = placed(0, 500, 0), here = placed(0, 0, 0);
  const double truth = (500 - 5e-4) / 1000;
  for (const fcl::CCDMotionType type : {fcl::CCDM_TRANS, fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
    for (const fcl::GJKSolverType solver : kSolvers) {
      for (const double error : {1e-4, 1e-9}) {
        fcl::ContinuousCollisionResultd fcls, swapped, objects, ours;
        const fcl::ContinuousCollisionRequestd request = advancing(error, type, solver);
        fcl::continuousCollide(bullet.get(), begin, end, wall.get(), here, here, request, fcls);
        fcl::continuousCollide(wall.get(), here, here, bullet.get(), begin, end, request, swapped);
        const fcl::CollisionObjectd object_a(bullet, begin), object_b(wall, here);
        fcl::continuousCollide(&object_a, end, &object_b, here, request, objects);
        tricover_fcl::continuousCollide(&object_a, end, &object_b, here, request, ours);
        for (const auto* result : {&fcls, &swapped, &objects, &ours}) {
          EXPECT_TRUE(result->is_collide);
          EXPECT_LE(result->time_of_contact, truth);
          EXPECT_GE(result->time_of_contact, truth - error);
        }
        EXPECT_NEAR(ours.contact_tf1.translation().x(), -5e-4, 1000 * error + 1e-9);
        EXPECT_TRUE(ours.contact_tf2.isApprox(here));
        EXPECT_NEAR(fcls.contact_tf1.translation().x(), -5e-4, 1000 * error + 1e-9);
      }
    }
  }
}

TEST(Continuous, contactAtTheEndsCounts) {
  for (const fcl::CCDMotionType type : {fcl::CCDM_TRANS, fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
    for (const fcl::CCDSolverType solver : {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT}) {
      fcl::ContinuousCollisionRequestd request = advancing(1e-9, type);
      request.ccd_solver_type = solver;
      const auto ask = [&](double from, double to) {
        fcl::ContinuousCollisionResultd result;
        fcl::continuousCollide(kSquare.get(), placed(0, from, 0), placed(0, to, 0), kSquare.get(), placed(0, 1, 0),
                               placed(0, 1, 0), request, result);
        return result;
      };
      // FCL's CCDM_LINEAR rounds, so it can't be made to touch exactly.
      const double touch = type == fcl::CCDM_LINEAR ? 1e-10 : 0;
      EXPECT_TRUE(ask(touch - 1, touch).is_collide);
      EXPECT_NEAR(ask(touch - 1, touch).time_of_contact, 1, 1e-9);
      EXPECT_FALSE(ask(-1, -1e-9).is_collide);
      EXPECT_TRUE(ask(touch, touch - 1).is_collide);
      EXPECT_EQ(ask(touch, touch - 1).time_of_contact, 0);
      EXPECT_EQ(ask(0.5, 1.5).time_of_contact, 0);
      EXPECT_FALSE(ask(-1e-9, -1).is_collide);
    }
    fcl::ContinuousCollisionResultd ours;
    EXPECT_NEAR(tricover_fcl::continuousCollide(kSquare.get(), placed(0, -3, 0), placed(0, 0, 0), kSquare.get(),
                                                placed(0, 1, 0), placed(0, 1, 0), advancing(1e-9, type), ours),
                1, 1e-9);
    EXPECT_TRUE(ours.is_collide);
  }
}

TEST(Continuous, turnsCount) {
  // A rod that sweeps past a post, about its own end; the poses at both ends are free.
  const Shape<double> rod = rectangular(0, -0.01, 10, 0.01);
  const Shape<double> post = rectangular(-0.01, -0.01, 0.01, 0.01);
  const fcl::TranslationMotiond still(placed(0, 0, 8), placed(0, 0, 8));
  const double truth = (kPi / 2 - std::atan2(0.01, 7.99) - std::asin(0.01 / std::hypot(7.99, 0.01))) / (0.9 * kPi);
  const fcl::InterpMotion<double> linear(placed(0, 0, 0).linear(), fcl::Vector3d::Zero(),
                                         placed(0.9 * kPi, 0, 0).linear(), fcl::Vector3d::Zero(),
                                         fcl::Vector3d::Zero());
  const fcl::ScrewMotion<double> screw(placed(0, 0, 0), placed(0.9 * kPi, 0, 0));
  for (const Motion* motion : {static_cast<const Motion*>(&linear), static_cast<const Motion*>(&screw)}) {
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto result = along(rod, *motion, post, still, 1e-9, solver);
      EXPECT_TRUE(result.is_collide);
      EXPECT_LE(result.time_of_contact, truth + 1e-12);
      EXPECT_GE(result.time_of_contact, truth - 1e-9 - 1e-12);
    }
  }
  for (const fcl::CCDMotionType type : {fcl::CCDM_LINEAR, fcl::CCDM_SCREW, fcl::CCDM_TRANS}) {
    fcl::ContinuousCollisionResultd ours;
    tricover_fcl::continuousCollide(rod.get(), placed(0, 0, 0), placed(0.9 * kPi, 0, 0), post.get(), placed(0, 0, 8),
                                    placed(0, 0, 8), advancing(1e-9, type), ours);
    EXPECT_EQ(ours.is_collide, type != fcl::CCDM_TRANS);  // which drops the turn, as FCL's does
    EXPECT_NEAR(ours.time_of_contact, type != fcl::CCDM_TRANS ? truth : 1, 2e-9);
  }
}

/// Leaves memory behind, of the size of FCL's motions, that is full of this number.
void leaveBehind(double rest) {
  std::vector<std::vector<double>> blocks;
  for (std::size_t more = 0; more < 16; ++more)
    for (int i = 0; i < 8; ++i) blocks.emplace_back(sizeof(fcl::InterpMotion<double>) / sizeof rest + more, rest);
}

TEST(Continuous, fclsTurnsBetweenTwoPosesAreAboutTheOrigin) {
  const Shape<double> rod = rectangular(0, -0.1, 10, 0.1);
  const fcl::Transform3d begin = placed(0, 0, 0), end = placed(2, 1, 0), there = placed(0, 0, 8);
  const fcl::CollisionObjectd object(rod, begin), post(kSquare, there);
  const fcl::ContinuousCollisionRequestd request = advancing(1e-9, fcl::CCDM_LINEAR);
  fcl::ContinuousCollisionResultd expected;
  tricover_fcl::continuousCollide(rod.get(), begin, end, kSquare.get(), there, there, request, expected);
  ASSERT_TRUE(expected.is_collide);
  for (const double rest : {7.5, 1e20, std::numeric_limits<double>::quiet_NaN()}) {
    fcl::ContinuousCollisionResultd geometries, objects;
    leaveBehind(rest);
    fcl::continuousCollide(rod.get(), begin, end, kSquare.get(), there, there, request, geometries);
    leaveBehind(rest);
    fcl::continuousCollide(&object, end, &post, there, request, objects);
    for (const auto* result : {&geometries, &objects}) {
      EXPECT_EQ(result->time_of_contact, expected.time_of_contact) << rest;
      EXPECT_TRUE(result->contact_tf1.isApprox(expected.contact_tf1)) << rest;
    }
  }
}

/// A random motion that keeps the plane, of each type, some upside down.
std::shared_ptr<Motion> randomMotion(Random& random, double reach, double z) {
  fcl::Transform3d begin = lifted(randomPose(random, reach), z);
  fcl::Transform3d end = lifted(randomPose(random, reach), z);
  if (random.oneIn(4)) {
    const fcl::AngleAxis<double> half_turn(kPi, fcl::Vector3d::UnitX());
    begin.linear() = begin.linear() * half_turn;
    end.linear() = end.linear() * half_turn;
  }
  switch (random.integer(0, 2)) {
    case 0:
      return std::make_shared<fcl::TranslationMotiond>(begin, end);
    case 1:
      return std::make_shared<fcl::InterpMotion<double>>(begin.linear(), begin.translation(), end.linear(),
                                                         end.translation(),
                                                         fcl::Vector3d(random.real(-1, 1), random.real(-1, 1), 0));
    default:
      return std::make_shared<fcl::ScrewMotion<double>>(begin, end);
  }
}

TEST(Continuous, noSampleOfFclsOwnMotionIsInContactBefore) {
  Random random(61);
  int hits = 0, at_once = 0;
  const int count = scaledCount(3000);
  for (int i = 0; i < count; ++i) {
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const auto motion_a = randomMotion(random, 4, 1.5), motion_b = randomMotion(random, 4, 1.5);
    const double error = 1e-7;
    const auto result = along(a, *motion_a, b, *motion_b, error, kSolvers[i % 2]);
    const auto swapped = along(b, *motion_b, a, *motion_a, error, kSolvers[(i + 1) % 2]);
    ASSERT_EQ(result.is_collide, swapped.is_collide);
    ASSERT_EQ(result.time_of_contact, swapped.time_of_contact);
    const auto meet = [&](double time) {
      fcl::CollisionResultd collision;
      return fcl::collide(a.get(), at(*motion_a, time), b.get(), at(*motion_b, time), fcl::CollisionRequestd(),
                          collision) > 0;
    };
    const double until = result.is_collide ? result.time_of_contact : 1;
    for (int sample = 0; sample < 100; ++sample) ASSERT_FALSE(meet(until * sample / 100) && until > 0) << i;
    if (!result.is_collide) {
      ASSERT_FALSE(meet(1)) << i;
      continue;
    }
    // No earlier than it may be: the polygons are as near as they can come in that time. No point is faster than 60.
    const tricover::Pose pose_a = flat(result.contact_tf1), pose_b = flat(result.contact_tf2);
    ASSERT_LE(tricover::distance(a->polygon(), pose_a, b->polygon(), pose_b).distance, 60 * error) << i;
    ++hits;
    at_once += result.time_of_contact == 0;
  }
  EXPECT_GT(hits, count * 2 / 10);
  EXPECT_LT(hits, count * 9 / 10);
  EXPECT_LT(at_once, hits / 2);
}

TEST(Continuous, collideAtTheBeginIsTimeZero) {
  Random random(62);
  int hits = 0;
  const int count = scaledCount(2000);
  for (int i = 0; i < count; ++i) {
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const auto motion_a = randomMotion(random, 1.2, 0), motion_b = randomMotion(random, 1.2, 0);
    fcl::CollisionResultd collision;
    const bool meet =
        fcl::collide(a.get(), at(*motion_a, 0), b.get(), at(*motion_b, 0), fcl::CollisionRequestd(), collision) > 0;
    const auto result = along(a, *motion_a, b, *motion_b, 1e-12);
    ASSERT_EQ(result.is_collide && result.time_of_contact == 0, meet) << i;
    hits += meet;
  }
  EXPECT_GT(hits, count * 2 / 10);
  EXPECT_LT(hits, count * 8 / 10);
}

/// FCL makes a motion from two poses without setting its reference point: whatever was in that memory must not count.
TEST(Continuous, slidesWithoutAReferencePoint) {
  using Interpolation = fcl::InterpMotion<double>;
  const fcl::TranslationMotiond still(placed(0, 0, 0), placed(0, 0, 0));
  for (const double rest : {0.0, 1e20, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    alignas(Interpolation) unsigned char memory[sizeof(Interpolation)];
    for (std::size_t i = 0; i < sizeof memory / sizeof rest; ++i) reinterpret_cast<volatile double*>(memory)[i] = rest;
    auto* motion = new (memory) Interpolation(placed(0, -10, 0), placed(0, 10, 0));
    const auto result = along(kSquare, *motion, kSquare, still, 1e-9);
    EXPECT_TRUE(result.is_collide);
    EXPECT_NEAR(result.time_of_contact, 0.45, 2e-9) << rest;
    EXPECT_NEAR(result.contact_tf1.translation().x(), -1, 4e-8) << rest;
    EXPECT_TRUE(result.contact_tf2.isApprox(placed(0, 0, 0))) << rest;
    motion->~Interpolation();
  }
}

TEST(Continuous, needsHeightsAndOccupancy) {
  const Shape<double> prism = std::make_shared<PolygonShaped>(kSquare->polygon(), PolygonOptions{0, -1, 1});
  const auto through = [&](double z, const Shape<double>& b) {
    const fcl::TranslationMotiond motion(placed(0, -3, 0, z), placed(0, 3, 0, z)),
        still(placed(0, 0, 0), placed(0, 0, 0));
    return along(kSquare, motion, b, still).is_collide;
  };
  EXPECT_TRUE(through(0, kSquare));
  EXPECT_FALSE(through(1e-300, kSquare));
  EXPECT_TRUE(through(1, prism));
  EXPECT_FALSE(through(1.001, prism));
  prism->cost_density = 0.5;
  EXPECT_FALSE(through(1, prism));
}

TEST(Continuous, motionsThatLeaveThePlaneAreRefused) {
  const fcl::Transform3d here = placed(0, 0, 0);
  const fcl::Transform3d flipped(fcl::AngleAxis<double>(kPi, fcl::Vector3d::UnitX()));
  const fcl::Transform3d tilted(fcl::AngleAxis<double>(0.1, fcl::Vector3d::UnitY()));
  const fcl::TranslationMotiond still(here, here), lift(here, placed(0, 3, 0, 1)), tilt(tilted, tilted);
  const fcl::InterpMotion<double> flip(here.linear(), fcl::Vector3d::Zero(), flipped.linear(), fcl::Vector3d::Zero(),
                                       fcl::Vector3d::Zero());
  const fcl::ScrewMotion<double> screw(here, placed(1, 3, 0, 1)), rise(here, placed(0, 0, 0, 2));
  for (const Motion* motion : std::initializer_list<const Motion*>{&lift, &tilt, &flip, &screw, &rise}) {
    for (const bool swapped : {false, true}) {
      const std::string text = thrownBy<std::invalid_argument>([&] {
        if (swapped) {
          along(kSquare, still, kSquare, *motion);
        } else {
          along(kSquare, *motion, kSquare, still);
        }
      });
      EXPECT_NE(text.find(swapped ? "motion_b" : "motion_a"), std::string::npos) << text;
      EXPECT_NE(text.find("plane"), std::string::npos) << text;
    }
  }
}

/// In the plane at height z, mostly towards the origin; some don't turn, some turn more than once.
fcl::SplineMotion<double> anySpline(Random& random, double z) {
  const double size = random.real(1, 40), spin = random.oneIn(4) ? 0 : random.real(0, 9);
  const auto position = [&] { return fcl::Vector3d(random.real(-size, size), random.real(-size, size), z); };
  const auto turn = [&] { return fcl::Vector3d(0, 0, 1 + random.real(-spin, spin)); };
  return {position(), position(), position(), position(), turn(), turn(), turn(), turn()};
}

TEST(Continuous, splinesAreFollowedByTheirControlPoints) {
  Random random(51);
  const int cases = scaledCount(1500);
  int hits = 0, at_start = 0;
  for (int i = 0; i < cases; ++i) {
    const auto polygon = [&] { return tricover::Polygon({star(random, random.integer(3, 9), 0.5, 3)}); };
    const double z = random.real(-5, 5);
    const double margins[] = {random.oneIn(3) ? random.real(0, 2) : 0, random.oneIn(3) ? random.real(0, 2) : 0};
    const Shape<double> a = std::make_shared<PolygonShaped>(polygon(), PolygonOptions{margins[0], 0, 0});
    const Shape<double> b = std::make_shared<PolygonShaped>(polygon(), PolygonOptions{margins[1], 0, 0});
    const fcl::SplineMotion<double> motion_a = anySpline(random, z), motion_b = anySpline(random, z);
    constexpr double kError = 1e-6;
    const fcl::ContinuousCollisionResultd result = along(a, motion_a, b, motion_b, kError, kSolvers[i % 2]);
    const double time = result.time_of_contact;
    // What a weighted sum of control points rounds by, in time.
    constexpr double kRounding = 1e-11;
    const auto collide = [&](double t, double more) {
      fcl::CollisionResultd there;
      return tricover_fcl::collide<double>(a.get(), at(motion_a, t), b.get(), at(motion_b, t), {}, {more}, there) > 0;
    };
    for (int k = 0; k < 200; ++k) {
      const double t = (k + random.unit()) / 200;
      ASSERT_FALSE(t < time - kRounding && collide(t, 0)) << "case " << i << ": " << t << " before " << time;
    }
    for (double ahead = 1e-10; ahead < 1e-3; ahead *= 10)
      ASSERT_FALSE(time > ahead && collide(time - ahead, 0)) << "case " << i;
    if (!result.is_collide) {
      ASSERT_FALSE(collide(1, 0)) << "case " << i;
      continue;
    }
    bool found = false;
    for (int k = 0; k <= 20; ++k) found = found || collide(std::min(1.0, time + k * kError / 20), 1e-9);
    ASSERT_TRUE(found) << "case " << i << ": nothing within the error after " << time;
    ASSERT_TRUE(result.contact_tf1.isApprox(at(motion_a, time)) && result.contact_tf2.isApprox(at(motion_b, time)));
    ++hits;
    at_start += time == 0;
  }
  EXPECT_GT(hits - at_start, cases / 10);
  EXPECT_GT(cases - hits, cases / 10);
}

TEST(Continuous, marginsAreMetBeforeContact) {
  const fcl::TranslationMotiond still(placed(0, 0, 0), placed(0, 0, 0)), right(placed(0, -10, 0), placed(0, 0, 0));
  const auto grown = [](double margin) -> Shape<double> {
    return std::make_shared<PolygonShaped>(kSquare->polygon(), PolygonOptions{margin, 0, 0});
  };
  EXPECT_NEAR(along(kSquare, right, kSquare, still).time_of_contact, 0.9, 1e-8);
  EXPECT_NEAR(along(grown(2), right, kSquare, still).time_of_contact, 0.7, 1e-8);
  EXPECT_NEAR(along(grown(2), right, grown(1), still).time_of_contact, 0.6, 1e-8);
  EXPECT_EQ(along(grown(8), right, grown(1), still).time_of_contact, 0);
  const fcl::TranslationMotiond past(placed(0, -10, 2), placed(0, 10, 2));
  EXPECT_TRUE(along(grown(1), past, kSquare, still).is_collide);
  EXPECT_FALSE(along(grown(1 - 1e-9), past, kSquare, still).is_collide);
}

TEST(Continuous, splinesThatLeaveThePlaneAreRefused) {
  const fcl::TranslationMotiond still(placed(0, 0, 0), placed(0, 0, 0));
  const fcl::Vector3d here = fcl::Vector3d::Zero(), up(0, 0, 1), turn(0, 0, 2), tilt(0, 1e-3, 2);
  const fcl::SplineMotion<double> rises(here, here, here, up, here, here, here, here);
  const fcl::SplineMotion<double> tilts(here, here, here, here, turn, turn, tilt, tilt);
  // It begins and ends upright.
  const fcl::Vector3d out(0, -5e-3, 2), in(0, 1e-3, 2);
  const fcl::SplineMotion<double> rolls(here, here, here, here, out, in, in, out);
  for (const auto* motion : {&rises, &tilts, &rolls})
    EXPECT_NE(
        thrownBy<std::invalid_argument>([&] { along(kSquare, still, kSquare, *motion); }).find("motion_b: it leaves"),
        std::string::npos);
  const fcl::SplineMotion<double> nowhere(here, here, here, here, here, here, here,
                                          fcl::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(thrownBy<std::invalid_argument>([&] { along(kSquare, nowhere, kSquare, still); }),
            "tricover: motion_a: a control point is not finite");
  const auto between = [&](auto continuous_collide) {
    return thrownBy<std::logic_error>([&] {
      fcl::ContinuousCollisionResultd result;
      continuous_collide(kSquare.get(), placed(0, 0, 0), placed(0, 9, 0), kSquare.get(), placed(0, 5, 0),
                         placed(0, 5, 0), advancing(1e-9, fcl::CCDM_SPLINE), result);
    });
  };
  EXPECT_NE(between([](auto&&... asked) { tricover_fcl::continuousCollide<double>(asked...); }).find("control points"),
            std::string::npos);
  EXPECT_NE(between([](auto&&... asked) { fcl::continuousCollide<double>(asked...); }).find("control points"),
            std::string::npos);
}

TEST(Continuous, badMotionsAndErrorsAreRefused) {
  const fcl::TranslationMotiond still(placed(0, 0, 0), placed(0, 0, 0));
  const fcl::TranslationMotiond nowhere(
      placed(0, 0, 0), placed(0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(thrownBy<std::invalid_argument>([&] { along(kSquare, still, kSquare, nowhere); }),
            "tricover: motion_b: its shift, turn or pivot is not finite");
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(along(kSquare, still, kSquare, still, bad), std::invalid_argument);
  }
}

TEST(Continuous, otherPairsGoToFcl) {
  const fcl::Sphered sphere(1);
  fcl::ContinuousCollisionResultd result;
  tricover_fcl::continuousCollide<double>(&sphere, placed(0, -5, 0), placed(0, 5, 0), &sphere, placed(0, 0, 0),
                                          placed(0, 0, 0), advancing(1e-9, fcl::CCDM_LINEAR), result);
  EXPECT_TRUE(result.is_collide);
  EXPECT_NEAR(result.time_of_contact, 0.3, 1e-2);
}

}  // namespace
}  // namespace tricover_fcl::test
