// SPDX-License-Identifier: BSD-3-Clause
// Regions that share long edges, as lanes, sheets and floor plans do: whether their interiors meet takes time about as
// n log n, counted in exact predicates.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "numbers/predicates.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/covers.h"
#include "tricover/scene.h"

namespace tricover {
namespace {

const Pose kHere = Pose::Identity();
const CollideOptions kOpen{0, 0, Touching::Allowed};

/// A comb whose teeth are as wide as its gaps: its back along y = 0, teeth from y = 1 to 3.
Ring comb(int teeth) {
  Ring ring{{0, 0}, {2.0 * teeth, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    if (i + 1 < teeth) ring.push_back({2.0 * i + 2, 1});
    if (i + 1 == teeth) ring.push_back({2.0 * teeth, 1});
    for (const Vec2& p : {Vec2(2 * i + 1, 1), Vec2(2 * i + 1, 3), Vec2(2 * i, 3)}) ring.push_back(p);
  }
  return ring;
}

/// The same, upside down: its teeth are exactly in the gaps.
Ring combInGaps(int teeth) {
  Ring ring;
  for (const Vec2& p : comb(teeth)) ring.push_back({2 * teeth - p.x(), 4 - p.y()});
  return ring;
}

/// The squares of one colour of a board.
std::vector<Ring> board(int size, int colour) {
  std::vector<Ring> rings;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      if ((x + y) % 2 == colour) rings.push_back({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
  return rings;
}

template <typename Query>
double exactCallsOf(Query query) {
  const std::uint64_t before = detail::exactCalls();
  query();
  return static_cast<double>(detail::exactCalls() - before);
}

TEST(InteriorsOfSharedEdges, CombsInGapsGrowWithTheirEdges) {
  double calls[2];
  for (int i = 0; i < 2; ++i) {
    const int teeth = i == 0 ? 32 : 256;
    const Polygon a({comb(teeth)}), b({combInGaps(teeth)});
    calls[i] = exactCallsOf([&] { EXPECT_FALSE(collide(a, kHere, b, kHere, kOpen)); });
    EXPECT_TRUE(collide(a, kHere, b, kHere));
    // One tooth wider than its gap.
    Ring wide = combInGaps(teeth);
    for (const std::size_t vertex : {std::size_t{3}, std::size_t{4}})
      wide[2 * static_cast<std::size_t>(teeth) + vertex].x() -= 1e-12;
    EXPECT_TRUE(collide(a, kHere, Polygon({wide}), kHere, kOpen));
  }
  EXPECT_LE(calls[1], 10 * calls[0]);
  EXPECT_LE(calls[1], 100 * 2 * 1026);
}

TEST(InteriorsOfSharedEdges, CheckerboardsGrowWithTheirEdges) {
  double calls[2];
  for (int i = 0; i < 2; ++i) {
    const int size = i == 0 ? 8 : 32;
    const Polygon a(board(size, 0)), b(board(size, 1));
    calls[i] = exactCallsOf([&] { EXPECT_FALSE(collide(a, kHere, b, kHere, kOpen)); });
  }
  EXPECT_LE(calls[1], 1.5 * 16 * calls[0]);
}

TEST(InteriorsOfSharedEdges, CoversGrowsWithItsEdges) {
  double calls[2];
  for (int i = 0; i < 2; ++i) {
    const int teeth = i == 0 ? 32 : 256;
    const Polygon a({comb(teeth)}), b({combInGaps(teeth)});
    calls[i] = exactCallsOf([&] {
      Scene scene;
      scene.add(a, kHere);
      scene.add(b, kHere);
      EXPECT_TRUE(scene.covers(Polygon({{{1, 0}, {2.0 * teeth, 0}, {2.0 * teeth, 3}, {1, 3}}}), kHere));
      EXPECT_TRUE(covers(a, kHere, a, kHere));
      EXPECT_FALSE(covers(a, kHere, b, kHere));
    });
  }
  EXPECT_LE(calls[1], 10 * calls[0]);
}

TEST(InteriorsOfSharedEdges, BarAcrossACombAsksNoSides) {
  const int teeth = 256;
  const Polygon a({comb(teeth)}), bar({{{-1, 1.5}, {2 * teeth + 1, 1.6}, {2 * teeth + 1, 2.1}, {-1, 2}}});
  CrossingOptions open;
  open.touching = Touching::Allowed;
  const double calls =
      exactCallsOf([&] { EXPECT_EQ(crossings(a, kHere, bar, kHere, open).size(), std::size_t{1024}); });
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace tricover
