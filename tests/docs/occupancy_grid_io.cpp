// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "own_folder.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"

namespace {

TEST(Documentation, OccupancyMap) {
  const tricover::support::OwnFolder own;
  const std::string folder = own.path();
  //! [occupancy map]
  std::ofstream(folder + "hall.pgm") << "P2\n4 3\n255\n"
                                     << "0 0 0 205\n"  // the highest row: three walls, and nobody knows
                                     << "0 254 254 0\n"
                                     << "0 0 0 0\n";
  std::ofstream(folder + "hall.yaml") << "image: hall.pgm\nresolution: 0.05\norigin: [-1, 2, 0]\nnegate: 0\n"
                                      << "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

  const tricover::OccupancyMap map = tricover::readOccupancyMap(folder + "hall.yaml");
  EXPECT_EQ(map.grid.cells, (std::vector<std::int8_t>{100, 100, 100, 100,  //
                                                      100, 0, 0, 100,      //
                                                      100, 100, 100, -1}));
  const auto walls = tricover::outline(map);  // in the world; nothing for a map without a wall
  const tricover::Polygon robot = tricover::Polygon::box(0.04, 0.04);
  const tricover::Pose world = tricover::Pose::Identity();
  EXPECT_FALSE(tricover::collide(*walls, world, robot, tricover::poseAt(-0.9, 2.075)));
  EXPECT_TRUE(tricover::collide(*walls, world, robot, tricover::poseAt(-0.9, 2.025)));
  //! [occupancy map]
}

TEST(Documentation, WriteOccupancyMap) {
  const tricover::support::OwnFolder own;
  const std::string folder = own.path();
  //! [write]
  tricover::OccupancyMap map;
  map.grid = {3, 1, {0, 100, -1}, 0.05};  // free, occupied, unknown
  map.pose = tricover::poseAt(-1, 2, 0.5);
  tricover::writeOccupancyMap(map, folder + "lane.yaml");              // and lane.pgm
  tricover::writeOccupancyMap(map, folder + "lane.yaml", "lane.png");  // or lane.png
  const tricover::OccupancyMap again = tricover::readOccupancyMap(folder + "lane.yaml");
  EXPECT_EQ(again.grid.cells, map.grid.cells);
  EXPECT_EQ(again.pose.matrix(), map.pose.matrix());
  //! [write]
}

}  // namespace
