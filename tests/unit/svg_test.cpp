// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "shapes.h"
#include "tricover/locate.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Every tag closed in order, nothing else that looks like one, no stray ampersand.
bool wellFormed(const std::string& text) {
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string::npos) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = text.substr(at + 1, end - at - 1);
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0 || tag.find('<') != std::string::npos) return false;
    const std::string name = tag.substr(tag[0] == '/', tag.find_first_of(" /", 1) - (tag[0] == '/'));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    at = end;
  }
  const int entities = count(text, "&amp;") + count(text, "&lt;") + count(text, "&gt;") + count(text, "&quot;");
  return open.empty() && count(text, "&") == entities;
}

/// What a drawing of this is: well formed, of numbers that are finite.
template <typename Draw>
std::string drawn(const Draw& draw, int width = 800) {
  SvgDrawing drawing(width);
  draw(drawing);
  const std::string svg = drawing.str();
  EXPECT_TRUE(wellFormed(svg)) << svg;
  EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0) << svg;
  return svg;
}

const Pose kHome = Pose::Identity();
const Polygon kUnit({rectangle(0, 0, 1, 1)}), kFrame({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)});

TEST(Svg, DrawsEveryRingTriangleAreaAndHit) {
  const Polygon peg({rectangle(0, 0, 2, 2)});
  const Pose pose_b = turnedAndMoved(0, 7, 3);
  const std::string svg = drawn([&](SvgDrawing& drawing) {
    drawing.polygon(kFrame, kHome, "#eee");
    drawing.polygon(peg, pose_b, "#abc");
    drawing.covering(kFrame, kHome);
    drawing.influenceAreas(kFrame, kHome, 0.5);
    drawing.hits(kFrame, kHome, peg, pose_b);
    drawing.polyline({{1, 1}, {2, 9}, {9, 9}}, "blue");
    drawing.text({5, 5}, "a < b & \"c\"");
  });
  EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
  EXPECT_EQ(count(svg, "<path "), 2);
  EXPECT_EQ(count(svg, "Z"), 3) << "one closed outline a ring";
  EXPECT_EQ(count(svg, "<polygon "), 8 + 8) << "covering and influence areas";
  // The peg lies across the hole's right edge: two of its edges cross it.
  EXPECT_EQ(count(svg, "<polyline "), 1 + 2 + 1);
  EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
}

TEST(Svg, FillsByThePolygonsRule) {
  for (const FillRule rule : {FillRule::EvenOdd, FillRule::NonZero}) {
    const std::string svg = drawn([&](SvgDrawing& d) { d.polygon(Polygon(kUnit.rings(), rule), kHome, "none"); });
    EXPECT_EQ(count(svg, "fill-rule=\"evenodd\""), rule == FillRule::EvenOdd ? 1 : 0);
    EXPECT_EQ(count(svg, "fill-rule=\"nonzero\""), rule == FillRule::EvenOdd ? 0 : 1);
  }
}

/// Also of collinear edges that overlap, and of hits that are alone.
TEST(Svg, HitsHoldWhatTouches) {
  const Polygon block({rectangle(0, 0, 4, 4)}), upon({rectangle(1, 4, 2, 5)}), beside({rectangle(4, 4, 5, 5)});
  const auto hits = [&](const Polygon& b, const Vec2& at, bool is_alone = false) {
    const auto draw = [&](SvgDrawing& drawing) {
      if (!is_alone) drawing.polygon(block, kHome, "none");
      drawing.hits(block, kHome, b, turnedAndMoved(0, at.x(), at.y()));
    };
    return count(drawn(draw), "<polyline ");
  };
  EXPECT_EQ(hits(upon, {0, 0}), 1 + 3);
  EXPECT_EQ(hits(beside, {0, 0}), 2 + 2);
  EXPECT_EQ(hits(upon, {0, 1e-12}), 0);
  EXPECT_EQ(hits(block, {4, 0}, true), 6);
}

/// The values of an attribute, one for each element that begins like `element`.
std::vector<std::string> attributes(const std::string& svg, const std::string& element, const std::string& name) {
  std::vector<std::string> values;
  const std::string before = " " + name + "=\"";
  for (std::size_t at = svg.find(element); at != std::string::npos; at = svg.find(element, at + 1)) {
    const std::size_t begin = svg.find(before, at) + before.size();
    values.push_back(svg.substr(begin, svg.find('"', begin) - begin));
  }
  return values;
}

/// The box that a drawing shows: left, top, width, height.
std::vector<double> viewBox(const std::string& svg) {
  std::istringstream in(attributes(svg, "<svg ", "viewBox").at(0));
  return {std::istream_iterator<double>(in), {}};
}

/// The picture's size in pixels.
Vec2 pixels(const std::string& svg) {
  return {std::stod(attributes(svg, "<svg ", "width").at(0)), std::stod(attributes(svg, "<svg ", "height").at(0))};
}

/// Whether a drawing shows these corners of a box.
void expectShows(const std::string& svg, const Vec2& low, const Vec2& high) {
  const std::vector<double> box = viewBox(svg);
  ASSERT_EQ(box.size(), 4u);
  EXPECT_LE(box[0], low.x());
  EXPECT_GE(box[0] + box[2], high.x());
  EXPECT_LE(box[1], -high.y());  // SVG's y axis points down
  EXPECT_GE(box[1] + box[3], -low.y());
}

TEST(Svg, FitsWhatIsDrawn) {
  const Polygon block({rectangle(-1, -2, 3, 4)});
  const std::string svg = drawn([&](SvgDrawing& d) { d.polygon(block, turnedAndMoved(0, 100, 50), "none"); }, 400);
  expectShows(svg, {99, 48}, {103, 54});
  EXPECT_LE(viewBox(svg)[2], 6);
  EXPECT_LE(viewBox(svg)[3], 8);
  EXPECT_NE(svg.find("width=\"400\""), std::string::npos);
}

/// "x,y x,y ...", back in the world.
std::vector<Vec2> points(const std::string& list) {
  std::vector<Vec2> result;
  std::istringstream in(list);
  double x, y;
  char comma;
  while (in >> x >> comma >> y) result.emplace_back(x, -y);
  return result;
}

TEST(Svg, BoxesOfEachLevelHoldAllVertices) {
  const Polygon frame({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8), comb(12, 1, 0.5, 3)});
  const Pose pose_frame = turnedAndMoved(0.5, 100, 20);
  std::size_t boxes_above = 0;
  for (int level = 0; level < 4; ++level) {
    SvgDrawing drawing;
    drawing.boxes(frame, pose_frame, level);
    const std::vector<std::string> lists = attributes(drawing.str(), "<polygon ", "points");
    EXPECT_GE(lists.size(), boxes_above);
    boxes_above = lists.size();
    std::vector<Polygon> boxes;
    for (const std::string& list : lists) boxes.emplace_back(std::vector<Ring>{points(list)});
    for (EdgeIndex edge = 0; edge < frame.edgeCount(); ++edge) {
      const Vec2 vertex = pose_frame * frame.edgeStart(edge),
                 inwards = (pose_frame * frame.coveringOrigin() - vertex) * 1e-6;
      // Boxes are rounded outwards by less than a millionth of what they hold; a thin one is as thin as its rounding.
      EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(),
                              [&](const Polygon& box) {
                                return locate(box, vertex) != Location::Outside ||
                                       locate(box, vertex + inwards) != Location::Outside;
                              }))
          << "level " << level << ", edge " << edge;
    }
  }
  EXPECT_EQ(boxes_above, frame.vertexCount()) << "one an edge, at last";
  SvgDrawing drawing;
  EXPECT_THROW(drawing.boxes(frame, pose_frame, -1), std::invalid_argument);
}

TEST(Svg, InnerDiscsLieInTheRegion) {
  const std::string svg = drawn([](SvgDrawing& drawing) { drawing.innerDiscs(kFrame, turnedAndMoved(0, 50, 7)); });
  const std::vector<std::string> x = attributes(svg, "<circle", "cx"), y = attributes(svg, "<circle", "cy"),
                                 r = attributes(svg, "<circle", "r");
  ASSERT_GT(r.size(), 0u);
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Vec2 center(std::stod(x[i]) - 50, -std::stod(y[i]) - 7);
    const double radius = std::stod(r[i]);
    EXPECT_GT(radius, 0);
    EXPECT_EQ(locate(kFrame, center), Location::Inside);
    const double to_outer = 5 - (center - Vec2(5, 5)).lpNorm<Eigen::Infinity>();
    EXPECT_LE(radius, to_outer + 1e-6);
    const Vec2 beyond_hole = ((center - Vec2(5, 5)).cwiseAbs() - Vec2(3, 3)).cwiseMax(0);
    EXPECT_LE(radius, beyond_hole.norm() + 1e-6) << "which a corner of the hole may bound";
  }
}

TEST(Svg, NearestPointsAreJoined) {
  const Polygon a({rectangle(0, 0, 2, 2)}), b({rectangle(5, 1, 6, 2)});
  const auto nearest = distance(a, kHome, b, kHome);
  const std::string svg = drawn([&](SvgDrawing& drawing) { drawing.nearest(nearest); });
  const std::vector<Vec2> line = points(attributes(svg, "<polyline ", "points").at(0));
  ASSERT_EQ(line.size(), 2u);
  EXPECT_EQ(line[0].x(), 2);
  EXPECT_EQ(line[1].x(), 5);
  EXPECT_EQ(count(svg, "<circle "), 2);
}

TEST(Svg, ContactsShowPointNormalAndDepth) {
  const Polygon a({rectangle(0, 0, 4, 4)}), b({rectangle(3, 1, 8, 3)});
  const std::vector<Contact> found = contacts(a, kHome, b, kHome);
  ASSERT_EQ(found.size(), 1u);
  const std::string svg = drawn([&](SvgDrawing& drawing) { drawing.contacts(found); });
  const std::vector<Vec2> way = points(attributes(svg, "<polyline ", "points").at(0));
  ASSERT_EQ(way.size(), 2u);
  EXPECT_TRUE((way[1] - way[0]).isApprox(Vec2(1, 0)));
  const std::string arrow = attributes(svg, "<path ", "transform").back();
  EXPECT_EQ(count(arrow, "rotate(0)") + count(arrow, "rotate(-0)"), 1) << arrow;
  EXPECT_EQ(count(svg, "<circle "), 1);
}

TEST(Svg, AnImpactShowsThePolygonsWhereTheyMeet) {
  const Polygon a({rectangle(0, 0, 2, 2)});
  const Motion still, falling = Motion::translation(turnedAndMoved(0, 0.5, 10), {0, -16});
  const auto first = timeOfImpact(a, still, kUnit, falling);
  ASSERT_TRUE(first.has_value());
  const std::string svg = drawn([&](SvgDrawing& drawing) { drawing.impact(a, still, kUnit, falling, *first); });
  EXPECT_EQ(count(svg, "<path "), 5) << "each polygon twice, and an arrow";
  const std::string landed = attributes(svg, "<path ", "d").at(3);  // "Mx,yL..."
  const std::vector<Vec2> corner = points(landed.substr(1, landed.find('L') - 1));
  EXPECT_NEAR(corner.at(0).y(), 2, 1e-4);
  EXPECT_NE(attributes(svg, "<path ", "transform").back().find("rotate(-90)"), std::string::npos) << svg;
}

TEST(Svg, ARoundRobotIsSeen) {
  const auto robot = [](const char* fill, const char* stroke) {
    return drawn([&](SvgDrawing& drawing) {
      drawing.polygon(Polygon::point({0, 0}), turnedAndMoved(0, 3, 4), fill, stroke, 0.5);
    });
  };
  const std::string svg = robot("#16a34a", "#333");
  ASSERT_EQ(count(svg, "<path "), 2);
  EXPECT_EQ(attributes(svg, "<path ", "stroke-width").at(0), "1") << "the disc's diameter";
  EXPECT_EQ(attributes(svg, "<path ", "stroke").at(0), "#16a34a");
  EXPECT_EQ(attributes(svg, "<path ", "stroke-linecap").at(0), "round");
  expectShows(svg, {2.5, 3.5}, {3.5, 4.5});
  EXPECT_EQ(attributes(robot("none", "#123456"), "<path ", "stroke").back(), "#123456");
}

TEST(Svg, AMarginWithoutAFillLeavesTheInsideClear) {
  const Polygon frame({rectangle(0, 0, 10, 10), rectangle(4, 4, 6, 6)});
  const auto picture = [&](const char* fill) {
    return drawn([&](SvgDrawing& drawing) { drawing.polygon(frame, turnedAndMoved(0, 20, 0), fill, "#123456", 0.5); });
  };
  const std::string svg = picture("none");
  ASSERT_EQ(count(svg, "<mask "), 1);
  EXPECT_EQ(count(picture("#eee"), "mask"), 0);
  // The mask shows its box, the region and its margin, without the region.
  EXPECT_EQ(attributes(svg, "<mask ", "x").at(0) + " " + attributes(svg, "<mask ", "y").at(0), "19.5 -10.5");
  EXPECT_EQ(attributes(svg, "<mask ", "width").at(0) + " " + attributes(svg, "<mask ", "height").at(0), "11 11");
  const std::vector<std::string> fills = attributes(svg, "<path ", "fill"), paths = attributes(svg, "<path ", "d");
  EXPECT_EQ(fills, (std::vector<std::string>{"black", "none", "none"}));
  EXPECT_EQ(paths[0], paths[1]);
  EXPECT_EQ(attributes(svg, "<path ", "mask").at(1), "url(#" + attributes(svg, "<mask ", "id").at(0) + ")");
}

TEST(Svg, ALonePointHasRoom) {
  for (const Vec2& at : {Vec2(0, 0), Vec2(3, -4), Vec2(-2e15, 1)})
    for (const std::string& svg :
         {drawn([&](SvgDrawing& drawing) { drawing.text(at, "here"); }),
          drawn([&](SvgDrawing& drawing) { drawing.polygon(Polygon::point(at), kHome, "#123"); })}) {
      EXPECT_EQ(pixels(svg), Vec2(800, 800));
      expectShows(svg, {nudged(at.x(), -1), nudged(at.y(), -1)}, {nudged(at.x(), 1), nudged(at.y(), 1)});
    }
}

TEST(Svg, APolylineWithoutPointsIsNothing) {
  SvgDrawing drawing, alone;
  drawing.polyline({{0, 0}, {1, 1}}, "#333");
  const std::string before = drawing.str();
  drawing.polyline({}, "#333");
  EXPECT_EQ(drawing.str(), before);
  alone.polyline({}, "#333");
  EXPECT_THROW(alone.str(), std::logic_error);
}

TEST(Svg, NeitherSideIsTooLong) {
  const auto picture = [](double width, double height) {
    const Polygon box({rectangle(0, 0, width, height)});
    return drawn([&](SvgDrawing& drawing) { drawing.polygon(box, kHome, "none"); }, 400);
  };
  for (const double length : {1.0, 1.5, 3.0, 1e3, 1e9}) {
    const std::string tall = picture(1, length), wide = picture(length, 1);
    EXPECT_LE(pixels(tall).x(), 400);
    EXPECT_LE(pixels(tall).y(), 800);
    EXPECT_EQ(pixels(wide).x(), 400);
    EXPECT_LE(pixels(wide).y(), 400);
    EXPECT_GE(pixels(wide).y(), 16);
    EXPECT_GE(pixels(tall).x(), 16);
    for (const std::string& svg : {tall, wide}) {
      const std::vector<double> box = viewBox(svg);
      EXPECT_NEAR(box[2] / box[3], pixels(svg).x() / pixels(svg).y(), 1e-6) << "pixels are square";
      EXPECT_NEAR(std::stod(attributes(svg, "<path ", "stroke-width").at(0)) * pixels(svg).x() / box[2], 1, 1e-6);
    }
  }
}

TEST(Svg, ASceneIsItsBodiesWithTheirMargins) {
  Scene scene;
  scene.add(kUnit, turnedAndMoved(0, 0, 0));
  const Scene::Body gone = scene.add(Polygon({rectangle(0, 0, 9, 9)}), turnedAndMoved(0, 50, 0));
  scene.add(kUnit, turnedAndMoved(0.5, 3, 0), {0.25});
  scene.remove(gone);
  SvgDrawing drawing, by_hand;
  drawing.scene(scene, "#abc", "#def");
  by_hand.polygon(kUnit, turnedAndMoved(0, 0, 0), "#abc", "#def");
  by_hand.polygon(kUnit, turnedAndMoved(0.5, 3, 0), "#abc", "#def", 0.25);
  EXPECT_EQ(drawing.str(), by_hand.str());
  SvgDrawing empty;
  empty.scene(Scene());
  EXPECT_THROW(empty.str(), std::logic_error);
}

TEST(Svg, AnImpactAloneIsAnArrowInTheCallersColour) {
  const std::string svg = drawn([](SvgDrawing& drawing) {
    drawing.impact({0.5, Vec2(1, 2), Vec2(0, 1), 0, 0}, "#0000ff");
    drawing.polyline({{0, 0}, {1, 1}}, "#333");
  });
  EXPECT_EQ(attributes(svg, "<path ", "stroke"), std::vector<std::string>{"#0000ff"});
  EXPECT_EQ(attributes(svg, "<circle ", "fill"), std::vector<std::string>{"#0000ff"});
}

TEST(Svg, RefusesWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Pose far = turnedAndMoved(0, infinity, 0);
  SvgDrawing drawing;
  drawing.polygon(kUnit, kHome, "none");
  const std::string before = drawing.str();
  EXPECT_THROW(drawing.polygon(kUnit, far, "none"), std::invalid_argument);
  EXPECT_THROW(drawing.covering(kUnit, far), std::invalid_argument);
  EXPECT_THROW(drawing.influenceAreas(kUnit, far, 1), std::invalid_argument);
  EXPECT_THROW(drawing.boxes(kUnit, far, 0), std::invalid_argument);
  EXPECT_THROW(drawing.innerDiscs(kUnit, far), std::invalid_argument);
  EXPECT_THROW(drawing.hits(kUnit, far, kUnit, far), std::invalid_argument);
  for (const double margin : {-1.0, nan, infinity})
    EXPECT_THROW(drawing.polygon(kUnit, kHome, "none", "#333", margin), std::invalid_argument);
  EXPECT_THROW(drawing.polyline({{0, nan}}, "#333"), std::invalid_argument);
  EXPECT_THROW(drawing.text({infinity, 0}, "far"), std::invalid_argument);
  EXPECT_THROW(drawing.nearest({1, {nan, 0}, {0, 0}, 0, 0}), std::invalid_argument);
  EXPECT_THROW(drawing.impact({0, {nan, 0}, {1, 0}, 0, 0}), std::invalid_argument);
  EXPECT_EQ(drawing.str(), before);
}

/// A comma for the point, and digits in groups.
struct German : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Svg, IsTheSameInEveryLocale) {
  const Polygon large({rectangle(-1234.5, 0.25, 12345678, 9)});
  const auto draw = [&](SvgDrawing& drawing) {
    drawing.polygon(large, turnedAndMoved(0.1, 0, 0), "none");
    drawing.text({0.5, 1000}, "1.5");
  };
  const std::string classic = drawn(draw);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new German));
  SvgDrawing drawing;
  draw(drawing);
  const std::string german = drawing.str();
  std::locale::global(before);
  EXPECT_EQ(german, classic);
}

TEST(Svg, NothingDrawnIsAnError) {
  EXPECT_THROW(SvgDrawing().str(), std::logic_error);
  EXPECT_THROW(SvgDrawing(0), std::invalid_argument);
}

}  // namespace
}  // namespace tricover::support
