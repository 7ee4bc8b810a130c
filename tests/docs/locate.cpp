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

TEST(Documentation, LocateInTheWorld) {
  //! [locate in the world]
  const tricover::Polygon shelf = tricover::Polygon::box(4, 1);
  const tricover::Pose at = tricover::poseAt(10, 5, M_PI / 2);  // it stands upright
  EXPECT_EQ(tricover::locate(shelf, at, {10.5, 7}), tricover::Location::Boundary);
  EXPECT_EQ(tricover::locate(shelf, at, {11.5, 5}), tricover::Location::Outside);
  //! [locate in the world]
}

}  // namespace
