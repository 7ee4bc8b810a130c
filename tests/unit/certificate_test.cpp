// SPDX-License-Identifier: BSD-3-Clause
// A cache's certificates rest on a bound: how far a change of pose moves a polygon at most.
#include "pair/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "polygon/cache_access.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

/// Turns and shifts of like effect, mirrors and distortions; a vertex in every direction, so that some moves about as
/// far as it can.
TEST(Displacement, BoundsTheWayOfEveryVertex) {
  Random random(41);
  for (int i = 0; i < scaledCount(3000); ++i) {
    const Ring ring = shifted(regular(64, 1), {random.real(-3, 3), random.real(-3, 3)});
    const Polygon polygon({ring});
    const double angle = random.real(0, 6.28), turn = std::pow(10, random.real(-6, 0)), way = turn * random.unit();
    const Pose before = turnedAndMoved(angle, 1, 2);
    const Vec2 center = before * polygon.coveringOrigin();
    Pose after = turnedAndMoved(angle + turn, 0, 0);
    if (i % 5 == 0) after = mirrored(turnedAndMoved(random.real(0, 6.28), 0, 0));
    if (i % 5 == 1) after = distorted(random, before);
    const double direction = random.real(0, 6.28);
    after.translation() =
        center - after.linear() * polygon.coveringOrigin() + way * Vec2(std::cos(direction), std::sin(direction));
    double farthest = 0;
    for (const Vec2& p : ring) farthest = std::max(farthest, (after * p - before * p).norm());
    double kept[6];
    detail::store(kept, before);
    const detail::Displacement change(detail::dataOf(polygon), kept, after);
    ASSERT_EQ(detail::displacement(detail::dataOf(polygon), kept, after), change.length());
    ASSERT_GE(change.length(), farthest * (1 - 1e-9) - 1e-15);
    if (i % 5 > 1) {
      ASSERT_LE(change.length(), 1.01 * farthest + 1e-12);
    }
    ASSERT_FALSE(change.isBelow(farthest * (1 - 1e-9) - 1e-15));
    ASSERT_TRUE(change.isBelow(1.42 * change.length()));
    ASSERT_EQ(detail::displacement(detail::dataOf(polygon), kept, before), 0);
  }
}

/// A certificate pays for the motion of both, whichever moved by little. Both may move by the same, and b be mirrored
/// besides, which the sum of its matrices would hide.
TEST(Recollection, CountsTheMotionOfBoth) {
  const auto expect = [](const Polygon& a, const Polygon& b, const Pose& before, double clearance,
                         const std::vector<std::tuple<Pose, Pose, bool>>& asked) {
    for (const bool swapped : {false, true}) {
      PairCache cache;
      detail::remember(detail::contentsOf(cache).collision, detail::dataOf(a), Pose::Identity(), detail::dataOf(b),
                       before, false, clearance);
      for (const auto& [pose_a, pose_b, truth] : asked)
        EXPECT_EQ(swapped ? collide(b, pose_b, a, pose_a, cache) : collide(a, pose_a, b, pose_b, cache), truth)
            << pose_a.translation().x() << " " << pose_b.translation().x();
    }
  };
  const Polygon a({rectangle(0, 0, 2, 2)}), b({rectangle(0, 0, 1, 1)});
  const std::tuple<double, double, bool> steps[] = {{0.1, 3, false},  {0, 2.9, false},  {0.1, 1.5, true},
                                                    {1.5, 3.1, true}, {0.6, 2.4, true}, {1.2, 3, true},
                                                    {0, 1.8, true}};
  for (const auto& [x_a, x_b, truth] : steps)
    expect(a, b, turnedAndMoved(0, 3, 0), 0.99, {{turnedAndMoved(0, x_a, 0), turnedAndMoved(0, x_b, 0), truth}});
  Pose flipped = turnedAndMoved(0, 0, 1);
  flipped.linear() << -1, 0, 0, 1;
  const Pose here = Pose::Identity(), up = turnedAndMoved(0, 0, 1);
  expect(Polygon({rectangle(-5, -1, -2, 1)}), Polygon({rectangle(1, -0.5, 3, 0.5)}), here, 2.99,
         {{here, here, false}, {up, flipped, true}, {here, here, false}, {up, flipped, true}});
}

TEST(SameAs, SeesEveryEntry) {
  double certificate[6];
  const Pose stored = turnedAndMoved(0.3, 7, -1e-300);
  detail::store(certificate, stored);
  EXPECT_TRUE(detail::sameAs(certificate, stored));
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      for (const int steps : {-1, 1}) {
        Pose other = stored;
        other.matrix()(row, column) = nudged(stored.matrix()(row, column), steps);
        EXPECT_FALSE(detail::sameAs(certificate, other)) << row << " " << column;
      }
  // Changes that cancel each other are changes.
  Pose both = stored;
  both.translation() += Vec2(1, -1);
  EXPECT_FALSE(detail::sameAs(certificate, both));
  // The two zeros are one place.
  detail::store(certificate, Pose::Identity());
  EXPECT_TRUE(detail::sameAs(certificate, pose(1, 0, -0.0, 0, 1, -0.0)));
}

/// A cache that goes from pair to pair holds nothing of the last one.
TEST(Claim, EmptiesAnotherPairsCache) {
  const Polygon a({rectangle(0, 0, 1, 1)}), b({rectangle(0, 0, 2, 2)}), c({rectangle(0, 0, 3, 3)});
  detail::Certificate cache;
  detail::remember(cache, detail::dataOf(a), turnedAndMoved(0, 1, 2), detail::dataOf(b), turnedAndMoved(0, 3, 4), true,
                   5);
  cache.first_edge = cache.second_edge = 3;
  detail::claim(cache, detail::dataOf(a), detail::dataOf(b));
  EXPECT_EQ(cache.first_edge, 3u);
  EXPECT_EQ(cache.clearance, 5);
  detail::claim(cache, detail::dataOf(a), detail::dataOf(c));
  EXPECT_EQ(cache.first_edge, detail::kNoEdge);
  EXPECT_EQ(cache.second_edge, detail::kNoEdge);
  EXPECT_EQ(cache.clearance, 0);
  EXPECT_EQ(cache.first_id, a.id());
  EXPECT_EQ(cache.second_id, c.id());
}

/// What pair_cache.h says.
TEST(PairCache, IsOfThatSize) { EXPECT_EQ(sizeof(PairCache), 184u); }

TEST(BackOff, DoublesWithEachFailure) {
  detail::BackOff back_off;
  EXPECT_FALSE(back_off.isOn()) << "a new one is tried";
  for (const int left : {2, 4, 8, 16, 32, 64, 128, 255, 255}) {
    back_off.judge(false);
    EXPECT_EQ(back_off.left, left);
  }
  back_off.left = 0;
  back_off.judge(true);
  EXPECT_FALSE(back_off.isOn());
  back_off.judge(false);
  EXPECT_EQ(back_off.left, 32) << "a success halves the count of failures";
}

/// Two outlines beside each other, whose discs overlap; and what a cache of theirs tells.
struct Walk {
  const Polygon a{{scaled(regular(40, 1), 3), regular(5, 1)}}, b{{rectangle(-1, -4, 1, 4)}};
  PairCache cache;
  int answered = 0, rested = 0;

  const detail::Certificate& certificate() { return detail::contentsOf(cache).collision; }
  void ask(double x, double y) {
    const std::uint32_t uses = certificate().uses;
    const bool rests = certificate().back_off.isOn();
    EXPECT_EQ(collide(a, Pose::Identity(), b, turnedAndMoved(0, x, y), cache),
              collide(a, Pose::Identity(), b, turnedAndMoved(0, x, y)));
    answered += certificate().uses > uses;
    rested += rests;
  }
};

/// Jumps, and steps of which none is a jump, for which no certificate lasts.
TEST(BackOff, WhatUsesUpEveryFactDoesWithout) {
  Walk jumps, steps;
  for (int i = 0; i < 400; ++i) jumps.ask(4.1, i % 2 == 0 ? -1.5 : 1.5);
  for (int i = 0; i < 400; ++i) steps.ask(4.1, 0.3 * std::abs(i % 8 - 4));
  EXPECT_EQ(jumps.answered + steps.answered, 0);
  EXPECT_GT(jumps.rested, 350);
  EXPECT_GT(steps.rested, 300);
}

/// After the rest, too, though the walk has gone on meanwhile.
TEST(BackOff, SlowStepsAreAnsweredByFacts) {
  Walk walk;
  for (int i = 0; i < 500; ++i) walk.ask(4.1, i % 2 == 0 ? -1.5 : 1.5);
  while (walk.certificate().back_off.isOn()) walk.ask(4.1, 0);
  walk.answered = walk.rested = 0;
  for (int i = 0; i < 1000; ++i) walk.ask(4.1, 1e-3 * i);
  EXPECT_GT(walk.answered, 900);
  EXPECT_LT(walk.rested, 10);
}

/// The last query of a back-off keeps the poses.
TEST(BackOff, EndsWithThePoses) {
  Walk walk;
  for (int i = 0; i < 20; ++i) walk.ask(4.1, 1e-3 * i);
  detail::contentsOf(walk.cache).collision.back_off.left = 2;
  walk.ask(4.1, 0.02);
  EXPECT_GT(walk.certificate().clearance, 0);
  walk.ask(4.1, 0.021);
  EXPECT_FALSE(walk.certificate().back_off.isOn());
  EXPECT_EQ(walk.certificate().clearance, 0);
  const Pose last = turnedAndMoved(0, 4.1, 0.021);
  EXPECT_TRUE(detail::sameAs(
      walk.certificate().first_id == walk.a.id() ? walk.certificate().second_pose : walk.certificate().first_pose,
      last));
}

/// Discs are asked first as long as they answer, and certificates again from the second query that they leave open.
TEST(BackOff, WhatDiscsDecideAsksNoFact) {
  Walk walk;
  for (int i = 0; i < 100; ++i) walk.ask(20, 1e-3 * i);
  EXPECT_EQ(walk.answered, 0);
  EXPECT_GT(walk.rested, 95);
  EXPECT_EQ(walk.certificate().back_off.left, 1);
  EXPECT_EQ(walk.certificate().clearance, 0);
  walk.ask(4.1, 0);
  EXPECT_EQ(walk.certificate().back_off.left, 0);
  walk.ask(4.1, 1e-5);
  EXPECT_GT(walk.certificate().clearance, 0);
  walk.ask(4.1, 2e-5);
  EXPECT_EQ(walk.answered, 1);
}

}  // namespace
}  // namespace tricover::support
