// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/occupancy_grid_io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <locale>
#include <string>

#include "map_folder.h"

namespace tricover {
namespace {

using OccupancyGridIo = MapFolder;

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

// As nav2 reads them.
TEST_F(OccupancyGridIo, ModeScaleGradesWhatIsBetweenTheThresholds) {
  write("map.pgm", "P2 6 1 200  0 50 100 101 150 200");  // p is 1, 0.75, 0.5, 0.495, 0.25, 0
  const auto cells = [&](const std::string& fields) {
    write("map.yaml", "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\n" + fields);
    return readOccupancyMap(path("map.yaml")).grid.cells;
  };
  const std::string wide = "\nnegate: 0\noccupied_thresh: 0.75\nfree_thresh: 0.25\n";
  for (const std::string scale : {"mode: scale", "mode: SCALE", "trinary: false", "trinary: 0\nmode: scale"})
    EXPECT_EQ(cells(scale + wide), (Cells{100, 100, 50, 49, 0, 0})) << scale;
  EXPECT_EQ(cells("mode: trinary" + wide), (Cells{100, 100, -1, -1, 0, 0}));
  EXPECT_EQ(cells("mode: scale\nnegate: 1\noccupied_thresh: 1\nfree_thresh: 0\n"), (Cells{0, 25, 50, 51, 75, 100}));
  EXPECT_EQ(cells("mode: scale\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0.5\n"), (Cells{100, 50, 0, 0, 0, 0}));
  EXPECT_EQ(cells("mode: scale\nnegate: 0\noccupied_thresh: 0.5\nfree_thresh: 0.5\n"), (Cells{100, 100, 100, 0, 0, 0}));
}

TEST_F(OccupancyGridIo, ModeRawTakesPixelsForValues) {
  write("map.pgm", "P2 6 1 255  0 1 100 101 254 255");
  for (const std::string negate : {"0", "1"}) {
    write("map.yaml", "image: map.pgm\nresolution: 1\norigin: [0, 0, 0]\nmode: raw\nnegate: " + negate +
                          "\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    EXPECT_EQ(readOccupancyMap(path("map.yaml")).grid.cells, (Cells{0, 1, 100, -1, -1, -1})) << negate;
  }
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
  for (const std::string mode : {"binary", "trinary scale", "2"})
    EXPECT_EQ(errorWith("mode", "mode: " + mode),
              yaml + "mode: '" + mode + "' is not a mode; write trinary, scale or raw");
  for (const std::string mode : {"trinary", "Raw"})
    EXPECT_EQ(errorWith("mode", "mode: " + mode + "\ntrinary: 0"),
              yaml + "trinary: 'false' means mode scale, and mode is " + mode + "; keep one");
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
                    none = pgm + "is neither a PGM image (P2 or P5) nor a PNG image; convert it to PNG";
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
