// SPDX-License-Identifier: BSD-3-Clause
// penetration() with a cache: the depth without one, on walks that slide, rest, rotate and jump, in either order, with
// other polygons' cache and an old one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/penetration.h"

namespace tricover::support {
namespace {

struct Tally {
  int queries = 0, wrong = 0;
};

struct Corners {
  int least, most;
};
/// With fewer, most searches are too short for a cache.
constexpr Corners kMany = {20, 56}, kFew = {12, 40};

Polygon anyOutline(Random& random, const Corners& corners = kMany) {
  std::vector<Ring> rings = {star(random, random.integer(corners.least, corners.most), 0.4, 1)};
  if (random.oneIn(3)) rings.push_back(scaled(star(random, random.integer(4, 9), 0.5, 1), 0.3));
  if (random.oneIn(4)) std::reverse(rings[0].begin(), rings[0].end());
  return Polygon(rings);
}

/// What penetration.h promises.
double precisionOf(const Case& c) {
  const double size = c.a.radius() + c.b.radius() + (c.pose_a.translation() - c.pose_b.translation()).norm();
  return 4e-12 * std::min(c.a.radius(), c.b.radius()) + 4e-13 * size + 1e-14 * c.pose_a.translation().norm();
}

bool partsThem(const Case& c, const Penetration& p, const PenetrationOptions& options) {
  Pose moved = c.pose_b;
  moved.translation() += p.translation;
  return !collide(c.a, c.pose_a, c.b, moved, {options.margin});
}

void ask(const Case& c, PairCache& cache, const PenetrationOptions& options, Tally& tally) {
  const auto without = penetration(c.a, c.pose_a, c.b, c.pose_b, options);
  const auto with = penetration(c.a, c.pose_a, c.b, c.pose_b, cache, options);
  ++tally.queries;
  bool right = with.has_value() == without.has_value();
  if (with && without) {
    const double error = precisionOf(c);
    right = partsThem(c, *with, options) && with->lower_bound <= with->depth &&
            with->lower_bound <= without->depth + error && without->lower_bound <= with->depth + error;
    if (options.margin == 0)
      right = right && with->optimal == without->optimal && std::abs(with->depth - without->depth) <= error;
  }
  if (right) return;
  if (++tally.wrong <= 3 && with && without)
    std::printf("depth %.17g instead of %.17g\n%s\n", with->depth, without->depth, reproduction(c).c_str());
}

/// How a body goes on from pose to pose.
void step(Random& random, int manner, double length, const Vec2& along, Case& c) {
  if (manner != 1) c.pose_b.translation() += length * along;
  if (manner == 1 || manner == 2) turn(c.pose_b, 0.3 * length);
  if (manner == 3) turn(c.pose_a, 0.1 * length);
  if (random.oneIn(12)) c.pose_b.translation() -= 5 * length * along;
  if (random.oneIn(30)) c.pose_b.translation() = c.pose_a.translation() + 0.3 * direction(random.real(0, 6.3));
}

void walk(int seed, const Corners& corners, PairCache& cache, Tally& tally) {
  Random random(static_cast<std::uint64_t>(seed));
  Case c{anyOutline(random, corners), randomPose(random, 3), anyOutline(random, corners), randomPose(random, 0)};
  if (random.oneIn(4)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(6)) c.pose_a = mirrored(c.pose_a);
  if (random.oneIn(6)) c.pose_b = throughFloat(c.pose_b);
  if (random.oneIn(8)) c.pose_a.translation() += Vec2(1e6, -1e6);
  const Vec2 along = direction(random.real(0, 6.3));
  c.pose_b.translation() = c.pose_a.translation() + random.real(0.1, 0.8) * direction(random.real(0, 6.3));
  PenetrationOptions options;
  if (random.oneIn(6)) options.margin = 0.05;
  const int manner = random.integer(0, 5);
  const double length = std::exp2(random.real(-12, -4));
  for (int i = 0; i < 24; ++i) {
    ask(random.oneIn(4) ? Case{c.b, c.pose_b, c.a, c.pose_a} : c, cache, options, tally);
    step(random, manner, length, along, c);
  }
}

TEST(PenetrationCache, ChangesNoDepth) {
  Tally tally;
  PairCache lasting;
  for (int i = 0; i < scaledCount(300); ++i) {
    PairCache fresh;
    walk(i, kMany, i % 4 == 0 ? lasting : fresh, tally);
  }
  // What is nearest in one square was found in another.
  for (const int seed : {1593, 230}) {
    PairCache fresh;
    walk(seed, kFew, fresh, tally);
  }
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.queries, scaledCount(300) * 20);
}

TEST(PenetrationCache, IsAValue) {
  Random random(3);
  const Polygon a = anyOutline(random), b = anyOutline(random), other = anyOutline(random);
  PairCache cache, old;
  for (int i = 0; i < 40; ++i) {
    const Case c{a, Pose::Identity(), b, pose(0.3, 0.2 + 0.002 * i, 0.1)};
    Tally tally;
    PairCache copy = i % 3 == 0 ? old : cache;
    ask(c, cache, {}, tally);
    ask(c, copy, {}, tally);
    PairCache of_others = cache;
    ask({other, c.pose_a, b, c.pose_b}, of_others, {}, tally);
    of_others = cache;
    ask({a, c.pose_a, other, c.pose_b}, of_others, {}, tally);
    ASSERT_EQ(tally.wrong, 0);
    if (i == 10) old = cache;
  }
}

}  // namespace
}  // namespace tricover::support
