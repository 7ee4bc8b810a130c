// SPDX-License-Identifier: BSD-3-Clause
// What pruned boxes promise of the pairs of edges that they leave out, and how few they leave.
#include "distance/pruned_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <vector>

#include "exact_reference.h"
#include "growth_inputs.h"
#include "pair/edge_pairs.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/distance.h"

namespace tricover::support {
namespace {

using detail::EdgeDistances;
using detail::PolygonData;
using detail::PosedVertices;
using detail::PrunedBoxes;

/// Which positions are of edges in pruned lanes.
std::vector<bool> prunedEdges(const PolygonData& polygon, const std::uint8_t* lanes) {
  std::vector<bool> pruned(polygon.path.size(), false);
  const std::vector<detail::Block>& blocks = detail::hierarchyOf(polygon).blocks;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (unsigned i = 0; blocks[k].leaf && i < blocks[k].count; ++i)
      pruned[blocks[k].child[i]] = (lanes[k] >> i & 1) != 0;
  return pruned;
}

/// Few coordinates, so that corners are given again and edges share them.
Polygon polygonOnGrid(Random& random) {
  Ring ring;
  const int n = random.integer(3, 30);
  for (int i = 0; i < n; ++i) {
    const bool again = i > 0 && random.oneIn(3);
    ring.push_back(again ? ring[static_cast<std::size_t>(random.integer(0, i - 1))]
                         : Vec2(random.integer(0, 4), random.integer(0, 4)));
  }
  return Polygon({ring});
}

TEST(PrunedBoxes, LeaveOutNothingNearer) {
  int pruned_pairs = 0, others = 0, equally_near = 0;
  for (int i = 0; i < scaledCount(400); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon p = polygonOnGrid(random), q = polygonOnGrid(random);
    const PolygonData &a = p.data(), &b = q.data();
    // Wide gaps, and such as at() has exact numbers for.
    const double gap = random.coin() ? 1 : std::ldexp(1, -random.integer(36, 46));
    const Pose pose_a = randomPose(random, 1), pose_b = pose_a * pose(0, 4 + gap, random.integer(-4, 4));
    const EdgeDistances edges(PosedVertices(a, pose_a, b, pose_b));
    const auto at = [&](std::size_t s, std::size_t t) {
      return edges.at(edges.view(s, t), s, t, {}, std::numeric_limits<double>::infinity()).distance;
    };
    const auto s = static_cast<std::size_t>(random.integer(0, static_cast<int>(a.path.size()) - 2));
    const auto t = static_cast<std::size_t>(random.integer(0, static_cast<int>(b.path.size()) - 2));
    const PrunedBoxes boxes(edges, s, t);
    if (!boxes.any()) continue;
    const std::vector<bool> of_a = prunedEdges(a, boxes.pairs().a), of_b = prunedEdges(b, boxes.pairs().b);
    EXPECT_TRUE(of_a[s] && of_b[t]);
    const double known = at(s, t);
    for (std::size_t v = 0; v < of_a.size(); ++v)
      for (std::size_t w = 0; w < of_b.size(); ++w) {
        if (!of_a[v] || !of_b[w]) {
          ++others;
          continue;
        }
        ++pruned_pairs;
        equally_near += at(v, w) == known;
        ASSERT_GE(at(v, w), known) << i;
      }
  }
  std::printf("%d pairs pruned, %d of them equally near, %d not\n", pruned_pairs, equally_near, others);
  EXPECT_GE(pruned_pairs, 0.05 * (pruned_pairs + others));
  EXPECT_GE(others, 0.05 * (pruned_pairs + others));
  EXPECT_GE(equally_near, 0.05 * pruned_pairs);
}

/// Of a box that holds one vertex beside or before p nothing is said, by however little.
TEST(PrunedBoxes, AskForCertainty) {
  const Pose still = Pose::Identity();
  const Polygon b({{{1, 0}, {2, 1}, {2, -1}}});
  for (const double x : {-1.0, -1e-9, -1e-18, 0.0, 1e-18, 0.5}) {
    const Polygon a({{{0, 0}, {-1, 1}, {x, 2}, {-1, 2}}});
    const PrunedBoxes boxes(EdgeDistances(PosedVertices(a.data(), still, b.data(), still)), 0, 0);
    ASSERT_TRUE(boxes.any()) << x;
    const bool certain = x < -1e-15;
    const std::vector<bool> expected = {true, certain, certain, true, false};
    EXPECT_EQ(prunedEdges(a.data(), boxes.pairs().a), expected) << x;
    // The same of b, turned by half.
    Pose turned = still;
    turned.linear() *= -1;
    const PrunedBoxes of_b(EdgeDistances(PosedVertices(b.data(), turned, a.data(), turned)), 0, 0);
    ASSERT_TRUE(of_b.any()) << x;
    EXPECT_EQ(prunedEdges(a.data(), of_b.pairs().b), expected) << x;
  }
  // Whichever ends of the two edges are nearest.
  const Polygon front({{{0, 0}, {-1, 1}, {-1, 2}}}), back({{{-1, 1}, {0, 0}, {-1, 2}}});
  const Polygon b_back({{{2, 1}, {1, 0}, {2, -1}}});
  for (const Polygon* p : {&front, &back})
    for (const Polygon* q : {&b, &b_back})
      EXPECT_TRUE(PrunedBoxes(EdgeDistances(PosedVertices(p->data(), still, q->data(), still)), 0, 0).any());
  // Nor where the pair itself has its nearest point between two vertices.
  const Polygon beside({{{1, 0}, {1, 1}, {2, 1}}}), flat({{{0, -1}, {0, 1}, {-1, 0}}});
  EXPECT_FALSE(PrunedBoxes(EdgeDistances(PosedVertices(flat.data(), still, beside.data(), still)), 0, 0).any());
}

std::size_t countShown(const growth::Input& input, const PrunedBoxes& pruned) {
  const Pose still = Pose::Identity();
  std::size_t shown = 0;
  const detail::PosedPair pair(input.a.data(), still, input.b.data(), input.motion.start);
  detail::forNearPairs(
      pair, 1 + 1e-12, pruned.pairs(),
      [&](double, std::size_t, std::size_t) {
        ++shown;
        return 1 + 1e-12;
      },
      [](double) { return 1 + 1e-12; }, [](std::size_t) { return false; });
  return shown;
}

TEST(PrunedBoxes, LeaveFewOfManyThatAreEquallyNear) {
  constexpr std::size_t kEdges = 100;
  for (const auto make : {growth::repeatedCorners, growth::equalPoints, growth::fans}) {
    const growth::Input input = make(kEdges);
    const Pose still = Pose::Identity();
    const EdgeDistances edges(PosedVertices(input.a.data(), still, input.b.data(), input.motion.start));
    EXPECT_GE(countShown(input, {}), kEdges * kEdges / 2);
    EXPECT_LE(countShown(input, PrunedBoxes(edges, 0, 0)), 8u);
  }
}

}  // namespace
}  // namespace tricover::support
