// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "random.h"
#include "refusal.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/locate.h"

namespace tricover {
namespace {

/// Rows from the highest y to the lowest, as one reads them; '#' is occupied.
OccupancyGrid gridOf(const std::vector<std::string>& rows) {
  OccupancyGrid grid;
  grid.height = rows.size();
  grid.width = rows[0].size();
  for (std::size_t y = 0; y < grid.height; ++y)
    for (const char c : rows[grid.height - 1 - y]) grid.cells.push_back(c == '#' ? 100 : 0);
  return grid;
}

double signedArea(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

/// Every cell's centre, and every corner: on the boundary where its four cells differ.
void expectRegionOf(const OccupancyGrid& grid, const Polygon& polygon) {
  const auto occupied = [&](std::ptrdiff_t x, std::ptrdiff_t y) {
    const auto width = static_cast<std::ptrdiff_t>(grid.width), height = static_cast<std::ptrdiff_t>(grid.height);
    return x >= 0 && y >= 0 && x < width && y < height && grid.cells[static_cast<std::size_t>(y * width + x)] != 0;
  };
  const auto at = [&](double x, double y) { return Vec2(grid.origin + grid.resolution * Vec2(x, y)); };
  for (std::ptrdiff_t y = 0; y <= static_cast<std::ptrdiff_t>(grid.height); ++y)
    for (std::ptrdiff_t x = 0; x <= static_cast<std::ptrdiff_t>(grid.width); ++x) {
      const double u = static_cast<double>(x), v = static_cast<double>(y);
      ASSERT_EQ(locate(polygon, at(u + 0.5, v + 0.5)), occupied(x, y) ? Location::Inside : Location::Outside)
          << "cell " << x << ", " << y;
      const int around = occupied(x - 1, y - 1) + occupied(x, y - 1) + occupied(x - 1, y) + occupied(x, y);
      ASSERT_EQ(locate(polygon, at(u, v)), around == 0   ? Location::Outside
                                           : around == 4 ? Location::Inside
                                                         : Location::Boundary)
          << "corner " << x << ", " << y;
    }
}

TEST(Outline, OfOneCellIsASquareThatRunsCounterClockwise) {
  OccupancyGrid grid = gridOf({"#"});
  grid.resolution = 0.05;
  grid.origin = Vec2(-10, 20);
  const auto polygon = outline(grid);
  ASSERT_TRUE(polygon);
  const double x = -10, y = 20, s = 0.05;
  EXPECT_EQ(polygon->rings(), (std::vector<Ring>{{{x + s, y}, {x + s, y + s}, {x, y + s}, {x, y}}}));
}

TEST(Outline, HasVerticesOnlyWhereItTurns) {
  const auto polygon = outline(gridOf({"#####", "#...#", "#.#.#", "#...#", "#####"}));
  ASSERT_TRUE(polygon);
  ASSERT_EQ(polygon->rings().size(), 3u);
  for (const Ring& ring : polygon->rings()) EXPECT_EQ(ring.size(), 4u);
  EXPECT_EQ(polygon->area(), 16 + 1);
}

TEST(Outline, OfDiagonalNeighboursBothWaysAreTwoRings) {
  EXPECT_EQ(outline(gridOf({"#.", ".#"}))->rings().size(), 2u);
  EXPECT_EQ(outline(gridOf({".#", "#."}))->rings().size(), 2u);
}

TEST(Outline, IsNothingWhereNothingIsOccupied) {
  EXPECT_FALSE(outline(gridOf({"...", "..."})));
  EXPECT_FALSE(outline(OccupancyGrid{}));
}

TEST(Outline, TakesWhatTheCallerCallsOccupied) {
  OccupancyGrid grid;
  grid.width = 3;
  grid.height = 1;
  grid.cells = {-1, 40, 70};
  EXPECT_EQ(signedArea(outline(grid)->rings()[0]), 3);
  const auto certain = outline(grid, [](std::int8_t value) { return value >= 65; });
  EXPECT_EQ(certain->rings(), (std::vector<Ring>{{{3, 0}, {3, 1}, {2, 1}, {2, 0}}}));
}

TEST(Outline, OfRandomGridsIsTheirRegion) {
  support::Random random(2026);
  const int cases = support::scaledCount(300, 30);
  int rings = 0, holes = 0;
  for (int k = 0; k < cases; ++k) {
    OccupancyGrid grid;
    grid.width = static_cast<std::size_t>(random.integer(1, 12));
    grid.height = static_cast<std::size_t>(random.integer(1, 12));
    const int share = random.integer(1, 7);
    for (std::size_t i = 0; i < grid.width * grid.height; ++i) grid.cells.push_back(random.integer(0, 7) < share);
    grid.resolution = 0.25;
    grid.origin = Vec2(-1.5, 40);
    const auto polygon = outline(grid);
    if (!polygon) continue;
    expectRegionOf(grid, *polygon);
    for (const Ring& ring : polygon->rings()) {
      ++rings;
      holes += signedArea(ring) < 0;
    }
  }
  EXPECT_GT(rings, cases);
  EXPECT_GT(holes, rings / 20);
  EXPECT_LT(holes, rings / 2);
}

TEST(Outline, RefusesWhatIsNoGridAndNamesTheField) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNaN = std::nan("");
  const std::vector<std::int8_t> four(4, 100);
  const std::pair<OccupancyGrid, const char*> refused[] = {
      {{2, 2, {100, 100, 100}, 1, {0, 0}}, "cells: 3 values for 2 x 2 cells"},
      {{2, 2, four, 0, {0, 0}}, "resolution"},
      {{2, 2, four, -1, {0, 0}}, "resolution"},
      {{2, 2, four, kNaN, {0, 0}}, "resolution"},
      {{2, 2, four, kInfinity, {0, 0}}, "origin"},
      {{2, 2, four, 0.05, {0, 1e17}}, "resolution: corners 0 and 1"},
      {{2, 2, four, 0.05, {kNaN, 0}}, "origin"},
      {{std::numeric_limits<std::size_t>::max(), 2, {}, 1, {0, 0}}, "height"}};
  for (const auto& [grid, field] : refused) {
    const std::string message = support::refusal([&, &of = grid] { outline(of); });
    EXPECT_NE(message.find(field), std::string::npos) << message;
  }
  EXPECT_EQ(support::refusal([] {
              outline({1, 1, {1}, 1, {0, 0}}, IsOccupied());
            }),
            "tricover: is_occupied: it is empty");
}

}  // namespace
}  // namespace tricover
