// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>

#include "map_folder.h"
#include "tricover/occupancy_grid_io.h"

namespace tricover {
namespace {

class OccupancyMapWrite : public MapFolder {
 protected:
  static OccupancyMap made(const Cells& cells) {
    OccupancyMap map;
    map.grid = {3, 2, cells, 0.05};
    map.pose = poseAt(-1.5, 2, 0.5);
    return map;
  }
  void expectBack(const OccupancyMap& map, const std::string& image = "") const {
    writeOccupancyMap(map, path("back.yaml"), image);
    const OccupancyMap found = readOccupancyMap(path("back.yaml"));
    EXPECT_EQ(found.grid.width, map.grid.width);
    EXPECT_EQ(found.grid.height, map.grid.height);
    EXPECT_EQ(found.grid.cells, map.grid.cells) << image;
    EXPECT_EQ(found.grid.resolution, map.grid.resolution);
    EXPECT_EQ(found.pose.matrix(), map.pose.matrix());
  }
  std::string refused(const OccupancyMap& map, const std::string& image = "") const {
    return errorOf<std::invalid_argument>([&] { writeOccupancyMap(map, path("out.yaml"), image); });
  }
};

TEST_F(OccupancyMapWrite, EveryValueComesBack) {
  const OccupancyMap plain = made({0, 100, -1, -1, 0, 100});
  for (const std::string image : {"", "a.pgm", "b.png", "C.PNG", "a 'b' \"c\" #: \xC3\xA4.png"})
    expectBack(plain, image);
  OccupancyMap graded;
  graded.grid = {101, 1, {}};
  for (int value = 0; value <= 100; ++value) graded.grid.cells.push_back(static_cast<std::int8_t>(value));
  for (const std::string image : {"", "a.pgm", "b.png"}) expectBack(graded, image);
  graded.grid.cells[7] = -1;
  for (const std::string image : {"", "b.png"}) expectBack(graded, image);
  EXPECT_FALSE(std::filesystem::exists(path("back.yaml.part0")));
}

TEST_F(OccupancyMapWrite, GreysAreRoundedToTheNearest) {
  OccupancyMap map;
  map.grid = {4, 1, {0, 33, 50, 100}};
  writeOccupancyMap(map, path("graded.yaml"), "graded.pgm");
  std::ifstream file(path("graded.pgm"), std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  EXPECT_EQ(bytes.substr(bytes.size() - 4), "\xFF\xAB\x80" + std::string(1, '\0'));
}

TEST_F(OccupancyMapWrite, NumbersComeBackBitForBit) {
  OccupancyMap map = made({0, 100, -1, -1, 0, 100});
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  for (const double number : {tiny, huge, 0.1, 1.0 / 3, 1e22, 1e-5, 100000.0}) {
    map.grid.resolution = number;
    map.pose.translation() << -number, number;
    expectBack(map);
  }
  map = made({0, 100, -1, -1, 0, 100});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> yaw(-3.141592653589793, 3.141592653589793);
  for (int i = 0; i < 1000; ++i) {
    map.pose = poseAt(yaw(random), yaw(random), i % 4 == 0 ? 1e-3 * yaw(random) : yaw(random));
    expectBack(map);
  }
  for (int quarters = -2; quarters <= 2; ++quarters) {
    map.pose = poseAt(0, 0, quarters * 1.5707963267948966);
    expectBack(map);
  }
  map.pose = Pose::Identity();
  expectBack(map);
}

TEST_F(OccupancyMapWrite, OtherRotationsComeBackWithin1e12) {
  OccupancyMap map = made({0, 100, -1, -1, 0, 100});
  for (int i = 0; i < 200; ++i) {
    map.pose = map.pose * poseAt(0, 0, 100.0 + i);
    writeOccupancyMap(map, path("back.yaml"));
    const Pose found = readOccupancyMap(path("back.yaml")).pose;
    EXPECT_LE((found.linear() - map.pose.linear()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_F(OccupancyMapWrite, WhatFilesDoNotKeepIsRefusedByName) {
  EXPECT_EQ(refused(made({0, 100, -1, -1, 101, 100})),
            "tricover: cells: cell 4 (column 1, row 1) is 101, not from -1 to 100");
  EXPECT_EQ(refused(made({0, 100, -1, -2, 0, 100})),
            "tricover: cells: cell 3 (column 0, row 1) is -2, not from -1 to 100");
  EXPECT_EQ(refused(made({0, 50, -1, 0, 0, 100}), "a.pgm").rfind("tricover: cells: cell 2 (column 2, row 0) is -1", 0),
            0u);
  EXPECT_EQ(refused(made({0, 1})), "tricover: cells: 2 values for 3 x 2 cells");
  OccupancyMap map = made({0, 100, -1, -1, 0, 100});
  EXPECT_EQ(refused(map, "a.bmp"), "tricover: image: 'a.bmp' ends in neither .pgm nor .png");
  EXPECT_EQ(refused(map, "\xFF.png").rfind("tricover: image: YAML does not keep the name", 0), 0u);
  map.grid.origin << 1, 0;
  EXPECT_EQ(refused(map).rfind("tricover: origin: ", 0), 0u);
  map = made({0, 100, -1, -1, 0, 100});
  map.pose.linear() << 1, 0, 0, -1;
  EXPECT_EQ(refused(map).rfind("tricover: pose: it mirrors", 0), 0u);
  map.pose.linear() << 1, 1e-5, 0, 1;
  EXPECT_EQ(refused(map).rfind("tricover: pose: no yaw gives", 0), 0u);
  EXPECT_FALSE(std::filesystem::exists(path("out.yaml")));
  EXPECT_FALSE(std::filesystem::exists(path("out.pgm")));
}

TEST_F(OccupancyMapWrite, AFaultLeavesNothing) {
  const OccupancyMap map = made({0, 100, -1, -1, 0, 100});
  const std::string nowhere = path("none/map.yaml");
  EXPECT_EQ(
      errorOf([&] { writeOccupancyMap(map, nowhere); }).rfind("tricover: " + path("none/map.pgm") + ": can't be", 0),
      0u);
  std::filesystem::create_directory(path("folder.yaml"));
  EXPECT_EQ(errorOf([&] { writeOccupancyMap(map, path("folder.yaml")); }),
            "tricover: " + path("folder.yaml") + ": can't be written: it is no plain file");
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  EXPECT_FALSE(std::filesystem::exists(path("folder.pgm")));
}

}  // namespace
}  // namespace tricover
