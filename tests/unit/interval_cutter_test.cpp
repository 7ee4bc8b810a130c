// SPDX-License-Identifier: BSD-3-Clause
// The bounds that intervals of time are cut by, each by itself: contact that is made to happen is never cut off.
#include "impact/interval_cutter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "impact/vertex_paths.h"
#include "numbers/cubic.h"
#include "portable_lanes.h"
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
  if (random.oneIn(4)) motion.shift_2 = anyVector(random);
  if (random.oneIn(4)) motion.shift_3 = anyVector(random);
  if (angle != 0 && random.oneIn(4)) motion.angle_2 = random.real(-1, 1);
  return motion;
}

/// Like rates are where axes that turn gain most, and where their bounds have the least room.
void anyAngles(Random& random, double& angle_a, double& angle_b) {
  angle_a = random.oneIn(3) ? 0 : random.real(-6, 6);
  angle_b = random.oneIn(3) ? angle_a : random.oneIn(3) ? 2 * angle_a : random.oneIn(3) ? 0 : random.real(-6, 6);
  if (random.coin()) std::swap(angle_a, angle_b);
}

constexpr int kWays = 5;

/// What one of the ways leaves of an interval in which two edges may meet; nothing if low > high.
Rest restBy(int way, const TimeInterval& interval, detail::EdgePosition edge_a, detail::EdgePosition edge_b) {
  if (way == 4) return restOfEdges(interval, edge_a, edge_b);
  const MovingBox a = interval.pair.a.edge(interval.a, edge_a), b = interval.pair.b.edge(interval.b, edge_b);
  const NearestPoints at_begin(interval.pair.a.ends(interval.a, 0, edge_a), interval.pair.b.ends(interval.b, 0, edge_b),
                               interval.pair.error);
  IntervalCutter cutter(interval, a, b);
  const bool parts = way == 0   ? cutter.cutByAxesOfA()
                     : way == 1 ? cutter.cutByAxesOfB()
                     : way == 2 ? cutter.cutByNormals()
                                : cutter.cutByAxis((at_begin.on_b - at_begin.on_a) / at_begin.distance);
  return parts ? Rest{1, 0, 0} : cutter.rest();
}

/// A way that starts and ends at rest moves between, by up to 3/2: its rate isn't the larger of those at the ends.
TEST(Cubic, BoundsTheRateWithinAnInterval) {
  const Cubic<double> way{0, 3, -2};
  EXPECT_EQ(way.rateAt(0), 0);
  EXPECT_EQ(way.rateAt(1), 0);
  EXPECT_EQ(way.rateAt(0.5), 1.5);
  EXPECT_GE(way.mostRate(0, 1), 1.5);
  EXPECT_GE(way.mostRate(0.25, 0.75), 1.5);
  EXPECT_LE(way.mostRate(0.5 - 1e-3, 0.5 + 1e-3), 1.5 + 1e-5);
}

/// A vertex of one is put on an edge or a vertex of the other at some time of an interval.
TEST(IntervalCutter, NeverCutsContactOff) {
  const int cases = scaledCount(400000);
  int parted[kWays] = {}, cuts[kWays] = {};
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
    const auto edge_a = static_cast<detail::EdgePosition>(random.integer(0, 2)),
               edge_b = static_cast<detail::EdgePosition>(random.integer(0, 2));
    const auto on = [&](const Polygon& polygon, std::size_t position, bool vertex) -> Vec2 {
      const auto edge = static_cast<EdgeIndex>(position);
      const double at = vertex ? random.integer(0, 1) : random.unit();
      return (1 - at) * polygon.edgeStart(edge) + at * polygon.edgeEnd(edge);
    };
    const bool vertex_of_a = random.coin();
    const Vec2 point_a = on(a, edge_a, vertex_of_a), point_b = on(b, edge_b, !vertex_of_a || random.oneIn(4));
    motion_b.start.translation() += motion_a.at(met) * point_a - motion_b.at(met) * point_b;

    MovingPair pair(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b);
    pair.prepare();
    const TimeInterval interval(pair, begin, begin + length);
    for (int way = 0; way < kWays; ++way) {
      const Rest rest = restBy(way, interval, edge_a, edge_b);
      ASSERT_LE(rest.low, rest.high) << "case " << i << ", way " << way << " parts edges that meet at " << share;
      // What the interval's length in time loses to rounding.
      ASSERT_LE(rest.low, share + 1e-12) << "case " << i << ", way " << way;
      ASSERT_GE(rest.high, share - 1e-12) << "case " << i << ", way " << way;
      cuts[way] += rest.low > 0.5 * share || rest.high < 0.5 * (share + 1);
    }
    // Moved aside by a little, they are parted where the bounds are of any use.
    motion_b.start.translation() += Vec2(0.3, 0.4) * anySize(random);
    const MovingPair aside(detail::dataOf(a), motion_a, detail::dataOf(b), motion_b);
    const TimeInterval other(aside, begin, begin + length);
    for (int way = 0; way < kWays; ++way) {
      const Rest rest = restBy(way, other, edge_a, edge_b);
      parted[way] += rest.low > rest.high;
    }
  }
  for (int way = 0; way < kWays; ++way) {
    EXPECT_GT(parted[way], cases / 5) << "way " << way;
    EXPECT_GT(cuts[way], cases / 20) << "way " << way;
  }
}

/// A box around a block's origin, and one that moves by `way`, bent aside by `bend`, and turns about its middle.
struct MovedBox {
  Vec2 middle, way, bend;
  double angle, turn, along, across;

  Vec2 at(double share, double u, double v) const {
    const Vec2 axis = direction(angle + share * turn);
    return middle + share * way + share * (1 - share) * bend + u * along * axis +
           v * across * Vec2(-axis.y(), axis.x());
  }
};

struct MovingQuery {
  MovingBox box;
  double with_block, with_box, slack;

  unsigned cut(const Block& block, float* from_begin, float* from_end) const {
    return cutIntervals(block, box, with_block, with_box, slack, from_begin, from_end);
  }
};
MovingQuery queryOf(const MovedBox& box, double reach) {
  MovingQuery query{};
  double sum = 0;
  for (int end = 0; end < 2; ++end) {
    const Vec2 p = box.at(end, 0, 0), axis = direction(box.angle + end * box.turn);
    query.box.x[end] = p.x();
    query.box.y[end] = p.y();
    query.box.ux[end] = axis.x();
    query.box.uy[end] = axis.y();
    sum = std::max(sum, p.lpNorm<1>() + box.along + box.across + 4);
  }
  query.box.along = box.along;
  query.box.across = box.across;
  query.slack = kMovingGapRounding * sum;
  const double rate = std::abs(box.turn), extent = box.along + box.across, speed = box.way.norm() + box.bend.norm();
  const double apart = box.middle.norm() + box.way.norm() + box.bend.norm() + reach, pull = 2 * box.bend.norm();
  query.with_block = 0.5 * (rate * rate * extent + pull) * (1 + 0x1p-10);
  query.with_box = 0.5 * (rate * rate * apart + 2 * rate * speed + pull) * (1 + 0x1p-10);
  return query;
}

/// Of eight boxes at once, a point of each in turn is met by one of the box that moves.
TEST(CutIntervals, NeverCutsContactOff) {
  const int cases = scaledCount(100000);
  int parted = 0, cuts = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const auto f = [](double value) { return static_cast<float>(value); };
    const auto size = [&] { return std::pow(10, random.real(-3, 0)); };
    Block block{};
    block.count = static_cast<std::uint8_t>(random.integer(1, kLanes));
    for (int k = 0; k < block.count; ++k) {
      const Vec2 axis = direction(random.real(-4, 4));
      block.x[k] = f(random.real(-0.5, 0.5));
      block.y[k] = f(random.real(-0.5, 0.5));
      block.ux[k] = f(axis.x());
      block.uy[k] = f(axis.y());
      block.along[k] = f(0.4 * size());
      block.across[k] = random.oneIn(3) ? 0 : f(0.2 * size());
    }
    MovedBox box{{0, 0}, anyVector(random), {0, 0}, random.real(-4, 4), 0, size(), random.oneIn(3) ? 0 : size()};
    if (random.coin()) box.turn = random.real(-1, 1);
    if (random.coin()) box.bend = 0.3 * anyVector(random);
    const int lane = random.integer(0, block.count - 1);
    const double share = random.oneIn(4) ? random.integer(0, 1) : random.unit();
    const auto inside = [&] { return random.coin() ? (random.coin() ? 1 : -1) : random.real(-1, 1); };
    const auto d = [](float value) { return static_cast<double>(value); };
    const double u = inside() * d(block.along[lane]), v = inside() * d(block.across[lane]);
    const Vec2 axis(d(block.ux[lane]), d(block.uy[lane]));
    const Vec2 met = Vec2(d(block.x[lane]), d(block.y[lane])) + u * axis + v * Vec2(-axis.y(), axis.x());
    box.middle = met - box.at(share, inside(), inside());

    const MovingQuery query = queryOf(box, 1.5);
    float from_begin[kLanes], from_end[kLanes], begin[kLanes], end[kLanes];
    const unsigned left = query.cut(block, from_begin, from_end);
    ASSERT_EQ(onPortableLanes([&] { return query.cut(block, begin, end); }), left) << i;
    ASSERT_EQ(left >> block.count, 0u) << i;
    ASSERT_NE(left >> lane & 1, 0u) << "case " << i << " parts boxes that meet at " << share;
    ASSERT_LE(d(from_begin[lane]), share) << i;
    ASSERT_LE(d(from_end[lane]), 1 - share) << i;
    ASSERT_EQ(begin[lane], from_begin[lane]) << i;
    ASSERT_EQ(end[lane], from_end[lane]) << i;
    cuts += d(from_begin[lane]) > 0.5 * share || d(from_end[lane]) > 0.5 * (1 - share);
    parted += block.count - __builtin_popcount(left);
  }
  EXPECT_GT(cuts, cases / 5);
  EXPECT_GT(parted, cases / 2);
}

}  // namespace
}  // namespace tricover::support
