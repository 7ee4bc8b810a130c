// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "shapes.h"

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

TEST(Svg, DrawsEveryRingTriangleAreaAndHit) {
  const Polygon frame({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)}), peg({rectangle(0, 0, 2, 2)});
  const Pose pose_b = pose(0, 7, 3);
  SvgDrawing drawing;
  drawing.polygon(frame, Pose::Identity(), "#eee");
  drawing.polygon(peg, pose_b, "#abc");
  drawing.covering(frame, Pose::Identity());
  drawing.influenceAreas(frame, Pose::Identity(), 0.5);
  drawing.hits(frame, Pose::Identity(), peg, pose_b);
  drawing.polyline({{1, 1}, {2, 9}, {9, 9}}, "blue");
  drawing.text({5, 5}, "a < b & \"c\"");
  const std::string svg = drawing.str();

  EXPECT_TRUE(wellFormed(svg)) << svg;
  EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
  EXPECT_EQ(count(svg, "<path "), 2);
  EXPECT_EQ(count(svg, "Z"), 3) << "one closed outline a ring";
  EXPECT_EQ(count(svg, "<polygon "), 8 + 8) << "covering and influence areas";
  // The peg lies across the hole's right edge: two of its edges cross it.
  EXPECT_EQ(count(svg, "<polyline "), 1 + 2 + 1);
  EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0);
}

TEST(Svg, HitsHoldCollinearEdgesThatOverlap) {
  const Polygon block({rectangle(0, 0, 4, 4)}), upon({rectangle(1, 4, 2, 5)}), beside({rectangle(4, 4, 5, 5)});
  const auto hits = [&](const Polygon& b, double lift) {
    SvgDrawing drawing;
    drawing.polygon(block, Pose::Identity(), "none");
    drawing.hits(block, Pose::Identity(), b, pose(0, 0, lift));
    return count(drawing.str(), "<polyline ");
  };
  EXPECT_EQ(hits(upon, 0), 1 + 3);
  EXPECT_EQ(hits(beside, 0), 2 + 2);
  EXPECT_EQ(hits(upon, 1e-12), 0);
}

TEST(Svg, FitsHitsThatAreAlone) {
  const Polygon block({rectangle(0, 0, 4, 4)});
  SvgDrawing drawing;
  drawing.hits(block, Pose::Identity(), block, pose(0, 4, 0));
  EXPECT_EQ(count(drawing.str(), "<polyline "), 6);
  EXPECT_EQ(count(drawing.str(), "inf") + count(drawing.str(), "nan"), 0);
}

TEST(Svg, FitsWhatIsDrawn) {
  SvgDrawing drawing(400);
  drawing.polygon(Polygon({rectangle(-1, -2, 3, 4)}), pose(0, 100, 50), "none");
  const std::string svg = drawing.str();
  const std::string before_box = "viewBox=\"";
  ASSERT_EQ(count(svg, before_box), 1);
  std::istringstream box(svg.substr(svg.find(before_box) + before_box.size()));
  double x, y, width, height;
  ASSERT_TRUE(box >> x >> y >> width >> height);
  // SVG's y axis points down.
  EXPECT_LE(x, 99);
  EXPECT_GE(x + width, 103);
  EXPECT_LE(y, -54);
  EXPECT_GE(y + height, -48);
  EXPECT_LE(width, 6);
  EXPECT_LE(height, 8);
  EXPECT_NE(svg.find("width=\"400\""), std::string::npos);
}

TEST(Svg, NothingDrawnIsAnError) {
  EXPECT_THROW(SvgDrawing().str(), std::logic_error);
  EXPECT_THROW(SvgDrawing(0), std::invalid_argument);
}

}  // namespace
}  // namespace tricover::support
