// SPDX-License-Identifier: BSD-3-Clause
// What costs about n log n is counted in exact predicates, which collinear points leave nothing but: whether interiors
// of regions that share long edges meet, as lanes, sheets and floor plans do, and outward simplification of maps.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "numbers/predicates.h"
#include "random.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/covers.h"
#include "tricover/outline.h"
#include "tricover/scene.h"

namespace tricover::support {
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

/// How many more times a query calls for a size than for another one. ask(size) returns the query.
template <typename Ask>
double growth(int small, int large, const Ask& ask) {
  return exactCallsOf(ask(large)) / exactCallsOf(ask(small));
}

TEST(InteriorsOfSharedEdges, GrowWithTheirEdges) {
  EXPECT_LE(growth(32, 256,
                   [](int teeth) {
                     const Polygon a({comb(teeth)}), b({combInGaps(teeth)});
                     EXPECT_TRUE(collide(a, kHere, b, kHere));
                     // One tooth wider than its gap.
                     Ring wide = combInGaps(teeth);
                     for (const std::size_t vertex : {std::size_t{3}, std::size_t{4}})
                       wide[2 * static_cast<std::size_t>(teeth) + vertex].x() -= 1e-12;
                     EXPECT_TRUE(collide(a, kHere, Polygon({wide}), kHere, kOpen));
                     return [a, b] { EXPECT_FALSE(collide(a, kHere, b, kHere, kOpen)); };
                   }),
            10);
  EXPECT_LE(growth(8, 32,
                   [](int size) {
                     return [a = Polygon(board(size, 0)), b = Polygon(board(size, 1))] {
                       EXPECT_FALSE(collide(a, kHere, b, kHere, kOpen));
                     };
                   }),
            1.5 * 16);
  EXPECT_LE(
      growth(32, 256,
             [](int teeth) {
               return [teeth, a = Polygon({comb(teeth)}), b = Polygon({combInGaps(teeth)})] {
                 Scene scene;
                 scene.add(a, kHere);
                 scene.add(b, kHere);
                 EXPECT_TRUE(scene.covers(Polygon({{{1, 0}, {2.0 * teeth, 0}, {2.0 * teeth, 3}, {1, 3}}}), kHere));
                 EXPECT_TRUE(covers(a, kHere, a, kHere));
                 EXPECT_FALSE(covers(a, kHere, b, kHere));
               };
             }),
      10);
  const Polygon a({comb(256)}), b({combInGaps(256)});
  EXPECT_LE(exactCallsOf([&] { EXPECT_FALSE(collide(a, kHere, b, kHere, kOpen)); }), 100 * 2 * 1026);
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

/// Racks in aisles, whose sides have noise as a scanner's map has, or noise alone.
Polygon gridMap(std::size_t side, bool is_noise) {
  Random random(side);
  OccupancyGrid grid;
  grid.width = grid.height = side;
  grid.resolution = 0.0625;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const bool is_rack = x % 40 < 30 && y % 16 < (random.oneIn(8) ? 7u : 6u);
      grid.cells.push_back((is_noise ? random.coin() : is_rack) ? 1 : 0);
    }
  return *outline(grid);
}

TEST(OuterRings, CoverMapsAndGrowHardlyFasterThanTheirVertices) {
  const std::pair<const char*, std::vector<Polygon>> kinds[] = {
      {"racks", {gridMap(150, false), gridMap(300, false)}},
      {"noise", {gridMap(30, true), gridMap(60, true)}},
      {"combs", {Polygon({support::comb(256, 0.125, 0.0625, 1)}), Polygon({support::comb(1024, 0.125, 0.0625, 1)})}}};
  for (const auto& [name, maps] : kinds)
    for (const double tolerance : {0.0625, 0.125}) {
      SCOPED_TRACE(std::string(name) + ", " + std::to_string(tolerance));
      std::vector<double> calls;
      for (const Polygon& map : maps) {
        Polygon cover = map;
        const double all = exactCallsOf([&] { cover = map.simplified(tolerance, Simplify::Outwards); });
        calls.push_back(all / static_cast<double>(map.vertexCount()));
        EXPECT_TRUE(covers(cover, Pose::Identity(), map, Pose::Identity()));
        EXPECT_LE(cover.vertexCount(), map.vertexCount());
      }
      EXPECT_LE(calls[1], 1.5 * calls[0] + 5);
    }
}

}  // namespace
}  // namespace tricover::support
