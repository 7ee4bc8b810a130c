// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tricover {
namespace {

/// A map of 3 x 2 cells, of which a test replaces what it is about.
class OccupancyGridIo : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("tricover_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write("map.pgm", "P2\n# by hand\n3 2\n255\n0 254 205\n254 0 254\n");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// The map of the usual keys, one of which may be another line, or none.
  OccupancyMap map(const std::string& key = "", const std::string& line = "") const {
    std::string text;
    for (const std::string usual : {"image: map.pgm", "resolution: 0.05", "origin: [-1.5, 2.0, 0.5]  # in metres",
                                    "negate: 0", "occupied_thresh: 0.65", "free_thresh: 0.196", "mode: 'trinary'"})
      text += (!key.empty() && usual.rfind(key, 0) == 0 ? line : usual) + "\n";
    write("map.yaml", text);
    return readOccupancyMap(path("map.yaml"));
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  template <typename Call>
  static std::string errorOf(Call&& call) {
    try {
      call();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  std::string errorWith(const std::string& key, const std::string& line) const {
    return errorOf([&] { map(key, line); });
  }
  std::string errorOfImage(const std::string& image) const {
    write("map.pgm", image);
    return errorOf([&] { map(); });
  }

  std::filesystem::path folder_;
};

using Cells = std::vector<std::int8_t>;

TEST_F(OccupancyGridIo, TheFirstRowOfTheImageIsTheLastOfTheMap) {
  const OccupancyMap found = map();
  EXPECT_EQ(found.grid.width, 3u);
  EXPECT_EQ(found.grid.height, 2u);
  EXPECT_EQ(found.grid.resolution, 0.05);
  EXPECT_EQ(found.grid.origin, Vec2(0, 0));
  EXPECT_EQ(found.grid.cells, (Cells{0, 100, 0, 100, 0, -1}));
  EXPECT_EQ(found.pose.translation(), Vec2(-1.5, 2));
  EXPECT_EQ(found.pose.linear(), Eigen::Rotation2Dd(0.5).toRotationMatrix());
}

TEST_F(OccupancyGridIo, BytesSayWhatTextSays) {
  const Cells text = map().grid.cells;
  write("map.pgm", std::string("P5 3 2 # by map_saver\n255\n") + '\0' + '\xFE' + '\xCD' + '\xFE' + '\0' + '\xFE');
  EXPECT_EQ(map().grid.cells, text);
}

TEST_F(OccupancyGridIo, NegatedWhiteIsOccupied) {
  EXPECT_EQ(map("negate", "negate: 1").grid.cells, (Cells{100, 0, 100, 0, 100, 100}));
}

TEST_F(OccupancyGridIo, TheImageMayBeNamedByItsWholePath) {
  EXPECT_EQ(map("image", "image: \"" + path("map.pgm") + "\"").grid.cells, map().grid.cells);
}

TEST_F(OccupancyGridIo, AnErrorNamesTheFileAndTheKey) {
  const std::string yaml = path("map.yaml");
  EXPECT_EQ(errorWith("resolution", "scale: 1"), yaml + ": no key 'resolution'");
  EXPECT_EQ(errorWith("resolution", "resolution:"), yaml + ": resolution: '' is empty");
  EXPECT_EQ(errorWith("resolution", "resolution: -1"), yaml + ": resolution: '-1' is not positive");
  EXPECT_EQ(errorWith("occupied", "occupied_thresh: 0,65"), yaml + ": occupied_thresh: '0,65' is not a number");
  EXPECT_EQ(errorWith("occupied", "occupied_thresh: inf"), yaml + ": occupied_thresh: 'inf' is not a number");
  EXPECT_EQ(errorWith("free", "free_thresh: 0.7"), yaml + ": free_thresh: '0.7' is above occupied_thresh");
  EXPECT_EQ(errorWith("negate", "negate: no"), yaml + ": negate: 'no' is neither 0 nor 1");
  EXPECT_EQ(errorWith("mode", "mode: raw"), yaml + ": mode: 'raw' is none that is read: trinary is");
  EXPECT_EQ(errorWith("origin", "origin: [1, 2]"), yaml + ": origin: '[1, 2]' has fewer than three numbers");
  EXPECT_EQ(errorWith("origin", "origin: [1, 2, 3, 4]"), yaml + ": origin: '[1, 2, 3, 4]' has more than three numbers");
  EXPECT_EQ(errorWith("origin", "origin: 1, 2, 3"), yaml + ": origin: '1, 2, 3' isn't written as [x, y, yaw]");
  EXPECT_EQ(errorWith("origin", "origin: ["), yaml + ": origin: '[' isn't written as [x, y, yaw]");
}

TEST_F(OccupancyGridIo, AnErrorNamesTheImage) {
  const std::string pgm = path("map.pgm") + ": ";
  EXPECT_EQ(errorOfImage(""), pgm + "is no PGM image, P2 or P5");
  EXPECT_EQ(errorOfImage("P6 1 1 255 123"), pgm + "is no PGM image, P2 or P5");
  EXPECT_EQ(errorOfImage("P2 3"), pgm + "has no height from 1 to 65535");
  EXPECT_EQ(errorOfImage("P2 0 2 1"), pgm + "has no width from 1 to 65535");
  EXPECT_EQ(errorOfImage("P2 70000 2 1"), pgm + "has no width from 1 to 65535");
  EXPECT_EQ(errorOfImage("P5 2 1 # deep\n65535\n1234"), pgm + "has no white from 1 to 255");
  EXPECT_EQ(errorOfImage("P2 3 2 2  0 1 2  2"), pgm + "ends before its last pixel");
  EXPECT_EQ(errorOfImage("P2 3 1 200  100 100"), pgm + "ends before its last pixel");
  EXPECT_EQ(errorOfImage("P5 3 2 255\n12345"), pgm + "ends before its last pixel");
  EXPECT_EQ(errorOfImage("P5 3 2 255"), pgm + "ends before its last pixel");
  EXPECT_EQ(errorOfImage("P2 2 1 2  0 3"), pgm + "has a pixel above its white, 3");
  EXPECT_EQ(errorOfImage("P2 2 1 2  0 300"), pgm + "has a pixel above its white, 300");
  EXPECT_EQ(errorOfImage("P5 2 1 2\n12"), pgm + "has a pixel above its white, 49");
}

// It took 4 GB and five seconds to say so.
TEST_F(OccupancyGridIo, PixelsThatAreMissingTakeNoMemory) {
  for (const std::string magic : {"P5", "P2"})
    EXPECT_EQ(errorOfImage(magic + "\n65535 65535\n255\n"), path("map.pgm") + ": ends before its last pixel");
}

TEST_F(OccupancyGridIo, WhatIsNoPlainFileIsRefused) {
  for (const std::string& none : {std::string("/dev/zero"), folder_.string()}) {
    const std::string refused = "can't read " + none + ": ";
    EXPECT_EQ(errorOf([&] { readOccupancyMap(none); }).substr(0, refused.size()), refused);
    EXPECT_EQ(errorWith("image", "image: " + none).substr(0, refused.size()), refused);
  }
  EXPECT_EQ(errorWith("image", "image: none.pgm").rfind("can't read " + path("none.pgm") + ": ", 0), 0u);
  write("long.yaml", std::string(2 << 20, '\n'));
  EXPECT_EQ(errorOf([&] { readOccupancyMap(path("long.yaml")); }),
            path("long.yaml") + ": is too long for the keys of a map");
}

}  // namespace
}  // namespace tricover
