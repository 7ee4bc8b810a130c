// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <locale>
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

TEST_F(OccupancyGridIo, BytesSayWhatTextSaysAndNegatedWhiteIsOccupied) {
  const Cells text = map().grid.cells;
  EXPECT_EQ(map("image", "image: \"" + path("map.pgm") + "\"").grid.cells, text) << "by its whole path";
  write("map.pgm", std::string("P5 3 2 # by map_saver\n255\n") + '\0' + '\xFE' + '\xCD' + '\xFE' + '\0' + '\xFE');
  EXPECT_EQ(map().grid.cells, text);
  for (const std::string yes : {"1", "true", "True", "yes"})
    EXPECT_EQ(map("negate", "negate: " + yes).grid.cells, (Cells{100, 0, 100, 0, 100, 100})) << yes;
}

TEST_F(OccupancyGridIo, FieldsMayBeWrittenAsYamlAllows) {
  const OccupancyMap usual = map();
  const auto expectTheSame = [&](const std::string& field, const std::string& line) {
    const OccupancyMap found = map(field, line);
    EXPECT_EQ(found.grid.cells, usual.grid.cells) << line;
    EXPECT_EQ(found.grid.resolution, usual.grid.resolution) << line;
    EXPECT_EQ(found.pose.matrix(), usual.pose.matrix()) << line;
  };
  expectTheSame("origin", "origin:\n- -1.5\n- 2.0\n- 0.5");  // PyYAML's blocks
  expectTheSame("origin", "origin:\n  - -1.5\n  - 2\n  - 5e-1");
  expectTheSame("origin", "origin: [-1.5, 2.0,\n  0.5]");
  for (const std::string no : {"0", "false", "False", "no", "'0'"}) expectTheSame("negate", "negate: " + no);
  for (const std::string mode : {"Trinary", "TRINARY", "\"trinary\""}) expectTheSame("mode", "mode: " + mode);
  expectTheSame("mode", "");
  for (const std::string yes : {"true", "1"}) expectTheSame("mode", "trinary: " + yes);
  expectTheSame("image", "\xEF\xBB\xBFimage: map.pgm");  // a byte order mark
  expectTheSame("image", "%YAML 1.1\n---\nimage: map.pgm");
  expectTheSame("resolution", "resolution: 0.05\r");
  expectTheSame("resolution", "{not: ours}: [1, 2]\nresolution: 0.05\nalso_not_ours: ~");
  std::filesystem::rename(path("map.pgm"), path("floor#2.pgm"));
  for (const std::string name : {"\"floor#2.pgm\"", "floor#2.pgm  # the second", "'floor#2.pgm'"})
    expectTheSame("image", "image: " + name);
}

TEST_F(OccupancyGridIo, ThresholdsAreReachedByWhatIsAsMuch) {
  write("map.pgm", "P2 3 1 4  0 2 4");
  const auto cells = [&](const std::string& occupied, const std::string& free) {
    std::string text = "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n";
    write("map.yaml", text + "occupied_thresh: " + occupied + "\nfree_thresh: " + free + "\n");
    return readOccupancyMap(path("map.yaml")).grid.cells;
  };
  EXPECT_EQ(cells("1.0", "0.0"), (Cells{100, -1, 0}));
  EXPECT_EQ(cells("0.5", "0.0"), (Cells{100, 100, 0}));
  EXPECT_EQ(cells("0.5", "0.5"), (Cells{100, 100, 0}));
  EXPECT_EQ(cells("1", "0.5"), (Cells{100, 0, 0}));
}

TEST_F(OccupancyGridIo, AHeaderMayEndInCrLfIfTheSizeProvesIt) {
  const std::string pixels = std::string() + '\0' + '\xFE' + '\xCD' + '\xFE' + '\0' + '\xFE';
  const Cells usual = map().grid.cells;
  write("map.pgm", "P5\r\n# by hand\r\n3 2\r\n255\r\n" + pixels);
  EXPECT_EQ(map().grid.cells, usual);
  write("map.pgm", "P5 3 2 255\r" + pixels);
  EXPECT_EQ(map().grid.cells, usual);
  // The first pixel is 10, after CR alone.
  write("map.pgm", "P5 3 2 255\r\n" + pixels.substr(1));
  EXPECT_EQ(map().grid.cells, usual);
  // Nobody can tell where the first pixel is.
  EXPECT_EQ(errorOfImage("P5 3 2 255\r\n" + pixels + "\n"),
            "tricover: " + path("map.pgm") +
                ": its header ends in CR LF and 2 bytes are left after the pixels, not 1; end the header in LF");
  // Other bytes after the pixels are another image's, as the format allows.
  write("map.pgm", "P5 3 2 255\n" + pixels + "P5 1 1 255\n0");
  EXPECT_EQ(map().grid.cells, usual);
}

TEST_F(OccupancyGridIo, NumbersAreReadInEveryLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const double resolution = map().grid.resolution;
  std::locale::global(before);
  EXPECT_EQ(resolution, 0.05);
}

TEST_F(OccupancyGridIo, AnErrorNamesTheFileAndTheField) {
  const std::string yaml = "tricover: " + path("map.yaml") + ": ";
  EXPECT_EQ(errorWith("resolution", "scale: 1"), yaml + "resolution: is missing; add it");
  EXPECT_EQ(errorWith("resolution", "resolution:"), yaml + "resolution: has no value; add one");
  EXPECT_EQ(errorWith("resolution", "resolution: ''"), yaml + "resolution: has no value; add one");
  EXPECT_EQ(errorWith("resolution", "resolution: [1]"), yaml + "resolution: has several values; keep one");
  EXPECT_EQ(errorWith("resolution", "resolution: 1\nresolution: 2"), yaml + "resolution: is there twice; keep one");
  EXPECT_EQ(errorWith("resolution", "resolution: -1"), yaml + "resolution: '-1' is not positive; write metres a cell");
  const std::string number = " is not a finite number; write it as 0.05 or 5e-2";
  for (const std::string none : {"0,65", "inf", ".inf", ".nan", "1 2", "1m"})
    EXPECT_EQ(errorWith("occupied", "occupied_thresh: " + none), yaml + "occupied_thresh: '" + none + "'" + number);
  EXPECT_EQ(errorWith("occupied", "occupied_thresh: 65"),
            yaml + "occupied_thresh: '65' is not from 0 to 1; write a share");
  EXPECT_EQ(errorWith("free", "free_thresh: -0.1"), yaml + "free_thresh: '-0.1' is not from 0 to 1; write a share");
  EXPECT_EQ(errorWith("free", "free_thresh: 0.7"), yaml + "free_thresh: '0.7' is above occupied_thresh; lower it");
  for (const std::string none : {"2", "-1", "maybe"})
    EXPECT_EQ(errorWith("negate", "negate: " + none),
              yaml + "negate: '" + none + "' is neither true nor false; write 1 or 0");
  const std::string trinary = "; save the map in mode trinary";
  for (const std::string mode : {"raw", "Scale", "binary"})
    EXPECT_EQ(errorWith("mode", "mode: " + mode), yaml + "mode: '" + mode + "' is not read" + trinary);
  for (const std::string no : {"false", "0"})
    EXPECT_EQ(errorWith("mode", "trinary: " + no),
              yaml + "trinary: 'false' means mode scale, which is not read" + trinary);
  EXPECT_EQ(errorWith("origin", "origin: [1, 2]"), yaml + "origin: has 2 values, not 3; write [x, y, yaw]");
  EXPECT_EQ(errorWith("origin", "origin: [1, 2, 3, 4]"), yaml + "origin: has 4 values, not 3; write [x, y, yaw]");
  EXPECT_EQ(errorWith("origin", "origin: 1, 2, 3"), yaml + "origin: isn't a list; write [x, y, yaw]");
  EXPECT_EQ(errorWith("origin", "origin: [1, x, 3]"), yaml + "origin: 'x'" + number);
}

TEST_F(OccupancyGridIo, WhatIsNoMapOfFieldsIsRefused) {
  const std::string yaml = "tricover: " + path("map.yaml") + ": ";
  for (const std::string text : {"", "just a text", "- a\n- list"}) {
    write("map.yaml", text);
    EXPECT_EQ(errorOf([&] { readOccupancyMap(path("map.yaml")); }), yaml + "has no fields; name a map's YAML file");
  }
  EXPECT_EQ(errorWith("origin", "origin: [").rfind(yaml + "is no YAML: line 5: ", 0), 0u);
  EXPECT_EQ(errorWith("origin", "origin: *nowhere").rfind(yaml + "is no YAML: line 3: ", 0), 0u);
  EXPECT_EQ(errorWith("origin", "origin: " + std::string(100000, '[')).rfind(yaml + "is no YAML: ", 0), 0u);
}

TEST_F(OccupancyGridIo, AnErrorNamesTheImage) {
  const std::string pgm = "tricover: " + path("map.pgm") + ": ",
                    none = pgm + "is no PGM image (P2 or P5); convert it to PGM";
  EXPECT_EQ(errorOfImage(""), none);
  EXPECT_EQ(errorOfImage("P6 1 1 255 123"), none);
  EXPECT_EQ(errorOfImage("P2 3"), pgm + "height: isn't from 1 to 65535");
  EXPECT_EQ(errorOfImage("P2 0 2 1"), pgm + "width: isn't from 1 to 65535");
  EXPECT_EQ(errorOfImage("P2 70000 2 1"), pgm + "width: isn't from 1 to 65535");
  EXPECT_EQ(errorOfImage("P5 2 1 # deep\n65535\n1234"), pgm + "maximum grey: isn't from 1 to 255");
  EXPECT_EQ(errorOfImage("P2 3 2 2  0 1 2  2"), pgm + "ends before the last of its 3 x 2 pixels");
  EXPECT_EQ(errorOfImage("P2 3 1 200  100 100"), pgm + "ends before the last of its 3 x 1 pixels");
  EXPECT_EQ(errorOfImage("P5 3 2 255\n12345"), pgm + "ends before the last of its 3 x 2 pixels");
  EXPECT_EQ(errorOfImage("P5 3 2 255\r\n1234"), pgm + "ends before the last of its 3 x 2 pixels");
  EXPECT_EQ(errorOfImage("P5 3 2 255"), pgm + "ends before the last of its 3 x 2 pixels");
  EXPECT_EQ(errorOfImage("P2 2 1 2  0 3"), pgm + "a pixel is 3, above the maximum grey, 2");
  EXPECT_EQ(errorOfImage("P2 2 1 2  0 300"), pgm + "a pixel is 300, above the maximum grey, 2");
  EXPECT_EQ(errorOfImage("P5 2 1 2\n12"), pgm + "a pixel is 49, above the maximum grey, 2");
}

// It took 4 GB and five seconds to say so.
TEST_F(OccupancyGridIo, PixelsThatAreMissingTakeNoMemory) {
  for (const std::string magic : {"P5", "P2"})
    EXPECT_EQ(errorOfImage(magic + "\n65535 65535\n255\n"),
              "tricover: " + path("map.pgm") + ": ends before the last of its 65535 x 65535 pixels");
}

TEST_F(OccupancyGridIo, WhatIsNoPlainFileIsRefused) {
  for (const std::string& none : {std::string("/dev/zero"), folder_.string()}) {
    const std::string refused = "tricover: " + none + ": can't be read: ";
    EXPECT_EQ(errorOf([&] { readOccupancyMap(none); }).substr(0, refused.size()), refused);
    EXPECT_EQ(errorWith("image", "image: " + none).substr(0, refused.size()), refused);
  }
  EXPECT_EQ(errorWith("image", "image: none.pgm").rfind("tricover: " + path("none.pgm") + ": can't be read: ", 0), 0u);
  write("long.yaml", std::string(2 << 20, '\n'));
  EXPECT_EQ(
      errorOf([&] { readOccupancyMap(path("long.yaml")); }),
      "tricover: " + path("long.yaml") + ": has 2097152 bytes, more than 1048576; name the YAML file, not the image");
}

}  // namespace
}  // namespace tricover
