// SPDX-License-Identifier: BSD-3-Clause
// Bodies that come, go, are copied and moved with their scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "random.h"
#include "shapes.h"
#include "tricover/scene.h"
#include "tricover/segment.h"

namespace tricover::support {
namespace {

const Polygon kSquare({rectangle(-1, -1, 1, 1)});

TEST(Scene, RefusesDeadHandlesAndBadNumbersAndStaysAsItWas) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, turnedAndMoved(0, 0, 0)), b = scene.add(kSquare, turnedAndMoved(0, 1, 0));
  scene.remove(a);
  EXPECT_FALSE(scene.contains(a));
  EXPECT_THROW(scene.remove(a), std::out_of_range);
  EXPECT_THROW(scene.move(a, turnedAndMoved(0, 0, 0)), std::out_of_range);
  EXPECT_THROW(scene.pose(7), std::out_of_range);
  Pose bad = turnedAndMoved(0, 0, 0);
  bad.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(scene.move(b, bad), std::invalid_argument);
  EXPECT_THROW(scene.add(kSquare, bad), std::invalid_argument);
  BodyOptions endless;
  endless.margin = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(scene.add(kSquare, turnedAndMoved(0, 0, 0), endless), std::invalid_argument);
  EXPECT_THROW(scene.impacts({{b, Motion()}, {b, Motion()}}), std::invalid_argument);
  EXPECT_THROW(scene.impacts({{a, Motion()}}), std::out_of_range);
  EXPECT_EQ(scene.size(), 1u);
  EXPECT_EQ(scene.pose(b).translation().x(), 1);
  EXPECT_TRUE(scene.collisions().empty());
  try {
    scene.remove(5);
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "tricover: body: the scene has none of the handle 5");
  }
}

TEST(Scene, GivesSlotsAgain) {
  Scene scene;
  std::vector<Scene::Body> bodies;
  for (int i = 0; i < 300; ++i) bodies.push_back(scene.add(kSquare, turnedAndMoved(0, 3 * i, 0)));
  for (int round = 0; round < 3; ++round) {
    for (const Scene::Body body : bodies) scene.remove(body);
    EXPECT_EQ(scene.size(), 0u);
    bodies.clear();
    for (int i = 0; i < 300; ++i) bodies.push_back(scene.add(kSquare, turnedAndMoved(0, 1.5 * i, 0)));
    for (const Scene::Body body : bodies) EXPECT_LT(Scene::indexOf(body), 600u);
    EXPECT_EQ(scene.collisions().size(), 299u);
  }
}

TEST(Scene, FindsWhoIsLeft) {
  Random random(14);
  Scene scene;
  std::vector<std::pair<Scene::Body, Pose>> left;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      const Pose at = turnedAndMoved(0, 3 * i + random.real(0, 0.9), 3 * k + random.real(0, 0.9));
      left.push_back({scene.add(kSquare, at), at});
    }
  const Polygon dot = point({0, 0});
  while (left.size() > 1) {
    const auto gone = left.begin() + random.integer(0, static_cast<int>(left.size()) - 1);
    scene.remove(gone->first);
    left.erase(gone);
    if (left.size() % 10 != 0) continue;
    for (const auto& [body, at] : left)
      ASSERT_EQ(scene.colliding(dot, at), std::vector<Scene::Body>{body}) << left.size();
  }
  EXPECT_EQ(scene.size(), 1u);
}

TEST(Scene, TakesManyBodiesAtOnce) {
  Random random(15);
  Scene scene;
  std::vector<std::pair<Scene::Body, Pose>> all;
  for (const int count : {1, 0, 7, 2, 900, 64, 3, 300}) {
    std::vector<BodyPlacement> more;
    for (int i = 0; i < count; ++i)
      more.push_back({kSquare, turnedAndMoved(random.real(0, 6), random.real(0, 60), random.real(0, 60)), {}});
    const std::vector<Scene::Body> bodies = scene.add(more);
    ASSERT_EQ(bodies.size(), more.size());
    for (std::size_t i = 0; i < more.size(); ++i) all.push_back({bodies[i], more[i].pose});
    if (count == 64)
      for (int i = 0; i < 10; ++i) {
        const auto gone = all.end() - 1 - random.integer(0, 70);
        scene.remove(gone->first);
        all.erase(gone);
      }
    for (auto& [body, at] : all)
      if (random.oneIn(20)) scene.move(body, at = turnedAndMoved(0, random.real(0, 60), random.real(0, 60)));
    for (int i = 0; i < 30; ++i) {
      const Pose asked = turnedAndMoved(random.real(0, 6), random.real(0, 60), random.real(0, 60));
      std::vector<Scene::Body> expected;
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [body, at] : all) {
        if (collide(kSquare, asked, kSquare, at)) expected.push_back(body);
        least = std::min(least, distance(kSquare, asked, kSquare, at).distance);
      }
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(scene.colliding(kSquare, asked), expected);
      ASSERT_EQ(scene.nearest(kSquare, asked)->result.distance, least);
    }
  }
  const std::size_t before = scene.size();
  BodyOptions endless;
  endless.margin = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(scene.add({{kSquare, turnedAndMoved(0, 0, 0), {}}, {kSquare, turnedAndMoved(0, 0, 0), endless}}),
               std::invalid_argument);
  EXPECT_EQ(scene.size(), before);
}

TEST(Scene, MovesABodyTwiceAtOnce) {
  Scene scene;
  const Scene::Body still = scene.add(kSquare, turnedAndMoved(0, 50, 0)),
                    moving = scene.add(kSquare, turnedAndMoved(0, 0, 0));
  for (int i = 1; i < 20; ++i) {  // its box has room for such steps by then
    scene.move({{moving, turnedAndMoved(0, 0.01 * i, 0)}});
    EXPECT_TRUE(scene.collisions().empty());
  }
  scene.move({{moving, turnedAndMoved(0, 0.2, 0)}, {moving, turnedAndMoved(0, 49, 0)}});
  EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{still, moving}}));
  scene.move({{moving, turnedAndMoved(0, 49.01, 0)}, {moving, turnedAndMoved(0, 0.2, 0)}});
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_EQ(scene.pose(moving).translation().x(), 0.2);
  for (int i = 1; i < 20; ++i) scene.move({{moving, turnedAndMoved(0, 0.2 + 0.01 * i, 0)}});
  scene.move({{moving, turnedAndMoved(0, 49, 0)},
              {moving, turnedAndMoved(0, 0.4, 0)}});  // the second one alone is within its box
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
  const Scene::Body a = scene.add(kSquare, turnedAndMoved(0, 0, 0)), b = scene.add(kSquare, turnedAndMoved(0, 0.5, 0));
  EXPECT_EQ(scene.collisions().size(), 1u);
  Scene branch(scene);
  branch.move(b, turnedAndMoved(0, 5, 0));
  EXPECT_EQ(branch.collisions().size(), 0u);
  EXPECT_EQ(branch.ended(), (std::vector<BodyPair>{{a, b}}));
  EXPECT_EQ(scene.collisions().size(), 1u);
  EXPECT_TRUE(branch.collides(kSquare, turnedAndMoved(0, 5.2, 0)));
  EXPECT_FALSE(scene.collides(kSquare, turnedAndMoved(0, 5.2, 0)));
  const Scene::Body c = branch.add(kSquare, turnedAndMoved(0, 9, 0));
  EXPECT_EQ(branch.bodies(), (std::vector<Scene::Body>{a, b, c}));
  EXPECT_EQ(scene.bodies(), (std::vector<Scene::Body>{a, b}));
  scene = branch;
  EXPECT_EQ(scene.size(), 3u);
  EXPECT_TRUE(scene.collides(kSquare, turnedAndMoved(0, 9, 0)));
}

TEST(Scene, SaysWhichOfManyPosesIsWrong) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, turnedAndMoved(0, 0, 0)), b = scene.add(kSquare, turnedAndMoved(0, 5, 0));
  Pose bad = turnedAndMoved(0, 1, 0);
  bad.linear() *= 2;
  const auto textOf = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(textOf([&] {
              scene.collides(kSquare, std::vector<Pose>{turnedAndMoved(0, 0, 0), bad});
            }).find("tricover: poses[1]: "),
            0u);
  EXPECT_EQ(textOf([&] { scene.move({{a, turnedAndMoved(0, 7, 0)}, {b, bad}}); }).find("tricover: poses[1]: "), 0u);
  EXPECT_THROW(scene.move({{a, turnedAndMoved(0, 7, 0)}, {b + 1, bad}}), std::out_of_range);
  EXPECT_EQ(scene.pose(a).translation().x(), 0);
}

TEST(Scene, StaleHandlesAreErrorsAndNeverAnotherBody) {
  Scene scene;
  std::vector<Scene::Body> gone;
  const Scene::Body stays = scene.add(kSquare, turnedAndMoved(0, 0, 0));
  for (int i = 0; i < 5; ++i) {
    const Scene::Body body = scene.add(kSquare, turnedAndMoved(0, 0.5, 0));
    EXPECT_EQ(Scene::indexOf(body), 1u);
    EXPECT_EQ(scene.bodies(), (std::vector<Scene::Body>{stays, body}));
    EXPECT_EQ(scene.collisions(), (std::vector<BodyPair>{{stays, body}}));
    EXPECT_EQ(scene.colliding(kSquare, turnedAndMoved(0, 0, 0)), (std::vector<Scene::Body>{stays, body}));
    EXPECT_EQ(scene.colliding(kSquare, turnedAndMoved(0, 0, 0), {}, BodyFilter::allBut(stays)),
              (std::vector<Scene::Body>{body}));
    for (const Scene::Body old : gone) {
      EXPECT_FALSE(scene.contains(old));
      EXPECT_THROW(scene.remove(old), std::out_of_range);
      EXPECT_THROW(scene.pose(old), std::out_of_range);
      EXPECT_THROW(scene.move(old, turnedAndMoved(0, 0, 0)), std::out_of_range);
      EXPECT_THROW(scene.move({{old, turnedAndMoved(0, 0, 0)}}), std::out_of_range);
      EXPECT_THROW(scene.setOptions(old, {}), std::out_of_range);
      EXPECT_THROW(scene.impacts({{old, Motion()}}), std::out_of_range);
      EXPECT_THROW(scene.collides(kSquare, turnedAndMoved(0, 0, 0), {}, BodyFilter::allBut(old)), std::out_of_range);
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
  const Scene::Body me = scene.add(kSquare, turnedAndMoved(0, 0, 0)),
                    other = scene.add(kSquare, turnedAndMoved(0, 1, 0));
  EXPECT_EQ(scene.anyColliding(kSquare, scene.pose(me), {}, BodyFilter::allBut(me)), other);
  EXPECT_TRUE(scene.collides(kSquare, scene.pose(me), {}, 1));
  EXPECT_FALSE(scene.collides(kSquare, scene.pose(me), {}, 2u));
  EXPECT_EQ(scene.anyColliding(kSquare, scene.pose(me), {}, {1, me}), other);
}

TEST(Scene, OptionsChangeInPlace) {
  Scene scene;
  const Scene::Body a = scene.add(kSquare, turnedAndMoved(0, 0, 0)), b = scene.add(kSquare, turnedAndMoved(0, 3, 0));
  EXPECT_TRUE(scene.collisions().empty());
  BodyOptions wide;
  wide.margin = 2;
  scene.setOptions(a, wide);
  EXPECT_TRUE(scene.collides(kSquare, turnedAndMoved(0, -2.5, 0)));
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
  wide.margin = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(scene.setOptions(a, wide), std::invalid_argument);
  EXPECT_EQ(scene.options(a).margin, 0);
}

TEST(Scene, IsEmptyWhenMovedFrom) {
  Scene scene;
  const Scene::Body body = scene.add(kSquare, turnedAndMoved(0, 0, 0));
  Scene moved(std::move(scene));
  EXPECT_TRUE(moved.collides(kSquare, moved.pose(body)));
  EXPECT_EQ(scene.size(), 0u);  // NOLINT
  EXPECT_FALSE(scene.collides(kSquare, turnedAndMoved(0, 0, 0)));
  EXPECT_TRUE(scene.collisions().empty());
  EXPECT_THROW(scene.remove(body), std::out_of_range);
  scene.add(kSquare, turnedAndMoved(0, 5, 0));
  scene = std::move(moved);
  EXPECT_TRUE(scene.contains(body));
  EXPECT_EQ(scene.size(), 1u);
  EXPECT_EQ(moved.size(), 0u);  // NOLINT
  moved.add(kSquare, turnedAndMoved(0, 1, 0));
  EXPECT_EQ(moved.size(), 1u);
}
}  // namespace
}  // namespace tricover::support
