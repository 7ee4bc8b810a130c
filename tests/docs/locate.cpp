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

}  // namespace
