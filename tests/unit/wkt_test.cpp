// SPDX-License-Identifier: BSD-3-Clause
// WKT in and out. Its parts mean what GeoJSON's do: geojson_test has more of these.
#include "tricover/wkt.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "refusal.h"
#include "tricover/tricover.h"

namespace tricover {
namespace {

std::string wrong(const std::string& text) {
  return support::refusal<std::runtime_error>([&] { parseWkt(text); });
}

TEST(Wkt, ReadsPolygons) {
  const std::vector<Ring> rings = {{{0, 0}, {4, 0}, {4, 4.5}}};
  for (const char* text :
       {"POLYGON((0 0,4 0,4 4.5,0 0))", " polygon ( ( 0\t0 ,+4 0e5,\r\n4. 45e-1 , 0 -0 ) ) \n",
        "PolygonZ((0 0 1,4 0 2,4 4.5 3,0 0 4))", "SRID=4326;POLYGON ZM ((0 0 1 1,4 0 2 1,4 4.5 3 1,0 0 4 1))",
        "POLYGON M ((0 0 nan,4 0 2,4 4.5 3,0 0 4))", "\xef\xbb\xbfMULTIPOLYGON(((0 0,4 0,4 4.5,0 0)))"}) {
    if (std::string(text).find("nan") == std::string::npos) {
      EXPECT_EQ(parseWkt(text).polygon.rings(), rings) << text;
    } else {
      EXPECT_NE(wrong(text).find("vertex 0: 'nan' is not a finite number"), std::string::npos) << wrong(text);
    }
  }
  const std::string two = "MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0),(1 1,2 1,2 2,1 1)),((20 0,21 0,21 1,20 0)))";
  EXPECT_EQ(parseWkt(two).polygon.area(), 81);
  EXPECT_EQ(parseWkt(two, {{20, 0}}).polygon.rings()[2], (Ring{{0, 0}, {1, 0}, {1, 1}}));
}

TEST(Wkt, WritesWhatItReads) {
  const std::string text =
      "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 2, 2 1, 1 1)), ((20 0, 21 0, 21 1, 20 0)))";
  EXPECT_EQ(toWkt(parseWkt(text).polygon), text);
  EXPECT_EQ(toWkt(Polygon::box(1, 2)), "POLYGON ((-0.5 -1, 0.5 -1, 0.5 1, -0.5 1, -0.5 -1))");
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Polygon odd({Ring{{-0.0, -1e300}, {1e300, 0.1}, {tiny, 1 / 3.0}}});
  const Polygon again = parseWkt(toWkt(odd)).polygon;
  EXPECT_EQ(again.rings(), odd.rings());
  EXPECT_TRUE(std::signbit(again.rings()[0][0].x()));
  EXPECT_NE(support::refusal([&] { toWkt(odd.complement()); }).find("WKT can't say"), std::string::npos);
}

TEST(Wkt, GivesAHoleToTheInnermostShell) {
  std::vector<Ring> rings;
  for (const double half : {4.0, 3.0, 2.0, 1.0}) rings.push_back(Polygon::box(2 * half, 2 * half).rings()[0]);
  EXPECT_EQ(toWkt(Polygon(rings)),
            "MULTIPOLYGON (((-4 -4, 4 -4, 4 4, -4 4, -4 -4), (-3 -3, -3 3, 3 3, 3 -3, -3 -3)), "
            "((-2 -2, 2 -2, 2 2, -2 2, -2 -2), (-1 -1, -1 1, 1 1, 1 -1, -1 -1)))");
}

TEST(Wkt, SaysWhereItIsWrong) {
  const std::vector<std::array<std::string, 2>> cases = {
      {"", "WKT: line 1: it doesn't begin with a word"},
      {"\n POINT(1 2)", "line 2: it is a POINT; POLYGON and MULTIPOLYGON are read"},
      {"POLYGON EMPTY", "it is EMPTY"},
      {"MULTIPOLYGON Z EMPTY", "it is EMPTY"},
      {"MULTIPOLYGON (EMPTY)", "part 0, ring 0, vertex 0: it is EMPTY"},
      {"POLYGON Q((0 0))", "'Q' is none of Z, M and ZM"},
      {"POLYGON((0 0,1 0", "ring 0, vertex 2: it ends early: ')' is missing after the positions"},
      {"POLYGON((0 0,1", "ring 0, vertex 1: it ends early: a number is missing"},
      {"POLYGON((0 0,1 0,\n1 x,0 0))", "line 2, ring 0, vertex 2: a number is missing"},
      {"POLYGON((0 0,1 0,1 1x,0 0))", "'1x' is no number"},
      {"POLYGON((0 0,1 1e999,1 1,0 0))", "vertex 1: '1e999' is beyond the range of doubles"},
      {"POLYGON((0 0,1 inf,1 1,0 0))", "'inf' is not a finite number"},
      {"POLYGON((0 0,1 0 1 1 1,1 1,0 0))", "')' is missing after the positions"},
      {"POLYGON((0 0,1 0,1 1,0 0)) x", "something is left"},
      {std::string("POLYGON((0 0,1 0,1 1,0 0))\0", 27), "something is left"},
      {"SRID=3", "';' is missing after the SRID"},
      {"POLYGON((0 0,1 0,1 1))", "WKT: ring 0: it has 3 positions"},
      {"MULTIPOLYGON(((0 0,1 0,1 1,0 1)))", "WKT: ring 0, vertex 3: the ring isn't closed"},
      {std::string(1000000, '('), "it doesn't begin with a word"},
      {"POLYGON" + std::string(1000000, '('), "a number is missing"}};
  // Each round of rounding these crossings found twice as many: it took hours. Found by fuzzing.
  const std::string needle = "((1e-323 1e-323,1e-323 2.464562164806065e-27,1 8.90874679343694e+194,1e-323 1e-323))";
  EXPECT_NE(wrong("MULTIPOLYGON(" + needle + ",((0 2,3 2,1 5,0 5,0 2)),((0 8,4 8,4 12,0 12,0 8)))")
                .find("its parts overlap, and cross at more than "),
            std::string::npos);
  for (const auto& [text, said] : cases) EXPECT_NE(wrong(text).find(said), std::string::npos) << wrong(text);
}

}  // namespace
}  // namespace tricover
