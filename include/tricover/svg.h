// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/export.h"
#include "tricover/motion.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

namespace tricover {

/// A drawing in world coordinates (y upwards), scaled to fit. Colours are SVG colour strings.
/// Members draw in call order, later ones on top. Numbers are written the same in every locale.
/// \throws std::invalid_argument in all members, for a pose that checkPose() refuses, a margin that is negative or not
/// finite, and a point that isn't finite
/// \snippet svg.cpp svg
class TRICOVER_EXPORT SvgDrawing {
 public:
  /// Makes an empty drawing. Its picture is `width_px` pixels wide. A tall one is narrower, so that it is at most twice
  /// as high as that.
  /// \throws std::invalid_argument for a width that isn't positive and finite
  explicit SvgDrawing(double width_px = 800);

  /// Draws the region under its fill rule, and its outline. With a margin, a world length, what is outside the region
  /// within that distance gets a paler fill (in the outline's colour if `fill` is "none"). point() with a margin is a
  /// disc.
  void polygon(const Polygon& polygon, const Pose& pose, const std::string& fill, const std::string& stroke = "#333",
               double margin = 0);
  /// All bodies with their margins, in the order of their handles. Without any, nothing.
  /// \snippet svg.cpp svg scene
  void scene(const Scene& scene, const std::string& fill = "#e7e5e4", const std::string& stroke = "#333");
  /// Draws an open line through the points; nothing without points.
  void polyline(const std::vector<Vec2>& points, const std::string& stroke);
  /// A line of text, centred at `position`.
  void text(const Vec2& position, const std::string& text);

  /// The covering: positive triangles in one tint, negative ones in another, and S.
  void covering(const Polygon& polygon, const Pose& pose);
  /// The bounded influence areas of length n of all edges.
  void influenceAreas(const Polygon& polygon, const Pose& pose, double length, const std::string& fill = "#f59e0b");
  /// The boxes of the polygon's hierarchy on one level. Level 0 is the box around everything. Level k + 1 is what the
  /// boxes of level k are divided into; the box of a single edge stays as it is.
  /// \throws std::invalid_argument for a negative level
  void boxes(const Polygon& polygon, const Pose& pose, int level, const std::string& stroke = "#7c3aed");
  /// The discs that the hierarchy knows to lie in the region.
  void innerDiscs(const Polygon& polygon, const Pose& pose, const std::string& fill = "#16a34a");

  /// The edges of each polygon that meet an edge of the other, in red. O(n m).
  void hits(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);
  /// The nearest points and the line between them.
  void nearest(const DistanceResult& result);
  /// Draws each contact: the point, an arrow along the normal and, in its true length, the translation by `depth`.
  void contacts(const std::vector<Contact>& contacts);
  /// The point of impact and an arrow along the normal: where the polygons are there, and in what colours, is yours.
  void impact(const Impact& impact, const std::string& stroke = "#dc2626");
  /// Both polygons at the start, faintly, and at the time of impact; there the point and an arrow along the normal.
  void impact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b, const Impact& impact);

  /// A whole SVG document.
  /// \throws std::logic_error while nothing is drawn
  std::string str() const;
  /// Writes the document, str(), to a file. A file of that name is replaced once all of the new one is written. After
  /// an error it is as before.
  /// \throws std::logic_error while nothing is drawn
  /// \throws std::runtime_error for a file that can't be written completely. The text has the path.
  /// \snippet svg.cpp svg
  void save(const std::string& path) const;

 private:
  void include(const Vec2& point, double around = 0);
  /// Adds a mask that hides a region within a box, and returns its name.
  std::string outsideMask(const std::string& region, const Eigen::AlignedBox2d& box);
  /// Draws four corners of the pose's frame. `look` holds all attributes but the width of the stroke, `px` pixels.
  void quadrangle(const std::array<Vec2, 4>& corners, const Pose& pose, const std::string& look, double px);
  void dot(const Vec2& at, const std::string& fill);
  void arrow(const Vec2& from, const Vec2& direction, const std::string& stroke);

  /// An element around one length in pixels, which is known in drawing units only when all is drawn; 0: around none.
  struct Element {
    std::string head;
    double px;
    std::string tail;
  };

  double width_px_;
  Vec2 low_, high_;
  std::vector<Element> elements_;
};

}  // namespace tricover
