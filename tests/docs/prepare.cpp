// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/prepare.h"

#include <gtest/gtest.h>

#include "tricover/collide.h"

namespace {

TEST(Documentation, Prepare) {
  using tricover::Pose;
  //! [prepare]
  // While the program starts: the map is asked a million times, and no answer may come late.
  const tricover::Polygon map({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{1, 1}, {8, 1}, {8, 8}, {1, 8}}});
  tricover::prepare(map);

  const tricover::Polygon robot({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  EXPECT_FALSE(collide(map, Pose::Identity(), robot, Pose(Eigen::Translation2d(3, 3))));
  //! [prepare]
}

}  // namespace
