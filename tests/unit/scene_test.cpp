// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "shapes.h"
#include "tricover/polygon.h"
#include "tricover/prepare.h"

namespace tricover::support {
namespace {

const Polygon kSquare({rectangle(-1, -1, 1, 1)});

Pose at(double x, double y = 0) { return turnedAndMoved(0, x, y); }

TEST(Scene, ReportsWhatCollidesAndWhatBeganAndEnded) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(2)), c = scene.add(kSquare, at(4.5));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}}));  // they touch
  EXPECT_EQ(scene.began(), (std::vector<BodyPair>{{a, b}}));
  EXPECT_TRUE(scene.ended().empty());

  scene.move(b, at(2.5));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{b, c}}));
  EXPECT_EQ(scene.began(), (std::vector<BodyPair>{{b, c}}));
  EXPECT_EQ(scene.ended(), (std::vector<BodyPair>{{a, b}}));

  EXPECT_EQ(scene.collisions().size(), 1u);
  EXPECT_TRUE(scene.began().empty());
  EXPECT_TRUE(scene.ended().empty());

  scene.remove(c);
  const Scene::Body d = scene.add(kSquare, at(2.5, 1));
  EXPECT_NE(Scene::indexOf(d), Scene::indexOf(c));  // of which something is left to report
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{b, d}}));
  EXPECT_EQ(scene.ended(), (std::vector<BodyPair>{{b, c}}));
  EXPECT_EQ(Scene::indexOf(scene.add(kSquare, at(100))), Scene::indexOf(c));
  EXPECT_EQ(scene.size(), 4u);
}

TEST(Scene, AddsMarginsUp) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0), {0.25}), b = scene.add(kSquare, at(2.5), {0.25});
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}}));
  scene.move(b, at(nudged(2.5, 1)));
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_TRUE(scene.collides(kSquare, at(-2.75), {0.5}));
  EXPECT_FALSE(scene.collides(kSquare, at(nudged(-2.75, -1)), {0.5}));
  EXPECT_EQ(scene.nearest(kSquare, at(-3))->result.distance, 0.75);
  EXPECT_EQ(scene.nearest(kSquare, at(-3))->body, a);
}

TEST(Scene, AsksCategoriesAndMasks) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(0), {0, 2}),
                    c = scene.add(kSquare, at(0), {0, 4, 1});
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}, {a, c}}));
  EXPECT_EQ(scene.colliding(kSquare, at(0)), (std::vector<Scene::Body>{a, b, c}));
  EXPECT_EQ(scene.colliding(kSquare, at(0), {}, 2 | 4), (std::vector<Scene::Body>{b, c}));
  EXPECT_FALSE(scene.collides(kSquare, at(0), {}, 8));
  EXPECT_FALSE(scene.nearest(kSquare, at(0), {}, 8));
}

TEST(Scene, CastsRaysAtWhatIsFirst) {
  Scene scene;
  const Scene::Body far = scene.add(kSquare, at(9)), near = scene.add(kSquare, at(5)),
                    disc = scene.add(Polygon::point({0, 0}), at(2), {0.5, 2});
  const auto hit = scene.castRay({0, 0}, {10, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->body, disc);
  EXPECT_NEAR(hit->hit.fraction, 0.15, 1e-13);
  EXPECT_NEAR((hit->hit.normal - Vec2(-1, 0)).norm(), 0, 1e-13);
  constexpr double kLargest = std::numeric_limits<double>::max();
  const std::tuple<Vec2, Vec2, unsigned, Scene::Body, double> hits[] = {
      {{0, 0}, {10, 0}, 1, near, 0.4},
      {{10, 2}, {10, 1}, 3, far, 1},  // a vertex
      {{2, 0.25}, {2, 9}, 3, disc, 0},
      {{kLargest, 0.25}, {-kLargest, 0.25}, 1, far, 0.5},
      {{kLargest, 0.25}, {-kLargest, 0.25}, 2, disc, 0.5},
  };
  for (const auto& [from, to, mask, body, fraction] : hits) {
    const auto found = scene.castRay(from, to, {}, mask);
    ASSERT_TRUE(found) << from << " " << to;
    EXPECT_EQ(found->body, body) << from << " " << to;
    EXPECT_NEAR(found->hit.fraction, fraction, std::abs(from.x()) > 10 ? 1e-9 : 0) << from << " " << to;
    EXPECT_EQ(found->hit.edge < 0, fraction == 0) << from << " " << to;
  }
  EXPECT_FALSE(scene.castRay({10, 2}, {nudged(10, 1), 1}));
  EXPECT_FALSE(scene.castRay({0, 9}, {9, 9}));
  // Of two at the same place, the one that came first.
  scene.add(kSquare, at(5));
  EXPECT_EQ(scene.castRay({0, 0}, {10, 0}, {}, 1)->body, near);
  EXPECT_THROW(scene.castRay({0, 0}, {std::numeric_limits<double>::infinity(), 0}), std::invalid_argument);
}

/// Frames within frames, 1 apart and 0.5 wide: discs tell of all of them that they may meet what is inside.
TEST(Scene, AsksBodiesWhoseDiscsDecideNothing) {
  Scene scene;
  for (int i = 1; i <= 40; ++i) {
    const double r = i + 0.5;
    scene.add(Polygon({rectangle(-r, -r, r, r), rectangle(-i, -i, i, i)}), at(0));
  }
  const Polygon dot({rectangle(-0.125, -0.125, 0.125, 0.125)});
  for (int i = 1; i <= 40; ++i) {
    EXPECT_TRUE(scene.collides(dot, at(i + 0.25))) << i;
    EXPECT_TRUE(scene.collides(dot, turnedAndMoved(0, 0, -(i + 0.625)))) << i;  // touches
    EXPECT_FALSE(scene.collides(dot, at(i + 0.75, i / 2.0))) << i;
  }
  for (Scene::Body body = 0; body < 40; ++body) scene.remove(body);
  EXPECT_FALSE(scene.collides(dot, at(1.25)));
}

/// A point collides where it is in the interior, also where touching is allowed; on the border it doesn't.
TEST(Scene, PointsCollideInsideWhereTouchingIsAllowed) {
  const Polygon square({rectangle(-1, -1, 1, 1)}), dot = Polygon::point({0.125, 0.25});
  prepare(square);
  const CollideOptions open{0, 0, Touching::Allowed};
  Scene scene;
  const Scene::Body body = scene.add(square, at(0));
  for (const double x : {0.0, 0.875}) {
    EXPECT_EQ(collide(dot, at(x), square, at(0), open), x == 0);
    EXPECT_EQ(scene.collides(dot, at(x), open), x == 0);
    EXPECT_EQ(scene.colliding(dot, at(x), open).empty(), x > 0);
    EXPECT_EQ(scene.anyColliding(dot, at(x)), body);
  }
}

TEST(Scene, MeetsWhatLiesWithinAndFarFromTheLargestDisc) {
  // A sickle, and something of many edges, too, in its slim end.
  Ring sickle, bean;
  for (int i = 0; i <= 20; ++i) sickle.push_back({10 * std::cos(0.3 * i), 10 * std::sin(0.3 * i)});
  for (int i = 20; i >= 0; --i) sickle.push_back({1 + 8 * std::cos(0.3 * i), 8 * std::sin(0.3 * i)});
  for (int i = 0; i < 20; ++i) bean.push_back({0.3 * std::cos(0.3 * i), 0.2 * std::sin(0.3 * i)});
  const Polygon outer({sickle}), inner({bean});
  prepare(outer), prepare(inner);
  Scene outside, inside;
  outside.add(outer, at(0));
  inside.add(inner, at(9.5, 0.6));
  EXPECT_TRUE(outside.collides(inner, at(9.5, 0.6)));
  EXPECT_TRUE(inside.collides(outer, at(0)));
  EXPECT_FALSE(outside.collides(inner, at(5)));
  EXPECT_FALSE(inside.collides(outer, at(4.5, 0.6)));
}

/// Two bodies whose distances differ by an ulp that rounding makes: whichever comes first, the nearest is the one that
/// distance() says.
TEST(Scene, NearestIsNoMatterOfWhoComesFirst) {
  const Polygon square({rectangle(0, 0, 1, 1)});
  const Pose asked = Pose::Identity();
  const DistanceOptions options{1.25};
  const Pose nearer = turnedAndMoved(38 * 0.1, std::nextafter(18.0, 0.0), 15),
             farther = turnedAndMoved(38 * 0.1, 18, 15);
  const double least = distance(square, asked, square, nearer, options).distance;
  ASSERT_LT(least, distance(square, asked, square, farther, options).distance);
  for (const bool first : {false, true}) {
    Scene scene;
    const Scene::Body one = scene.add(square, first ? nearer : farther),
                      other = scene.add(square, first ? farther : nearer), expected = first ? one : other;
    const std::optional<BodyDistance> found = scene.nearest(square, asked, options);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->body, expected);
    EXPECT_EQ(found->result.distance, least);
    EXPECT_EQ(scene.nearestK(square, asked, 1, 100, options).front().body, expected);
  }
}

TEST(Scene, OfNothing) {
  Scene scene;
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_FALSE(scene.collides(kSquare, at(0)));
  EXPECT_FALSE(scene.nearest(kSquare, at(0)));
  EXPECT_FALSE(scene.firstImpact(kSquare, Motion()));
  EXPECT_TRUE(scene.impacts(std::vector<BodyMotion>()).empty());
  EXPECT_TRUE(scene.impacts(std::vector<BodyTrajectory>()).empty());
  EXPECT_FALSE(scene.castRay({0, 0}, {1, 0}));
  const Scene::Body a = scene.add(kSquare, at(0));
  scene.remove(a);
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_FALSE(scene.collides(kSquare, at(0)));
}

/// Up and back again: where it begins and ends says nothing of where it was.
TEST(Scene, FollowsWaysThatBend) {
  const Polygon beam({rectangle(-20, -1, 20, 1)});
  Scene scene;
  const Scene::Body post = scene.add(Polygon({rectangle(-1, 2.5, 1, 4)}), at(0)), moving = scene.add(beam, at(0, -50));
  Motion motion = Motion::translation(at(0), {0, 8});
  motion.shift_2 = {0, -8};
  const double time = 0.25;  // 8 t - 8 t^2 = 1.5
  const auto first = scene.firstImpact(beam, motion);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->body, post);
  EXPECT_NEAR(first->impact.time, time, 1e-5);
  const auto all = scene.impacts({{moving, motion}});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(all[0].impact.time, time, 1e-5);
}

/// All of it within what is one interval of the others' time.
TEST(Scene, FindsTheImpactsOfADashBetweenLongWaits) {
  Scene scene;
  const auto here = at(0);
  const Scene::Body moving = scene.add(kSquare, here), post = scene.add(kSquare, at(60));
  const Trajectory way = Trajectory::through({{0, here}, {500, here}, {501, at(90)}, {502, here}, {1000, here}});
  const auto impacts = scene.impacts({{moving, way}});
  ASSERT_EQ(impacts.size(), 1u);
  EXPECT_EQ(impacts[0].pair, (BodyPair{moving, post}));
  EXPECT_NEAR(impacts[0].impact.time, 500 + 58 / 90.0, 1e-5);
  EXPECT_EQ(scene.conflicts({{moving, way}}).size(), 2u);
  EXPECT_EQ(scene.firstImpact(kSquare, way, {}, BodyFilter::allBut(moving))->impact.time, impacts[0].impact.time);
}

/// The first body to be near is not the first to be hit.
TEST(Scene, LooksOnAfterAnImpactThatIsLater) {
  Scene scene;
  scene.add(Polygon({{{-5, -4}, {100, -4}, {100, 9}, {95, 9}, {95, -3}, {-5, -3}}}), at(0));
  const Scene::Body first = scene.add(kSquare, at(50));
  const auto impact = scene.firstImpact(kSquare, Motion::translation(at(0), {98, 0}));
  ASSERT_TRUE(impact);
  EXPECT_EQ(impact->body, first);
}

/// Margins of the ray and of the body add up: as if the body had both.
TEST(Scene, CastsRaysWithMargins) {
  Scene scene, wider;
  scene.add(kSquare, at(20, 0.5), {0.25});
  wider.add(kSquare, at(20, 0.5), {0.75});
  for (const Vec2& to : {Vec2(40, 0), Vec2(40, 1), Vec2(40, 4), Vec2(19, 0), Vec2(19, 0.5)}) {
    const auto hit = scene.castRay({0, 0}, to, {0.5}), expected = wider.castRay({0, 0}, to);
    const auto alone = castRay(kSquare, at(20, 0.5), {0, 0}, to, {0.75});
    ASSERT_TRUE(hit.has_value() == alone.has_value() && expected.has_value() == alone.has_value()) << to.transpose();
    if (!hit) continue;
    EXPECT_EQ(hit->hit.fraction, alone->fraction);
    EXPECT_EQ(expected->hit.fraction, alone->fraction);
  }
  // Beyond the box of the body, within the ray's margin alone.
  EXPECT_TRUE(scene.castRay({20, 10}, {20, 2.4}, {1.5}));
  EXPECT_THROW(scene.castRay({0, 0}, {1, 0}, {-1}), std::invalid_argument);
}

/// Two that approach, one faster than its share of the gap lets it: in every frame the answer is collide()'s.
void expectEveryFrameOfTwo(Scene& scene, const Vec2& step_p, const Vec2& step_q, int frames) {
  const CollideOptions options{scene.options(0).margin + scene.options(1).margin};
  int hits = 0;
  EXPECT_TRUE(scene.collisions().empty());
  for (int frame = 0; frame < frames; ++frame) {
    for (const Scene::Body body : {0u, 1u}) {
      Pose next = scene.pose(body);
      next.translation() += body == 0 ? step_p : step_q;
      scene.move(body, next);
    }
    const bool hit = collide(scene.polygon(0), scene.pose(0), scene.polygon(1), scene.pose(1), options);
    ASSERT_EQ(!scene.collisions().empty(), hit) << "frame " << frame;
    hits += hit;
  }
  EXPECT_GT(hits, 0);
  EXPECT_LT(hits, frames);
}

TEST(Scene, SharesTheGapOfTwo) {
  const Polygon disc({regular(64, 1)});
  const Vec2 slow(0.02, 0.02), fast(0.05, 0.05);
  for (const bool first_is_fast : {false, true}) {
    Scene scene;
    scene.add(disc, at(0));
    scene.add(disc, at(1.8, 1.8));  // their boxes meet, at rest
    expectEveryFrameOfTwo(scene, first_is_fast ? fast : slow, first_is_fast ? Vec2(-slow) : Vec2(-fast), 7);
  }
  Scene scene;  // what margins leave of it
  scene.add(disc, at(0), {0.5});
  scene.add(disc, at(3.2), {0.5});
  expectEveryFrameOfTwo(scene, {0.05, 0}, {-0.05, 0}, 4);
}

}  // namespace
}  // namespace tricover::support
