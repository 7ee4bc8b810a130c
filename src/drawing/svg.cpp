// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "hierarchy/hierarchy.h"
#include "numbers/errors.h"
#include "numbers/whole_file.h"
#include "pair/posed_pair.h"
#include "polygon/polygon_data.h"
#include "tricover/paper.h"

namespace tricover {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTallest = 2;  ///< a picture's height by its width, see SvgDrawing()

/// In the classic locale: the global one may write a comma for the point and group digits.
std::string number(double x) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(9);
  out << x;
  return out.str();
}

/// "x,y"; SVG's y axis points down.
std::string pair(const Vec2& p) { return number(p.x()) + "," + number(-p.y()); }

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

/// A box of the hierarchy by its corners in the polygon's frame. It is given in lengths of `scale` units from `origin`,
/// itself in units.
std::array<Vec2, 4> corners(const detail::PolygonData& polygon, const detail::Box& box, const Vec2& origin,
                            double scale) {
  const Vec2 axis(box.ux, box.uy), normal(-box.uy, box.ux), u = axis * box.along, v = normal * box.across;
  const Vec2 center(box.x, box.y);
  const auto inFrame = [&](const Vec2& p) { return Vec2(polygon.origin + (origin + p * scale) * polygon.unit); };
  return {inFrame(center - u - v), inFrame(center + u - v), inFrame(center + u + v), inFrame(center - u + v)};
}

/// Calls visit(corners) for the boxes of one level, the block's own being level 1. Edges are divided no further.
template <typename Visit>
void forEachBox(const detail::PolygonData& polygon, const std::vector<detail::Block>& blocks,
                const detail::Block& block, int level, const Visit& visit) {
  for (std::size_t i = 0; i < block.count; ++i) {
    if (level == 1 || block.leaf) {
      const detail::Box box = {block.x[i], block.y[i], block.ux[i], block.uy[i], block.along[i], block.across[i]};
      visit(corners(polygon, box, {block.origin_x, block.origin_y}, block.scale));
    } else {
      forEachBox(polygon, blocks, blocks[block.child[i]], level - 1, visit);
    }
  }
}

}  // namespace

SvgDrawing::SvgDrawing(double width_px)
    : width_px_(width_px), low_(kInfinity, kInfinity), high_(-kInfinity, -kInfinity) {
  if (!(width_px > 0 && std::isfinite(width_px))) detail::refuse("width_px", "it must be positive and finite");
}

void SvgDrawing::include(const Vec2& point, double around) {
  detail::requireFinite(point, "point");
  low_ = low_.cwiseMin(point - Vec2(around, around));
  high_ = high_.cwiseMax(point + Vec2(around, around));
}

void SvgDrawing::polygon(const Polygon& polygon, const Pose& pose, const std::string& fill, const std::string& stroke,
                         double margin) {
  checkPose(pose, "pose");
  detail::requireFiniteNotNegative(margin, "margin");
  std::string path;
  Eigen::AlignedBox2d box;
  for (const Ring& ring : polygon.rings()) {
    char command = 'M';
    for (const Vec2& p : ring) {
      const Vec2 world = pose * p;
      include(world, margin);
      box.extend(world);
      path += command + pair(world);
      command = 'L';
    }
    path += 'Z';
  }
  if (polygon.isComplement()) {  // as far as a frame around its rings
    const Vec2 around = Vec2::Constant(margin + 0.25 * box.sizes().maxCoeff());
    box = {box.min() - around, box.max() + around};
    include(box.min());
    include(box.max());
    path += 'M' + pair(box.min()) + 'L' + pair({box.max().x(), box.min().y()}) + 'L' + pair(box.max()) + 'L' +
            pair({box.min().x(), box.max().y()}) + 'Z';
  }
  const std::string region = "<path d=\"" + path + "\" fill-rule=\"" +
                             (polygon.fillRule() == FillRule::EvenOdd ? "evenodd" : "nonzero") + "\"";
  if (margin > 0) {
    // A line twice as wide as the margin, with round ends, covers what is within the margin of the outline. The fill
    // covers its inner half; without a fill, a mask hides that.
    std::string masked;
    if (fill == "none") {
      const Vec2 grown(margin, margin);
      masked = " mask=\"url(#" + outsideMask(region, {box.min() - grown, box.max() + grown}) + ")\"";
    }
    elements_.push_back({"<path d=\"" + path + "\" fill=\"none\" stroke=\"" + escaped(fill == "none" ? stroke : fill) +
                             "\" stroke-opacity=\"0.4\" stroke-linecap=\"round\" stroke-width=\"" + number(2 * margin) +
                             "\"" + masked + "/>",
                         0, ""});
  }
  elements_.push_back(
      {region + " fill=\"" + escaped(fill) + "\" stroke=\"" + escaped(stroke) + "\" stroke-width=\"", 1, "\"/>"});
}

std::string SvgDrawing::outsideMask(const std::string& region, const Eigen::AlignedBox2d& box) {
  const std::string frame = "x=\"" + number(box.min().x()) + "\" y=\"" + number(-box.max().y()) + "\" width=\"" +
                            number(box.sizes().x()) + "\" height=\"" + number(box.sizes().y()) + "\"";
  // Named by its contents, because a page may hold several drawings.
  const std::string id = "outside-" + std::to_string(std::hash<std::string>()(region + frame));
  elements_.push_back({"<mask id=\"" + id + "\" maskUnits=\"userSpaceOnUse\" " + frame + "><rect " + frame +
                           " fill=\"white\"/>" + region + " fill=\"black\"/></mask>",
                       0, ""});
  return id;
}

void SvgDrawing::scene(const Scene& scene, const std::string& fill, const std::string& stroke) {
  for (const Scene::Body body : scene.bodies())
    polygon(scene.polygon(body), scene.pose(body), fill, stroke, scene.options(body).margin);
}

void SvgDrawing::covering(const Polygon& polygon, const Pose& pose) {
  checkPose(pose, "pose");
  for (const paper::CoveringTriangle& triangle : paper::covering(polygon)) {
    const std::string tint = triangle.sign > 0 ? "#3b82f6" : triangle.sign < 0 ? "#ef4444" : "none";
    const Vec2 s = pose * triangle.s;
    include(s);
    elements_.push_back({"<polygon points=\"" + pair(s) + " " + pair(pose * triangle.v) + " " +
                             pair(pose * triangle.w) + "\" fill=\"" + tint + "\" fill-opacity=\"0.12\" stroke=\"" +
                             tint + "\" stroke-opacity=\"0.5\" stroke-width=\"",
                         0.6, "\"/>"});
  }
}

void SvgDrawing::influenceAreas(const Polygon& polygon, const Pose& pose, double length, const std::string& fill) {
  checkPose(pose, "pose");
  const EdgeIndex count = polygon.edgeCount();
  const std::string look =
      "fill=\"" + escaped(fill) + "\" fill-opacity=\"0.08\" stroke=\"" + escaped(fill) + "\" stroke-opacity=\"0.4\"";
  for (EdgeIndex edge = 0; edge < count; ++edge)
    quadrangle(paper::boundedInfluenceArea(polygon, edge, length), pose, look, 0.5);
}

void SvgDrawing::quadrangle(const std::array<Vec2, 4>& corners, const Pose& pose, const std::string& look, double px) {
  std::string points;
  for (const Vec2& corner : corners) {
    const Vec2 world = pose * corner;
    include(world);
    points += (points.empty() ? "" : " ") + pair(world);
  }
  elements_.push_back({"<polygon points=\"" + points + "\" " + look + " stroke-width=\"", px, "\"/>"});
}

void SvgDrawing::boxes(const Polygon& polygon, const Pose& pose, int level, const std::string& stroke) {
  checkPose(pose, "pose");
  if (level < 0) detail::refuse("level", std::to_string(level) + " is below 0");
  const detail::PolygonData& data = detail::dataOf(polygon);
  const detail::Hierarchy& hierarchy = hierarchyOf(data);
  const auto draw = [&](const std::array<Vec2, 4>& box) {
    quadrangle(box, pose, "fill=\"none\" stroke=\"" + escaped(stroke) + "\" stroke-opacity=\"0.7\"", 1);
  };
  if (level == 0)
    draw(corners(data, hierarchy.root, Vec2::Zero(), 1));
  else
    forEachBox(data, hierarchy.blocks, hierarchy.blocks.front(), level, draw);
}

void SvgDrawing::innerDiscs(const Polygon& polygon, const Pose& pose, const std::string& fill) {
  checkPose(pose, "pose");
  const detail::PolygonData& data = detail::dataOf(polygon);
  const detail::InnerDiscs& discs = innerDiscsOf(data);
  for (int i = 0; i < discs.count; ++i) {
    const Vec2 center = pose * Vec2(data.origin + Vec2(discs.x[i], discs.y[i]) * data.unit);
    const double radius = discs.radius[i] * data.unit;
    include(center, radius);
    elements_.push_back({"<circle cx=\"" + number(center.x()) + "\" cy=\"" + number(-center.y()) + "\" r=\"" +
                             number(radius) + "\" fill=\"" + escaped(fill) + "\" fill-opacity=\"0.2\" stroke=\"" +
                             escaped(fill) + "\" stroke-width=\"",
                         1, "\"/>"});
  }
}

void SvgDrawing::hits(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  checkPose(pose_a, "pose_a");
  checkPose(pose_b, "pose_b");
  const detail::PosedPair posed(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b);
  std::vector<bool> hit_a(a.vertexCount(), false), hit_b(b.vertexCount(), false);
  for (EdgeIndex i = 0; i < a.edgeCount(); ++i)
    for (EdgeIndex j = 0; j < b.edgeCount(); ++j)
      if (detail::edgesMeet(posed, detail::dataOf(a).edgePosition(i), detail::dataOf(b).edgePosition(j)))
        hit_a[static_cast<std::size_t>(i)] = hit_b[static_cast<std::size_t>(j)] = true;
  const auto draw = [&](const Polygon& polygon, const Pose& pose, const std::vector<bool>& hit) {
    for (std::size_t i = 0; i < hit.size(); ++i) {
      if (!hit[i]) continue;
      const auto edge = static_cast<EdgeIndex>(i);
      polyline({pose * polygon.edgeStart(edge), pose * polygon.edgeEnd(edge)}, "#dc2626");
    }
  };
  draw(a, pose_a, hit_a);
  draw(b, pose_b, hit_b);
}

void SvgDrawing::polyline(const std::vector<Vec2>& points, const std::string& stroke) {
  if (points.empty()) return;
  std::string list;
  for (const Vec2& point : points) {
    include(point);
    list += (list.empty() ? "" : " ") + pair(point);
  }
  elements_.push_back(
      {"<polyline points=\"" + list + "\" fill=\"none\" stroke=\"" + escaped(stroke) + "\" stroke-width=\"", 2.5,
       "\"/>"});
}

void SvgDrawing::text(const Vec2& position, const std::string& text) {
  include(position);
  elements_.push_back({"<text x=\"" + number(position.x()) + "\" y=\"" + number(-position.y()) +
                           "\" fill=\"#111\" text-anchor=\"middle\" font-size=\"",
                       13, "\">" + escaped(text) + "</text>"});
}

void SvgDrawing::dot(const Vec2& at, const std::string& fill) {
  include(at);
  elements_.push_back(
      {"<circle cx=\"" + number(at.x()) + "\" cy=\"" + number(-at.y()) + "\" fill=\"" + fill + "\" r=\"", 4, "\"/>"});
}

void SvgDrawing::arrow(const Vec2& from, const Vec2& direction, const std::string& stroke) {
  include(from);
  const double degrees = std::atan2(-direction.y(), direction.x()) * (180 / static_cast<double>(EIGEN_PI));
  elements_.push_back({"<path d=\"M0,0L24,0M17,-4L24,0L17,4\" fill=\"none\" stroke=\"" + stroke +
                           "\" stroke-width=\"2\" transform=\"translate(" + pair(from) + ") rotate(" + number(degrees) +
                           ") scale(",
                       1, ")\"/>"});
}

void SvgDrawing::nearest(const DistanceResult& result) {
  polyline({result.point_a, result.point_b}, "#2563eb");
  dot(result.point_a, "#2563eb");
  dot(result.point_b, "#2563eb");
}

void SvgDrawing::contacts(const std::vector<Contact>& contacts) {
  for (const Contact& contact : contacts) {
    polyline({contact.point, contact.point + contact.normal * contact.depth}, "#f59e0b");
    arrow(contact.point, contact.normal, "#dc2626");
    dot(contact.point, "#dc2626");
  }
}

void SvgDrawing::impact(const Impact& impact, const std::string& stroke) {
  arrow(impact.point, impact.normal, stroke);
  dot(impact.point, stroke);
}

void SvgDrawing::impact(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                        const Impact& impact) {
  polygon(a, motion_a.at(0), "none", "#93c5fd");
  polygon(b, motion_b.at(0), "none", "#fdba74");
  polygon(a, motion_a.at(impact.time), "#bfdbfe");
  polygon(b, motion_b.at(impact.time), "#fed7aa");
  this->impact(impact);
}

std::string SvgDrawing::str() const {
  if (elements_.empty()) throw std::logic_error(detail::refusal("SvgDrawing", "nothing is drawn"));
  const double extent = (high_ - low_).maxCoeff();
  // A lone point gets room that the digits of its coordinates can show.
  const double room = extent > 0 ? 1e-3 * extent : std::max(1.0, 1e-6 * high_.cwiseAbs().maxCoeff());
  const Vec2 size = (high_ - low_).cwiseMax(room), middle = 0.5 * low_ + 0.5 * high_;
  const double border = 0.03 * size.maxCoeff();
  const double width = size.x() + 2 * border, height = size.y() + 2 * border;
  const double x = middle.x() - 0.5 * width, y = -middle.y() - 0.5 * height;
  const double px = std::max(width, height / kTallest) / width_px_;  // the length of a pixel
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width / px) + "\" height=\"" +
                    number(height / px) + "\" viewBox=\"" + number(x) + " " + number(y) + " " + number(width) + " " +
                    number(height) + "\">\n<g stroke-linejoin=\"round\" font-family=\"sans-serif\">\n" + "<rect x=\"" +
                    number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) + "\" height=\"" +
                    number(height) + "\" fill=\"white\"/>\n";
  for (const Element& element : elements_)
    svg += element.head + (element.px > 0 ? number(element.px * px) : "") + element.tail + "\n";
  return svg + "</g>\n</svg>\n";
}

void SvgDrawing::save(const std::string& path) const { detail::writeWhole(path, str()); }

}  // namespace tricover
