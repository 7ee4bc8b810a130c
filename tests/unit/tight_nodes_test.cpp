// SPDX-License-Identifier: BSD-3-Clause
// Nodes fitted in doubles hold their chains, closely; pivots part what sampling finds apart, and nothing else; gaps of
// nodes' corners are those of their edges.
#include "impact/tight_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "impact/node_corners.h"
#include "numbers/segment.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

using detail::kLanes;
using detail::MovingBox;
using detail::MovingPair;
using detail::Node;
using detail::TightNodes;
using detail::Window;

/// Positions of all edges below a node.
std::vector<std::size_t> edgesBelow(const detail::Mover& mover, std::uint32_t index) {
  const Node node = mover.node(index);
  if (node.edge) return {node.child};
  std::vector<std::size_t> edges;
  for (std::uint32_t lane = 0; lane < mover.tree->blocks[node.child].count; ++lane)
    for (const std::size_t e : edgesBelow(mover, node.child * kLanes + lane)) edges.push_back(e);
  return edges;
}

std::vector<std::uint32_t> allNodes(const detail::Mover& mover) {
  std::vector<std::uint32_t> nodes = {detail::kRootNode};
  const auto& blocks = mover.tree->blocks;
  for (std::uint32_t k = 0; k < blocks.size(); ++k)
    for (std::uint32_t lane = 0; lane < blocks[k].count; ++lane) nodes.push_back(k * kLanes + lane);
  return nodes;
}

Motion randomMotion(Random& random) {
  Motion motion = Motion::still(pose(random.real(0, 6), random.real(-3, 3), random.real(-3, 3)));
  motion.angle = random.coin() ? random.real(-2, 2) : 0;
  motion.shift = random.real(0, 1) * Vec2(random.real(-1, 1), random.real(-1, 1));
  motion.pivot = random.coin() ? Vec2(0, 0) : Vec2(random.real(-2, 2), random.real(-2, 2));
  if (random.oneIn(3)) motion.angle_2 = random.real(-1, 1), motion.shift_3 = Vec2(0.3, random.real(-1, 1));
  return motion;
}

Polygon outline(Random& random) {
  const int n = random.integer(3, 200);
  std::vector<Ring> rings = {random.coin() ? regular(n, random.real(0.5, 2)) : star(random, n, 1, 2)};
  if (random.oneIn(4)) rings.push_back(regular(random.integer(3, 30), 0.3));
  return Polygon(rings);
}

TEST(TightNodes, HoldTheirChainsClosely) {
  int fitted = 0, nodes = 0;
  for (int i = 0; i < scaledCount(240); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = outline(random), b = outline(random);
    MovingPair pair(a.data(), randomMotion(random), b.data(), randomMotion(random));
    pair.prepare();
    TightNodes tight(pair.a);
    for (const std::uint32_t index : allNodes(pair.a)) {
      const Node node = tight.node(index), wide = pair.a.node(index);
      ++nodes;
      if (!std::isfinite(node.far)) continue;
      ++fitted;
      EXPECT_EQ(node.child, wide.child);
      EXPECT_EQ(node.edge, wide.edge);
      EXPECT_LE(node.along * node.across, wide.along * wide.across);
      double near = 1e300, far = 0, along = 0, across = 0;
      const Vec2 axis(node.ux, node.uy), center(node.x, node.y), pivot = a.data().inUnits(pair.a.pivot);
      for (const std::size_t e : edgesBelow(pair.a, index))
        for (const double s : {0.0, 0.25, 0.5, 1.0}) {
          const Vec2 p = (1 - s) * a.data().inUnits(a.data().path[e]) + s * a.data().inUnits(a.data().path[e + 1]);
          along = std::max(along, std::abs(axis.dot(p - center)));
          across = std::max(across, std::abs(detail::cross(axis, p - center)));
          const double lever = (pair.a.linear * (p - pivot)).norm();
          near = std::min(near, lever);
          far = std::max(far, lever);
        }
      EXPECT_LE(along, node.along);
      EXPECT_LE(across, node.across);
      EXPECT_GE(along, node.along - 1e-13);
      EXPECT_GE(across, node.across - 1e-13);
      EXPECT_LE(node.near, near + 1e-15);
      EXPECT_GE(node.far, far - 1e-15);
      EXPECT_LE(node.far, far + 1e-15);
    }
  }
  EXPECT_EQ(fitted, nodes) << "but for pivots very far away";
}

TEST(NodeCorners, HaveTheGapsOfTheirEdges) {
  int parted = 0, pairs = 0;
  for (int i = 0; i < scaledCount(240); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = outline(random), b = outline(random);
    const Motion motion_a = randomMotion(random), motion_b = randomMotion(random);
    MovingPair pair(a.data(), motion_a, b.data(), motion_b);
    pair.prepare();
    const Window window(pair, 0.25, 0.75);
    detail::NodeCorners corners_a(pair.a), corners_b(pair.b);
    const std::vector<std::uint32_t> nodes_a = allNodes(pair.a), nodes_b = allNodes(pair.b);
    for (int k = 0; k < 20; ++k, ++pairs) {
      const std::uint32_t node_a = k == 0 ? detail::kRootNode
                                          : nodes_a[random.integer(0, static_cast<int>(nodes_a.size()) - 1)],
                          node_b = k == 0 ? detail::kRootNode
                                          : nodes_b[random.integer(0, static_cast<int>(nodes_b.size()) - 1)];
      const std::vector<Vec2>&below_a = corners_a.below(node_a), &below_b = corners_b.below(node_b);
      const Vec2 guess(random.real(-1, 1), random.real(-1, 1));
      const auto found = detail::axisBetween(below_a, window.a, below_b, window.b, guess, 0);
      parted += found.has_value();
      const Vec2 axis = found.value_or(guess.normalized());
      const detail::Double2 gap =
          detail::gapAlong(detail::GapCutter::standing(axis, 0), below_a, window.a, below_b, window.b);
      for (const int lane : {0, 1}) {
        double least = 1e300, most_a = -1e300;
        for (const std::size_t e : edgesBelow(pair.a, node_a))
          for (const int end : {0, 1}) most_a = std::max(most_a, axis.dot(pair.a.ends(window.a, lane, e).end(end)));
        for (const std::size_t e : edgesBelow(pair.b, node_b))
          for (const int end : {0, 1})
            least = std::min(least, axis.dot(pair.b.ends(window.b, lane, e).end(end)) - most_a);
        EXPECT_NEAR(gap[lane], least, 1e-14);
        EXPECT_TRUE(!found || lane == 1 || gap[lane] > 0) << "an axis that parts nothing";
      }
    }
  }
  EXPECT_GT(parted, pairs / 4);
  EXPECT_LT(parted, pairs * 99 / 100);
}

/// Of two nodes that pivots part no sampled points are within the margin.
TEST(TightNodes, PivotsPartWhatIsApart) {
  int parted = 0, asked = 0;
  for (int i = 0; i < scaledCount(300); ++i) {
    Random random(static_cast<std::uint64_t>(i) + 1000);
    const bool is_hole = random.coin();  // something that turns in it, or around
    const Polygon a(is_hole ? Polygon({regular(60, 2.2), regular(60, 2.05)}) : outline(random)),
        b = is_hole && random.coin() ? Polygon({regular(60, random.real(1.95, 2.05))}) : outline(random);
    Motion motion_a = randomMotion(random), motion_b = randomMotion(random);
    if (is_hole) {
      motion_a.start = pose(random.real(0, 6), random.real(-0.1, 0.1), 0);
      motion_b.start = pose(random.real(0, 6), 0, 0);
      motion_b.pivot = motion_a.pivot = Vec2(0, 0);
    }
    MovingPair pair(a.data(), motion_a, b.data(), motion_b, random.coin() ? 0.05 : 0);
    pair.prepare();
    TightNodes tight_a(pair.a), tight_b(pair.b);
    const std::vector<std::uint32_t> of_a = allNodes(pair.a), of_b = allNodes(pair.b);
    for (int k = 0; k < 100; ++k) {
      const std::uint32_t s = of_a[static_cast<std::size_t>(random.integer(0, static_cast<int>(of_a.size()) - 1))];
      const std::uint32_t t = of_b[static_cast<std::size_t>(random.integer(0, static_cast<int>(of_b.size()) - 1))];
      const double begin = random.unit(), end = begin + (1 - begin) * random.unit();
      const Window window(pair, begin, end);
      const Node node_a = tight_a.node(s), node_b = tight_b.node(t);
      ++asked;
      if (!detail::partedByPivots(window, node_a, pair.a.box(window.a, node_a), node_b, pair.b.box(window.b, node_b)))
        continue;
      ++parted;
      for (const double time : {begin, 0.5 * (begin + end), end}) {
        const detail::Places at_a = pair.a.places(time, time), at_b = pair.b.places(time, time);
        for (const std::size_t e : edgesBelow(pair.a, s))
          for (const std::size_t f : edgesBelow(pair.b, t)) {
            const detail::NearestPoints nearest(pair.a.edge(at_a, e), pair.b.edge(at_b, f), 0, 0);
            ASSERT_GT(nearest.distance, pair.margin) << i << ", " << k;
          }
      }
    }
  }
  std::printf("%d of %d parted\n", parted, asked);
  EXPECT_GE(parted, 0.05 * asked);
  EXPECT_LE(parted, 0.95 * asked);
}

}  // namespace
}  // namespace tricover::support
