// SPDX-License-Identifier: BSD-3-Clause
// Ways of many legs as motions of FCL's: of polygons, beside polygons and beside FCL's own geometries.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ask.h"
#include "tricover/distance.h"
#include "tricover/trajectory.h"

namespace tricover_fcl::test {
namespace {

using Geometry = fcl::CollisionGeometryd;
using Motion = fcl::MotionBased;

constexpr double kError = 1e-7;

fcl::ContinuousCollisionResultd along(const Geometry& a, const Motion& motion_a, const Geometry& b,
                                      const Motion& motion_b) {
  const fcl::ContinuousCollisionRequestd request = advancing(kError);
  fcl::ContinuousCollisionResultd result, ours;
  const double time = fcl::continuousCollide(&a, &motion_a, &b, &motion_b, request, result);
  EXPECT_EQ(tricover_fcl::continuousCollide(&a, &motion_a, &b, &motion_b, request, ours), time);
  EXPECT_EQ(ours.is_collide, result.is_collide);
  return result;
}

/// Splines, waits and turns, by a clock that begins at any time; some of mirror images.
tricover::Trajectory randomTrajectory(Random& random, double reach) {
  std::vector<tricover::TimedKnot> knots;
  double time = random.real(-5, 5);
  for (int i = random.integer(2, 5); i > 0; --i) {
    const auto any = [&](double most) { return random.real(-most, most); };
    knots.push_back({time, {{any(reach), any(reach)}, any(3), {any(reach), any(reach)}, any(2)}});
    time += random.real(0.1, 3);
    if (random.oneIn(3)) {
      knots.back().end.velocity.setZero(), knots.back().end.angular_velocity = 0;
      knots.push_back({time, knots.back().end});
      time += random.real(0.1, 3);
    }
  }
  if (knots.size() == 1) knots.push_back({time, knots.back().end});
  std::vector<tricover::Leg> legs = tricover::Trajectory::spline(knots, {random.real(-1, 1), 0}).legs();
  if (random.oneIn(4)) {
    const Eigen::DiagonalMatrix<double, 2> mirror(1, -1);
    for (tricover::Leg& leg : legs) leg.motion.start.linear() = leg.motion.start.linear() * mirror;
  }
  return tricover::Trajectory(std::move(legs));
}

/// Contacts are no later than any of many samples', and where they are the two are as near as they come in kError.
void expectFirst(const Geometry& a, const Motion& motion_a, const Geometry& b, const Motion& motion_b, double speed,
                 int& hits, int& later) {
  const auto result = along(a, motion_a, b, motion_b);
  const auto swapped = along(b, motion_b, a, motion_a);
  ASSERT_EQ(result.is_collide, swapped.is_collide);
  ASSERT_NEAR(result.time_of_contact, swapped.time_of_contact, kError);
  const double until = result.is_collide ? result.time_of_contact : 1;
  for (int sample = 0; sample < 100; ++sample) {
    const double time = until * sample / 100;
    ASSERT_FALSE(until > 0 && collides(a, at(motion_a, time), b, at(motion_b, time))) << time;
  }
  if (!result.is_collide) {
    ASSERT_FALSE(collides(a, at(motion_a, 1), b, at(motion_b, 1)));
    return;
  }
  fcl::DistanceRequestd request;
  fcl::DistanceResultd distance;
  ASSERT_LE(fcl::distance(&a, result.contact_tf1, &b, result.contact_tf2, request, distance), speed * kError);
  ++hits;
  later += result.time_of_contact > 0;
}

TEST(TrajectoryMotion, OfOneLegIsThatMotion) {
  Random random(71);
  const fcl::Vector3d zero = fcl::Vector3d::Zero();
  int hits = 0;
  for (int i = 0; i < 50; ++i) {
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    std::vector<fcl::Vector3d> place, turn;
    for (int k = 0; k < 4; ++k) {
      place.emplace_back(random.real(-4, 4), random.real(-4, 4), 2);
      turn.emplace_back(0, 0, random.real(-3, 3));
    }
    const auto spline = std::make_shared<fcl::SplineMotion<double>>(place[0], place[1], place[2], place[3], turn[0],
                                                                    turn[1], turn[2], turn[3]);
    const fcl::Vector3d there(0, 0, 2);
    const fcl::SplineMotion<double> rests(there, there, there, there, zero, zero, zero, zero);
    const TrajectoryMotiond one({{0, 1, spline}}, 0, 1);
    const auto expected = along(*a, *spline, *b, rests), result = along(*a, one, *b, rests);
    ASSERT_EQ(result.is_collide, expected.is_collide);
    ASSERT_EQ(result.time_of_contact, expected.time_of_contact);
    for (const double time : {0.0, 0.3, 1.0}) ASSERT_TRUE(at(one, time).isApprox(at(*spline, time), 1e-12));
    hits += result.is_collide;
  }
  EXPECT_GT(hits, 10);
  EXPECT_LT(hits, 45);
}

TEST(TrajectoryMotion, FindsTheFirstContactOfPolygons) {
  Random random(72);
  int hits = 0, later = 0;
  const int count = scaledCount(300);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const tricover::Trajectory way_a = randomTrajectory(random, 5), way_b = randomTrajectory(random, 5);
    const double begin = random.real(-6, 6), end = begin + random.real(0.5, 20);
    const TrajectoryMotiond motion_a(way_a, begin, end), motion_b(way_b, begin, end);
    for (const double time : {0.0, 0.4, 1.0}) {
      const tricover::Pose pose = way_a.at(motion_a.clockAt(time));
      ASSERT_TRUE(flat(at(motion_a, time)).isApprox(pose, 1e-9));
    }
    ASSERT_NO_FATAL_FAILURE(expectFirst(*a, motion_a, *b, motion_b, 4000, hits, later));
  }
  EXPECT_GT(hits, count / 4);
  EXPECT_LT(hits, count * 9 / 10);
  EXPECT_GT(later, hits / 4);
}

/// A class of motion that FCL doesn't have.
class Slide : public fcl::MotionBase<double> {
 public:
  Slide(const fcl::Transform3d& begin, const fcl::Vector3d& way) : begin_(begin), way_(way) {}
  bool integrate(double time) const override {
    time_ = time;
    return true;
  }
  void getCurrentTransform(fcl::Transform3d& pose) const override {
    pose = begin_;
    pose.translation() += time_ * way_;
  }
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>&) const override { return way_.norm() * 1.001; }
  double computeMotionBound(const fcl::TriangleMotionBoundVisitor<double>&) const override { return 1e9; }
  void getTaylorModel(fcl::TMatrix3<double>&, fcl::TVector3<double>&) const override {}

 private:
  fcl::Transform3d begin_;
  fcl::Vector3d way_;
  mutable double time_ = 0;
};

TEST(TrajectoryMotion, FindsTheFirstContactBesideOtherGeometriesAndMotions) {
  Random random(73);
  const fcl::Boxd box(1.5, 1, 0.5);
  const fcl::Sphered sphere(0.8);
  int hits = 0, later = 0;
  const int count = scaledCount(100);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Shape<double> a = shapeOf(randomPolygon(random, 1));
    const double begin = random.real(-6, 6), end = begin + random.real(0.5, 20);
    const TrajectoryMotiond motion_a(randomTrajectory(random, 4), begin, end, 0.1),
        motion_b(randomTrajectory(random, 4), begin, end, 0.2);
    const Geometry& other = i % 2 == 0 ? static_cast<const Geometry&>(box) : sphere;
    ASSERT_NO_FATAL_FAILURE(expectFirst(*a, motion_a, other, motion_b, 4000, hits, later));
    const fcl::Transform3d place = lifted(randomPose(random, 4), 0.1);
    const fcl::TranslationMotiond slides(
        place, lifted(tricover::support::turnedAndMoved(0, random.real(-4, 4), random.real(-4, 4)), 0.1));
    ASSERT_NO_FATAL_FAILURE(expectFirst(*a, slides, other, motion_b, 4000, hits, later));
    const Shape<double> b = shapeOf(randomPolygon(random, 1));
    const Slide own(place, {random.real(-4, 4), random.real(-4, 4), 0});
    ASSERT_NO_FATAL_FAILURE(expectFirst(*a, motion_a, *b, own, 4000, hits, later));
  }
  EXPECT_GT(hits, count / 2);
  EXPECT_LT(hits, count * 27 / 10);
  EXPECT_GT(later, hits / 4);
}

/// What is in between is not met, what is there is.
TEST(TrajectoryMotion, MayJumpBesideAMotionOfAnotherClass) {
  const Shape<double> square = rectangular(-0.5, -0.5, 0.5, 0.5);
  const auto rest = [](double x) { return tricover::Motion::still(tricover::support::turnedAndMoved(0, x, 0)); };
  const TrajectoryMotiond jumps(tricover::Trajectory({{0, 0.5, rest(-9)}, {0.5, 1, rest(0)}}), 0, 1);
  const auto ask = [&](double x, double y) {
    return along(*square, jumps, *square, Slide(lifted(0, x, y), {0, -12, 0}));
  };
  EXPECT_NEAR(ask(0, 9).time_of_contact, 8 / 12.0, 1e-6);
  EXPECT_NEAR(ask(-9, 5).time_of_contact, 4 / 12.0, 1e-6);
  EXPECT_FALSE(ask(-9, 9).is_collide);
  EXPECT_FALSE(ask(-4.5, 6).is_collide);
  EXPECT_NEAR(ask(0, 6).time_of_contact, 0.5, 1e-6);  // it is there already
}

TEST(TrajectoryMotion, MeetsAHalfspaceOnItsLastLeg) {
  const Shape<double> square = rectangular(-0.5, -0.5, 0.5, 0.5);
  const auto here = [](double x, double y) { return tricover::support::turnedAndMoved(0, x, y); };
  const TrajectoryMotiond to_and_fro(
      tricover::Trajectory::through({{0, here(0, 1)}, {10, here(50, 1)}, {20, here(0, 1)}, {30, here(0, 0)}}), 0, 40);
  const fcl::Halfspaced below(fcl::Vector3d(0, 1, 0), 0);
  const fcl::TranslationMotiond rests(fcl::Transform3d::Identity(), fcl::Transform3d::Identity());
  const auto result = along(*square, to_and_fro, below, rests);
  ASSERT_TRUE(result.is_collide);
  EXPECT_NEAR(to_and_fro.clockAt(result.time_of_contact), 25, 1e-5);
  EXPECT_TRUE(result.contact_tf1.translation().isApprox(fcl::Vector3d(0, 0.5, 0), 1e-5));
}

TEST(TrajectoryMotion, IsCutAndRestsByTheClock) {
  const Shape<double> square = rectangular(-0.5, -0.5, 0.5, 0.5);
  const auto here = [](double x) { return tricover::support::turnedAndMoved(0, x, 0); };
  const tricover::Trajectory way = tricover::Trajectory::through({{10, here(-9)}, {20, here(1)}, {30, here(11)}});
  const auto ask = [&](double begin, double end) {
    return along(*square, TrajectoryMotiond(way, begin, end), *square,
                 TrajectoryMotiond(tricover::Trajectory({{0, 1, tricover::Motion::still(here(0))}}), begin, end));
  };
  EXPECT_NEAR(ask(0, 40).time_of_contact, 18.0 / 40, kError);
  EXPECT_NEAR(ask(12, 22).time_of_contact, 0.6, kError);
  EXPECT_FALSE(ask(0, 17).is_collide);
  EXPECT_TRUE(ask(0, 18).is_collide);
  EXPECT_EQ(ask(19, 40).time_of_contact, 0);
  EXPECT_FALSE(ask(22, 40).is_collide);
  EXPECT_FALSE(ask(50, 60).is_collide);
}

/// FCL's answer is that of the core, whatever the order of the two and however often it is asked.
TEST(TrajectoryMotion, IsAbsentOutsideOfItsTime) {
  const Shape<double> square = rectangular(-0.5, -0.5, 0.5, 0.5);
  const fcl::Sphered ball(0.5);
  const auto still = [](double begin, double end, double x = 0) {
    return tricover::Trajectory({{begin, end, tricover::Motion::still(tricover::support::turnedAndMoved(0, x, 0))}});
  };
  const auto ask = [&](const tricover::Trajectory& a, bool a_is_absent, const tricover::Trajectory& b, bool b_is_absent,
                       double begin = 0, double end = 20) {
    const TrajectoryMotiond motion_a(a, begin, end, 0, a_is_absent), motion_b(b, begin, end, 0, b_is_absent);
    const auto result = along(*square, motion_a, *square, motion_b);
    for (int again = 0; again < 2; ++again) {
      EXPECT_EQ(along(*square, motion_b, *square, motion_a).time_of_contact, result.time_of_contact);
      EXPECT_NEAR(along(*square, motion_a, ball, motion_b).time_of_contact, result.time_of_contact, 2 * kError);
    }
    EXPECT_TRUE(result.is_collide || result.time_of_contact == 1);
    return result.is_collide ? motion_a.clockAt(result.time_of_contact) : -1;
  };
  const auto first = still(0, 10), second = still(11, 20), late = still(9, 20), after = still(30, 40);
  EXPECT_EQ(ask(first, false, second, false), 0);
  EXPECT_EQ(ask(first, true, second, true), -1);
  EXPECT_EQ(ask(first, false, second, true), 11);
  EXPECT_EQ(ask(first, true, second, false), 0);
  EXPECT_EQ(ask(first, true, late, true), 9);
  EXPECT_EQ(ask(first, true, still(10, 20), true), 10);  // at one time alone
  EXPECT_EQ(ask(first, true, first, true, 10, 20), -1);  // a leg that would take no time for FCL
  EXPECT_EQ(ask(first, true, first, true, 9, 20), 9);
  EXPECT_EQ(ask(after, true, after, true), -1);  // both are never there
  EXPECT_EQ(ask(after, true, first, true), -1);
  EXPECT_EQ(ask(after, true, first, false), -1);
  EXPECT_EQ(ask(after, false, first, true), 0);
  EXPECT_EQ(ask(after, true, after, true, 0, 35), 30);
  // It comes to the other one's place at the end, when that one is gone.
  const auto here = [](double x) { return tricover::support::turnedAndMoved(0, x, 0); };
  const tricover::Trajectory comes = tricover::Trajectory::through({{0, here(-19)}, {20, here(-1)}});
  EXPECT_EQ(ask(first, true, comes, true), -1);
  EXPECT_NEAR(ask(still(5, 20), true, comes, true), 20, 20 * kError);
  // As legs; absent for a part of the time, beside a motion of the user's own and a half-space.
  const auto stays = std::make_shared<fcl::TranslationMotiond>(lifted(0, 0, 0), lifted(0, 0, 0));
  const Slide falls(lifted(0, 0, 10), {0, -20, 0});
  const auto fallsOn = [&](double begin, double end) {
    const TrajectoryMotiond motion(std::vector<TimedMotion<double>>{{begin, end, stays}}, 0, 1, true);
    return along(*square, motion, *square, falls);
  };
  EXPECT_NEAR(fallsOn(-1, 2).time_of_contact, 0.45, 1e-6);
  EXPECT_NEAR(fallsOn(0.5, 0.6).time_of_contact, 0.5, 1e-6);
  EXPECT_FALSE(fallsOn(0, 0.4).is_collide);
  EXPECT_FALSE(fallsOn(0.6, 1).is_collide);
  EXPECT_FALSE(fallsOn(2, 3).is_collide);
  const fcl::Halfspaced below(fcl::Vector3d(1, 0, 0), -5);
  const fcl::TranslationMotiond rests(fcl::Transform3d::Identity(), fcl::Transform3d::Identity());
  EXPECT_EQ(along(*square, TrajectoryMotiond(comes, -20, 20, 0, true), below, rests).time_of_contact, 0.5);
  EXPECT_FALSE(along(*square, TrajectoryMotiond(comes, 17, 40, 0, true), below, rests).is_collide);
}

/// The first contact is that of the two along the time at which both are there, on which they never rest.
TEST(TrajectoryMotion, FindsTheFirstContactOfBodiesThatComeAndGo) {
  Random random(75);
  int hits = 0, later = 0, never = 0;
  const int count = scaledCount(300);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const tricover::Trajectory way_a = randomTrajectory(random, 3), way_b = randomTrajectory(random, 3);
    const double begin = random.real(-6, 6), end = begin + random.real(0.5, 10);
    const TrajectoryMotiond motion_a(way_a, begin, end, 0, true), motion_b(way_b, begin, end, 0, true);
    const auto result = along(*a, motion_a, *b, motion_b);
    const double from = std::max({begin, way_a.begin(), way_b.begin()}),
                 until = std::min({end, way_a.end(), way_b.end()});
    if (!(from < until)) {
      ++never;
      ASSERT_FALSE(result.is_collide);
      continue;
    }
    const TrajectoryMotiond cut_a(way_a, from, until), cut_b(way_b, from, until);
    const auto expected = along(*a, cut_a, *b, cut_b);
    ASSERT_EQ(result.is_collide, expected.is_collide);
    if (!result.is_collide) continue;
    ASSERT_NEAR(motion_a.clockAt(result.time_of_contact), cut_a.clockAt(expected.time_of_contact),
                2 * kError * (end - begin));
    ASSERT_GE(motion_a.clockAt(result.time_of_contact), from - 1e-12);
    ++hits;
    later += expected.time_of_contact > 0;
  }
  if (tricover::support::isScaledDown()) return;
  EXPECT_GT(never, count / 20);
  EXPECT_GT(hits, count / 5);
  EXPECT_LT(hits, count * 4 / 5);
  EXPECT_GT(later, hits / 4);
}

TEST(TrajectoryMotion, WorksForFloatAndForObjectsWithMotions) {
  const auto square = std::make_shared<PolygonShapef>(tricover::Polygon({rectangle(-0.5, -0.5, 0.5, 0.5)}));
  const auto here = [](double x) { return tricover::support::turnedAndMoved(0, x, 0); };
  const auto comes = std::make_shared<TrajectoryMotionf>(
      tricover::Trajectory::through({{0, here(-9)}, {1, here(-9)}, {2, here(1)}}), 0, 2);
  const auto rests =
      std::make_shared<TrajectoryMotionf>(tricover::Trajectory({{0, 1, tricover::Motion::still(here(0))}}), 0, 2);
  const fcl::ContinuousCollisionObject<float> a(square, comes), b(square, rests);
  fcl::ContinuousCollisionRequestf request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultf result;
  EXPECT_NEAR(tricover_fcl::collide(&a, &b, request, result), 0.9, 2e-4);
  EXPECT_TRUE(result.is_collide);
}

TEST(TrajectoryMotion, RefusesWhatItDoesNotFollow) {
  const auto slides = [](double z) {
    return std::make_shared<fcl::TranslationMotiond>(lifted(0, 0, 0, z), lifted(0, 1, 0, z));
  };
  const auto refusal = [](const std::vector<TimedMotion<double>>& legs, double end = 9) {
    return thrownBy<std::invalid_argument>([&] { TrajectoryMotiond(legs, 0, end); });
  };
  EXPECT_EQ(refusal({}), "tricover: legs: a trajectory needs at least one");
  EXPECT_EQ(refusal({{0, 1, slides(1)}, {1, 2, nullptr}}), "tricover: legs[1].motion: there is none");
  EXPECT_EQ(refusal({{0, 1, slides(1)}, {1, 2, slides(1.5)}}),
            "tricover: legs[1].motion: it is at another height, or the other way up, than the first");
  EXPECT_EQ(refusal({{0, 1, slides(1)}, {3, 4, slides(1)}}),
            "tricover: legs[1]: it must begin when the one before ends");
  EXPECT_EQ(refusal({{0, 1, slides(1)}}, -1), "tricover: end: it must be after begin, both finite");
  EXPECT_NE(refusal({{0, 1, std::make_shared<Slide>(fcl::Transform3d::Identity(), fcl::Vector3d::UnitX())}})
                .find("is none of FCL's motions"),
            std::string::npos);
  const auto one = std::make_shared<TrajectoryMotiond>(std::vector<TimedMotion<double>>{{0, 1, slides(1)}}, 0, 1);
  EXPECT_NE(refusal({{0, 1, one}}).find("is none of FCL's motions"), std::string::npos);
  const fcl::Sphered ball(1);
  // Of a polygon that isn't in the world's plane it would be a way out of its plane.
  fcl::Transform3d tilted = fcl::Transform3d::Identity();
  tilted.linear() = fcl::AngleAxis<double>(1, fcl::Vector3d::UnitX()).toRotationMatrix();
  const fcl::TranslationMotiond stays(tilted, tilted);
  const Shape<double> square = rectangular(-1, -1, 1, 1);
  EXPECT_NE(thrownBy<std::invalid_argument>([&] { along(*square, stays, ball, *one); }).find("leaves the polygon's"),
            std::string::npos);
}

}  // namespace
}  // namespace tricover_fcl::test
