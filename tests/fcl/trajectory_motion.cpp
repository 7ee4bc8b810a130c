// SPDX-License-Identifier: BSD-3-Clause
// Ways of many legs as motions of FCL's: of polygons, beside polygons and beside FCL's own geometries.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>

#include <algorithm>
#include <vector>

#include "motions.h"
#include "tricover/trajectory.h"

namespace tricover_fcl::test {
namespace {

constexpr double kError = 1e-7;
const Shape<double> kSquare = rectangular(-0.5, -0.5, 0.5, 0.5);

template <typename A, typename B>
Impact along(const A& a, const Motion& motion_a, const B& b, const Motion& motion_b) {
  return impactOf(a, motion_a, b, motion_b, advancing(kError));
}

Pose at(double x, double y = 0) { return turnedAndMoved(0, x, y); }

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

struct Tally {
  int hits = 0, later = 0;

  void expectFirst(const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b) {
    Impact result;
    ASSERT_NO_FATAL_FAILURE(test::expectFirst<double>(a, motion_a, b, motion_b, kError, {0, 4000, false}, result));
    hits += result.is_collide;
    later += result.is_collide && result.time_of_contact > 0;
  }
};

TEST(TrajectoryMotion, OfOneLegIsThatMotion) {
  Random random(71);
  int hits = 0;
  for (int i = 0; i < 50; ++i) {
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const auto spline =
        std::make_shared<Spline>(splineOf([&] { return Vec3(random.real(-4, 4), random.real(-4, 4), 2); },
                                          [&] { return Vec3(0, 0, random.real(-3, 3)); }));
    const Spline rests = splineOf([] { return Vec3(0, 0, 2); }, [] { return Vec3(0, 0, 0); });
    const TrajectoryMotiond one({{0, 1, spline}}, 0, 1);
    const auto expected = along(a, *spline, b, rests), result = along(a, one, b, rests);
    ASSERT_EQ(result.is_collide, expected.is_collide);
    ASSERT_EQ(result.time_of_contact, expected.time_of_contact);
    for (const double time : {0.0, 0.3, 1.0}) ASSERT_TRUE(test::at(one, time).isApprox(test::at(*spline, time), 1e-12));
    hits += result.is_collide;
  }
  EXPECT_GT(hits, 10);
  EXPECT_LT(hits, 45);
}

TEST(TrajectoryMotion, FindsTheFirstContactOfPolygons) {
  Random random(72);
  Tally tally;
  const int count = scaledCount(300);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const tricover::Trajectory way_a = randomTrajectory(random, 5), way_b = randomTrajectory(random, 5);
    const double begin = random.real(-6, 6), end = begin + random.real(0.5, 20);
    const TrajectoryMotiond motion_a(way_a, begin, end), motion_b(way_b, begin, end);
    for (const double time : {0.0, 0.4, 1.0})
      ASSERT_TRUE(flat(test::at(motion_a, time)).isApprox(way_a.at(motion_a.clockAt(time)), 1e-9));
    ASSERT_NO_FATAL_FAILURE(tally.expectFirst(*a, motion_a, *b, motion_b));
  }
  EXPECT_GT(tally.hits, count / 4);
  EXPECT_LT(tally.hits, count * 9 / 10);
  EXPECT_GT(tally.later, tally.hits / 4);
}

TEST(TrajectoryMotion, FindsTheFirstContactBesideOtherGeometriesAndMotions) {
  Random random(73);
  const fcl::Boxd box(1.5, 1, 0.5);
  const fcl::Sphered sphere(0.8);
  Tally tally;
  const int count = scaledCount(100);
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
    const double begin = random.real(-6, 6), end = begin + random.real(0.5, 20);
    const TrajectoryMotiond motion_a(randomTrajectory(random, 4), begin, end, 0.1),
        motion_b(randomTrajectory(random, 4), begin, end, 0.2);
    const Body& other = i % 2 == 0 ? static_cast<const Body&>(box) : sphere;
    const Transform place = lifted(randomPose(random, 4), 0.1);
    const Vec3 way(random.real(-4, 4), random.real(-4, 4), 0), to(random.real(-4, 4), random.real(-4, 4), 0);
    ASSERT_NO_FATAL_FAILURE(tally.expectFirst(*a, motion_a, other, motion_b));
    ASSERT_NO_FATAL_FAILURE(tally.expectFirst(*a, Slide(place, lifted(0, to.x(), to.y(), 0.1)), other, motion_b));
    ASSERT_NO_FATAL_FAILURE(tally.expectFirst(*a, motion_a, *b, straight(place, way)));
  }
  EXPECT_GT(tally.hits, count / 2);
  EXPECT_LT(tally.hits, count * 27 / 10);
  EXPECT_GT(tally.later, tally.hits / 4);
}

/// What is in between is not met, what is there is.
TEST(TrajectoryMotion, MayJumpBesideAMotionOfAnotherClass) {
  const auto rest = [](double x) { return tricover::Motion::still(turnedAndMoved(0, x, 0)); };
  const TrajectoryMotiond jumps(tricover::Trajectory({{0, 0.5, rest(-9)}, {0.5, 1, rest(0)}}), 0, 1);
  const auto ask = [&](double x, double y) {
    return along(kSquare, jumps, kSquare, straight(lifted(0, x, y), {0, -12, 0}));
  };
  EXPECT_NEAR(ask(0, 9).time_of_contact, 8 / 12.0, 1e-6);
  EXPECT_NEAR(ask(-9, 5).time_of_contact, 4 / 12.0, 1e-6);
  EXPECT_FALSE(ask(-9, 9).is_collide);
  EXPECT_FALSE(ask(-4.5, 6).is_collide);
  EXPECT_NEAR(ask(0, 6).time_of_contact, 0.5, 1e-6);  // it is there already
}

TEST(TrajectoryMotion, MeetsAHalfspaceOnItsLastLeg) {
  const TrajectoryMotiond to_and_fro(
      tricover::Trajectory::through({{0, at(0, 1)}, {10, at(50, 1)}, {20, at(0, 1)}, {30, at(0, 0)}}), 0, 40);
  const fcl::Halfspaced below(Vec3(0, 1, 0), 0);
  const auto result = along(kSquare, to_and_fro, below, kRests);
  ASSERT_TRUE(result.is_collide);
  EXPECT_NEAR(to_and_fro.clockAt(result.time_of_contact), 25, 1e-5);
  EXPECT_TRUE(result.contact_tf1.translation().isApprox(Vec3(0, 0.5, 0), 1e-5));
}

TEST(TrajectoryMotion, IsCutAndRestsByTheClock) {
  const tricover::Trajectory way = tricover::Trajectory::through({{10, at(-9)}, {20, at(1)}, {30, at(11)}});
  const auto ask = [&](double begin, double end) {
    return along(kSquare, TrajectoryMotiond(way, begin, end), kSquare,
                 TrajectoryMotiond(tricover::Trajectory({{0, 1, tricover::Motion::still(at(0))}}), begin, end));
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
  const fcl::Sphered ball(0.5);
  const auto still = [](double begin, double end, double x = 0) {
    return tricover::Trajectory({{begin, end, tricover::Motion::still(turnedAndMoved(0, x, 0))}});
  };
  const auto ask = [&](const tricover::Trajectory& a, bool a_is_absent, const tricover::Trajectory& b, bool b_is_absent,
                       double begin = 0, double end = 20) {
    const auto shown = [](const tricover::Trajectory& way, bool is_absent) {
      return is_absent ? way.appearing().vanishing() : way;
    };
    const TrajectoryMotiond motion_a(shown(a, a_is_absent), begin, end), motion_b(shown(b, b_is_absent), begin, end);
    const auto result = along(kSquare, motion_a, kSquare, motion_b);
    for (int again = 0; again < 2; ++again) {
      EXPECT_EQ(along(kSquare, motion_b, kSquare, motion_a).time_of_contact, result.time_of_contact);
      EXPECT_NEAR(along(kSquare, motion_a, ball, motion_b).time_of_contact, result.time_of_contact, 2 * kError);
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
  const tricover::Trajectory comes = tricover::Trajectory::through({{0, at(-19)}, {20, at(-1)}});
  EXPECT_EQ(ask(first, true, comes, true), -1);
  EXPECT_NEAR(ask(still(5, 20), true, comes, true), 20, 20 * kError);
  // As legs; absent for a part of the time, beside a motion of the user's own and a half-space.
  const auto stays = std::make_shared<Slide>(lifted(0, 0, 0), lifted(0, 0, 0));
  const auto falls = straight(lifted(0, 0, 10), {0, -20, 0});
  const auto fallsOn = [&](double begin, double end) {
    const TrajectoryMotiond motion(std::vector<TimedMotion<double>>{{begin, end, stays}}, 0, 1, true, true);
    return along(kSquare, motion, kSquare, falls);
  };
  EXPECT_NEAR(fallsOn(-1, 2).time_of_contact, 0.45, 1e-6);
  EXPECT_NEAR(fallsOn(0.5, 0.6).time_of_contact, 0.5, 1e-6);
  EXPECT_FALSE(fallsOn(0, 0.4).is_collide);
  EXPECT_FALSE(fallsOn(0.6, 1).is_collide);
  EXPECT_FALSE(fallsOn(2, 3).is_collide);
  const fcl::Halfspaced below(Vec3(1, 0, 0), -5);
  EXPECT_EQ(along(kSquare, TrajectoryMotiond(comes.appearing().vanishing(), -20, 20), below, kRests).time_of_contact,
            0.5);
  EXPECT_FALSE(along(kSquare, TrajectoryMotiond(comes.appearing().vanishing(), 17, 40), below, kRests).is_collide);
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
    const TrajectoryMotiond motion_a(way_a.appearing().vanishing(), begin, end),
        motion_b(way_b.appearing().vanishing(), begin, end);
    const auto result = along(a, motion_a, b, motion_b);
    const double from = std::max({begin, way_a.begin(), way_b.begin()}),
                 until = std::min({end, way_a.end(), way_b.end()});
    if (!(from < until)) {
      ++never;
      ASSERT_FALSE(result.is_collide);
      continue;
    }
    const TrajectoryMotiond cut_a(way_a, from, until), cut_b(way_b, from, until);
    const auto expected = along(a, cut_a, b, cut_b);
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
  const auto square = std::make_shared<PolygonShapef>(Polygon({rectangle(-0.5, -0.5, 0.5, 0.5)}));
  const auto comes =
      std::make_shared<TrajectoryMotionf>(tricover::Trajectory::through({{0, at(-9)}, {1, at(-9)}, {2, at(1)}}), 0, 2);
  const auto rests =
      std::make_shared<TrajectoryMotionf>(tricover::Trajectory({{0, 1, tricover::Motion::still(at(0))}}), 0, 2);
  const fcl::ContinuousCollisionObject<float> a(square, comes), b(square, rests);
  fcl::ContinuousCollisionRequestf request;
  request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
  fcl::ContinuousCollisionResultf result;
  EXPECT_NEAR(tricover_fcl::collide(&a, &b, request, result), 0.9, 2e-4);
  EXPECT_TRUE(result.is_collide);
}

TEST(TrajectoryMotion, RefusesWhatItDoesNotFollow) {
  const auto slides = [](double z) { return std::make_shared<Slide>(lifted(0, 0, 0, z), lifted(0, 1, 0, z)); };
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
  EXPECT_NE(refusal({{0, 1, std::make_shared<Handing<Slide>>(straight(kHere, Vec3::UnitX()))}})
                .find("is none of FCL's motions"),
            std::string::npos);
  const auto one = std::make_shared<TrajectoryMotiond>(std::vector<TimedMotion<double>>{{0, 1, slides(1)}}, 0, 1);
  EXPECT_NE(refusal({{0, 1, one}}).find("is none of FCL's motions"), std::string::npos);
  const fcl::Sphered ball(1);
  // Of a polygon that isn't in the world's plane it would be a way out of its plane.
  Transform tilted = kHere;
  tilted.linear() = fcl::AngleAxis<double>(1, Vec3::UnitX()).toRotationMatrix();
  const Slide stays(tilted, tilted);
  EXPECT_NE(thrownBy<std::invalid_argument>([&] { along(kSquare, stays, ball, *one); }).find("leaves the polygon's"),
            std::string::npos);
}

}  // namespace
}  // namespace tricover_fcl::test
