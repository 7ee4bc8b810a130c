// SPDX-License-Identifier: BSD-3-Clause
// GeoJSON in and out: regions, doubles bit for bit, and errors that say where.
#include "tricover/geojson.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <stdexcept>
#include <string>
#include <vector>

#include "own_folder.h"
#include "refusal.h"
#include "tricover/tricover.h"

namespace tricover {
namespace {

const Pose kHere = Pose::Identity();

std::string polygonText(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
}
std::string multiText(const std::string& coordinates) {
  return R"({"type":"MultiPolygon","coordinates":)" + coordinates + "}";
}
std::string featureText(const std::string& geometry, const std::string& more = {}) {
  return R"({"type":"Feature",)" + more + R"("properties":null,"geometry":)" + geometry + "}";
}
std::string collectionText(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}
const char* const kSquare = "[[[0,0],[4,0],[4,4],[0,4],[0,0]]]";
std::string box(double x0, double y0, double x1, double y1) {
  const auto at = [](double x, double y) { return "[" + std::to_string(x) + "," + std::to_string(y) + "]"; };
  return "[" + at(x0, y0) + "," + at(x1, y0) + "," + at(x1, y1) + "," + at(x0, y1) + "," + at(x0, y0) + "]";
}

GeoFeature one(const std::string& text, const GeoOptions& options = {}) {
  const std::vector<GeoFeature> features = parseGeoJson(text, options);
  EXPECT_EQ(features.size(), 1u);
  return features.at(0);
}

std::string wrong(const std::string& text, const GeoOptions& options = {}) {
  return support::refusal<std::runtime_error>([&] { parseGeoJson(text, options); });
}

bool sameBits(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t r = 0; r < a.size(); ++r)
    if (a[r].size() != b[r].size() || std::memcmp(a[r].data(), b[r].data(), a[r].size() * sizeof(Vec2)) != 0)
      return false;
  return true;
}

TEST(GeoJson, ReadsEachKindOfObject) {
  const std::string square = polygonText(kSquare);
  const std::string two = multiText("[" + std::string(kSquare) + ",[" + box(5, 0, 6, 1) + "]]");
  const std::vector<Ring> rings = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  EXPECT_EQ(one(square).polygon.rings(), rings);
  EXPECT_EQ(one(featureText(square)).polygon.rings(), rings);
  EXPECT_EQ(one(collectionText(featureText(square))).polygon.rings(), rings);
  EXPECT_EQ(one("\xef\xbb\xbf " + square).polygon.rings(), rings);  // a byte order mark
  EXPECT_EQ(one(two).polygon.area(), 17);
  EXPECT_EQ(one(two).polygon.fillRule(), FillRule::EvenOdd);
  EXPECT_EQ(one(R"({"type":"GeometryCollection","geometries":[)" + square + "," + two + "]}").polygon.area(), 17);
  EXPECT_TRUE(parseGeoJson(collectionText("")).empty());
  // Members in any order, z and m dropped, foreign members that are anything.
  EXPECT_EQ(one(R"({"bbox":[0,0,[{"type":7}],1],"coordinates":[[[0,0,7],[4,0,8,9],[4,4,7],[0,4,7],[0,0,1]]],)"
                R"("type":"Polygon","coordinatesX":"x"})")
                .polygon.rings(),
            rings);
}

TEST(GeoJson, KeepsIdsAndPropertiesAsTheyAre) {
  const std::string text =
      collectionText(R"({"type":"Feature","id":17,"properties":{"z":1.50,"a":["\u00e4\n",null,true,{}]},"geometry":)" +
                     polygonText(kSquare) + R"(},{"geometry":)" + polygonText(kSquare) +
                     R"(,"properties":null,"type":"Feature","id":"do\"ck"})");
  const std::vector<GeoFeature> features = parseGeoJson(text);
  ASSERT_EQ(features.size(), 2u);
  EXPECT_EQ(features[0].id, "17");
  EXPECT_EQ(features[0].properties, "{\"z\":1.50,\"a\":[\"\u00e4\\n\",null,true,{}]}");
  EXPECT_EQ(features[1].id, "\"do\\\"ck\"");
  EXPECT_EQ(features[1].properties, "");
  const std::vector<GeoFeature> again = parseGeoJson(toGeoJson(features));
  ASSERT_EQ(again.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again[i].id, features[i].id);
    EXPECT_EQ(again[i].properties, features[i].properties);
    EXPECT_EQ(again[i].polygon.rings(), features[i].polygon.rings());
  }
}

TEST(GeoJson, KeepsHolesAndIslands) {
  const std::string text = multiText("[[" + box(0, 0, 9, 9) + "," + box(1, 1, 8, 8) + "],[" + box(2, 2, 7, 7) + "]]");
  const Polygon polygon = one(text).polygon;
  EXPECT_EQ(polygon.area(), 81 - 49 + 25);
  EXPECT_EQ(polygon.fillRule(), FillRule::EvenOdd);
  // Shells go out counter-clockwise, holes clockwise.
  EXPECT_EQ(toGeoJson(polygon), R"({"type":"MultiPolygon","coordinates":[[[[0,0],[9,0],[9,9],[0,9],[0,0]],)"
                                R"([[1,1],[1,8],[8,8],[8,1],[1,1]]],[[[2,2],[7,2],[7,7],[2,7],[2,2]]]]})");
}

/// A drivable area: lanes that overlap, one around a hole.
TEST(GeoJson, JoinsPartsThatOverlap) {
  const std::string ring_road = "[" + box(0, 0, 30, 30) + "," + box(4, 4, 26, 26) + "]";
  const std::vector<std::string> lanes = {ring_road, "[" + box(-10, 10, 40, 14) + "]",
                                          "[[[1,-9],[5,-9],[29,39],[25,39],[1,-9]]]", "[" + box(12, 12, 13, 13) + "]"};
  std::string all;
  Scene scene;
  for (const std::string& lane : lanes) {
    all += (all.empty() ? "" : ",") + lane;
    scene.add(one(polygonText(lane)).polygon, kHere);
  }
  const GeoFeature area = one(multiText("[" + all + "]"));
  EXPECT_EQ(area.polygon.fillRule(), FillRule::NonZero);
  EXPECT_GT(area.rounded_crossings, 8u);
  for (const SelfCrossing& crossing : selfCrossings(area.polygon))
    EXPECT_NE(crossing.kind, SelfCrossingKind::Crossing) << crossing.text;

  const Polygon outside = area.polygon.complement();
  const Polygon car = Polygon::box(1.5, 0.75);
  int inside = 0, cases = 0;
  for (double x = -12; x < 42; x += 0.71)
    for (double y = -11; y < 41; y += 0.83, ++cases) {
      const Pose pose = poseAt(x, y, x + 2 * y);
      const bool is_covered = scene.covers(car, pose);
      EXPECT_EQ(covers(area.polygon, kHere, car, pose), is_covered) << x << " " << y;
      EXPECT_EQ(!collide(outside, kHere, car, pose, {0, 0, Touching::Allowed}), is_covered) << x << " " << y;
      inside += is_covered ? 1 : 0;
    }
  EXPECT_GT(inside, cases / 20);
  EXPECT_LT(inside, cases / 2);

  // It crosses itself, which GeoJSON doesn't allow; its border doesn't.
  EXPECT_NE(support::refusal([&] { toGeoJson(area.polygon); }).find("complement().complement()"), std::string::npos);
  const Polygon border = outside.complement();
  const Polygon again = one(toGeoJson(border)).polygon;
  EXPECT_NEAR(again.area(), area.polygon.area(), 1e-9);
  EXPECT_TRUE(covers(again, kHere, border, kHere) && covers(border, kHere, again, kHere));
}

TEST(GeoJson, KeepsPartsThatTouchUnderTheEvenOddRule) {
  const GeoFeature lanes = one(multiText("[[" + box(0, 0, 4, 2) + "],[" + box(1, 2, 3, 5) + "]]"));
  EXPECT_EQ(lanes.polygon.fillRule(), FillRule::EvenOdd);
  EXPECT_EQ(lanes.rounded_crossings, 0u);
  EXPECT_EQ(lanes.polygon.complement().complement().area(), 14);
  // The same part twice is there once.
  EXPECT_EQ(one(multiText("[[" + box(0, 0, 4, 2) + "],[" + box(0, 0, 4, 2) + "]]")).polygon.area(), 8);
}

TEST(GeoJson, WritesNonZeroRingsThatAreNested) {
  const Ring outer{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, inner{{1, 1}, {2, 1}, {2, 2}, {1, 2}};
  Ring hole = inner;
  std::reverse(hole.begin(), hole.end());
  const auto partsOf = [](const Polygon& polygon) { return one(toGeoJson(polygon)).polygon; };
  EXPECT_EQ(partsOf(Polygon({outer, inner}, FillRule::NonZero)).rings(), (std::vector<Ring>{outer}));
  EXPECT_EQ(partsOf(Polygon({outer, hole}, FillRule::NonZero)).area(), 80);
  EXPECT_EQ(partsOf(Polygon({hole, outer}, FillRule::NonZero)).area(), 80);
  EXPECT_EQ(partsOf(Polygon({outer, inner}, FillRule::EvenOdd)).area(), 80);
}

TEST(GeoJson, RefusesToWriteWhatItCannotSay) {
  const Ring bow{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  EXPECT_NE(support::refusal([&] { toGeoJson(Polygon(bow)); }).find("ring 0 crosses itself at (1, 1)"),
            std::string::npos);
  EXPECT_NE(support::refusal([&] { toGeoJson(Polygon::box(1, 1).complement()); }).find("unbounded"), std::string::npos);
  EXPECT_NE(support::refusal([&] { toGeoJson(Polygon::point({1, 1})); }).find("no area"), std::string::npos);
  EXPECT_NE(support::refusal([&] {
              toGeoJson({{Polygon::box(1, 1), "dock"}});
            }).find("features[0].id"),
            std::string::npos);
  EXPECT_NE(support::refusal([&] {
              toGeoJson({{Polygon::box(1, 1), "", "[1]"}});
            }).find("features[0].properties"),
            std::string::npos);
  const std::string deep = "{\"a\":" + std::string(100, '[') + std::string(100, ']') + "}";
  EXPECT_NE(support::refusal([&] { toGeoJson({{Polygon::box(1, 1), "", deep}}); }).find("too deep"), std::string::npos);
  // The writer refuses what the reader would.
  int written = 0;
  for (std::size_t depth = 55; depth < 66; ++depth)
    for (const std::string inner : {"", "1", "{}"}) {
      const std::string brackets = std::string(depth, '[') + inner + std::string(depth, ']');
      try {
        const std::string text = toGeoJson({{Polygon::box(1, 1), "", "{\"a\":" + brackets + "}"}});
        EXPECT_EQ(parseGeoJson(text).size(), 1u);
        ++written;
      } catch (const std::invalid_argument&) {
      }
    }
  EXPECT_EQ(written, 6 + 6 + 5);  // 64 without the collection, its list, the feature and the properties
  for (const std::string& bad : {std::string("7\0,", 3), std::string("\xef\xbb\xbf"
                                                                     "7")})
    EXPECT_NE(support::refusal([&] { toGeoJson({{Polygon::box(1, 1), bad}}); }).find("a byte 0"), std::string::npos);
  EXPECT_NE(wrong(polygonText(kSquare) + std::string("\0x", 2)).find("a byte 0"), std::string::npos);
}

TEST(GeoJson, KeepsDoublesBitForBit) {
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  const std::vector<Ring> rings = {{{-0.0, -0.0}, {1e300, 0.1}, {1 / 3.0, 1e300}},
                                   {{-tiny, -tiny}, {-tiny, -huge}, {-1e-300, -5e-324}},
                                   {{-1e22, 123456789012345678}, {-1e22 - 1e7, 0.1 + 0.2}, {-3e22, 9007199254740993}}};
  for (const Ring& ring : rings) {
    const Polygon polygon(ring);
    Ring turned = ring;
    std::reverse(turned.begin() + 1, turned.end());
    const Polygon again = one(toGeoJson(polygon)).polygon;
    EXPECT_TRUE(sameBits(again.rings(), {ring}) || sameBits(again.rings(), {turned})) << toGeoJson(polygon);
  }
}

TEST(GeoJson, IsTheSameInEveryLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string text = polygonText("[[[0.5,0],[123456.25,0],[4,4.75],[0.5,0]]]");
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const char* const set = std::setlocale(LC_ALL, "de_DE.UTF-8");  // if it is installed
  const Polygon polygon = one(text).polygon;
  const std::string written = toGeoJson(polygon);
  if (set != nullptr) std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  EXPECT_EQ(polygon.rings()[0][1], Vec2(123456.25, 0));
  EXPECT_EQ(written, text);
}

TEST(GeoJson, SubtractsAnOrigin) {
  const std::string text = polygonText("[[[1000.25,2000],[1001,2000],[1000,2001.5],[1000.25,2000]]]");
  const GeoFeature exact = one(text, {{1000, 2000}});
  EXPECT_EQ(exact.polygon.rings()[0], (Ring{{0.25, 0}, {1, 0}, {0, 1.5}}));
  EXPECT_EQ(exact.rounded_coordinates, 0u);
  EXPECT_EQ(one(text, {{0.1, 0}}).rounded_coordinates, 3u);
  const std::string far = polygonText("[[[1.5e308,0],[0,1],[0,2],[1.5e308,0]]]");
  EXPECT_NE(wrong(far, {{-1.5e308, 0}}).find("ring 0, vertex 0: a coordinate minus the origin"), std::string::npos);
}

// By rounded products the first ring, counter-clockwise with an area of 1.5, has one of -32.
TEST(GeoJson, KnowsTheDirectionOfASliver) {
  const Ring sliver{{0, 0}, {678187773, 642667408}, {807006422, 764739127}, {762297868, 722372202}};
  const std::string text = "[[0,0],[678187773,642667408],[807006422,764739127],[762297868,722372202],[0,0]]";
  const GeoFeature both = one(multiText("[[" + text + "],[" + box(0, 0, 1e9, 1e9) + "]]"));
  EXPECT_EQ(both.polygon.rings()[0], sliver);
  EXPECT_EQ(both.polygon.fillRule(), FillRule::NonZero);
}

TEST(GeoJson, SaysWhereItIsWrong) {
  const std::string square = featureText(polygonText(kSquare));
  const std::vector<std::array<std::string, 2>> cases = {
      {"", "GeoJSON: line 1: it is no JSON: "},
      {"{\n\"type\":\n", "GeoJSON: line 3: it is no JSON: "},
      {polygonText("[[[0,0],[NaN,0],[1,1],[0,0]]]"), "it is no JSON: "},
      {polygonText("[[[0,0],\n[1e999,0],[1,1],[0,0]]]"), "line 2: it is no JSON: number overflow"},
      {"\xff\xfe{", "save it as UTF-8"},
      {"[]", "GeoJSON: it is an array; a GeoJSON text is an object"},
      {"17", "it is a single value"},
      {"{}", "has no 'type'"},
      {R"({"type":"Polygn"})", "GeoJSON: \"Polygn\" is no type of GeoJSON"},
      {R"({"type":"Polygon","type":"Polygon"})", "it has 'type' twice"},
      {R"({"type":"FeatureCollection"})", "has no 'features'"},
      {collectionText(square + "," + polygonText(kSquare)), "feature 1: 'features' has a \"Polygon\""},
      {collectionText(square + ",7"), "'features' has a value among its objects"},
      {collectionText(square + "," + featureText(polygonText("[[[0,0],[1,0],[1,1],[0,1]]]"), R"("id":"a",)")),
       "feature 1 (id \"a\"): ring 0, vertex 3: the ring isn't closed; end it with its first position"},
      {polygonText("[[[0,0],[1,0],[0,0]]]"), "ring 0: it has 3 positions; a ring needs at least 4"},
      {polygonText("[]"),
       "its geometry is a Polygon without coordinates, which has no area; set GeoOptions::skip_others"},
      {polygonText("[[]]"), "the coordinates of a Polygon have an empty array"},
      {polygonText("[\"a\"]"), "the coordinates of a Polygon have a value that is no number"},
      {collectionText(R"({"type":"Feature","properties":null})"), "a Feature has no 'geometry'"},
      {polygonText("[[[0,0],[1,0],[1,1],[0,0]],[]]"), "a ring without positions at ring 1, vertex 0"},
      {polygonText("[[[0,0],[1]]]"), "a position without x and y at ring 0, vertex 1"},
      {polygonText("[[[0,0],[1,\"2\"]]]"), "a value that is no number at ring 0, vertex 1"},
      {polygonText("[[[0,0],[1,[2]]]]"), "an array instead of a number at ring 0, vertex 1"},
      {polygonText("[[[0,0],5]]"), "a number where positions are expected at ring 0, vertex 1"},
      {multiText(kSquare), "positions in 3 arrays, not 4"},
      {polygonText("[" + std::string(kSquare) + "]"), "positions in 4 arrays, not 3"},
      {polygonText("[" + box(0, 0, 4, 4) + "," + box(3, 3, 5, 5) + "]"), "ring 1: the hole is not inside of its shell"},
      {polygonText("[" + box(0, 0, 4, 4) + "," + box(8, 8, 9, 9) + "]"), "ring 1: the hole is not inside of its shell"},
      {polygonText("[" + box(0, 0, 4, 4) + "," + box(1, 1, 3, 3) + "," + box(2, 2, 3.5, 3.5) + "]"),
       "ring 2: the hole overlaps another one, ring 1"},
      {multiText("[[[[0,0],[2,2],[2,0],[0,2],[0,0]]],[" + box(0, 0, 1, 1) + "]]"),
       "part 0: ring 0 crosses itself at (1, 1)"},
      {featureText(R"({"type":"Point","coordinates":[1,2]})"), "set GeoOptions::skip_others"},
      {featureText("null"), "its geometry is a null"},
      {R"({"type":"GeometryCollection","geometries":[]})", "GeometryCollection without geometries"},
      {featureText(featureText("null")), "a Feature stands in a geometry's place"}};
  for (const auto& [text, said] : cases) EXPECT_NE(wrong(text).find(said), std::string::npos) << text << wrong(text);
}

TEST(GeoJson, SkipsOthersIfItMay) {
  const std::string others = featureText(R"({"type":"Point","coordinates":[]})") + "," + featureText("null") + "," +
                             featureText(multiText("[]")) + "," + featureText(polygonText("[]")) + "," +
                             featureText(R"({"type":"MultiLineString","coordinates":[[[0,0],[1,1]]]})") + ",";
  GeoOptions options;
  options.skip_others = true;
  const std::string text = collectionText(others + featureText(polygonText(kSquare), R"("id":3,)"));
  EXPECT_EQ(one(text, options).id, "3");
  EXPECT_NE(wrong(text).find("feature 0"), std::string::npos);
}

TEST(GeoJson, SkipsForeignMembersHoweverTheyNest) {
  const std::string foreign = R"("foreign":[[1,[2]],{"type":[{"coordinates":{}},[]]}],"bbox":[[0],[[1]]],)";
  EXPECT_EQ(one(R"({"type":"Feature",)" + foreign + R"("geometry":{)" + foreign + polygonText(kSquare).substr(1) +
                R"(,"id":5})")
                .id,
            "5");
}

TEST(GeoJson, ReadsAShellThatCrossesItself) {
  const GeoFeature bow = one(polygonText("[[[0,0],[2,2],[2,0],[0,2],[0,0]]]"));
  EXPECT_EQ(bow.polygon.area(), 2);
  EXPECT_EQ(selfCrossings(bow.polygon).size(), 1u);
  EXPECT_TRUE(bow.polygon.complement().isComplement());
}

TEST(GeoJson, IsBoundedByTheText) {
  for (const char* deep :
       {"[", "{\"a\":", "{\"type\":\"Feature\",\"properties\":{\"a\":[", "{\"geometry\":", "{\"coordinates\":[[[["}) {
    std::string text;
    for (int i = 0; i < 200000; ++i) text += deep;
    EXPECT_FALSE(wrong(text).empty());
    EXPECT_LT(wrong(text).size(), 400u);
  }
  EXPECT_LT(wrong("\"" + std::string(1000000, 'x')).size(), 400u);
  const auto nested = [](std::size_t depth) {
    return "{\"a\":" + std::string(depth - 1, '[') + std::string(depth - 1, ']') + "," + polygonText(kSquare).substr(1);
  };
  EXPECT_EQ(wrong(nested(64)), "");
  EXPECT_NE(wrong(nested(65)).find("nest more than 64 deep"), std::string::npos);
}

TEST(GeoJson, ReadsAndWritesFiles) {
  const support::OwnFolder folder;
  const std::string path = folder.path() + "file.geojson";
  writeGeoJson(path, {{Polygon::box(1, 2), "1", "{}"}});
  EXPECT_EQ(readGeoJson(path).at(0).polygon.area(), 2);
  EXPECT_EQ(readGeoJson(path).at(0).properties, "{}");
  std::ofstream(path) << "{";
  const auto said = [](const std::string& file) {
    return support::refusal<std::runtime_error>([&] { readGeoJson(file); });
  };
  EXPECT_NE(said(path).find(path + ": line 1: it is no JSON"), std::string::npos) << said(path);
  EXPECT_NE(said(path + ".none").find("can't be read"), std::string::npos);
  EXPECT_NE(said(folder.path()).find("can't be read"), std::string::npos);
  EXPECT_THROW(writeGeoJson("/none/x.geojson", {}), std::runtime_error);
}

}  // namespace
}  // namespace tricover
