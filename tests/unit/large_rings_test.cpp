// SPDX-License-Identifier: BSD-3-Clause
// Rings of 100,000 vertices (fewer where the tests are scaled): linear memory, and no recursion that grows with them
// (the queries run on a small stack).
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <new>
#include <utility>

#include "shapes.h"
#include "small_stack.h"
#include "strategies.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/locate.h"

namespace {

std::atomic<std::size_t> allocated{0};

}  // namespace

// Not inlined: GCC takes a pair of which it sees one half for mismatched.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated += size;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace tricover::support {
namespace {

const int kVertices = scaledCount(100000);
constexpr std::size_t kStackBytes = 512 * 1024;

void onSmallStack(std::function<void()> work) { ASSERT_EQ(onStackOf(kStackBytes, std::move(work)), ""); }

/// Cold, cached and in both orders.
bool collideAllWays(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const bool answer = collide(a, pose_a, b, pose_b);
  PairCache cache;
  EXPECT_EQ(collide(b, pose_b, a, pose_a), answer);
  EXPECT_EQ(collide(a, pose_a, b, pose_b, cache), answer);
  EXPECT_EQ(collide(a, pose_a, b, pose_b, cache), answer);
  EXPECT_EQ(!contacts(a, pose_a, b, pose_b).empty(), answer);
  return answer;
}

TEST(LargeRings, AnnulusAroundADiscWithoutTouching) {
  onSmallStack([] {
    const Polygon annulus({regular(kVertices, 2), regular(kVertices, 1.0001)}), disc({regular(kVertices, 1)});
    EXPECT_FALSE(collideAllWays(annulus, Pose::Identity(), disc, Pose::Identity()));
    EXPECT_FALSE(collideAllWays(annulus, Pose::Identity(), disc, turnedAndMoved(1, 0.00009, 0)));
    EXPECT_TRUE(collideAllWays(annulus, Pose::Identity(), disc, turnedAndMoved(1, 0.00011, 0)));
    EXPECT_TRUE(collideAllWays(annulus, Pose::Identity(), disc, turnedAndMoved(1, 1.5, 0)));
    EXPECT_FALSE(collideAllWays(annulus, Pose::Identity(), disc, turnedAndMoved(1, 3.1, 0)));
    EXPECT_EQ(locate(annulus, {1.5, 0}), Location::Inside);
    EXPECT_EQ(locate(annulus, {0, 0}), Location::Outside);
    for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper})
      EXPECT_FALSE(collide(strategy, annulus, Pose::Identity(), disc, turnedAndMoved(0, 50, 0)));
  });
}

TEST(LargeRings, TwoStarsOverlappingNearAndFar) {
  onSmallStack([] {
    Random random(7);
    const Polygon a({star(random, kVertices, 0.9, 1)}), b({star(random, kVertices, 0.9, 1)});
    EXPECT_TRUE(collideAllWays(a, Pose::Identity(), b, turnedAndMoved(0.5, 1.5, 0)));
    EXPECT_TRUE(collideAllWays(a, Pose::Identity(), b, Pose::Identity()));
    EXPECT_FALSE(collideAllWays(a, Pose::Identity(), b, turnedAndMoved(0.5, 2.0001, 0)));
    EXPECT_FALSE(collideAllWays(a, Pose::Identity(), b, turnedAndMoved(0.5, 1e9, 0)));
    EXPECT_TRUE(collide(a, Pose::Identity(), b, turnedAndMoved(0.5, 3, 0), CollideOptions{1.1, 0}));
    EXPECT_FALSE(collide(a, Pose::Identity(), b, turnedAndMoved(0.5, 3, 0), CollideOptions{0.9, 0}));
  });
}

TEST(LargeRings, InterlockingCombs) {
  onSmallStack([] {
    const int teeth = kVertices / 4;
    const Polygon up({comb(teeth, 1, 0.4, 1)}), down({comb(teeth, 1, 0.4, 1)});
    Pose turned = turnedAndMoved(0, 1.4 + teeth - 1 - 0.5, 1.5);
    turned.linear() << -1, 0, 0, -1;
    EXPECT_FALSE(collideAllWays(up, Pose::Identity(), down, turned));
    turned.translation().x() += 0.11;
    EXPECT_TRUE(collideAllWays(up, Pose::Identity(), down, turned));
  });
}

std::size_t bytesFor(int vertices) {
  std::vector<Ring> rings = {regular(vertices, 1)};
  const std::size_t before = allocated;
  const Polygon polygon(std::move(rings));
  const Polygon other({rectangle(0, 0, 1, 1)});
  EXPECT_TRUE(collide(polygon, Pose::Identity(), other, Pose::Identity()));
  paper::MaskCache cache;
  EXPECT_TRUE(paper::collide(polygon, Pose::Identity(), other, Pose::Identity(), cache));
  return allocated - before;
}

TEST(LargeRings, MemoryIsLinear) {
  const std::size_t once = bytesFor(kVertices), twice = bytesFor(2 * kVertices);
  EXPECT_LE(once, 500 * static_cast<std::size_t>(kVertices));
  EXPECT_LE(static_cast<double>(twice), 2.1 * static_cast<double>(once));
}

}  // namespace
}  // namespace tricover::support
