// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/outline.h"

#include <gtest/gtest.h>

#include "tricover/locate.h"

namespace {

TEST(Documentation, Outline) {
  //! [outline]
  tricover::OccupancyGrid grid;
  grid.width = 4;
  grid.height = 3;
  grid.cells = {100, 100, 100, 100,  // the lowest row
                100, 0,   0,   100,  //
                100, 100, 100, -1};
  grid.resolution = 0.05;
  grid.origin = {-1, 2};

  const auto walls = tricover::outline(grid);
  EXPECT_EQ(walls->rings().size(), 2u);  // the walls' outer side, and the room
  EXPECT_EQ(tricover::locate(*walls, {-0.9, 2.075}), tricover::Location::Outside);

  // What is unknown is occupied unless you say otherwise.
  const auto certain = tricover::outline(grid, [](std::int8_t value) { return value >= 65; });
  EXPECT_EQ(tricover::locate(*walls, {-0.825, 2.125}), tricover::Location::Inside);
  EXPECT_EQ(tricover::locate(*certain, {-0.825, 2.125}), tricover::Location::Outside);
  //! [outline]
}

}  // namespace
