// SPDX-License-Identifier: BSD-3-Clause
// Continuous collision through FCL: its motions, its solvers, and tricover_fcl::continuousCollide.
#include <cmath>
#include <vector>

#include "mixed_scene.h"
#include "motions.h"
#include "tricover/trajectory.h"

namespace tricover_fcl::test {
namespace {

const Shape<double> kSquare = rectangular(-0.5, -0.5, 0.5, 0.5);
constexpr fcl::CCDMotionType kTypes[] = {fcl::CCDM_TRANS, fcl::CCDM_LINEAR, fcl::CCDM_SCREW};
constexpr fcl::CCDSolverType kAllSolvers[] = {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT,
                                              fcl::CCDC_RAY_SHOOTING, fcl::CCDC_POLYNOMIAL_SOLVER};
using Request = fcl::ContinuousCollisionRequestd;

/// FCL's default solver looks ten times on the way and sees nothing, and two others know no polygons.
TEST(Continuous, nothingTunnelsWhoeverIsAsked) {
  struct Row {
    Shape<double> bullet, wall;
    double from, truth;
    fcl::Boxd box;  ///< the same wall
  };
  const Row rows[] = {
      {rectangular(-5e-4, -5e-4, 5e-4, 5e-4), rectangular(-5e-4, -1, 5e-4, 1), -500, 0.5 - 1e-6, {1e-3, 2, 1}},
      {kSquare, rectangular(-0.025, -5, 0.025, 5), -20, 0.486875, {0.05, 10, 1}}};
  std::vector<Request> requests = {{}};
  for (const fcl::CCDSolverType solver : kAllSolvers) {
    requests.push_back({10, 0.9, fcl::CCDM_LINEAR, fcl::GST_LIBCCD, solver});
    for (const fcl::GJKSolverType gjk : kSolvers) requests.push_back({1, 1e-4, fcl::CCDM_TRANS, gjk, solver});
  }
  for (const fcl::CCDMotionType type : kTypes)
    for (const fcl::GJKSolverType gjk : kSolvers)
      for (const double error : {1e-4, 1e-9}) requests.push_back(advancing(error, type, gjk));
  for (const Row& row : rows) {
    const Transform begin = lifted(0, row.from, 0), end = lifted(0, -row.from, 0);
    const auto passes = std::make_shared<Slide>(begin, end), rests = std::make_shared<Slide>(kHere, kHere);
    const Body *bullet = row.bullet.get(), *wall = row.wall.get(), *box = &row.box;
    const fcl::CollisionObjectd object(row.bullet, begin), beside(row.wall, kHere);
    const fcl::ContinuousCollisionObjectd moving(row.bullet, passes), resting(row.wall, rests);
    for (const Request& request : requests) {
      SCOPED_TRACE(testing::Message() << row.from << ", " << request.ccd_solver_type << ", " << request.toc_err);
      Impact results[8];
      fcl::continuousCollide(bullet, begin, end, wall, kHere, kHere, request, results[0]);
      fcl::continuousCollide(&object, end, &beside, kHere, request, results[1]);
      tricover_fcl::continuousCollide(&object, end, &beside, kHere, request, results[2]);
      fcl::continuousCollide<double>(bullet, passes.get(), wall, rests.get(), request, results[3]);
      fcl::collide(&moving, &resting, request, results[4]);
      fcl::continuousCollide<double>(bullet, passes.get(), box, rests.get(), request, results[5]);
      fcl::continuousCollide(wall, kHere, kHere, bullet, begin, end, request, results[6]);
      fcl::continuousCollide<double>(box, rests.get(), bullet, passes.get(), request, results[7]);
      for (const Impact& result : results) {
        ASSERT_TRUE(result.is_collide);
        EXPECT_LE(result.time_of_contact, row.truth + 1e-12);
        EXPECT_GE(result.time_of_contact, row.truth - request.toc_err);
        const bool is_swapped = &result >= results + 6;
        const Transform &of_bullet = is_swapped ? result.contact_tf2 : result.contact_tf1,
                        &of_wall = is_swapped ? result.contact_tf1 : result.contact_tf2;
        EXPECT_NEAR(of_bullet.translation().x(), row.from * (1 - 2 * result.time_of_contact), -5e-14 * row.from);
        EXPECT_TRUE(of_wall.isApprox(kHere));
      }
    }
  }
}

TEST(Continuous, contactAtTheEndsCounts) {
  const auto at = [](double x) { return lifted(0, x, 0); };
  for (const fcl::CCDMotionType type : kTypes) {
    for (const fcl::CCDSolverType solver : {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT}) {
      const auto ask = [&](double from, double to) {
        Impact result;
        fcl::continuousCollide<double>(kSquare.get(), at(from), at(to), kSquare.get(), at(1), at(1),
                                       Request(10, 1e-9, type, fcl::GST_LIBCCD, solver), result);
        return result.is_collide ? result.time_of_contact : 2;
      };
      // FCL's CCDM_LINEAR rounds, so it can't be made to touch exactly.
      const double touch = type == fcl::CCDM_LINEAR ? 1e-10 : 0;
      EXPECT_NEAR(ask(touch - 1, touch), 1, 1e-9);
      EXPECT_EQ(ask(-1, -1e-9), 2);
      EXPECT_EQ(ask(touch, touch - 1), 0);
      EXPECT_EQ(ask(0.5, 1.5), 0);
      EXPECT_EQ(ask(-1e-9, -1), 2);
    }
    Impact ours;
    EXPECT_NEAR(tricover_fcl::continuousCollide(kSquare.get(), at(-3), at(0), kSquare.get(), at(1), at(1),
                                                advancing(1e-9, type), ours),
                1, 1e-9);
    EXPECT_TRUE(ours.is_collide);
  }
}

TEST(Continuous, turnsCount) {
  // A rod that sweeps past a post, about its own end; the poses at both ends are free.
  const Shape<double> rod = rectangular(0, -0.01, 10, 0.01), post = rectangular(-0.01, -0.01, 0.01, 0.01);
  const Transform there = lifted(0, 0, 8), end = lifted(0.9 * M_PI, 0, 0);
  const Slide still(there, there);
  const double truth = (M_PI / 2 - std::atan2(0.01, 7.99) - std::asin(0.01 / std::hypot(7.99, 0.01))) / (0.9 * M_PI);
  const fcl::InterpMotion<double> linear = turning(kHere, end, {0, 0});
  const fcl::ScrewMotion<double> screw(kHere, end);
  for (const Motion* motion : {static_cast<const Motion*>(&linear), static_cast<const Motion*>(&screw)}) {
    for (const fcl::GJKSolverType solver : kSolvers) {
      const Impact result = impactOf(rod, *motion, post, still, advancing(1e-9, fcl::CCDM_TRANS, solver));
      EXPECT_TRUE(result.is_collide);
      EXPECT_LE(result.time_of_contact, truth + 1e-12);
      EXPECT_GE(result.time_of_contact, truth - 1e-9 - 1e-12);
    }
  }
  for (const fcl::CCDMotionType type : kTypes) {
    Impact ours;
    tricover_fcl::continuousCollide(rod.get(), kHere, end, post.get(), there, there, advancing(1e-9, type), ours);
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
  const Transform end = lifted(2, 1, 0), there = lifted(0, 0, 8);
  const fcl::CollisionObjectd object(rod, kHere), post(kSquare, there);
  const Request request = advancing(1e-9, fcl::CCDM_LINEAR);
  Impact expected;
  tricover_fcl::continuousCollide(rod.get(), kHere, end, kSquare.get(), there, there, request, expected);
  ASSERT_TRUE(expected.is_collide);
  for (const double rest : {7.5, 1e20, kNaN}) {
    Impact geometries, objects;
    leaveBehind(rest);
    fcl::continuousCollide(rod.get(), kHere, end, kSquare.get(), there, there, request, geometries);
    leaveBehind(rest);
    fcl::continuousCollide(&object, end, &post, there, request, objects);
    for (const auto* result : {&geometries, &objects}) {
      EXPECT_EQ(result->time_of_contact, expected.time_of_contact) << rest;
      EXPECT_TRUE(result->contact_tf1.isApprox(expected.contact_tf1)) << rest;
    }
  }
}

/// FCL makes a motion from two poses without setting its reference point: whatever was in that memory must not count.
TEST(Continuous, slidesWithoutAReferencePoint) {
  using Interpolation = fcl::InterpMotion<double>;
  for (const double rest : {0.0, 1e20, 1e300, kNaN}) {
    alignas(Interpolation) unsigned char memory[sizeof(Interpolation)];
    for (std::size_t i = 0; i < sizeof memory / sizeof rest; ++i) reinterpret_cast<volatile double*>(memory)[i] = rest;
    auto* motion = new (memory) Interpolation(lifted(0, -10, 0), lifted(0, 10, 0));
    const Impact result = impactOf(kSquare, *motion, kSquare, kRests);
    EXPECT_TRUE(result.is_collide);
    EXPECT_NEAR(result.time_of_contact, 0.45, 2e-9) << rest;
    EXPECT_NEAR(result.contact_tf1.translation().x(), -1, 4e-8) << rest;
    EXPECT_TRUE(result.contact_tf2.isApprox(kHere)) << rest;
    motion->~Interpolation();
  }
}

/// A random motion that keeps the plane, of each type, some upside down.
std::shared_ptr<Motion> anyMotion(Random& random, double reach, double z) {
  Transform begin = lifted(randomPose(random, reach), z), end = lifted(randomPose(random, reach), z);
  if (random.oneIn(4)) {
    const fcl::AngleAxis<double> half_turn(M_PI, Vec3::UnitX());
    begin.linear() = begin.linear() * half_turn;
    end.linear() = end.linear() * half_turn;
  }
  switch (random.integer(0, 2)) {
    case 0:
      return std::make_shared<Slide>(begin, end);
    case 1:
      return std::make_shared<fcl::InterpMotion<double>>(
          turning(begin, end, Vec2(random.real(-1, 1), random.real(-1, 1))));
    default:
      return std::make_shared<fcl::ScrewMotion<double>>(begin, end);
  }
}

/// In the plane at height z, mostly towards the origin; some don't turn, some turn more than once.
std::shared_ptr<Motion> anySpline(Random& random, double, double z) {
  const double size = random.real(1, 40), spin = random.oneIn(4) ? 0 : random.real(0, 9);
  return std::make_shared<Spline>(splineOf([&] { return Vec3(random.real(-size, size), random.real(-size, size), z); },
                                           [&] { return Vec3(0, 0, 1 + random.real(-spin, spin)); }));
}

TEST(Continuous, fclsMotionsAreFollowed) {
  struct Row {
    std::uint64_t seed;
    int cases;
    std::shared_ptr<Motion> (*motion)(Random&, double reach, double z);
    double reach, error;
    Nearness nearness;
    double most_margin;
  };
  for (const Row& row : {Row{61, 3000, anyMotion, 4, 1e-7, {0, 60}, 0},       // no point is faster than 60
                         Row{62, 2000, anyMotion, 1.2, 1e-12, {0, 1000}, 0},  // many meet at the begin
                         Row{51, 1500, anySpline, 0, 1e-6, {1e-9}, 2}}) {
    Random random(row.seed);
    const int count = scaledCount(row.cases);
    int hits = 0, at_once = 0;
    for (int i = 0; i < count; ++i) {
      SCOPED_TRACE(testing::Message() << row.seed << ": " << i);
      const double z = random.real(-5, 5);
      const auto shape = [&] {
        const double margin = random.oneIn(3) ? random.real(0, row.most_margin) : 0;
        return shapeOf(
            row.most_margin > 0 ? Polygon({star(random, random.integer(3, 9), 0.5, 3)}) : randomPolygon(random, 1),
            {margin, 0, 0});
      };
      const Shape<double> a = shape(), b = shape();
      const auto motion_a = row.motion(random, row.reach, z), motion_b = row.motion(random, row.reach, z);
      Impact result;
      ASSERT_NO_FATAL_FAILURE(
          expectFirst<double>(*a, *motion_a, *b, *motion_b, row.error, row.nearness, result, kSolvers[i % 2]));
      hits += result.is_collide;
      at_once += result.is_collide && result.time_of_contact == 0;
    }
    const bool meet_at_once = row.seed == 62;
    EXPECT_GT(meet_at_once ? at_once : hits, count * (row.seed == 51 ? 1 : 2) / 10);
    EXPECT_LT(meet_at_once ? at_once : hits, count * (meet_at_once ? 8 : 9) / 10);
    EXPECT_TRUE(meet_at_once || at_once < hits / 2) << at_once << " of " << hits;
  }
}

TEST(Continuous, needsHeightsOccupancyAndMargins) {
  const Shape<double> prism = shapeOf(kSquare->polygon(), {0, -1, 1});
  const auto through = [&](double z, const Shape<double>& b) {
    return impactOf(kSquare, Slide(lifted(0, -3, 0, z), lifted(0, 3, 0, z)), b, kRests).is_collide;
  };
  EXPECT_TRUE(through(0, kSquare));
  EXPECT_FALSE(through(1e-300, kSquare));
  EXPECT_TRUE(through(1, prism));
  EXPECT_FALSE(through(1.001, prism));
  prism->cost_density = 0.5;
  EXPECT_FALSE(through(1, prism));

  const auto grown = [](double margin) { return shapeOf(kSquare->polygon(), {margin, 0, 0}); };
  const Slide right(lifted(0, -10, 0), kHere), past(lifted(0, -10, 2), lifted(0, 10, 2));
  EXPECT_NEAR(impactOf(kSquare, right, kSquare, kRests).time_of_contact, 0.9, 1e-8);
  EXPECT_NEAR(impactOf(grown(2), right, kSquare, kRests).time_of_contact, 0.7, 1e-8);
  EXPECT_NEAR(impactOf(grown(2), right, grown(1), kRests).time_of_contact, 0.6, 1e-8);
  EXPECT_EQ(impactOf(grown(8), right, grown(1), kRests).time_of_contact, 0);
  EXPECT_TRUE(impactOf(grown(1), past, kSquare, kRests).is_collide);
  EXPECT_FALSE(impactOf(grown(1 - 1e-9), past, kSquare, kRests).is_collide);
}

TEST(Continuous, motionsThatLeaveThePlaneAreRefused) {
  const Transform flipped(fcl::AngleAxis<double>(M_PI, Vec3::UnitX()));
  const Transform tilted(fcl::AngleAxis<double>(0.1, Vec3::UnitY()));
  const Slide lift(kHere, lifted(0, 3, 0, 1)), tilt(tilted, tilted);
  const fcl::InterpMotion<double> flip = turning(kHere, flipped, {0, 0});
  const fcl::ScrewMotion<double> screw(kHere, lifted(1, 3, 0, 1)), rise(kHere, lifted(0, 0, 0, 2));
  // Splines that rise, that tilt, and that roll, which begin and end upright.
  const Vec3 here = Vec3::Zero(), up(0, 0, 1), turn(0, 0, 2), lean(0, 1e-3, 2), out(0, -5e-3, 2), in(0, 1e-3, 2);
  const Spline rises(here, here, here, up, here, here, here, here),
      tilts(here, here, here, here, turn, turn, lean, lean), rolls(here, here, here, here, out, in, in, out);
  for (const Motion* motion :
       std::initializer_list<const Motion*>{&lift, &tilt, &flip, &screw, &rise, &rises, &tilts, &rolls}) {
    expectRefused({"motion_a: it leaves", "plane"}, [&] { impactOf(kSquare, *motion, kSquare, kRests); });
    expectRefused({"motion_b: it leaves", "plane"}, [&] { impactOf(kSquare, kRests, kSquare, *motion); });
  }
  const auto expectText = [](const Motion& a, const Motion& b, const char* text) {
    EXPECT_EQ(thrownBy([&] { impactOf(kSquare, a, kSquare, b); }), text);
  };
  const Spline nowhere(here, here, here, here, here, here, here, Vec3::Constant(kNaN));
  expectText(nowhere, kRests, "tricover: motion_a: a control point is not finite");
  expectText(kRests, Slide(kHere, lifted(0, kNaN, kNaN)), "tricover: motion_b: its shift, turn or pivot is not finite");
  for (const double bad : {-1.0, kNaN})
    EXPECT_THROW(impactOf(kSquare, kRests, kSquare, kRests, advancing(bad)), std::invalid_argument);
  const auto between = [&](auto continuous_collide) {
    expectRefused<std::logic_error>({"control points"}, [&] {
      Impact result;
      continuous_collide(kSquare.get(), kHere, lifted(0, 9, 0), kSquare.get(), lifted(0, 5, 0), lifted(0, 5, 0),
                         advancing(1e-9, fcl::CCDM_SPLINE), result);
    });
  };
  between([](auto&&... asked) { tricover_fcl::continuousCollide<double>(asked...); });
  between([](auto&&... asked) { fcl::continuousCollide<double>(asked...); });
}

/// FCL would take the motion for one that stands still, and a body that is absent for one that rests: wherever the two
/// are, also where they overlap at time 0, of which FCL asks no motion.
TEST(Continuous, aTrajectoryMotionBesideFclsOwnPairsIsSampledOrRefused) {
  const fcl::Boxd box(1, 1, 1);
  for (const double x : {0.0, 9.0}) {
    const auto still = [x](double begin, double end) {
      return tricover::Trajectory({{begin, end, tricover::Motion::still(turnedAndMoved(0, x, 0))}});
    };
    for (const fcl::CCDSolverType solver :
         {fcl::CCDC_NAIVE, fcl::CCDC_CONSERVATIVE_ADVANCEMENT, fcl::CCDC_POLYNOMIAL_SOLVER}) {
      SCOPED_TRACE(testing::Message() << x << ", " << solver);
      for (const bool swapped : {false, true}) {
        for (const bool ours : {false, true}) {
          const auto ask = [&](const tricover::Trajectory& trajectory, bool absent) {
            const TrajectoryMotiond motion(absent ? trajectory.appearing().vanishing() : trajectory, 0, 1);
            const Motion *one = swapped ? static_cast<const Motion*>(&kRests) : &motion,
                         *other = swapped ? static_cast<const Motion*>(&motion) : &kRests;
            Request request;
            request.ccd_solver_type = solver;
            Impact result;
            if (ours)
              tricover_fcl::continuousCollide<double>(&box, one, &box, other, request, result);
            else
              fcl::continuousCollide<double>(&box, one, &box, other, request, result);
            return result.is_collide;
          };
          for (const auto& part : {still(-2, -1), still(0.5, 2), still(0, 0.5)})
            EXPECT_THROW(ask(part, true), std::logic_error);
          if (solver == fcl::CCDC_NAIVE) {
            EXPECT_EQ(ask(still(-2, -1), false), x == 0);
            EXPECT_EQ(ask(still(-1, 3), true), x == 0);
          } else {
            expectRefused<std::logic_error>({"CCDC_NAIVE"}, [&] { ask(still(-2, -1), false); });
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace tricover_fcl::test
