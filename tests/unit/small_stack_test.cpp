// SPDX-License-Identifier: BSD-3-Clause
// Every query runs in a thread whose stack is small.
#include "small_stack.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "shapes.h"
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

constexpr void (*kQueries[])(const Polygon& a, const Polygon& b) = {
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

TEST(SmallStack, IsEnoughForEveryQuery) {
  const bool sanitized = &__asan_init != nullptr || &__tsan_init != nullptr;
  for (const std::size_t vertices : {8U, 64U, 4096U})
    for (const double inner : {1.0, 0.9})
      for (std::size_t query = 0; query < std::size(kQueries); ++query) {  // each is the first that the polygons meet
        const Polygon a = wheel(vertices, inner), b = wheel(vertices, inner);
        EXPECT_EQ(onStackOf(sanitized ? kStackOfSanitizers : kSmallStack, [&] { kQueries[query](a, b); }), "")
            << vertices << " vertices, query " << query;
      }
}

}  // namespace
}  // namespace tricover::support
