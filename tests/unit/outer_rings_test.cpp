// SPDX-License-Identifier: BSD-3-Clause
// Outward simplification of maps: collinear axis-parallel edges are their common case. What it costs is counted by
// exact signs, since collinear points are what filters leave to these.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "numbers/predicates.h"
#include "random.h"
#include "shapes.h"
#include "tricover/covers.h"
#include "tricover/outline.h"

namespace tricover::support {
namespace {

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
      {"combs", {Polygon({comb(256, 0.125, 0.0625, 1)}), Polygon({comb(1024, 0.125, 0.0625, 1)})}}};
  for (const auto& [name, maps] : kinds)
    for (const double tolerance : {0.0625, 0.125}) {
      SCOPED_TRACE(std::string(name) + ", " + std::to_string(tolerance));
      std::vector<double> calls;
      for (const Polygon& map : maps) {
        const std::uint64_t before = detail::exactCalls();
        const Polygon cover = map.simplified(tolerance, Simplify::Outwards);
        calls.push_back(static_cast<double>(detail::exactCalls() - before) / static_cast<double>(map.vertexCount()));
        EXPECT_TRUE(covers(cover, Pose::Identity(), map, Pose::Identity()));
        EXPECT_LE(cover.vertexCount(), map.vertexCount());
      }
      std::printf("%s, %g: %zu to %zu vertices, %.3g and %.3g exact signs a vertex\n", name, tolerance,
                  maps[0].vertexCount(), maps[1].vertexCount(), calls[0], calls[1]);
      EXPECT_LE(calls[1], 1.5 * calls[0] + 5);
    }
}

}  // namespace
}  // namespace tricover::support
