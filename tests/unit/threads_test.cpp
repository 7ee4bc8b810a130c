// SPDX-License-Identifier: BSD-3-Clause
// Threads that share polygons: the first use (which builds what is built lazily) happens in all of them at once. And a
// thread whose stack is small.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "refusal.h"
#include "shapes.h"
#include "small_stack.h"
#include "stages.h"
#include "strategies.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/penetration.h"
#include "tricover/ray.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

// Linked with sanitizers, whose frames are larger, or not.
extern "C" void __asan_init() __attribute__((weak));
extern "C" void __tsan_init() __attribute__((weak));

namespace tricover::support {
namespace {

constexpr int kThreads = 8;
constexpr int kRounds = 60;
constexpr int kQueries = 40;

/// In as many threads at once, by their number.
void inThreads(int count, const std::function<void(int)>& task) {
  std::atomic<bool> go{false};
  std::vector<std::thread> threads;
  for (int t = 0; t < count; ++t)
    threads.emplace_back([&, t] {
      while (!go) std::this_thread::yield();
      task(t);
    });
  go = true;
  for (std::thread& thread : threads) thread.join();
}

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
    inThreads(kThreads,
              [&](int t) { wrong += wrongAnswers(round, t % 4 == 0 ? Strategy::Paper : Strategy::Hierarchy); });
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
    inThreads(kThreads, [&](int) { wrong += answers(map) != expected; });
    EXPECT_EQ(wrong, 0);
  }
}

/// A Parallel.
void byThreads(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  inThreads(3, [&](int) {
    for (std::size_t i = next++; i < count; i = next++) task(i);
  });
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

/// All answers as numbers: of many poses at once, and one by one; impacts' times at the end.
std::vector<double> ask(const Scene& scene, const Polygon& robot, std::uint64_t seed, const Parallel& parallel) {
  Random random(seed);
  std::vector<Pose> poses;
  for (int i = 0; i < 1200; ++i) poses.push_back(randomPose(random, 14));
  const std::vector<bool> many = scene.collides(robot, poses, {}, kEveryCategory, parallel);
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(scene.collides(robot, poses[i]), many[i]) << i;
  std::vector<double> answers(many.begin(), many.end());
  std::vector<BodyMotion> motions;
  for (std::size_t i = 0; i < 20; ++i) {
    const Pose& at = poses[i];
    for (const Scene::Body body : scene.colliding(robot, at)) answers.push_back(static_cast<double>(body));
    const auto nearest = scene.nearest(robot, at);
    answers.push_back(static_cast<double>(nearest->body));
    answers.push_back(nearest->result.distance);
    Motion motion = Motion::still(at);
    motion.shift = Vec2(random.real(-9, 9), random.real(-9, 9));
    const auto impact = scene.firstImpact(robot, motion);
    answers.push_back(impact ? impact->impact.time : 2);
    motion.start = scene.pose(static_cast<Scene::Body>(i));
    motions.push_back({static_cast<Scene::Body>(i), motion});
  }
  const std::vector<PairImpact> impacts = scene.impacts(motions, {}, parallel);
  EXPECT_FALSE(impacts.empty());
  for (const PairImpact& impact : impacts) answers.push_back(impact.impact.time);
  return answers;
}

TEST(Threads, AskOneScene) {
  const UpTo stages(detail::Stages::Paid);
  for (std::uint64_t round = 0; round < static_cast<std::uint64_t>(scaledCount(10)); ++round) {
    const auto robot = [] { return Polygon({rectangle(-1, -0.5, 1, 0.5)}); };
    const std::vector<double> expected = ask(makeScene(round), robot(), round, {});
    for (const int answer : {0, 1}) EXPECT_NE(std::count(expected.begin(), expected.begin() + 1200, answer), 0);
    const Scene scene = makeScene(round);
    const Polygon shared = robot();
    std::atomic<int> wrong{0};
    inThreads(kThreads / 2, [&](int t) {
      wrong += !(ask(scene, shared, round, t % 2 == 0 ? Parallel(byThreads) : Parallel()) == expected);
    });
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
  return refusal<std::runtime_error>(ask).empty() ? 0 : 1;
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
  for (int frame = 0; frame < scaledCount(30, 4); ++frame) {
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
  const Polygon shared({rectangle(0, 0, 1, 1)});
  inThreads(kThreads, [&ids, copy = shared](int t) {
    const Polygon of_thread = copy;  // NOLINT: the copy is the point
    for (int i = 0; i < 200; ++i) {
      const Polygon own({rectangle(0, 0, 1, 1)});
      ids[static_cast<std::size_t>(t)].push_back(own.id());
      EXPECT_TRUE(collide(own, Pose::Identity(), of_thread, Pose::Identity()));
    }
  });
  std::vector<std::uint64_t> all = {shared.id()};
  for (const std::vector<std::uint64_t>& some : ids) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

constexpr std::size_t kSmallStack = 64 * 1024, kStackOfSanitizers = 1024 * 1024;

/// A wheel whose every other vertex is nearer to its middle; nothing is derived from it yet.
Polygon wheel(std::size_t vertices, double inner) {
  std::vector<Vec2> ring;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(vertices);
    ring.emplace_back((i % 2 == 0 ? 1 : inner) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return Polygon({ring});
}

const Pose kHome = Pose::Identity(), kNear = turnedAndMoved(0, 1.5, 0.1), kApart = turnedAndMoved(0.3, 2.5, 0);

constexpr void (*kAllQueries[])(const Polygon& a, const Polygon& b) = {
    [](const Polygon& a, const Polygon& b) {
      collide(a, kHome, b, kNear);
      collide(a, kHome, b, kApart);
    },
    [](const Polygon& a, const Polygon& b) {
      PairCache cache;
      collide(a, kHome, b, kApart, cache);
      collide(a, kHome, b, kNear, cache, {0.1, 0});
    },
    [](const Polygon& a, const Polygon& b) {
      distance(a, kHome, b, kNear);
      distance(a, kHome, b, kApart);
    },
    [](const Polygon& a, const Polygon& b) { contacts(a, kHome, b, kNear); },
    [](const Polygon& a, const Polygon& b) { crossings(a, kHome, b, kNear); },
    [](const Polygon& a, const Polygon& b) { penetration(a, kHome, b, kNear); },
    [](const Polygon& a, const Polygon& b) {
      timeOfImpact(a, Motion::still(kHome), b, Motion::translation(kApart, {-1, 0}));
      timeOfImpact(a, Motion::still(kHome), b, Motion::between(kApart, turnedAndMoved(2, -2, 0.1)));
    },
    [](const Polygon& a, const Polygon& b) {
      conflicts(a, Motion::still(kHome), b, Motion::translation(kApart, {-5, 0}), {0, 1e-3});
    },
    [](const Polygon& a, const Polygon& b) {
      locate(a, {0.1, 0.2});
      castRay(a, kHome, {-3, 0.1}, {3, 0.2});
      castRay(b, kHome, {-3, 0.1}, {3, 0.2}, {0.1});
    },
    [](const Polygon& a, const Polygon& b) {
      Scene scene;
      const Scene::Body first = scene.add(a, kHome);
      for (int i = 0; i < 40; ++i) scene.add(b, turnedAndMoved(0.1 * i, 2.0 * i, 1.5));
      scene.collisions();
      scene.move(first, kNear);
      scene.collisions();
      scene.collides(b, kApart);
      scene.firstImpact(b, Motion::translation(kApart, {-5, 0}));
    },
};

TEST(Threads, ASmallStackIsEnoughForEveryQuery) {
  const bool sanitized = &__asan_init != nullptr || &__tsan_init != nullptr;
  for (const std::size_t vertices : {8U, 64U, 4096U})
    for (const double inner : {1.0, 0.9})
      for (std::size_t query = 0; query < std::size(kAllQueries);
           ++query) {  // each is the first that the polygons meet
        const Polygon a = wheel(vertices, inner), b = wheel(vertices, inner);
        EXPECT_EQ(onStackOf(sanitized ? kStackOfSanitizers : kSmallStack, [&] { kAllQueries[query](a, b); }), "")
            << vertices << " vertices, query " << query;
      }
}

}  // namespace
}  // namespace tricover::support
