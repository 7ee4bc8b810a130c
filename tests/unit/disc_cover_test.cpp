// SPDX-License-Identifier: BSD-3-Clause
// Discs that cover a region lie in it, and wherever a sum of those of two says so, the regions overlap.
#include "contact/disc_cover.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <vector>

#include "contact/translation_space.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/locate.h"

namespace tricover::support {
namespace {

/// Of up to 400 vertices, which the search for discs thins, with a hole, off the origin.
Polygon anyRegion(Random& random, double size) {
  const Vec2 off(random.real(-9, 9), random.real(-9, 9));
  std::vector<Ring> rings = {star(random, 2 * random.integer(4, random.coin() ? 20 : 200), 1, 2)};
  if (random.coin()) rings.push_back(star(random, random.integer(3, 30), 0.2, 0.8));
  for (Ring& ring : rings) ring = scaled(shifted(ring, off), size);
  return Polygon(rings);
}

TEST(DiscCover, LiesInTheRegion) {
  std::size_t discs = 0;
  const int cases = scaledCount(40);
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon polygon = anyRegion(random, 0.3);
    const std::vector<detail::Disc>& cover = detail::discCoverOf(polygon.data());
    discs += cover.size();
    for (const detail::Disc& disc : cover)
      for (int way = 0; way < 40; ++way) {
        const Vec2 p = disc.center + 0.9999 * disc.radius * pose(0.157 * way, 0, 0).linear().col(0);
        ASSERT_NE(locate(polygon, polygon.origin() + p * polygon.data().unit), Location::Outside) << "seed " << i;
      }
  }
  EXPECT_GE(discs, static_cast<std::size_t>(20 * cases));
}

/// The largest radius around t that they say is held, to within a thousandth; 0 if none is.
double heldRadius(const detail::DiscSums& sums, const Vec2& t) {
  double low = 0, high = 8;
  while (high - low > 1e-3 * high) {
    if (high < 1e-6) return 0;
    const double middle = 0.5 * (low + high);
    (sums.hold(t, middle) ? low : high) = middle;
  }
  return low;
}

TEST(DiscSums, HoldWhatOverlaps) {
  int asked = 0, held = 0, kept = 0;
  for (int i = 0; i < scaledCount(60); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = anyRegion(random, random.coin() ? 1 : 0.3), b = anyRegion(random, random.coin() ? 1 : 0.1);
    Pose pose_a = randomPose(random, 3), pose_b = randomPose(random, 0);
    if (random.coin()) pose_a = mirrored(pose_a);
    if (random.coin()) pose_b = mirrored(pose_b);
    pose_b.translation() += pose_a * a.origin() - pose_b * b.origin();
    const detail::TranslationSpace space(a.data(), pose_a, b.data(), pose_b);
    const detail::DiscSums all = space.discSums();
    for (int k = 0; k < 10; ++k) {
      const Vec2 t = Vec2(random.real(-1, 1), random.real(-1, 1)) * (a.radius() + b.radius()) / space.unit();
      const double radius = heldRadius(all, t);
      ++asked;
      if (radius == 0) continue;
      ++held;
      for (int way = 0; way < 40; ++way) {
        Pose moved = pose_b;
        const Vec2 aside = pose(0.157 * way, 0, 0).linear().col(0) * 0.999 * radius;
        moved.translation() += (t + aside) * space.unit();
        ASSERT_TRUE(collide(a, pose_a, b, moved)) << "seed " << i << ", " << k << ", way " << way;
      }
      // What holds a part of a cell that isn't at its end is near the cell.
      kept += all.near(t + Vec2(1.6 * radius, 0), 4 * radius).hold(t, radius);
    }
  }
  std::printf("%d of %d held, %d of them by those near, too\n", held, asked, kept);
  EXPECT_GE(held, 0.1 * asked);
  EXPECT_LE(held, 0.9 * asked);
  EXPECT_EQ(kept, held);
}

}  // namespace
}  // namespace tricover::support
