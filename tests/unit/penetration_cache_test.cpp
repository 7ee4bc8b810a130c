// SPDX-License-Identifier: BSD-3-Clause
// penetration() with a cache: the depth without one, on walks that slide, rest, rotate and jump, in either order, with
// other polygons' cache and an old one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "queries.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

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

void ask(const Case& c, PairCache& cache, double margin = 0) {
  static const Query& query = *std::find_if(queries().begin(), queries().end(),
                                            [](const Query& q) { return std::string(q.name) == "penetration"; });
  EXPECT_EQ(wrongWithCache(c, query, {margin, false, &cache}), "") << reproduction(c);
}

/// How a body goes on from pose to pose.
void step(Random& random, int manner, double length, const Vec2& along, Case& c) {
  if (manner != 1) c.pose_b.translation() += length * along;
  if (manner == 1 || manner == 2) turn(c.pose_b, 0.3 * length);
  if (manner == 3) turn(c.pose_a, 0.1 * length);
  if (random.oneIn(12)) c.pose_b.translation() -= 5 * length * along;
  if (random.oneIn(30)) c.pose_b.translation() = c.pose_a.translation() + 0.3 * direction(random.real(0, 6.3));
}

void walk(int seed, const Corners& corners, PairCache& cache) {
  Random random(static_cast<std::uint64_t>(seed));
  Case c{anyOutline(random, corners), randomPose(random, 3), anyOutline(random, corners), randomPose(random, 0)};
  if (random.oneIn(4)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(6)) c.pose_a = mirrored(c.pose_a);
  if (random.oneIn(6)) c.pose_b = throughFloat(c.pose_b);
  if (random.oneIn(8)) c.pose_a.translation() += Vec2(1e6, -1e6);
  const Vec2 along = direction(random.real(0, 6.3));
  c.pose_b.translation() = c.pose_a.translation() + random.real(0.1, 0.8) * direction(random.real(0, 6.3));
  const double margin = random.oneIn(6) ? 0.05 : 0;
  const int manner = random.integer(0, 5);
  const double length = std::exp2(random.real(-12, -4));
  for (int i = 0; i < 24; ++i) {
    ask(random.oneIn(4) ? Case{c.b, c.pose_b, c.a, c.pose_a} : c, cache, margin);
    step(random, manner, length, along, c);
  }
}

TEST(PenetrationCache, ChangesNoDepth) {
  PairCache lasting;
  for (int i = 0; i < scaledCount(300); ++i) {
    PairCache fresh;
    walk(i, kMany, i % 4 == 0 ? lasting : fresh);
  }
  // What is nearest in one square was found in another.
  for (const int seed : {1593, 230}) {
    PairCache fresh;
    walk(seed, kFew, fresh);
  }
}

TEST(PenetrationCache, IsAValue) {
  Random random(3);
  const Polygon a = anyOutline(random), b = anyOutline(random), other = anyOutline(random);
  PairCache cache, old;
  for (int i = 0; i < 40; ++i) {
    const Case c{a, Pose::Identity(), b, turnedAndMoved(0.3, 0.2 + 0.002 * i, 0.1)};
    PairCache copy = i % 3 == 0 ? old : cache;
    ask(c, cache);
    ask(c, copy);
    PairCache of_others = cache;
    ask({other, c.pose_a, b, c.pose_b}, of_others);
    of_others = cache;
    ask({a, c.pose_a, other, c.pose_b}, of_others);
    if (i == 10) old = cache;
  }
}

}  // namespace
}  // namespace tricover::support
