// SPDX-License-Identifier: BSD-3-Clause
// Bodies that come, go, are copied and moved with their scene; and of a size, or as far away, that sums of coordinates
// overflow.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "refusal.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

const Polygon kSquare({rectangle(-1, -1, 1, 1)});

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Pose at(double x, double y = 0) { return turnedAndMoved(0, x, y); }

TEST(Scene, RefusesDeadHandlesAndBadNumbersAndStaysAsItWas) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(1));
  scene.remove(a);
  EXPECT_THROW(scene.pose(7), std::out_of_range);
  const Pose bad = at(std::nan(""));
  EXPECT_THROW(scene.move(b, bad), std::invalid_argument);
  EXPECT_THROW(scene.add(kSquare, bad), std::invalid_argument);
  EXPECT_THROW(scene.add(kSquare, at(0), {-kInfinity}), std::invalid_argument);
  EXPECT_THROW(scene.add({{kSquare, at(0), {}}, {kSquare, at(0), {-kInfinity}}}), std::invalid_argument);
  EXPECT_THROW(scene.impacts({{b, Motion()}, {b, Motion()}}), std::invalid_argument);
  EXPECT_EQ(scene.size(), 1u);
  EXPECT_EQ(scene.pose(b).translation().x(), 1);
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(refusal<std::out_of_range>([&] { scene.remove(5); }), "tricover: body: the scene has none of the handle 5");
}

TEST(Scene, GivesSlotsAgain) {
  Scene scene;
  std::vector<Scene::Body> bodies;
  for (int i = 0; i < 300; ++i) bodies.push_back(scene.add(kSquare, at(3 * i)));
  for (int round = 0; round < 3; ++round) {
    for (const Scene::Body body : bodies) scene.remove(body);
    EXPECT_EQ(scene.size(), 0u);
    bodies.clear();
    for (int i = 0; i < 300; ++i) bodies.push_back(scene.add(kSquare, at(1.5 * i)));
    for (const Scene::Body body : bodies) EXPECT_LT(Scene::indexOf(body), 600u);
    EXPECT_EQ(scene.collisions().size(), 299u);
  }
}

TEST(Scene, MovesABodyTwiceAtOnce) {
  Scene scene;
  const Scene::Body still = scene.add(kSquare, at(50)), moving = scene.add(kSquare, at(0));
  for (int i = 1; i < 20; ++i) {  // its box has room for such steps by then
    scene.move({{moving, at(0.01 * i)}});
    EXPECT_TRUE(scene.collisions().empty());
  }
  scene.move({{moving, at(0.2)}, {moving, at(49)}});
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{still, moving}}));
  scene.move({{moving, at(49.01)}, {moving, at(0.2)}});
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(scene.pose(moving).translation().x(), 0.2);
  for (int i = 1; i < 20; ++i) scene.move({{moving, at(0.2 + 0.01 * i)}});
  scene.move({{moving, at(49)}, {moving, at(0.4)}});  // the second one alone is within its box
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(scene.pose(moving).translation().x(), 0.4);
}

TEST(Scene, KnowsWhatWasMovedWhenTheUsersThreadsFail) {
  constexpr int kPairs = 600;
  Scene scene;
  std::vector<BodyPose> poses;
  for (int i = 0; i < 2 * kPairs; ++i) {
    const Pose at = turnedAndMoved(0, 10 * (i / 2) + 2.45 * (i % 2), 0);
    poses.push_back({scene.add(kSquare, at), at});
  }
  const auto approach = [&](const Parallel& parallel) {
    for (std::size_t i = 1; i < poses.size(); i += 2) poses[i].pose.translation().x() -= 0.1;
    scene.move(poses, parallel);
  };
  for (int i = 0; i < 4; ++i) {
    approach({});
    EXPECT_TRUE(scene.collisions().empty());
  }
  int calls = 0;
  const Parallel failing = [&](std::size_t count, const std::function<void(std::size_t)>& task) {
    const bool fails = ++calls == 2;  // the first one checks
    for (std::size_t i = 0; i < (fails ? count / 2 : count); ++i) task(i);
    if (fails) throw std::runtime_error("no more threads");
  };
  EXPECT_THROW(approach(failing), std::runtime_error);
  std::size_t moved = 0;
  for (const BodyPose& move : poses) moved += scene.pose(move.body).translation() == move.pose.translation() ? 1 : 0;
  const std::size_t pairs = moved - kPairs;  // the others stay where they are in any case
  EXPECT_GT(pairs, 0u);
  EXPECT_LT(pairs, std::size_t{kPairs});
  EXPECT_EQ(scene.collisions().size(), pairs);
}

TEST(Scene, IsCopied) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(0.5));
  EXPECT_EQ(scene.collisions().size(), 1u);
  Scene branch(scene);
  branch.move(b, at(5));
  EXPECT_EQ(branch.collisions().size(), 0u);
  EXPECT_EQ(branch.ended(), (std::vector<BodyPair>{{a, b}}));
  EXPECT_EQ(scene.collisions().size(), 1u);
  EXPECT_TRUE(branch.collides(kSquare, at(5.2)));
  EXPECT_FALSE(scene.collides(kSquare, at(5.2)));
  const Scene::Body c = branch.add(kSquare, at(9));
  EXPECT_EQ(branch.bodies(), (std::vector<Scene::Body>{a, b, c}));
  EXPECT_EQ(scene.bodies(), (std::vector<Scene::Body>{a, b}));
  scene = branch;
  EXPECT_EQ(scene.size(), 3u);
  EXPECT_TRUE(scene.collides(kSquare, at(9)));
}

TEST(Scene, SaysWhichOfManyPosesIsWrong) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(5));
  Pose bad = at(1);
  bad.linear() *= 2;
  const std::string start = "tricover: poses[1]: ";
  const std::vector<Pose> poses{at(0), bad};
  EXPECT_EQ(refusal([&] { scene.collides(kSquare, poses); }).substr(0, start.size()), start);
  EXPECT_EQ(refusal([&] { scene.move({{a, at(7)}, {b, bad}}); }).substr(0, start.size()), start);
  EXPECT_THROW(scene.move({{a, at(7)}, {b + 1, bad}}), std::out_of_range);
  EXPECT_EQ(scene.pose(a).translation().x(), 0);
}

TEST(Scene, IgnoredPairsAreInNoResult) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(1)), c = scene.add(kSquare, at(1, 1));
  const std::vector<BodyPair> all{{a, b}, {a, c}, {b, c}}, others{{a, c}, {b, c}};
  EXPECT_EQ(scene.collisions(), all);
  scene.setIgnored(b, a);
  scene.setIgnored(a, b);  // twice is once
  EXPECT_EQ(scene.collisions(), others);
  EXPECT_EQ(scene.ended(), (std::vector<BodyPair>{{a, b}}));
  const std::vector<BodyMotion> moves{{a, Motion::translation(at(0), {0, 0.5})}};
  EXPECT_EQ(scene.impacts(moves).size(), 1u);
  EXPECT_EQ(scene.conflicts(moves).size(), 1u);
  for (const PairContact& found : scene.contacts()) EXPECT_NE(found.pair, (BodyPair{a, b}));
  EXPECT_EQ(scene.colliding(kSquare, at(0)).size(), 3u);  // a query is of no body

  // A copy has it, too, and goes its own way.
  Scene copy(scene);
  copy.setIgnored(a, b, false);
  EXPECT_EQ(copy.collisions(), all);
  EXPECT_EQ(copy.began(), (std::vector<BodyPair>{{a, b}}));
  EXPECT_EQ(scene.collisions(), others);

  // It ends with either body, whoever takes the place.
  scene.move(b, at(50));
  scene.remove(a);
  scene.collisions();
  const Scene::Body d = scene.add(kSquare, at(50));
  EXPECT_EQ(Scene::indexOf(d), Scene::indexOf(a));
  EXPECT_FALSE(scene.isIgnored(b, d));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{b, d}}));
}

TEST(Scene, ContactsAreThoseOfAllPairs) {
  Scene scene;
  const Polygon u({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  const Scene::Body below = scene.add(u, at(0)), bar = scene.add(Polygon::box(4, 1), at(1.5, 2.25));
  scene.add(kSquare, at(50));
  BodyOptions padded;
  padded.margin = 0.5;
  const Scene::Body near = scene.add(Polygon::box(4, 1), at(1.5, 3.5), padded);  // 0.25 from the bar
  const std::vector<PairContact> found = scene.contacts();
  ASSERT_EQ(found.size(), 3u);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(found[i].pair, (BodyPair{below, bar}));
    EXPECT_EQ(found[i].contact.depth, 0.25);
  }
  EXPECT_NE(found[0].contact.point.x(), found[1].contact.point.x());
  EXPECT_EQ(found[2].pair, (BodyPair{bar, near}));
  EXPECT_EQ(found[2].contact.depth, 0.25);
  EXPECT_EQ(scene.collisions().size(), 2u);
  EXPECT_TRUE(scene.began().empty());  // contacts() has asked
  scene.setOptions(near, {-0.5});
  EXPECT_EQ(scene.contacts(ContactDetail::Points).size(), 2u);
}

TEST(Scene, LeastDistanceIsThatOfTheNearestBody) {
  Scene scene;
  EXPECT_FALSE(scene.leastDistance(kSquare, Motion::still(at(0))));
  EXPECT_THROW(scene.leastDistance(kSquare, Motion::still(at(0)), {0, -1}), std::invalid_argument);
  const Scene::Body a = scene.add(kSquare, at(10, 4)), b = scene.add(kSquare, at(20, -3.5), {0.25});
  scene.add(kSquare, at(30, 8));
  const Motion way = Motion::translation(at(0), {40, 0});
  LeastDistanceOptions options;
  options.absolute_error = 1e-9;
  auto found = scene.leastDistance(kSquare, way, options);
  EXPECT_EQ(found->body, b);
  EXPECT_NEAR(found->least.distance, 1.25, 1e-9);
  EXPECT_GE(found->least.lower_bound, 1.25 - 3e-9);
  EXPECT_LE(found->least.lower_bound, 1.25);
  EXPECT_EQ(scene.leastDistance(kSquare, way, options, BodyFilter::allBut(b))->body, a);
  EXPECT_FALSE(scene.leastDistance(kSquare, way, options, BodyFilter(2)));
  options.margin = 1.5;
  EXPECT_EQ(scene.leastDistance(kSquare, way, options)->least.distance, 0);
  // By the clock: it waits, and is there no longer when it would be near.
  const auto waits = Trajectory::through({{5, at(0)}, {9, at(0)}, {10, at(1)}}).vanishing();
  found = scene.leastDistance(kSquare, waits);
  EXPECT_EQ(found->body, a);
  EXPECT_EQ(found->least.time, 10);
  EXPECT_THROW(scene.leastDistance(kSquare, Trajectory(at(0))), std::invalid_argument);
}

TEST(Scene, VisitsEndWhenTheyAreTold) {
  Scene scene;
  for (int i = 0; i < 20; ++i) scene.add(kSquare, at(0.01 * i));
  std::vector<Scene::Body> met;
  const auto visit = [&](Scene::Body body) {
    met.push_back(body);
    return true;
  };
  scene.visitColliding(kSquare, at(0), visit);
  std::sort(met.begin(), met.end());
  EXPECT_EQ(met, scene.colliding(kSquare, at(0)));
  int count = 0;
  scene.visitColliding(kSquare, at(0), [&](Scene::Body) { return ++count < 3; });
  EXPECT_EQ(count, 3);
  EXPECT_NE(refusal([&] { scene.visitColliding(kSquare, at(0), nullptr); }).find("visit"), std::string::npos);
}

TEST(Scene, StaleHandlesAreErrorsAndNeverAnotherBody) {
  Scene scene;
  std::vector<Scene::Body> gone;
  const Scene::Body stays = scene.add(kSquare, at(0));
  for (int i = 0; i < 5; ++i) {
    const Scene::Body body = scene.add(kSquare, at(0.5));
    EXPECT_EQ(Scene::indexOf(body), 1u);
    EXPECT_EQ(scene.bodies(), (std::vector<Scene::Body>{stays, body}));
    EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{stays, body}}));
    EXPECT_EQ(scene.colliding(kSquare, at(0)), (std::vector<Scene::Body>{stays, body}));
    EXPECT_EQ(scene.colliding(kSquare, at(0), {}, BodyFilter::allBut(stays)), (std::vector<Scene::Body>{body}));
    for (const Scene::Body old : gone) {
      EXPECT_FALSE(scene.contains(old));
      EXPECT_THROW(scene.remove(old), std::out_of_range);
      EXPECT_THROW(scene.pose(old), std::out_of_range);
      EXPECT_THROW(scene.move(old, at(0)), std::out_of_range);
      EXPECT_THROW(scene.move({{old, at(0)}}), std::out_of_range);
      EXPECT_THROW(scene.setOptions(old, {}), std::out_of_range);
      EXPECT_THROW(scene.impacts({{old, Motion()}}), std::out_of_range);
      EXPECT_THROW(scene.collides(kSquare, at(0), {}, BodyFilter::allBut(old)), std::out_of_range);
    }
    scene.remove(body);
    gone.push_back(body);
    EXPECT_TRUE(scene.collisions().empty());
    EXPECT_EQ(scene.ended(), (std::vector<BodyPair>{{stays, body}}));
  }
}

/// A handle in the place of a mask would select bodies by its low bits. See also handle_as_mask.cpp.
TEST(Scene, HandlesAreNoMasks) {
  static_assert(!std::is_convertible_v<Scene::Body, BodyFilter> && !std::is_constructible_v<BodyFilter, Scene::Body>);
  static_assert(!std::is_constructible_v<BodyFilter, Scene::Body, Scene::Body>);
  static_assert(!std::is_convertible_v<std::size_t, BodyFilter> && !std::is_convertible_v<long long, BodyFilter>);
  static_assert(std::is_convertible_v<int, BodyFilter> && std::is_convertible_v<unsigned, BodyFilter>);
  static_assert(std::is_convertible_v<std::uint8_t, BodyFilter> &&
                std::is_constructible_v<BodyFilter, int, Scene::Body>);
  Scene scene;
  const Scene::Body me = scene.add(kSquare, at(0)), other = scene.add(kSquare, at(1));
  EXPECT_EQ(scene.anyColliding(kSquare, scene.pose(me), {}, BodyFilter::allBut(me)), other);
  EXPECT_TRUE(scene.collides(kSquare, scene.pose(me), {}, 1));
  EXPECT_FALSE(scene.collides(kSquare, scene.pose(me), {}, 2u));
  EXPECT_EQ(scene.anyColliding(kSquare, scene.pose(me), {}, {1, me}), other);
}

TEST(Scene, OptionsChangeInPlace) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(0)), b = scene.add(kSquare, at(3));
  EXPECT_TRUE(scene.collisions().empty());
  BodyOptions wide{2};
  scene.setOptions(a, wide);
  EXPECT_TRUE(scene.collides(kSquare, at(-2.5)));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}}));
  EXPECT_EQ(scene.began(), (std::vector<BodyPair>{{a, b}}));
  wide.margin = 2.5;  // it goes on
  scene.setOptions(a, wide);
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}}));
  EXPECT_TRUE(scene.began().empty() && scene.ended().empty());
  wide.mask = 2;  // not what b is
  scene.setOptions(a, wide);
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(scene.ended(), (std::vector<BodyPair>{{a, b}}));
  scene.setOptions(a, {});
  EXPECT_TRUE(scene.collisions().empty() && scene.ended().empty());
  wide.margin = -kInfinity;
  EXPECT_THROW(scene.setOptions(a, wide), std::invalid_argument);
  EXPECT_EQ(scene.options(a).margin, 0);
}

TEST(Scene, IsEmptyWhenMovedFrom) {
  Scene scene;
  const Scene::Body body = scene.add(kSquare, at(0));
  Scene moved(std::move(scene));
  EXPECT_TRUE(moved.collides(kSquare, moved.pose(body)));
  EXPECT_EQ(scene.size(), 0u);  // NOLINT
  EXPECT_FALSE(scene.collides(kSquare, at(0)));
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_THROW(scene.remove(body), std::out_of_range);
  scene.add(kSquare, at(5));
  scene = std::move(moved);
  EXPECT_TRUE(scene.contains(body));
  EXPECT_EQ(scene.size(), 1u);
  EXPECT_EQ(moved.size(), 0u);  // NOLINT
  moved.add(kSquare, at(1));
  EXPECT_EQ(moved.size(), 1u);
}

/// Bodies that overflow have boxes without ends. Their boxes meet every body, but they themselves don't.
TEST(Scene, MeetsWhatOverflows) {
  const Polygon spike({{{-1, -1}, {1, -1}, {0, 1e308}}});
  const Pose turned = pose(0, 1, 5, 1, 0, 0);
  Scene scene;
  const Scene::Body a = scene.add(kSquare, at(5)), b = scene.add(kSquare, at(9, 9));
  EXPECT_EQ(scene.colliding(spike, turned), (std::vector<Scene::Body>{a}));
  const Scene::Body c = scene.add(spike, turned);
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, c}}));
  scene.remove(a);
  EXPECT_TRUE(scene.colliding(spike, at(-5)).empty());
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(scene.colliding(kSquare, at(8, 8)), (std::vector<Scene::Body>{b}));
}

/// On its way into the world a coordinate overflows that comes back: its box must not stay at infinity.
TEST(Scene, MeetsWhatComesBackFromBeyondTheLargestDouble) {
  const Polygon corner({rectangle(1.69e308, 1.69e308, 1.7e308, 1.7e308)}),
      here({rectangle(0.6e308, -1e307, 0.8e308, 1e307)});
  Scene scene;
  const Scene::Body right = scene.add(corner, turnedAndMoved(-M_PI / 4, -1.7e308, 0));
  EXPECT_EQ(scene.colliding(here, at(0)), std::vector<Scene::Body>{right});
  scene.remove(right);
  const Scene::Body up = scene.add(corner, turnedAndMoved(M_PI / 4, 0, -1.7e308));
  EXPECT_EQ(scene.colliding(here, turnedAndMoved(M_PI / 2, 0, 0)), std::vector<Scene::Body>{up});
}

TEST(Scene, OfAPolygonThatIsTooLargeForItsBoxes) {
  const Polygon huge({rectangle(-1.7e308, -1.7e308, 1.7e308, 1.7e308)}),
      far({rectangle(1.6e308, 1.6e308, 1.65e308, 1.65e308)});
  Scene scene;
  scene.add(huge, at(0));
  scene.add(far, at(0));
  EXPECT_EQ(scene.collisions().size(), 1u);
  EXPECT_TRUE(scene.collides(far, at(0)));
  EXPECT_EQ(scene.colliding(kSquare, at(-1e308, 1e308)).size(), 1u);
}

/// The way that a body moves in all, and the square of each step, are above the largest double.
TEST(Scene, FollowsHugeBodies) {
  Scene scene;
  scene.add(Polygon({rectangle(-1e307, -1e307, 1e307, 1e307)}), at(-8e307));
  const Scene::Body there = scene.add(Polygon({rectangle(-1e306, -1e306, 1e306, 1e306)}), at(-7e307));
  int hits = 0;
  for (int frame = 0; frame < 150; ++frame) {
    const int way = frame < 100 ? frame % 50 : frame - 100;
    const double x = (frame / 50 % 2 == 0 ? -8e307 + 3e306 * way : 7e307 - 3e306 * way);
    scene.move(0, at(x));
    const bool hit = collide(scene.polygon(0), scene.pose(0), scene.polygon(there), scene.pose(there));
    ASSERT_EQ(!scene.collisions().empty(), hit) << "frame " << frame;
    hits += hit;
  }
  EXPECT_GT(hits, 3);
  EXPECT_LT(hits, 100);
}

/// A size and a step that overflow say nothing of each other: the step is a jump.
TEST(Scene, FollowsBodiesWhoseSizeOverflows) {
  Scene scene;
  const Scene::Body a = scene.add(Polygon({rectangle(-1e308, 0, 1e308, 1e308)}), at(0, 1), {1e308}),
                    b = scene.add(Polygon({rectangle(-1, -1.1e308, 1, -1e308)}), at(0));
  EXPECT_TRUE(scene.collisions().empty());
  scene.move(a, at(1e200, 1));
  EXPECT_TRUE(scene.collisions().empty());
  scene.move(a, at(1e200));
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{a, b}}));
}

/// Times of impact know nothing of a polygon whose radius is above the largest unit, and report whatever is asked.
/// Impacts of scenes are the same: its box must not leave anything out.
TEST(Scene, ReportsTheImpactsOfWhatIsAboveTheLargestUnit) {
  const Polygon huge({{{0x1.529e7dd968fbep+1021, -0x1.e197746867ccap+1020},
                       {0x1.1df1ed1dfda18p+1021, -0x1.1df1ed1dfda18p+1021},
                       {0x1.9dde2809b933ep+1021, -0x1.0ee5317aba632p+1022},
                       {0x1.da111696c62d7p+1021, -0x1.8ed16c6675f57p+1021}}},
                     FillRule::EvenOdd),
      other({{{0x1.c37dfd21e14fdp+1019, 0x1.6931974e4dd98p+1017},
              {0x1.f0a4300bab0bp+1020, -0x1.0ee5317aba632p+1020},
              {0x1.ffb0ebaeee497p+1020, -0x1.2cfea8c140dfep+1018},
              {0x1.b471417e9e117p+1020, 0x1.c37dfd21e14fdp+1019}}},
            FillRule::EvenOdd);
  const Pose far = pose(0x1.fdf0286065c03p-1, -0x1.6f3a10c379e5ap-4, -0x1.c6d2a73618d38p+1003, 0x1.6f3a10c379e5ap-4,
                        0x1.fdf0286065c03p-1, -0x1.9285ddd048ea6p+1002);
  const Pose there = pose(0x1.fdbdfa24c0a89p-1, -0x1.803fd6927ecc7p-4, 0x1.ec0f0d248048dp+1008, 0x1.803fd6927ecc7p-4,
                          0x1.fdbdfa24c0a89p-1, 0x1.2d366ce6fd6ddp+1009);
  const Motion still = Motion::still(far), here = Motion::still(there), origin = Motion::still(at(0));
  Motion turning = still;
  turning.angle = 3;
  turning.pivot = huge.coveringOrigin();
  Scene scene;
  const Scene::Body a = scene.add(huge, far), b = scene.add(other, there), c = scene.add(kSquare, origin.start);
  for (const Motion& motion : {still, turning}) {
    const auto with_b = timeOfImpact(huge, motion, other, here), with_c = timeOfImpact(huge, motion, kSquare, origin);
    EXPECT_EQ(scene.impacts({{a, motion}}).size(), (with_b ? 1u : 0u) + (with_c ? 1u : 0u));
    EXPECT_EQ(scene.firstImpact(huge, motion, {}, {~0u, a}).has_value(), with_b || with_c);
  }
  const auto of_still = timeOfImpact(huge, still, kSquare, origin);
  scene.remove(b);
  EXPECT_EQ(scene.impacts({{c, origin}}).size(), of_still ? 1u : 0u);
  EXPECT_EQ(scene.firstImpact(kSquare, origin, {}, {~0u, c}).has_value(), of_still.has_value());
}

}  // namespace
}  // namespace tricover::support
