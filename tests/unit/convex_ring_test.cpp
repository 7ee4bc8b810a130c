// SPDX-License-Identifier: BSD-3-Clause
// The support vertex of a convex ring along any direction, by binary search and by a walk, against all vertices.
#include "convex/convex_ring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"

namespace tricover::support {
namespace {

using detail::ConvexRing;
using detail::Double2;
using detail::RingRange;

TEST(ConvexRing, FindsTheSupportVertex) {
  Random random(31);
  int walked = 0, doubtful = 0;
  const int count = scaledCount(4000);
  for (int i = 0; i < count; ++i) {
    Ring vertices = random.oneIn(4) ? rectangle(-2, -1, 2, 1) : regular(random.integer(3, 100), 1);
    const int turn = random.coin() ? 1 : -1;
    if (turn < 0) std::reverse(vertices.begin(), vertices.end());
    std::rotate(vertices.begin(), vertices.begin() + random.integer(0, static_cast<int>(vertices.size()) - 1),
                vertices.end());
    const std::size_t size = vertices.size();
    vertices.push_back(vertices.front());
    const ConvexRing ring(vertices.data(), size, turn);
    const Vec2 n = direction(random.oneIn(4) ? random.integer(0, 3) * 1.5707963267948966 : random.real(0, 6.3));
    const auto height = [&](std::uint32_t k) { return n.dot(vertices[k]); };
    double highest = height(0);
    for (std::uint32_t k = 1; k < size; ++k) highest = std::max(highest, height(k));
    EXPECT_NEAR(height(ring.supportVertex(Double2{n.x(), n.y()})), highest, 1e-15);
    // What is walked over is all that is no lower than by the doubt, wherever the walk begins.
    const double doubt = random.oneIn(3) ? 0.01 : 1e-12;
    RingRange range{static_cast<std::uint32_t>(random.integer(0, static_cast<int>(size) - 1)), 0};
    const std::uint32_t begin = range.first;
    if (!ring.supportVertex(Double2{n.x(), n.y()}, doubt, range)) continue;
    double best = height(range.first);
    for (std::uint32_t k = 0; k < range.count; ++k) best = std::max(best, height(ring.after(range.first, k)));
    EXPECT_EQ(best, highest);
    const std::uint32_t last = ring.after(range.first, range.count - 1);
    EXPECT_GT(height(range.first) - height(ring.previous(range.first)), doubt * (1 - 1e-3));
    EXPECT_GT(height(last) - height(ring.next(last)), doubt * (1 - 1e-3));
    walked += begin != range.first;
    doubtful += range.count > 1;
  }
  EXPECT_GT(walked, count / 2);
  EXPECT_GT(doubtful, count / 20);
}

/// Edges that are parallel but for rounding, the first one among them: all cross products of these two numbers'
/// multiples are whole, and far below what doubles round theirs by.
TEST(ConvexRing, FindsTheSupportVertexOfNearlyStraightChains) {
  Random random(32);
  const Vec2 step(4807526976, 2971215073),
      first(7778742049, 4807526976);  // Fibonacci numbers: their cross product is 1
  const int count = scaledCount(4000);
  for (int i = 0; i < count; ++i) {
    const int edges = random.integer(2, 20);
    Ring vertices{Vec2(0, 0)};
    for (int k = 0; k < edges; ++k) vertices.push_back(vertices.back() + first + k * step);
    vertices.emplace_back(-1e11, 1e11);
    std::rotate(vertices.begin(), vertices.begin() + random.integer(0, edges + 1), vertices.end());
    const std::size_t size = vertices.size();
    vertices.push_back(vertices.front());
    const Vec2 n = direction(random.real(0, 6.3));
    double highest = n.dot(vertices[0]);
    for (const Vec2& v : vertices) highest = std::max(highest, n.dot(v));
    const ConvexRing ring(vertices.data(), size, 1);
    ASSERT_NEAR(n.dot(vertices[ring.supportVertex(Double2{n.x(), n.y()})]), highest, 1) << i;
  }
}

}  // namespace
}  // namespace tricover::support
