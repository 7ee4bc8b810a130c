// SPDX-License-Identifier: BSD-3-Clause
// The bounds that windows of time are cut by, each by itself: contact that is made to happen is never cut off.
#include "apart/window_cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apart/cubic.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using namespace detail;

double anySize(Random& random) { return std::pow(10, random.real(-1.5, 1)); }

Vec2 anyVector(Random& random) {
  const double size = anySize(random);
  return {random.real(-size, size), random.real(-size, size)};
}

Motion anyMotion(Random& random, double angle) {
  Motion motion;
  motion.start = random.oneIn(4) ? distorted(random, randomPose(random, 1)) : randomPose(random, 1);
  motion.angle = angle;
  if (random.coin()) motion.shift = anyVector(random);
  if (random.coin()) motion.pivot = anyVector(random);
  return motion;
}

/// Like rates are where axes that turn gain most, and where their bounds have the least room.
void anyAngles(Random& random, double& angle_a, double& angle_b) {
  angle_a = random.oneIn(3) ? 0 : random.real(-6, 6);
  angle_b = random.oneIn(3) ? angle_a : random.oneIn(3) ? 2 * angle_a : random.oneIn(3) ? 0 : random.real(-6, 6);
  if (random.coin()) std::swap(angle_a, angle_b);
}

/// One of the ways to cut.
bool cut(WindowCutter& cutter, int way, const Vec2& axis) {
  if (way == 0) return cutter.cutByAxesOfA();
  if (way == 1) return cutter.cutByAxesOfB();
  if (way == 2) return cutter.cutByNormals();
  return cutter.cutByAxis(axis);
}

/// A way that starts and ends at rest moves between, by up to 3/2: its rate isn't the larger of those at the ends.
TEST(Cubic, BoundsTheRateWithinAWindow) {
  const Cubic<double> way{0, 3, -2};
  EXPECT_EQ(way.rateAt(0), 0);
  EXPECT_EQ(way.rateAt(1), 0);
  EXPECT_EQ(way.rateAt(0.5), 1.5);
  EXPECT_GE(way.mostRate(0, 1), 1.5);
  EXPECT_GE(way.mostRate(0.25, 0.75), 1.5);
  EXPECT_LE(way.mostRate(0.5 - 1e-3, 0.5 + 1e-3), 1.5 + 1e-5);
}

/// A vertex of one is put on an edge or a vertex of the other at some time of a window.
TEST(WindowCutter, NeverCutsContactOff) {
  const int cases = scaledCount(400000);
  int parted[4] = {}, cuts[4] = {};
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a({shifted(star(random, 3, 0.2, 1), anyVector(random))});
    const Polygon b({shifted(star(random, 3, 0.2, 1), anyVector(random))});
    double angle_a, angle_b;
    anyAngles(random, angle_a, angle_b);
    const Motion motion_a = anyMotion(random, angle_a);
    Motion motion_b = anyMotion(random, angle_b);
    const double begin = random.oneIn(3) ? 0 : random.unit(), length = (1 - begin) * std::pow(10, random.real(-2, 0));
    const double share = random.unit(), met = begin + share * length;
    const std::size_t edge_a = static_cast<std::size_t>(random.integer(0, 2)),
                      edge_b = static_cast<std::size_t>(random.integer(0, 2));
    const auto on = [&](const Polygon& polygon, std::size_t edge, bool vertex) -> Vec2 {
      const double at = vertex ? random.integer(0, 1) : random.unit();
      return (1 - at) * polygon.edgeStart(edge) + at * polygon.edgeEnd(edge);
    };
    const bool vertex_of_a = random.coin();
    const Vec2 point_a = on(a, edge_a, vertex_of_a), point_b = on(b, edge_b, !vertex_of_a || random.oneIn(4));
    motion_b.start.translation() += motion_a.at(met) * point_a - motion_b.at(met) * point_b;

    const MovingPair pair(a.data(), motion_a, b.data(), motion_b);
    const Window window(pair, begin, begin + length);
    const MovingBox box_a = pair.a.edge(window.a, edge_a), box_b = pair.b.edge(window.b, edge_b);
    const NearestPoints at_begin(box_a, box_b, 0, pair.error);
    for (int way = 0; way < 4; ++way) {
      WindowCutter cutter(window, box_a, box_b);
      ASSERT_FALSE(cut(cutter, way, (at_begin.on_b - at_begin.on_a) / at_begin.distance))
          << "case " << i << ", way " << way << " parts edges that meet at " << share;
      const Rest rest = cutter.rest();
      // What the window's length in time loses to rounding.
      ASSERT_LE(rest.low, share + 1e-12) << "case " << i << ", way " << way;
      ASSERT_GE(rest.high, share - 1e-12) << "case " << i << ", way " << way;
      cuts[way] += rest.low > 0.5 * share || rest.high < 0.5 * (share + 1);
    }
    // Moved aside by a little, they are parted where the bounds are of any use.
    motion_b.start.translation() += Vec2(0.3, 0.4) * anySize(random);
    const MovingPair aside(a.data(), motion_a, b.data(), motion_b);
    const Window other(aside, begin, begin + length);
    const MovingBox aside_a = aside.a.edge(other.a, edge_a), aside_b = aside.b.edge(other.b, edge_b);
    const NearestPoints from(aside_a, aside_b, 0, aside.error);
    for (int way = 0; way < 4; ++way) {
      WindowCutter cutter(other, aside_a, aside_b);
      parted[way] += cut(cutter, way, (from.on_b - from.on_a) / from.distance);
    }
  }
  for (int way = 0; way < 4; ++way) {
    EXPECT_GT(parted[way], cases / 5) << "way " << way;
    EXPECT_GT(cuts[way], cases / 20) << "way " << way;
  }
}

}  // namespace
}  // namespace tricover::support
