// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/rasterize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tricover/collide.h"
#include "tricover/covers.h"

namespace tricover {
namespace {

using Indices = std::vector<std::size_t>;

OccupancyGrid gridOf(std::size_t width, std::size_t height, double resolution = 1) {
  return {width, height, std::vector<std::int8_t>(width * height), resolution};
}

/// By a query of each cell.
Indices byCells(const Polygon& polygon, const Pose& pose, const OccupancyMap& map, const CollideOptions& options) {
  Indices result;
  const OccupancyGrid& grid = map.grid;
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    const auto corner = [&](std::size_t i, std::size_t j) {
      return Vec2(grid.origin.x() + static_cast<double>(i) * grid.resolution,
                  grid.origin.y() + static_cast<double>(j) * grid.resolution);
    };
    const std::size_t i = cell % grid.width, j = cell / grid.width;
    const Polygon square(Ring{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
    if (collide(polygon, pose, square, map.pose, options)) result.push_back(cell);
  }
  return result;
}

TEST(Rasterize, DegeneratePolygonsMeetTheCellsTheyTouch) {
  const OccupancyGrid grid = gridOf(4, 3);
  const Pose here = Pose::Identity();
  EXPECT_EQ(rasterize(Polygon::point({1, 1}), here, grid), (Indices{0, 1, 4, 5})) << "a corner";
  EXPECT_EQ(rasterize(Polygon::point({1.5, 1}), here, grid), (Indices{1, 5})) << "a border";
  EXPECT_EQ(rasterize(Polygon::point({4, 3}), here, grid), (Indices{11}));
  EXPECT_EQ(rasterize(Polygon::point({4.1, 3}), here, grid), Indices());
  EXPECT_EQ(rasterize(Polygon::segment({1, 1}, {2, 1}), here, grid), (Indices{0, 1, 2, 4, 5, 6}));
  EXPECT_EQ(rasterize(Polygon::box(2, 2), poseAt(2, 1), grid, {0, 0, Touching::Allowed}), (Indices{1, 2, 5, 6}));
  EXPECT_EQ(rasterize(Polygon::box(2, 2), poseAt(2, 1), grid).size(), 12u);
  EXPECT_EQ(rasterize(Polygon::box(1, 1), here, gridOf(0, 5)), Indices());
}

TEST(Rasterize, EveryCellIsAnsweredAsCollideDoes) {
  std::mt19937_64 random(1);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::size_t found = 0, all = 0;
  for (int i = 0; i < 150; ++i) {
    const double unit = std::pow(10, static_cast<int>(i % 7) * 3 - 9);
    OccupancyMap map{gridOf(1 + random() % 14, 1 + random() % 14, 0.5 * unit), poseAt(0, 0)};
    if (i % 3 > 0) map.pose = poseAt(number(-3, 3) * unit, number(-3, 3) * unit, number(-3, 3));
    if (i % 5 == 0) map.grid.origin = Vec2(0.25, -0.5) * unit;
    Ring ring;
    for (std::size_t k = 3 + random() % 6; k > 0; --k)
      ring.emplace_back(i % 2 ? Vec2(number(-4, 4) * unit, number(-4, 4) * unit)
                              : Vec2(std::round(number(-8, 8)) * 0.5 * unit, std::round(number(-8, 8)) * 0.5 * unit));
    Polygon polygon(ring);
    if (i % 4 == 3 && polygon.area() > 0) polygon = polygon.complement();
    const Pose pose = i % 2 ? poseAt(3 * unit, 3 * unit, number(-3, 3)) : poseAt(3 * unit, 3 * unit);
    for (const double margin : {0.0, 0.5, 3.0, 0.01, -0.2, -0.6})
      for (const Touching touching : {Touching::Collides, Touching::Allowed}) {
        const CollideOptions options{margin * unit, 0, touching};
        const Indices cells = rasterize(polygon, pose, map, options);
        ASSERT_EQ(cells, byCells(polygon, pose, map, options)) << "case " << i << ", margin " << margin;
        found += cells.size();
        all += map.grid.cells.size();
      }
  }
  EXPECT_GT(found, all / 10);
  EXPECT_LT(found, all * 9 / 10);
}

TEST(Rasterize, TheCellsCoverThePolygon) {
  OccupancyMap map{gridOf(60, 50, 0.1), poseAt(-3, -2, 0.3)};
  const Polygon robot = Polygon::box(2, 1);
  const Pose pose = poseAt(-1, 1, 0.7);
  for (const std::size_t cell : rasterize(robot, pose, map)) map.grid.cells[cell] = 100;
  EXPECT_TRUE(covers(*outline(map.grid), map.pose, robot, pose));
}

}  // namespace
}  // namespace tricover
