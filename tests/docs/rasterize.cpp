// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/rasterize.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

TEST(Documentation, Rasterize) {
  //! [rasterize]
  tricover::OccupancyMap map;
  map.grid = {4, 3, std::vector<std::int8_t>(12), 0.5};
  map.pose = tricover::poseAt(10, 20);
  const tricover::Polygon robot = tricover::Polygon::box(0.5, 0.4);
  for (const std::size_t cell : tricover::rasterize(robot, tricover::poseAt(11, 20.25), map))
    map.grid.cells[cell] = 100;
  EXPECT_EQ(map.grid.cells, (std::vector<std::int8_t>{0, 100, 100, 0,  //
                                                      0, 0, 0, 0,      //
                                                      0, 0, 0, 0}));
  //! [rasterize]
}

TEST(Documentation, RasterizeGrid) {
  //! [rasterize grid]
  const tricover::OccupancyGrid grid{4, 3, std::vector<std::int8_t>(12)};
  const tricover::Polygon post = tricover::Polygon::point({1, 1});  // on a corner of four cells
  EXPECT_EQ(tricover::rasterize(post, tricover::Pose::Identity(), grid), (std::vector<std::size_t>{0, 1, 4, 5}));
  //! [rasterize grid]
}

}  // namespace
