// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tricover/polygon.h"

namespace tricover {

/// A drawing in world coordinates (y upwards), scaled to fit. Colours are SVG colour strings.
/// Members draw in call order, later ones on top.
class SvgDrawing {
 public:
  /// Throws std::invalid_argument for a width that isn't positive and finite.
  explicit SvgDrawing(double width_px = 800);

  /// The region under its fill rule, and its outline.
  void polygon(const Polygon& polygon, const Pose& pose, const std::string& fill, const std::string& stroke = "#333");
  /// The covering: positive triangles in one tint, negative ones in another, and S.
  void covering(const Polygon& polygon, const Pose& pose);
  /// The bounded influence areas of length n of all edges.
  void influenceAreas(const Polygon& polygon, const Pose& pose, double length, const std::string& fill = "#f59e0b");
  /// The edges of each polygon that meet an edge of the other, in red. O(n m).
  void hits(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);
  /// An open line through the points.
  void polyline(const std::vector<Vec2>& points, const std::string& stroke);
  /// Centred at `position`.
  void text(const Vec2& position, const std::string& text);

  /// A whole SVG document. Throws std::logic_error while nothing is drawn.
  std::string str() const;

 private:
  void include(const Vec2& point);

  /// An element with one length in pixels, which is known in drawing units only when all is drawn.
  struct Element {
    std::string head, attribute;
    double px;
    std::string tail;
  };

  double width_px_;
  Vec2 low_, high_;
  std::vector<Element> elements_;
};

}  // namespace tricover
