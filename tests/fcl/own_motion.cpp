// SPDX-License-Identifier: BSD-3-Clause
// Conservative advancement along motion classes that FCL doesn't have, as a fleet planner's.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/halfspace.h>

#include <cmath>

#include "motions.h"
#include "tricover/time_of_impact.h"

namespace tricover_fcl::test {
namespace {

/// Swings to and fro, and its heading does, too.
template <typename S>
struct Swing {
  Vec2 center, reach;
  double frequency, phase, heading, turn;

  Pose at(double time) const {
    const double wave = std::sin(frequency * time + phase);
    const Vec2 place = center + wave * reach;
    return turnedAndMoved(heading + turn * wave, place.x(), place.y());
  }
  /// Of points within `radius` of the moving frame's origin.
  double speed(double radius) const {
    return frequency * (reach.norm() + std::abs(turn) * radius) * (1 + 4 * std::numeric_limits<S>::epsilon());
  }
};

template <typename S>
class SwingMotion : public OwnMotion<S> {
 public:
  SwingMotion(const Swing<S>& swing, double radius, double z = 0)
      : OwnMotion<S>(static_cast<S>(swing.speed(radius))), swing_(swing), z_(z) {}
  void getCurrentTransform(fcl::Transform3<S>& pose) const override {
    pose = lifted<S>(swing_.at(static_cast<double>(this->time_)), z_);
  }

 private:
  Swing<S> swing_;
  double z_;
};

template <typename S>
Swing<S> anySwing(Random& random) {
  const auto vector = [&](double size) { return Vec2(random.real(-size, size), random.real(-size, size)); };
  return {vector(9), vector(9), random.real(0.5, 6), random.real(0, 6), random.real(-3, 3), random.real(-2, 2)};
}

double radiusOf(const Polygon& polygon) {
  double radius = 0;
  for (const Ring& ring : polygon.rings()) {
    for (const Vec2& vertex : ring) radius = std::max(radius, vertex.norm());
  }
  return radius;
}

/// Two stars that swing, or one beside something that goes straight on or, of `box`, stands still.
template <typename S>
void expectSwingsOnTime(std::uint64_t seed, int cases, S error, const fcl::Box<S>* box, int least_hits) {
  Random random(seed);
  int hits = 0, margins = 0;
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const auto polygon = [&] { return Polygon({star(random, random.integer(3, 9), 0.5, 3)}); };
    const double margin = random.coin() ? random.real(0, 1) : 0, z = box != nullptr ? 0.5 : 0;
    const Shape<S> a = shapeOf<S>(polygon(), {margin, 0, 0}), star = shapeOf<S>(polygon());
    const fcl::CollisionGeometry<S>& b = box != nullptr ? static_cast<const fcl::CollisionGeometry<S>&>(*box) : *star;
    const SwingMotion<S> motion_a(anySwing<S>(random), radiusOf(a->polygon()), z),
        motion_b(anySwing<S>(random), box != nullptr ? std::hypot(1.5, 1) : radiusOf(star->polygon()), z);
    const fcl::Transform3<S> from = lifted<S>(randomPose(random, 9), z), to = lifted<S>(randomPose(random, 9), z);
    const fcl::TranslationMotion<S> straight(from, box != nullptr ? from : to);
    const Nearness nearness{1e-5, 0, false};
    fcl::ContinuousCollisionResult<S> result;
    if (i % 3 == 0)
      expectFirst<S>(*a, motion_a, b, motion_b, error, nearness, result);
    else if (i % 3 == 1)
      expectFirst<S>(*a, motion_a, b, straight, error, nearness, result);
    else
      expectFirst<S>(b, straight, *a, motion_a, error, nearness, result);
    if (::testing::Test::HasFailure()) return;
    hits += result.is_collide;
    margins += result.is_collide && margin > 0;
  }
  EXPECT_GT(hits, least_hits);
  EXPECT_GT(cases - hits, cases / 10);
  EXPECT_GT(margins, least_hits / 4);
}

TEST(OwnMotions, swingsMeetOnTime) {
  const int cases = scaledCount(400), float_cases = scaledCount(100);
  expectSwingsOnTime<double>(71, cases, 1e-6, nullptr, cases / 5);
  expectSwingsOnTime<float>(71, float_cases, 1e-3f, nullptr, float_cases / 5);
}

TEST(OwnMotions, swingsMeetOtherGeometriesOnTime) {
  const int cases = std::max(15, scaledCount(150));  // few of them hit
  const fcl::Boxd box(3, 2, 2);
  expectSwingsOnTime<double>(72, cases, 1e-6, &box, cases / 20);
}

/// The planner's question: a robot on a spline, and one that waits.
TEST(OwnMotions, splinesMeetWhatStandsStill) {
  Random random(73);
  const int cases = scaledCount(300);
  int hits = 0;
  for (int i = 0; i < cases; ++i) {
    const auto polygon = [&] { return shapeOf(Polygon({star(random, random.integer(3, 9), 0.5, 3)})); };
    const auto vector = [&] { return Vec3(random.real(-12, 12), random.real(-12, 12), 0); };
    const auto turn = [&] { return Vec3(0, 0, random.real(-4, 4)); };
    const Spline spline = splineOf(vector, turn);
    const Vec3 place = vector(), heading = turn();
    const StaticMotion waits(lifted(heading.z(), place.x(), place.y()));
    const Spline rests = splineOf([&] { return place; }, [&] { return heading; });
    const Shape<double> robot = polygon(), other = polygon();
    const Impact result = impactOf(robot, spline, other, waits, advancing(1e-6)),
                 swapped = impactOf(other, waits, robot, spline, advancing(1e-6)),
                 of_splines = impactOf(robot, spline, other, rests, advancing(1e-6));
    ASSERT_EQ(result.is_collide, of_splines.is_collide) << i;
    ASSERT_NEAR(result.time_of_contact, of_splines.time_of_contact, 1.1e-6) << i;
    ASSERT_EQ(result.time_of_contact, swapped.time_of_contact) << i;
    ASSERT_LE(waits.asked, 24) << "standing still is noticed";  // of four queries
    hits += result.is_collide;
  }
  EXPECT_GT(hits, cases / 20);
  EXPECT_GT(cases - hits, cases / 10);
}

const Shape<double> kSquare = rectangular(-0.5, -0.5, 0.5, 0.5);

TEST(OwnMotions, standingStillIsOneCollide) {
  for (const double x : {0.5, 1.0, 1.5}) {
    const StaticMotion a(kHere), b(lifted(0, x, 0));
    Impact result;
    const double time = fcl::continuousCollide<double>(kSquare.get(), &a, kSquare.get(), &b, advancing(1e-9), result);
    EXPECT_EQ(result.is_collide, x <= 1);
    EXPECT_EQ(time, x <= 1 ? 0 : 1);
    EXPECT_LE(a.asked + b.asked, 12);
  }
}

TEST(OwnMotions, narrowGapsTakeFewSteps) {
  const auto floor = rectangular(-3, -2, 3, 0);
  const auto triangle = shapeOf(Polygon({{{0, 0}, {1, 1}, {-0.5, 1}}}));
  for (double gap = 1e-3; gap > 1e-11; gap /= 10) {
    for (const double error : {1e-3, 1e-6, 1e-12}) {
      SCOPED_TRACE(testing::Message() << gap << ", " << error);
      const auto begin = [&](double heading, double x) { return turnedAndMoved(heading, x, gap); };
      const Handing sliding(Slide(lifted(begin(0.1, -2)), lifted(begin(0.1, 2))));
      EXPECT_FALSE(impactOf(triangle, sliding, floor, kRests, advancing(error)).is_collide);
      EXPECT_LT(sliding.asked, 2 * 100);  // of two queries

      // It tips about the corner that nearly touches, until it lies on its side or stands on its other one.
      for (const double angle : {0.5, 2.0}) {
        const Handing tipping(turning(lifted(begin(0.1, 0.3)), lifted(begin(0.1 + angle, 0.3)), {0, 0}));
        const Impact result = impactOf(triangle, tipping, floor, kRests, advancing(error));
        const double time = result.time_of_contact;
        EXPECT_EQ(result.is_collide, angle > 1);
        EXPECT_LT(tipping.asked, 2 * 400);
        if (angle < 1) continue;
        tricover::Motion same;
        same.start = begin(0.1, 0.3);
        same.angle = angle;
        const auto impact = tricover::timeOfImpact(triangle->polygon(), same, floor->polygon(),
                                                   tricover::Motion::still(Pose::Identity()), {0, 1e-12});
        ASSERT_TRUE(impact);
        EXPECT_LE(time, impact->time + 1e-9);
        EXPECT_GE(time, impact->time - error - 1e-9);
      }
    }
  }
}

/// The same motion by FCL's class, which is known, and by one that is asked for its bounds alone.
TEST(OwnMotions, areFollowedAsFclsOwn) {
  struct Row {
    std::uint64_t seed;
    int cases;
    double reach, pivot, error, of_known, early, late;
  };
  for (const Row& row : {Row{74, scaledCount(600), 7, 9, 1e-6, 1e-9, 1.1e-6, 1e-9},
                         Row{84, std::max(40, scaledCount(200)), 4, 2, 1e-5, 1e-7, 1.2e-5, 1e-6}}) {
    const bool allows_overlap = row.seed == 84;
    Random random(row.seed);
    int hits = 0;
    for (int i = 0; i < row.cases; ++i) {
      SCOPED_TRACE(testing::Message() << row.seed << ": " << i);
      const auto shape = [&](double margin) {
        return shapeOf(Polygon({allows_overlap ? tricover::support::anyConvex(random, 2)
                                               : star(random, random.integer(3, 40), 0.5, 3)}),
                       {margin, 0, 0});
      };
      const double margin = allows_overlap ? -random.real(0, 0.5) : random.coin() ? random.real(0, 1) : 0;
      const Shape<double> a = shape(margin), b = shape(allows_overlap ? 0.01 : 0);
      const auto inner = [&](double pivot) {
        const Transform from = lifted(randomPose(random, row.reach)), to = lifted(randomPose(random, row.reach));
        return turning(from, to, Vec2(random.real(-pivot, pivot), random.real(-pivot, pivot)));
      };
      const auto inner_a = inner(row.pivot), inner_b = inner(allows_overlap ? row.pivot : 0);
      const Impact result = impactOf(a, Handing(inner_a), b, Handing(inner_b), advancing(row.error)),
                   known = impactOf(a, inner_a, b, inner_b, advancing(row.of_known));
      if (result.is_collide != known.is_collide) {
        ASSERT_GT(std::min(result.time_of_contact, known.time_of_contact), 1 - row.error);
      }
      ASSERT_LE(result.time_of_contact, known.time_of_contact + row.late);
      ASSERT_GE(result.time_of_contact, known.time_of_contact - row.early);
      hits += result.is_collide && result.time_of_contact > 0;
    }
    EXPECT_GT(hits, row.cases / (allows_overlap ? 10 : 5));
    EXPECT_LT(hits, row.cases * (allows_overlap ? 9 : 8) / 10);
  }
}

TEST(OwnMotions, reachAllowedOverlapOnTime) {
  const Polygon unit({rectangle(-0.5, -0.5, 0.5, 0.5)});
  const Handing moves(Slide(lifted(0, -3, 0), lifted(0, 3, 0)));
  const Handing slides(Slide(lifted(0, -3, 0.76), lifted(0, 3, 0.76)));
  const fcl::Boxd box(1, 1, 1);
  for (const double error : {1e-3, 1e-6, 1e-9}) {
    const auto ask = [&](const Body& a, const Motion& motion_a, const Body& b, const Motion& motion_b) {
      const Impact result = impactOf(a, motion_a, b, motion_b, advancing(error));
      return result.is_collide ? result.time_of_contact : 2;
    };
    const auto shape = withMargin(unit, -0.25), other = withMargin(unit, 0), wide = withMargin(unit, 0.5),
               less = withMargin(unit, -0.75);
    for (const double time : {ask(*shape, moves, *other, kRests), ask(*other, kRests, *shape, moves),
                              ask(*less, moves, *wide, kRests), ask(*shape, moves, box, kRests)}) {
      EXPECT_LE(time, 2.25 / 6 + 1e-12);
      EXPECT_GE(time, 2.25 / 6 - error - 1e-12);
    }
    // It rests on the other one, a little less deep than is allowed, and slides along it.
    slides.asked = 0;
    EXPECT_EQ(ask(*shape, slides, *other, kRests), 2);
    EXPECT_EQ(ask(*other, kRests, *shape, slides), 2);
    EXPECT_LT(slides.asked, 2 * 400);
  }
  // It leaves an area, by as much as is allowed, and its own corner turns out of it.
  const auto outside = withMargin(Polygon({rectangle(-2, -2, 2, 2)}).complement(), -0.25);
  const Handing leaves(Slide(kHere, lifted(0, 8, 0)));
  const Impact result = impactOf(shapeOf(unit), leaves, outside, kRests, advancing(1e-6));
  EXPECT_TRUE(result.is_collide);
  EXPECT_LE(result.time_of_contact, 1.75 / 8 + 1e-12);
  EXPECT_GE(result.time_of_contact, 1.75 / 8 - 1e-6 - 1e-12);
}
TEST(OwnMotions, tightBoundsAreNotPassed) {
  const auto wall = rectangular(8.5, -9, 9, 9);
  const auto time = [&](const Motion& motion, const Motion& of_wall) {
    return impactOf(kSquare, motion, wall, of_wall, advancing(1e-7)).time_of_contact;
  };
  // Also between the directions that bounds are asked for.
  for (const double heading : {0.0, M_PI / 16, M_PI / 8, 1.0, 3.0}) {
    const Transform start = lifted(heading, 0, 0);
    const Vec3 way = start * Vec3(16, 0, 0);
    const double contact = time(straight(start, way), StaticMotion(start));
    EXPECT_LE(contact, 0.5 + 1e-12) << heading;
    EXPECT_NEAR(contact, 0.5, 2e-7) << heading;
  }
  // 10 t^3, beside a wall that slides along itself.
  const Vec3 here = Vec3::Zero();
  const Spline faster(here, here, here, Vec3(60, 0, 0), here, here, here, here);
  const double contact = time(faster, straight(kHere, {0, 1e-3, 0}));
  EXPECT_LE(contact, std::cbrt(0.8) + 1e-12);
  EXPECT_NEAR(contact, std::cbrt(0.8), 2e-7);
}

/// Hands itself to FCL's visitor, which says 0.
class Visiting : public SwingMotion<double> {
 public:
  using SwingMotion::SwingMotion;
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>& visitor) const override {
    return visitor.visit(*this);
  }
};

class Boundless : public SwingMotion<double> {
 public:
  using SwingMotion::SwingMotion;
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>&) const override { return kNaN; }
};

/// Rises as it goes.
class Rising : public SwingMotion<double> {
 public:
  using SwingMotion::SwingMotion;
  void getCurrentTransform(Transform& pose) const override {
    SwingMotion::getCurrentTransform(pose);
    pose.translation().z() += time_;
  }
};

TEST(OwnMotions, whatCannotBeAnsweredThrows) {
  const Swing<double> swing{{2, 0}, {1, 1}, 1, 0, 0, 0.1};
  const StaticMotion still(kHere);
  const auto ask = [&](const Motion& motion, double error = 1e-9) {
    impactOf(kSquare, still, kSquare, motion, advancing(error));
  };
  const SwingMotion<double> moves(swing, 1);
  EXPECT_NO_THROW(ask(moves));
  expectRefused<std::logic_error>({"motion_b", "Visiting"}, [&] { ask(Visiting(swing, 1)); });
  expectRefused<std::logic_error>({"Boundless is not finite"}, [&] { ask(Boundless(swing, 1)); });
  expectRefused({"motion_b: it leaves"}, [&] { ask(Rising(swing, 1)); });
  for (const double bad : {-1.0, kNaN}) EXPECT_THROW(ask(moves, bad), std::invalid_argument);

  // A halfspace that swings has no bound of its speed; one that stands still has.
  const fcl::Halfspaced halfspace(Vec3::UnitX(), 0.75);
  expectRefused<std::logic_error>({"motion_b: what has no end"},
                                  [&] { impactOf(kSquare, still, halfspace, moves, advancing(1e-6)); });
  EXPECT_FALSE(impactOf(kSquare, moves, halfspace, still, advancing(1e-6)).is_collide);
}

/// A bound that knows no direction, beside a wall at a distance of 1e-9, takes 1e9 steps: the search ends before, with
/// a time until which nothing is met.
TEST(OwnMotions, aSearchEndsWithALowerBound) {
  const Swing<double> still{{0, 0}, {0, 0}, 1, 0, 0, 0}, along{{1 + 1e-9, 0}, {0, 1}, 1, 0, 0, 0};
  const Shape<double> wall = rectangular(-1, -9, 0, 9), square = rectangular(-1, -1, 1, 1);
  const SwingMotion<double> moving(along, 2);
  const StaticMotion standing(lifted(still.at(0)));
  const Impact result = impactOf(square, moving, wall, standing, advancing(1e-3));
  EXPECT_TRUE(result.is_collide);
  EXPECT_GT(result.time_of_contact, 0);
  EXPECT_LT(result.time_of_contact, 1e-3);
}

}  // namespace
}  // namespace tricover_fcl::test
