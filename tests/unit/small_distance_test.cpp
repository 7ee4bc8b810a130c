// SPDX-License-Identifier: BSD-3-Clause
// Distances of small polygons without a tree: the same bits as all pairs of edges give, on all lanes.
#include "distance/small_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "families.h"
#include "portable_lanes.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

using namespace detail;

/// Spikes, sides that face each other where angles and radii are regular, and crossing edges where angles aren't
/// sorted.
Ring smallRing(Random& random, double size, int n) {
  const bool regular = random.oneIn(4), crossing = random.oneIn(6);
  const Vec2 center = random.oneIn(4) ? Vec2(3 * size, -2 * size) : Vec2(0, 0);
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double turn = crossing ? random.real(0, 1) : (i + (regular ? 0 : random.real(0, 0.9))) / n;
    const double angle = 2 * 3.14159265358979 * turn,
                 radius = size * (regular ? (i % 2 + 1) / 2.0 : random.real(0.2, 1));
    ring.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Sixteen edges or fewer, of one or more rings.
Polygon smallPolygon(Random& random, double size) {
  int left = 16;
  std::vector<Ring> rings;
  do {
    rings.push_back(smallRing(random, size * (rings.empty() ? 1 : random.real(0.1, 1)), random.integer(3, left)));
    left -= static_cast<int>(rings.back().size());
  } while (left >= 3 && random.coin());
  return Polygon(rings);
}

/// Two of them, far apart to touching.
Case ringPair(Random& random) {
  const double size = std::pow(10, random.real(-3, 3));
  Case c{smallPolygon(random, size), randomPose(random, size), smallPolygon(random, size * random.real(0.01, 1)),
         randomPose(random, size)};
  if (random.oneIn(4)) c.b = c.a;
  if (random.oneIn(3)) c.pose_b.linear() = c.pose_a.linear();
  if (random.oneIn(3)) c.pose_b = mirrored(c.pose_b);
  const double angle = random.real(-4, 4);
  const Vec2 away(std::cos(angle), std::sin(angle));
  const auto [near, far] = contactOnWay(c, away, 128 * size, random.integer(0, 30));
  c.pose_b.translation() = c.pose_a.translation() + (random.oneIn(8) ? near : far) * away;
  return c;
}

std::vector<std::uint32_t> edgesOf(const PolygonData& polygon) {
  std::vector<std::uint32_t> positions;
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring)
    for (std::size_t e = polygon.edgeBegin(ring); e < polygon.edgeEnd(ring); ++e)
      positions.push_back(static_cast<std::uint32_t>(e));
  return positions;
}

bool lists(const DistanceFacts& cache, std::uint32_t i, std::uint32_t j) {
  for (int k = 0; k < cache.count; ++k)
    if (cache.first_edge[k] == i && cache.second_edge[k] == j) return true;
  return false;
}

TEST(SmallDistance, GivesTheSameBitsAsAllPairsOfEdges) {
  int shown = 0, near = 0, looking_ahead = 0, meeting = 0;
  const int count = scaledCount(20000);
  for (int n = 0; n < count; ++n) {
    Random random(static_cast<std::uint64_t>(n) + 1000);
    const Case c = ringPair(random);
    const bool ordered = c.a.radius() >= c.b.radius();
    const PosedPair pair = ordered ? PosedPair(c.a.data(), c.pose_a, c.b.data(), c.pose_b)
                                   : PosedPair(c.b.data(), c.pose_b, c.a.data(), c.pose_a);
    const EdgeDistances edges(PosedVertices(pair.a, pair.pose_a, pair.b, pair.pose_b));
    const DistanceQuery options;
    DistanceSearch search(edges, options), portable(edges, options), all(edges, options);
    const double ahead = random.coin() ? 0 : random.real(0, 0.5) * pair.b.radius;
    search.lookAhead(ahead);
    portable.lookAhead(ahead);
    const bool is_shown = showSmall(pair, search);
    ASSERT_EQ(onPortableLanes([&] { return showSmall(pair, portable); }), is_shown) << reproduction(c);
    if (!is_shown) {
      meeting += collide(c.a, c.pose_a, c.b, c.pose_b);
      continue;
    }
    ASSERT_FALSE(collide(c.a, c.pose_a, c.b, c.pose_b)) << reproduction(c);
    for (const std::uint32_t i : edgesOf(pair.a))
      for (const std::uint32_t j : edgesOf(pair.b)) ASSERT_TRUE(all.show(i, j)) << reproduction(c);
    DistanceFacts cache;
    search.keep(cache);
    for (const std::uint32_t i : edgesOf(pair.a))
      for (const std::uint32_t j : edgesOf(pair.b))
        ASSERT_TRUE(lists(cache, i, j) || edges.bounds(i, j).high >= cache.apart[cache.count]) << reproduction(c);
    search.finish();
    portable.finish();
    all.finish();
    ASSERT_EQ(search.best().distance, all.best().distance) << reproduction(c);
    ASSERT_EQ(portable.best().distance, all.best().distance) << reproduction(c);
    ++shown;
    near += all.best().distance < 1e-3 * pair.b.radius;
    looking_ahead += cache.count > 4;
  }
  EXPECT_GT(shown, 0.5 * count);
  EXPECT_GT(near, 0.05 * count);
  EXPECT_GT(looking_ahead, 0.1 * count);
  EXPECT_GT(meeting, 0.02 * count);
}

}  // namespace
}  // namespace tricover::support
