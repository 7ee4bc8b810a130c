// SPDX-License-Identifier: BSD-3-Clause
// What a hierarchy says of its polygon, against exact numbers: its boxes hold their chains, its discs are in the
// region.
#include "hierarchy/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "exact_reference.h"
#include "hierarchy/inner_discs.h"
#include "polygon/polygon_data.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

using detail::Block;
using detail::Derived;
using detail::EdgePosition;
using detail::Hierarchy;
using detail::kLanes;
using detail::kNoEdge;
using detail::PolygonData;

/// A polygon that large isn't made here: its paths are checked before they are.
TEST(Polygon, IsRefusedWhereItsHierarchyCouldNotNameItsEdges) {
  EXPECT_NO_THROW(detail::requireCapacity(detail::kMostPositions));
  EXPECT_THROW(detail::requireCapacity(detail::kMostPositions + 1), std::length_error);
}

/// Whether a block's box holds a point given in units, but for `room` in the block's scale.
bool holds(const Block& block, int i, const Vec2& p, double room) {
  const double x = (p.x() - block.origin_x) * block.inverse - block.x[i];
  const double y = (p.y() - block.origin_y) * block.inverse - block.y[i];
  const double ux = block.ux[i], uy = block.uy[i], norm = std::hypot(ux, uy);
  return std::abs(x * ux + y * uy) <= block.along[i] * norm + room &&
         std::abs(y * ux - x * uy) <= block.across[i] * norm + room;
}

/// Of all sizes, far from the origin or not.
Polygon outline(Random& random, double size = 1) {
  std::vector<Ring> rings = {star(random, random.integer(3, 300), 5, 10)};
  for (int k = random.oneIn(7) ? random.integer(30, 90) : random.integer(0, 3); k > 0; --k)
    rings.push_back(shifted(star(random, random.integer(3, 30), 0.5, 1), {random.real(-3, 3), random.real(-3, 3)}));
  if (random.oneIn(5)) rings[0][1] = rings[0][0];
  if (random.oneIn(10)) rings[0].back() = rings[0][rings[0].size() - 2] + Vec2(1e-13, 0);
  const Vec2 far(random.coin() ? 0 : 1e9, random.coin() ? 0 : -1e6);
  for (Ring& ring : rings) ring = scaled(shifted(ring, far), size);
  return Polygon(rings);
}

double anySize(Random& random) {
  const double sizes[] = {1, 1, 1e-13, 1e-290, 1e290};
  return sizes[random.integer(0, 4)];
}

/// Visits the edges below a box.
template <typename Visit>
void forEachEdge(const Hierarchy& hierarchy, const Block& block, int lane, Visit visit) {
  if (block.leaf) return visit(block.child[lane]);
  const Block& below = hierarchy.blocks[block.child[lane]];
  for (int i = 0; i < below.count; ++i) forEachEdge(hierarchy, below, i, visit);
}

int depthOf(const Hierarchy& hierarchy, const Block& block) {
  int depth = 0;
  for (int lane = 0; lane < block.count && !block.leaf; ++lane)
    depth = std::max(depth, depthOf(hierarchy, hierarchy.blocks[block.child[lane]]));
  return depth + 1;
}

/// Their own rounding is part of it: a quarter of kOutwards is left, for what is computed with the axis. Each edge has
/// one leaf, and each block but the root is some box.
TEST(Boxes, HoldTheirEdgesWithRoomToSpare) {
  Random random(21);
  int deepest = 0;
  for (int i = 0; i < scaledCount(200); ++i) {
    const Polygon polygon = outline(random, anySize(random));
    const PolygonData& data = detail::dataOf(polygon);
    const Hierarchy& hierarchy = hierarchyOf(data);
    std::vector<int> leaves(data.path.size());
    std::size_t boxes = 0;
    for (const Block& block : hierarchy.blocks) {
      boxes += block.count;
      ASSERT_EQ(block.scale * block.inverse, 1);
      for (int lane = 0; lane < block.count; ++lane) {
        EdgePosition first = kNoEdge, last = 0, edges = 0;
        forEachEdge(hierarchy, block, lane, [&](EdgePosition e) {
          ASSERT_TRUE(holds(block, lane, data.inUnits(data.path[e]), -0x1p-23));
          ASSERT_TRUE(holds(block, lane, data.inUnits(data.path[e + 1]), -0x1p-23));
          first = std::min(first, e);
          last = std::max(last, e);
          ++edges;
        });
        if (block.leaf) ++leaves[first];
        const bool one_chain = data.ringOf(first) == data.ringOf(last) && last - first + 1 == edges;
        ASSERT_TRUE(one_chain || (block.spanned >> lane & 1) == 0);
        // As the descent may assume them to be.
        ASSERT_LE(std::max(std::abs(block.x[lane]), std::abs(block.y[lane])), 1);
        ASSERT_LE(block.along[lane] + block.across[lane], 1 + 0x1p-19);
      }
      for (int lane = block.count; lane < kLanes; ++lane) ASSERT_LT(block.along[lane], -1e20f) << "an unused lane";
    }
    ASSERT_TRUE(data.ringCount() == 1 || !hierarchy.root_spanned);
    const std::size_t edges = data.path.size() - data.ringCount();
    EXPECT_LE(hierarchy.blocks.size(), std::max<std::size_t>(edges / 2, 1));
    EXPECT_EQ(boxes, edges + hierarchy.blocks.size() - 1);
    EXPECT_EQ(static_cast<std::size_t>(std::count(leaves.begin(), leaves.end(), 1)), edges);
    deepest = std::max(deepest, depthOf(hierarchy, hierarchy.blocks[0]));
  }
  EXPECT_GE(deepest, 3);
  EXPECT_LE(deepest, 9);
}

/// Exactly: the centre is inside, and no edge is nearer than the radius.
void expectInside(const Polygon& polygon, const Vec2& center, const mpq_class& radius) {
  ASSERT_EQ(exact::locate(polygon, center), Location::Inside);
  for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e)
    ASSERT_TRUE(exact::distanceSquared(center, polygon.edgeStart(e), polygon.edgeEnd(e)) >= radius * radius);
}

TEST(InnerDiscs, AreInTheRegion) {
  Random random(22);
  int discs = 0, found = 0, large = 0;
  const int cases = scaledCount(400);
  for (int i = 0; i < cases; ++i) {
    const double size = random.coin() ? 1 : random.coin() ? 1e-200 : 1e200;
    const Polygon polygon = outline(random, size);
    const PolygonData& data = detail::dataOf(polygon);
    const detail::InnerDiscs& inner = innerDiscsOf(data);
    if (inner.largest > 0) expectInside(polygon, inner.center, inner.largest);
    found += inner.largest > 0;
    large += inner.largest > 2 * size;
    for (int k = 0; k < inner.count; ++k, ++discs) {
      const float radius = inner.radius[k];
      EXPECT_LE(radius, inner.radius[0]) << "innerDepth() takes the first for the largest";
      const Vec2 place(inner.x[k], inner.y[k]), center = data.origin + place * data.unit;
      expectInside(polygon, center, mpq_class(radius) * mpq_class(data.unit));
      // Rounded inwards, whatever the proof leaves; of few edges it leaves more than rounding.
      if (!detail::ThinnedOutline::isWhole(data)) {
        EXPECT_LE(radius, detail::provenRadius(data, place, radius));
      }
    }
  }
  EXPECT_GT(discs, cases);
  EXPECT_GE(found, 0.95 * cases);
  EXPECT_GE(large, 0.3 * cases);
}

/// Edges that are nearly level, ones that are nearly points, and probes at the very heights of vertices.
TEST(InnerDiscs, DepthsAreMeasuredWithinTheirError) {
  Random random(24);
  int certain = 0, outside = 0;
  for (int i = 0; i < scaledCount(300); ++i) {
    Ring ring = star(random, random.integer(4, 40), 1, 10);
    const double fine = std::pow(10.0, random.real(-14, 0));
    for (std::size_t k = 1; k < ring.size(); ++k) {
      if (random.integer(0, 2) == 0) ring[k].y() = ring[k - 1].y() + random.real(-fine, fine);
      if (random.integer(0, 4) == 0) ring[k] = ring[k - 1] + Vec2(random.real(-fine, fine), random.real(-fine, fine));
    }
    const Polygon polygon({ring, shifted(star(random, 5, 0.5, 4), {1, 1})},
                          random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
    const PolygonData& data = detail::dataOf(polygon);
    ASSERT_TRUE(detail::ThinnedOutline::isWhole(data));
    detail::DepthProbes probes;
    for (int k = 0; k < kLanes; ++k) {
      const Vec2 vertex = data.inUnits(ring[static_cast<std::size_t>(random.integer(0, 3))]);
      probes.x[k] = static_cast<float>(random.real(-0.5, 0.5));
      probes.y[k] = static_cast<float>(random.coin() ? 0.5 * vertex.y() : random.real(-0.5, 0.5));
      if (random.integer(0, 3) == 0) probes.y[k] = static_cast<float>(vertex.y());
    }
    detail::measureDepths(detail::ThinnedOutline(data), probes);
    for (int k = 0; k < kLanes; ++k) {
      // From S, so that the point is exact.
      const Vec2 point = Vec2(probes.x[k], probes.y[k]) * data.unit;
      const Polygon moved = polygon.translated(-data.origin);
      mpq_class least = 1e30;
      for (EdgeIndex e = 0; e < moved.edgeCount(); ++e) {
        const mpq_class square = exact::distanceSquared(point, moved.edgeStart(e), moved.edgeEnd(e));
        if (square < least) least = square;
      }
      const double distance = std::sqrt(least.get_d()) / data.unit, depth = probes.depth[k];
      ASSERT_NEAR(std::abs(depth), distance, detail::kDepthError);
      if (!(std::abs(depth) > detail::kSurelyBeside)) continue;
      ASSERT_EQ(depth > 0, exact::locate(moved, point) == Location::Inside) << "polygon " << i << ", probe " << k;
      ++certain;
      outside += depth < 0 ? 1 : 0;
    }
  }
  EXPECT_GT(certain, scaledCount(300) * 7);
  EXPECT_GT(outside, certain / 4);
  EXPECT_LT(outside, 3 * certain / 4);
}

/// Outlines of a great many vertices whose hole has four: the search, on a thinned outline, doesn't see the hole. Nor
/// is a disc taken for inside because of another one that it doesn't meet.
TEST(InnerDiscs, AreNotInAHoleThatTheSearchOverlooks) {
  const Polygon frame({regular(2000, 10), rectangle(-5, -5, 5, 5)}), peg({regular(40, 1)}),
      two({regular(2000, 10), shifted(regular(2000, 8), {19, 0}), rectangle(15, -4, 23, 4)});
  for (const Polygon* polygon : {&frame, &two}) {
    const PolygonData& data = detail::dataOf(*polygon);
    const detail::InnerDiscs& discs = innerDiscsOf(data);
    ASSERT_GT(discs.count, 0);
    for (int k = 0; k < discs.count; ++k)
      EXPECT_EQ(locate(*polygon, data.origin + data.unit * Vec2(discs.x[k], discs.y[k])), Location::Inside);
  }
  EXPECT_FALSE(collide(frame, Pose::Identity(), peg, turnedAndMoved(0, 0.3, 0.2)));
}

/// The radius is no more than what is certain, even where the polygon's frame has few digits left for it.
TEST(InnerDiscs, OfATriangleFarAway) {
  for (int k = 0; k < 200; ++k) {
    const double far = (k % 2 == 0 ? 0x1p30 : 0x1p42) * (1 + 0.013 * k);
    const Polygon triangle({{{far, far}, {far + 1, far + 0.25}, {far + 0.125 * (k % 7), far + 1}}});
    const detail::InnerDiscs& discs = innerDiscsOf(detail::dataOf(triangle));
    ASSERT_GT(discs.largest, 0);
    expectInside(triangle, discs.center, discs.largest);
  }
}

struct Number : Derived::Thing {
  explicit Number(int n) : number(n) {}
  const int number;
};

/// And one that couldn't be built is built by whoever comes next.
TEST(DerivedThings, AreBuiltOnceForAllThreads) {
  const Derived place;
  EXPECT_EQ(place.ifBuilt(), nullptr);
  const auto refuse = []() -> std::unique_ptr<const Number> { throw std::length_error("too large"); };
  EXPECT_THROW(place.built(refuse), std::length_error);
  EXPECT_EQ(place.ifBuilt(), nullptr);
  std::atomic<int> built{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      const Derived::Thing* thing = place.built([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return std::make_unique<const Number>(++built);
      });
      EXPECT_EQ(static_cast<const Number*>(thing)->number, 1);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(built, 1);
  EXPECT_EQ(place.built(refuse), place.ifBuilt());
}

}  // namespace
}  // namespace tricover::support
