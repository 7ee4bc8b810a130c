// SPDX-License-Identifier: BSD-3-Clause
// The gap of a line between convex polygons is a lower bound of their distance.
#include "pair/convex_apart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact_reference.h"
#include "hierarchy/hierarchy.h"
#include "polygon/cache_access.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover::support {
namespace {

/// Round ones and boxes, some with straight and repeated vertices, either way around.
Ring anyConvex(Random& random, double size) {
  Ring ring = star(random, random.integer(3, 40), size, size);
  if (random.oneIn(3)) ring = rectangle(-size, -size / 4, size, size / 4);
  if (random.oneIn(3)) {
    Ring more;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      more.push_back(ring[k]);
      const Vec2& next = ring[(k + 1) % ring.size()];
      if (ring[k].x() == next.x() || ring[k].y() == next.y()) more.push_back((ring[k] + next) / 2);
      if (random.coin()) more.push_back(more.back());
    }
    ring = more;
  }
  if (random.coin()) std::reverse(ring.begin(), ring.end());
  return ring;
}

TEST(ConvexApart, IsNeverMoreThanTheDistance) {
  Random random(97);
  const int cases = scaledCount(4000);
  int found = 0, tight = 0, apart = 0;
  for (int i = 0; i < cases; ++i) {
    const double scale = random.oneIn(8) ? std::pow(10, random.integer(-140, 140)) : 1;
    const Polygon a({anyConvex(random, scale)}), b({anyConvex(random, scale * random.real(0.1, 1))});
    if (detail::hierarchyOf(a.data()).convex == 0 || detail::hierarchyOf(b.data()).convex == 0) continue;
    Pose pose_a = pose(random.real(0, 6.3), 0, 0), pose_b = pose(random.oneIn(3) ? 0 : random.real(0, 6.3), 0, 0);
    if (random.oneIn(3)) pose_a = Pose::Identity();
    if (random.oneIn(4)) pose_b = mirrored(pose_b);
    if (random.oneIn(4)) pose_b = distorted(random, pose_b);
    pose_b.translation() = 3 * scale * direction(random.real(0, 6.3));
    // Nearer, to gaps from all of it to what rounding leaves in doubt, and some into each other.
    const DistanceResult far = distance(a, pose_a, b, pose_b);
    const double gap = far.distance * std::pow(10, random.real(-17, 0)) * (random.oneIn(8) ? -1 : 1);
    pose_b.translation() -= (1 - gap / far.distance) * (far.point_b - far.point_a);
    const detail::PosedPair pair(a.data(), pose_a, b.data(), pose_b);
    const auto anyVertex = [&](const Polygon& polygon) {
      return random.oneIn(3) ? -1 : random.integer(0, static_cast<int>(polygon.vertexCount()) - 1);
    };
    const auto line = detail::findConvexApart(pair, anyVertex(a), anyVertex(b), random.coin() ? 2 * scale : 0);
    const bool collides = exact::collide(a, pose_a, b, pose_b);
    apart += !collides;
    if (!line) continue;
    ASSERT_FALSE(collides) << i;
    const double exact = exact::distanceBelow(exact::distanceSquared(a, pose_a, b, pose_b));
    ASSERT_GT(line->gap, 0);
    ASSERT_LE(line->gap * (1 - pair.scale_defect), exact * (1 + 1e-15)) << i;
    ASSERT_LT(static_cast<std::size_t>(line->near_a), a.vertexCount());
    ASSERT_LT(static_cast<std::size_t>(line->near_b), b.vertexCount());
    ++found;
    tight += line->gap > 0.5 * exact;
  }
  EXPECT_GT(apart, cases / 2);
  EXPECT_GT(found, apart / 3);
  EXPECT_GT(tight, found / 2);
}

TEST(ConvexApart, GoesOnAlongBothOutlines) {
  // A round one slides along a side, a hundredth above it: the line is found from where it was before, as far as the
  // vertices that bound it have moved on.
  const Polygon floor({rectangle(-100, -1, 100, 0)}), wheel({regular(64, 1)});
  std::ptrdiff_t near_a = -1, near_b = -1;
  for (int i = 0; i < 200; ++i) {
    const Pose here = Pose::Identity(), there = pose(-0.013 * i, -1.0 + 0.01 * i, 1.01);
    const detail::PosedPair pair(floor.data(), here, wheel.data(), there);
    const auto line = detail::findConvexApart(pair, near_a, near_b, 0);
    ASSERT_TRUE(line) << i;
    EXPECT_GE(line->gap, 0.01 - 1e-12) << i;
    EXPECT_LE(line->gap, distance(floor, here, wheel, there).distance + 1e-12) << i;
    near_a = line->near_a;
    near_b = line->near_b;
  }
}

/// The same walk by collide(): what expires goes on along the line, and costs no answer.
TEST(ConvexApart, CachesGoOnWithIt) {
  const Polygon a({regular(256, 1)}), b({regular(40, 0.5)});
  PairCache cache;
  int on_line = 0, hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.003 * i, far = 1.5001 + 0.0002 * std::sin(0.01 * i);
    const Pose there = pose(0.5 * angle, far * std::cos(angle), far * std::sin(angle));
    const bool hit = collide(a, Pose::Identity(), b, there, cache);
    ASSERT_EQ(hit, collide(a, Pose::Identity(), b, there)) << i;
    hits += hit;
    const detail::CollisionFact& fact = detail::factsIn(cache).collision;
    on_line += !fact.overlapping && fact.first_edge >= 0;
  }
  EXPECT_GT(on_line, 500);
  EXPECT_GT(hits, 20);
}

}  // namespace
}  // namespace tricover::support
