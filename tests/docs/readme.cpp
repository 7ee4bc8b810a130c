// SPDX-License-Identifier: BSD-3-Clause
// The lines of README that are no whole programs: CTest compares them to the letter.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tricover/occupancy_grid_io.h"
#include "tricover/tricover.h"

namespace {

using tricover::poseAt, tricover::Motion, tricover::Polygon, tricover::Vec2;

const tricover::Pose here = tricover::Pose::Identity();

TEST(Readme, Queries) {
  const auto folder = std::filesystem::current_path();
  std::filesystem::current_path(testing::TempDir());
  std::ofstream("map.pgm") << "P2 2 1 255 254 0";  // free, and a wall
  std::ofstream("map.yaml") << "image: map.pgm\nresolution: 4\norigin: [5, -6, 1.5707963267948966]\nnegate: 0\n"
                            << "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  const Polygon a = Polygon::box(4, 4), b = Polygon::box(2, 2);
  const tricover::Pose pose_a = here, pose_b = poseAt(2.5, 0);
  const Motion motion_a = Motion::still(here), motion_b = Motion::translation(poseAt(9, 0), {-12, 0});
  const Vec2 point(1, 1), from(-5, 1), to(5, 1);
  {
#include "readme_queries.inc"
    EXPECT_TRUE(hit && gap == 0 && out && first && hit_at);
    EXPECT_EQ(parts.size(), 1u);
    EXPECT_EQ(where, tricover::Location::Inside);
    EXPECT_EQ(disc.vertexCount() + stadium.vertexCount(), 6u);
    EXPECT_TRUE(tricover::collide(*walls, here, b, pose_b));  // not where the grid's own frame is
    EXPECT_FALSE(tricover::collide(*tricover::outline(map.grid), here, b, pose_b));
  }
  std::filesystem::current_path(folder);
}

TEST(Readme, Containment) {
  const Polygon lot = Polygon::box(20, 10), car = Polygon::box(4, 2),
                dock({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}});
  const Polygon& robot = car;
  const tricover::Pose pose_lot = here, pose_car = poseAt(1, 1);
  const Motion still = Motion::still(here), motion = Motion::translation(poseAt(-5, 2), {10, 0});
#include "readme_containment.inc"
  EXPECT_TRUE(inside);
  EXPECT_NEAR(least.distance, 2, 1e-6);
  EXPECT_EQ(pushes.size(), 1u);
}

}  // namespace
