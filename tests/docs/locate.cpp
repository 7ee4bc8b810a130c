// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/locate.h"

#include <gtest/gtest.h>

namespace {

TEST(Documentation, Locate) {
  //! [locate]
  const tricover::Polygon frame({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  EXPECT_EQ(tricover::locate(frame, {0.5, 2}), tricover::Location::Inside);
  EXPECT_EQ(tricover::locate(frame, {1, 2}), tricover::Location::Boundary);
  EXPECT_EQ(tricover::locate(frame, {2, 2}), tricover::Location::Outside);  // in the hole
  //! [locate]
}

TEST(Documentation, LocateWithCache) {
  //! [locate with cache]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  tricover::PointCache cache;
  int inside = 0;
  for (double x = -2; x <= 6; x += 0.25)
    inside += tricover::locate(square, {x, 1}, cache) == tricover::Location::Inside;
  EXPECT_EQ(inside, 15);  // 0 and 4 are on the boundary
  //! [locate with cache]
}

}  // namespace
