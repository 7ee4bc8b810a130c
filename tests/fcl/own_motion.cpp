// SPDX-License-Identifier: BSD-3-Clause
// Conservative advancement along motion classes that FCL doesn't have, as a fleet planner's.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/spline_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ask.h"
#include "tricover/time_of_impact.h"

namespace tricover_fcl::test {
namespace {

/// What answers nothing but where it is and how fast.
template <typename S>
class OwnMotion : public fcl::MotionBase<S> {
 public:
  S computeMotionBound(const fcl::BVMotionBoundVisitor<S>&) const override { return bound_; }
  S computeMotionBound(const fcl::TriangleMotionBoundVisitor<S>&) const override {
    throw std::runtime_error("no bound of triangles");
  }
  void getTaylorModel(fcl::TMatrix3<S>&, fcl::TVector3<S>&) const override {
    throw std::runtime_error("no Taylor model");
  }

 protected:
  explicit OwnMotion(S bound) : bound_(bound) {}

 private:
  S bound_;
};

/// As open-rmf/rmf_traffic has it.
class StaticMotion : public OwnMotion<double> {
 public:
  explicit StaticMotion(const fcl::Transform3d& pose) : OwnMotion(0), pose_(pose) {}
  bool integrate(double) const override { return ++asked > 0; }
  void getCurrentTransform(fcl::Transform3d& pose) const override { pose = pose_; }

  mutable int asked = 0;

 private:
  fcl::Transform3d pose_;
};

/// Swings to and fro, and its heading does, too.
template <typename S>
struct Swing {
  tricover::Vec2 center, reach;
  double frequency, phase, heading, turn;

  tricover::Pose at(double time) const {
    const double wave = std::sin(frequency * time + phase);
    const tricover::Vec2 place = center + wave * reach;
    return tricover::support::turnedAndMoved(heading + turn * wave, place.x(), place.y());
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
  bool integrate(S time) const override {
    time_ = time;
    return true;
  }
  void getCurrentTransform(fcl::Transform3<S>& pose) const override {
    pose = lifted<S>(swing_.at(static_cast<double>(time_)), z_);
  }

 private:
  Swing<S> swing_;
  double z_;
  mutable S time_ = 0;
};

template <typename S>
Swing<S> anySwing(Random& random) {
  const auto vector = [&](double size) { return tricover::Vec2(random.real(-size, size), random.real(-size, size)); };
  return {vector(9), vector(9), random.real(0.5, 6), random.real(0, 6), random.real(-3, 3), random.real(-2, 2)};
}

double radiusOf(const tricover::Polygon& polygon) {
  double radius = 0;
  for (const tricover::Ring& ring : polygon.rings()) {
    for (const tricover::Vec2& vertex : ring) radius = std::max(radius, vertex.norm());
  }
  return radius;
}

/// Asks both, along their motions; checks that nothing meets before, and that something does within `error` after.
template <typename S>
bool follows(const fcl::CollisionGeometry<S>& a, const fcl::MotionBase<S>& motion_a, const fcl::CollisionGeometry<S>& b,
             const fcl::MotionBase<S>& motion_b, S error) {
  fcl::ContinuousCollisionRequest<S> request;
  request.toc_err = error;
  request.num_max_iterations = 1;
  fcl::ContinuousCollisionResult<S> result;
  const S time = tricover_fcl::continuousCollide(&a, &motion_a, &b, &motion_b, request, result);
  const auto collide = [&](double t, double more) {
    fcl::CollisionResult<S> there;
    return tricover_fcl::collide(&a, at(motion_a, t), &b, at(motion_b, t), fcl::CollisionRequest<S>(), {more}, there) >
           0;
  };
  constexpr int kSamples = 200;
  const double until = result.is_collide ? static_cast<double>(time) : 1 + 1e-12;
  for (int k = 0; k < kSamples; ++k)
    EXPECT_FALSE((k < until * kSamples) && collide(double(k) / kSamples, 0) && time > 0);
  for (double ahead = 1e-7; ahead < 1e-2; ahead *= 10) EXPECT_FALSE(until > ahead && collide(until - ahead, 0));
  if (!result.is_collide) return false;
  bool found = false;
  for (int k = 0; k <= 20 && !found; ++k)
    found = collide(std::min(1.0, static_cast<double>(time + error * static_cast<S>(k) / 20)), 1e-5);
  EXPECT_TRUE(found) << "nothing within the error after " << time;
  return true;
}

template <typename S>
void swingsMeetOnTime(int full, S error) {
  Random random(71);
  const int cases = scaledCount(full);
  int hits = 0, margins = 0;
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const auto polygon = [&] { return tricover::Polygon({star(random, random.integer(3, 9), 0.5, 3)}); };
    const double margin = random.coin() ? random.real(0, 1) : 0;
    const auto a = std::make_shared<PolygonShape<S>>(polygon(), PolygonOptions{margin, 0, 0});
    const auto b = std::make_shared<PolygonShape<S>>(polygon());
    const SwingMotion<S> motion_a(anySwing<S>(random), radiusOf(a->polygon())),
        motion_b(anySwing<S>(random), radiusOf(b->polygon()));
    const fcl::TranslationMotion<S> straight(lifted<S>(randomPose(random, 9)), lifted<S>(randomPose(random, 9)));
    const bool hit = i % 3 == 0   ? follows<S>(*a, motion_a, *b, motion_b, error)
                     : i % 3 == 1 ? follows<S>(*a, motion_a, *b, straight, error)
                                  : follows<S>(*b, straight, *a, motion_a, error);
    hits += hit;
    margins += hit && margin > 0;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(hits, cases / 5);
  EXPECT_GT(cases - hits, cases / 10);
  EXPECT_GT(margins, cases / 20);
}

TEST(OwnMotions, swingsMeetOnTime) { swingsMeetOnTime<double>(400, 1e-6); }
TEST(OwnMotions, floatSwingsMeetOnTime) { swingsMeetOnTime<float>(100, 1e-3f); }

TEST(OwnMotions, swingsMeetOtherGeometriesOnTime) {
  Random random(72);
  const int cases = std::max(15, scaledCount(150));  // few of them hit
  const fcl::Boxd box(3, 2, 2);
  int hits = 0;
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const PolygonShaped shape(tricover::Polygon({star(random, random.integer(3, 9), 0.5, 3)}));
    const SwingMotion<double> driven(anySwing<double>(random), radiusOf(shape.polygon()), 0.5);
    const SwingMotion<double> carried(anySwing<double>(random), std::hypot(1.5, 1), 0.5);
    const StaticMotion still(lifted(randomPose(random, 9), 0.5));
    hits += i % 3 == 0   ? follows<double>(shape, driven, box, carried, 1e-6)
            : i % 3 == 1 ? follows<double>(box, carried, shape, still, 1e-6)
                         : follows<double>(box, still, shape, driven, 1e-6);
    if (HasFailure()) return;
  }
  EXPECT_GT(hits, cases / 20);
  EXPECT_GT(cases - hits, cases / 10);
}

/// The planner's question: a robot on a spline, and one that waits.
TEST(OwnMotions, splinesMeetWhatStandsStill) {
  Random random(73);
  const int cases = scaledCount(300);
  int hits = 0;
  for (int i = 0; i < cases; ++i) {
    const auto polygon = [&] {
      return std::make_shared<PolygonShaped>(tricover::Polygon({star(random, random.integer(3, 9), 0.5, 3)}));
    };
    const auto vector = [&] { return fcl::Vector3d(random.real(-12, 12), random.real(-12, 12), 0); };
    const auto turn = [&] { return fcl::Vector3d(0, 0, random.real(-4, 4)); };
    const auto spline = std::make_shared<fcl::SplineMotion<double>>(vector(), vector(), vector(), vector(), turn(),
                                                                    turn(), turn(), turn());
    const fcl::Vector3d place = vector(), heading = turn();
    const auto waits =
        std::make_shared<StaticMotion>(lifted(tricover::support::turnedAndMoved(heading.z(), place.x(), place.y())));
    const auto rests =
        std::make_shared<fcl::SplineMotion<double>>(place, place, place, place, heading, heading, heading, heading);
    const fcl::ContinuousCollisionObjectd robot(polygon(), spline), other(polygon(), waits);
    const fcl::ContinuousCollisionObjectd same(
        std::const_pointer_cast<fcl::CollisionGeometryd>(other.collisionGeometry()), rests);
    fcl::ContinuousCollisionResultd result, swapped, of_splines;
    fcl::collide(&robot, &other, advancing(1e-6), result);
    fcl::collide(&other, &robot, advancing(1e-6), swapped);
    fcl::collide(&robot, &same, advancing(1e-6), of_splines);
    ASSERT_EQ(result.is_collide, of_splines.is_collide) << i;
    ASSERT_NEAR(result.time_of_contact, of_splines.time_of_contact, 1.1e-6) << i;
    ASSERT_EQ(result.time_of_contact, swapped.time_of_contact) << i;
    ASSERT_LE(waits->asked, 12) << "standing still is noticed";
    hits += result.is_collide;
  }
  EXPECT_GT(hits, cases / 20);
  EXPECT_GT(cases - hits, cases / 10);
}

const Shape<double> kSquare = rectangular(-0.5, -0.5, 0.5, 0.5);

TEST(OwnMotions, standingStillIsOneCollide) {
  const auto pose = [](double x) { return lifted(0, x, 0); };
  for (const double x : {0.5, 1.0, 1.5}) {
    const StaticMotion a(pose(0)), b(pose(x));
    fcl::ContinuousCollisionResultd result;
    const double time = fcl::continuousCollide<double>(kSquare.get(), &a, kSquare.get(), &b, advancing(1e-9), result);
    EXPECT_EQ(result.is_collide, x <= 1);
    EXPECT_EQ(time, x <= 1 ? 0 : 1);
    EXPECT_LE(a.asked + b.asked, 12);
  }
}

/// Straight on. Its bound is its speed in the direction that it is asked about: nothing is to spare.
class Straight : public OwnMotion<double> {
 public:
  Straight(const tricover::Pose& start, const tricover::Vec2& shift)
      : OwnMotion(0), inner_(lifted(start), lifted(tricover::Pose(Eigen::Translation2d(shift) * start))) {}
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>& visitor) const override {
    return visitor.visit(inner_);
  }
  bool integrate(double time) const override { return inner_.integrate(time); }
  void getCurrentTransform(fcl::Transform3d& pose) const override { inner_.getCurrentTransform(pose); }

 private:
  fcl::TranslationMotion<double> inner_;
};

/// A class of its own around one of FCL's, whose bound is that one's; counts how often it is asked.
template <class Inner>
class Handing : public OwnMotion<double> {
 public:
  explicit Handing(const Inner& inner) : OwnMotion(0), inner_(inner) {}
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>& visitor) const override {
    return visitor.visit(inner_);
  }
  bool integrate(double time) const override { return inner_.integrate(time) && ++asked > 0; }
  void getCurrentTransform(fcl::Transform3d& pose) const override { inner_.getCurrentTransform(pose); }

  mutable int asked = 0;

 private:
  Inner inner_;
};

/// A turn about a point of the moving frame, which goes straight on.
fcl::InterpMotion<double> turning(const tricover::Pose& begin, const tricover::Pose& end, const tricover::Vec2& about) {
  const fcl::Transform3d from = lifted(begin), to = lifted(end);
  return {from.linear(), from.translation(), to.linear(), to.translation(), fcl::Vector3d(about.x(), about.y(), 0)};
}

TEST(OwnMotions, narrowGapsTakeFewSteps) {
  const auto floor = rectangular(-3, -2, 3, 0);
  const auto triangle = shapeOf(tricover::Polygon({{{0, 0}, {1, 1}, {-0.5, 1}}}));
  const fcl::TranslationMotion<double> still(fcl::Transform3d::Identity(), fcl::Transform3d::Identity());
  for (double gap = 1e-3; gap > 1e-11; gap /= 10) {
    for (const double error : {1e-3, 1e-6, 1e-12}) {
      SCOPED_TRACE(testing::Message() << gap << ", " << error);
      const auto begin = [&](double heading, double x) { return tricover::support::turnedAndMoved(heading, x, gap); };
      fcl::ContinuousCollisionResultd result;

      const Handing sliding(fcl::TranslationMotion<double>(lifted(begin(0.1, -2)), lifted(begin(0.1, 2))));
      fcl::continuousCollide<double>(triangle.get(), &sliding, floor.get(), &still, advancing(error), result);
      EXPECT_FALSE(result.is_collide);
      EXPECT_LT(sliding.asked, 100);

      // It tips about the corner that nearly touches, until it lies on its side or stands on its other one.
      for (const double angle : {0.5, 2.0}) {
        const Handing tipping(turning(begin(0.1, 0.3), begin(0.1 + angle, 0.3), {0, 0}));
        const double time =
            fcl::continuousCollide<double>(triangle.get(), &tipping, floor.get(), &still, advancing(error), result);
        EXPECT_EQ(result.is_collide, angle > 1);
        EXPECT_LT(tipping.asked, 400);
        if (angle < 1) continue;
        tricover::Motion same;
        same.start = begin(0.1, 0.3);
        same.angle = angle;
        const auto impact = tricover::timeOfImpact(triangle->polygon(), same, floor->polygon(),
                                                   tricover::Motion::still(tricover::Pose::Identity()), {0, 1e-12});
        ASSERT_TRUE(impact);
        EXPECT_LE(time, impact->time + 1e-9);
        EXPECT_GE(time, impact->time - error - 1e-9);
      }
    }
  }
}

/// The same motion by FCL's class, which is known, and by one that is asked for its bounds alone.
TEST(OwnMotions, boundsAlongDirectionsMissNothing) {
  Random random(74);
  const int cases = scaledCount(600);
  int hits = 0;
  for (int i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    const auto shape = [&](double margin) {
      const tricover::Polygon polygon({star(random, random.integer(3, 40), 0.5, 3)});
      return std::make_shared<PolygonShaped>(polygon, PolygonOptions{margin, 0, 0});
    };
    const auto a = shape(random.coin() ? random.real(0, 1) : 0), b = shape(0);
    const auto pose = [&] { return randomPose(random, 7); };
    const auto inner_a = turning(pose(), pose(), {random.real(-9, 9), random.real(-9, 9)}),
               inner_b = turning(pose(), pose(), {0, 0});
    const Handing motion_a(inner_a), motion_b(inner_b);
    fcl::ContinuousCollisionResultd result, known;
    const double time = fcl::continuousCollide<double>(a.get(), &motion_a, b.get(), &motion_b, advancing(1e-6), result);
    const double expected =
        fcl::continuousCollide<double>(a.get(), &inner_a, b.get(), &inner_b, advancing(1e-9), known);
    if (result.is_collide != known.is_collide) {
      ASSERT_GT(expected, 1 - 1e-6);
    }
    ASSERT_LE(time, expected + 1e-9);
    ASSERT_GE(time, expected - 1.1e-6);
    hits += result.is_collide && time > 0;
  }
  EXPECT_GT(hits, cases / 5);
  EXPECT_LT(hits, cases * 4 / 5);
}

TEST(OwnMotions, tightBoundsAreNotPassed) {
  const auto wall = rectangular(8.5, -9, 9, 9);
  const auto time = [&](const fcl::MotionBase<double>& motion, const fcl::MotionBase<double>& of_wall) {
    fcl::ContinuousCollisionResultd result;
    return fcl::continuousCollide<double>(kSquare.get(), &motion, wall.get(), &of_wall, advancing(1e-7), result);
  };
  // Also between the directions that bounds are asked for.
  for (const double heading : {0.0, M_PI / 16, M_PI / 8, 1.0, 3.0}) {
    const tricover::Pose start = tricover::support::turnedAndMoved(heading, 0, 0);
    const double contact = time(Straight(start, start * tricover::Vec2(16, 0)), StaticMotion(lifted(start)));
    EXPECT_LE(contact, 0.5 + 1e-12) << heading;
    EXPECT_NEAR(contact, 0.5, 2e-7) << heading;
  }
  // 10 t^3, beside a wall that slides along itself.
  const fcl::Vector3d here = fcl::Vector3d::Zero();
  const fcl::SplineMotion<double> faster(here, here, here, fcl::Vector3d(60, 0, 0), here, here, here, here);
  const double contact = time(faster, Straight(tricover::Pose::Identity(), {0, 1e-3}));
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
  double computeMotionBound(const fcl::BVMotionBoundVisitor<double>&) const override {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

/// Rises as it goes.
class Rising : public SwingMotion<double> {
 public:
  using SwingMotion::SwingMotion;
  bool integrate(double time) const override {
    rise_ = time;
    return SwingMotion::integrate(time);
  }
  void getCurrentTransform(fcl::Transform3d& pose) const override {
    SwingMotion::getCurrentTransform(pose);
    pose.translation().z() += rise_;
  }

 private:
  mutable double rise_ = 0;
};

TEST(OwnMotions, whatCannotBeAnsweredThrows) {
  const Swing<double> swing{{2, 0}, {1, 1}, 1, 0, 0, 0.1};
  const StaticMotion still(lifted(0, 0, 0));
  const auto ask = [&](const fcl::MotionBase<double>& motion, double error = 1e-9) {
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(kSquare.get(), &still, kSquare.get(), &motion, advancing(error), result);
  };
  EXPECT_NO_THROW(ask(SwingMotion<double>(swing, 1)));
  const std::string visits = thrownBy<std::logic_error>([&] { ask(Visiting(swing, 1)); });
  EXPECT_NE(visits.find("motion_b"), std::string::npos) << visits;
  EXPECT_NE(visits.find("Visiting"), std::string::npos) << visits;
  const std::string boundless = thrownBy<std::logic_error>([&] { ask(Boundless(swing, 1)); });
  EXPECT_NE(boundless.find("Boundless is not finite"), std::string::npos) << boundless;
  const std::string rising = thrownBy<std::invalid_argument>([&] { ask(Rising(swing, 1)); });
  EXPECT_NE(rising.find("motion_b: it leaves"), std::string::npos) << rising;
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(ask(SwingMotion<double>(swing, 1), bad), std::invalid_argument);

  // A halfspace that swings has no bound of its speed; one that stands still has.
  const fcl::Halfspaced halfspace(fcl::Vector3d::UnitX(), 0.75);
  fcl::ContinuousCollisionResultd result;
  const SwingMotion<double> moves(swing, 1);
  EXPECT_NE(thrownBy<std::logic_error>([&] {
              fcl::continuousCollide<double>(kSquare.get(), &still, &halfspace, &moves, advancing(1e-6), result);
            }).find("motion_b: what has no end"),
            std::string::npos);
  fcl::continuousCollide<double>(kSquare.get(), &moves, &halfspace, &still, advancing(1e-6), result);
  EXPECT_FALSE(result.is_collide);
}

/// A bound that knows no direction, beside a wall at a distance of 1e-9, takes 1e9 steps: the search ends before, with
/// a time until which nothing is met.
TEST(OwnMotion, aSearchEndsWithALowerBound) {
  const Swing<double> still{{0, 0}, {0, 0}, 1, 0, 0, 0}, along{{1 + 1e-9, 0}, {0, 1}, 1, 0, 0, 0};
  const Shape<double> wall = rectangular(-1, -9, 0, 9), square = rectangular(-1, -1, 1, 1);
  const SwingMotion<double> moving(along, 2);
  const StaticMotion standing(lifted(still.at(0)));
  fcl::ContinuousCollisionResultd result;
  const double time =
      tricover_fcl::continuousCollide<double>(square.get(), &moving, wall.get(), &standing, advancing(1e-3), result);
  EXPECT_TRUE(result.is_collide);
  EXPECT_GT(time, 0);
  EXPECT_LT(time, 1e-3);
}

}  // namespace
}  // namespace tricover_fcl::test
