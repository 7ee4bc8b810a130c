// SPDX-License-Identifier: BSD-3-Clause
// Threads that share polygons: the first use (which builds what is built lazily) happens in all of them at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "shapes.h"
#include "stages.h"
#include "strategies.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

constexpr int kThreads = 8;
constexpr int kRounds = 60;
constexpr int kQueries = 40;

struct Query {
  Pose pose_a, pose_b;
  bool truth;
};

struct Round {
  std::vector<Polygon> polygons;
  std::vector<Query> queries;  ///< query i is about polygons i and i + 1, cyclically
};

Round makeRound(std::uint64_t seed) {
  Random random(seed);
  Round round;
  for (int i = 0; i < 4; ++i) round.polygons.push_back(Polygon({star(random, 40, 1, 3), star(random, 10, 0.2, 0.8)}));
  for (std::size_t i = 0; i < kQueries; ++i) {
    const Polygon &a = round.polygons[i % 4], &b = round.polygons[(i + 1) % 4];
    const Pose pose_a = randomPose(random, 5), pose_b = randomPose(random, 5);
    round.queries.push_back({pose_a, pose_b, exact::collide(a, pose_a, b, pose_b)});
  }
  return round;
}

int wrongAnswers(const Round& round, Strategy strategy) {
  int wrong = 0;
  StrategyCaches caches[4];
  for (std::size_t i = 0; i < round.queries.size(); ++i) {
    const Query& query = round.queries[i];
    const Polygon a = round.polygons[i % 4], b = round.polygons[(i + 1) % 4];
    wrong += collide(strategy, a, query.pose_a, b, query.pose_b, caches[i % 4]) != query.truth;
    wrong += collide(strategy, b, query.pose_b, a, query.pose_a) != query.truth;
    wrong += contacts(a, query.pose_a, b, query.pose_b).empty() == query.truth;
    wrong += locate(a, {10, 10}) != Location::Outside;
  }
  return wrong;
}

TEST(Threads, ShareFreshPolygons) {
  int hits = 0, queries = 0;
  std::atomic<int> wrong{0};
  for (int r = 0; r < scaledCount(kRounds); ++r) {
    // Everything by all at the first query, or in stages, as users do.
    const UpTo stages(r % 2 == 0 ? detail::Stages::All : detail::Stages::Paid);
    const Round round = makeRound(static_cast<std::uint64_t>(r));
    for (const Query& query : round.queries) hits += query.truth, ++queries;
    std::atomic<bool> go{false};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&, t] {
        while (!go) std::this_thread::yield();
        wrong += wrongAnswers(round, t % 4 == 0 ? Strategy::Paper : Strategy::Hierarchy);
      });
    }
    go = true;
    for (std::thread& thread : threads) thread.join();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(hits, 0.2 * queries);
  EXPECT_LE(hits, 0.8 * queries);
}

/// Many rings, whose hierarchy and starts are built by whichever thread pays for them last.
TEST(Threads, ShareAFreshMap) {
  for (int r = 0; r < scaledCount(20); ++r) {
    const UpTo stages(r % 2 == 0 ? detail::Stages::All : detail::Stages::Paid);
    Random random(static_cast<std::uint64_t>(r));
    std::vector<Ring> rings;
    for (int i = 0; i < 36; ++i) rings.push_back(star(random, 8, 0.2, 0.6, {i % 6, i / 6}));
    std::vector<Pose> poses;
    for (int i = 0; i < 200; ++i)
      poses.push_back(turnedAndMoved(random.real(0, 6), random.real(-1, 6), random.real(-1, 6)));
    const auto answers = [&](const Polygon& map) {
      const Polygon robot({rectangle(-0.2, -0.1, 0.2, 0.1)});
      std::vector<double> all;
      for (const Pose& at : poses) {
        all.push_back(static_cast<double>(locate(map, at.translation())));
        all.push_back(collide(map, Pose::Identity(), robot, at));
        all.push_back(distance(map, Pose::Identity(), robot, at).distance);
      }
      return all;
    };
    const Polygon map(rings);
    const std::vector<double> expected = answers(Polygon(rings));
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) threads.emplace_back([&] { wrong += answers(map) != expected; });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
  }
}

/// A Parallel.
void byThreads(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t)
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    });
  for (std::thread& thread : threads) thread.join();
}

/// The same bodies for the same seed, of polygons that nobody has asked anything yet.
Scene makeScene(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (int i = 0; i < 30; ++i) {
    BodyOptions options;
    options.margin = random.oneIn(3) ? random.real(0, 0.2) : 0;
    scene.add(Polygon({star(random, random.integer(3, 40), 0.5, 2)}), randomPose(random, 12), options);
  }
  return scene;
}

struct SceneAnswers {
  std::vector<bool> collides;
  std::vector<std::vector<Scene::Body>> colliding;
  std::vector<double> distances, times;
  std::vector<Scene::Body> nearest;

  bool operator==(const SceneAnswers& other) const {
    return collides == other.collides && colliding == other.colliding && distances == other.distances &&
           times == other.times && nearest == other.nearest;
  }
};

SceneAnswers ask(const Scene& scene, const Polygon& robot, std::uint64_t seed, const Parallel& parallel) {
  Random random(seed);
  SceneAnswers answers;
  std::vector<Pose> poses;
  for (int i = 0; i < 1200; ++i) poses.push_back(randomPose(random, 14));
  const std::vector<bool> many = scene.collides(robot, poses, {}, kEveryCategory, parallel);
  answers.collides.assign(many.begin(), many.end());
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < 20; ++i) {
    const Pose& at = poses[i];
    answers.collides.push_back(scene.collides(robot, at));
    answers.colliding.push_back(scene.colliding(robot, at));
    const auto nearest = scene.nearest(robot, at);
    answers.nearest.push_back(nearest->body);
    answers.distances.push_back(nearest->result.distance);
    Motion motion = Motion::still(at);
    motion.shift = Vec2(random.real(-9, 9), random.real(-9, 9));
    const auto impact = scene.firstImpact(robot, motion);
    answers.times.push_back(impact ? impact->impact.time : 2);
    motion.start = scene.pose(static_cast<Scene::Body>(i));
    motions.push_back({static_cast<Scene::Body>(i), motion});
  }
  for (const PairImpact& impact : scene.impacts(motions, {}, parallel)) answers.times.push_back(impact.impact.time);
  return answers;
}

TEST(Threads, AskOneScene) {
  const UpTo stages(detail::Stages::Paid);
  for (std::uint64_t round = 0; round < static_cast<std::uint64_t>(scaledCount(10)); ++round) {
    const auto robot = [] { return Polygon({rectangle(-1, -0.5, 1, 0.5)}); };
    const SceneAnswers expected = ask(makeScene(round), robot(), round, {});
    EXPECT_NE(std::count(expected.collides.begin(), expected.collides.end(), true), 0);
    EXPECT_NE(std::count(expected.collides.begin(), expected.collides.end(), false), 0);
    EXPECT_GT(expected.times.size(), 20u);
    const Scene scene = makeScene(round);
    const Polygon shared = robot();
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads / 2; ++t)
      threads.emplace_back(
          [&, t] { wrong += !(ask(scene, shared, round, t % 2 == 0 ? Parallel(byThreads) : Parallel()) == expected); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
  }
}

/// Threads that fail at one of the next times that they are given tasks, after half of them.
Parallel failing(Random& random) {
  return [left = random.integer(0, 4)](std::size_t count, const std::function<void(std::size_t)>& task) mutable {
    const bool fails = left-- == 0;
    for (std::size_t i = 0; i < (fails ? count / 2 : count); ++i) task(i);
    if (fails) throw std::runtime_error("no threads");
  };
}

template <typename Ask>
int failuresOf(const Ask& ask) {
  try {
    ask();
    return 0;
  } catch (const std::runtime_error&) {
    return 1;
  }
}

/// All pairs that any frame begins and ends with, of bodies that walk, leap, come and go, whatever failed before.
TEST(Threads, FindTheCollisionsThatOneFinds) {
  const UpTo stages(detail::Stages::Paid);
  Random random(5);
  std::vector<Polygon> shapes;
  for (int i = 0; i < 8; ++i) shapes.push_back(Polygon({star(random, random.integer(3, 20), 0.5, 1)}));
  constexpr int kBodies = 1600;
  Scene alone, shared;
  const auto add = [&] {
    const Polygon& shape = shapes[static_cast<std::size_t>(random.integer(0, 7))];
    const Pose at = randomPose(random, 50);
    EXPECT_EQ(alone.add(shape, at), shared.add(shape, at));
  };
  for (int i = 0; i < kBodies; ++i) add();
  std::size_t pairs = 0;
  int failures = 0;
  for (int frame = 0; frame < std::max(scaledCount(30), 4); ++frame) {
    std::vector<BodyPose> poses;
    for (const Scene::Body body : alone.bodies()) {
      Pose pose = alone.pose(body);
      if (random.oneIn(50)) pose = randomPose(random, 50);
      pose.translation() += Vec2(random.real(-0.2, 0.2), random.real(-0.2, 0.2));
      poses.push_back({body, pose});
    }
    poses.push_back({poses.front().body, randomPose(random, 50)});  // twice in one call
    alone.move(poses);
    failures += failuresOf([&] { shared.move(poses, failing(random)); });
    shared.move(poses, byThreads);
    if (random.coin()) {
      const int failed = failuresOf([&] { shared.collisions(failing(random)); });
      if (failed == 0) alone.collisions();
      failures += failed;
    }
    EXPECT_EQ(shared.collisions(byThreads), alone.collisions());
    EXPECT_EQ(shared.began(), alone.began());
    EXPECT_EQ(shared.ended(), alone.ended());
    pairs += alone.began().size();
    const Scene::Body leaves = poses[static_cast<std::size_t>(random.integer(0, kBodies - 1))].body;
    alone.remove(leaves);
    shared.remove(leaves);
    add();
  }
  EXPECT_GT(pairs, 500u);
  EXPECT_GT(failures, 0);
}

TEST(Threads, IdsStayUniqueAndTheLastCopyMayDieAnywhere) {
  std::vector<std::vector<std::uint64_t>> ids(kThreads);
  std::vector<std::thread> threads;
  const Polygon shared({rectangle(0, 0, 1, 1)});
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&ids, t, copy = shared] {
      for (int i = 0; i < 200; ++i) {
        const Polygon own({rectangle(0, 0, 1, 1)});
        ids[t].push_back(own.id());
        EXPECT_TRUE(collide(own, Pose::Identity(), copy, Pose::Identity()));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::vector<std::uint64_t> all = {shared.id()};
  for (const std::vector<std::uint64_t>& some : ids) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

}  // namespace
}  // namespace tricover::support
