// SPDX-License-Identifier: BSD-3-Clause
// tricover.paper: the covering, the influence areas and Algorithm 3.
#include "python/of_poses.h"

namespace tricover_python {
namespace {

namespace paper = tricover::paper;
using tricover::EdgeIndex;

py::array_t<bool> maskOf(const Shape& polygon, const py::object& point, double length) {
  const tricover::Polygon& region = polygon;
  const auto words = paper::influenceMask(region, pointFrom(point, "point"), length);
  return arrayOf<bool>(region.vertexCount(), [&](std::size_t i) { return (words[i / 64] >> (i % 64) & 1) != 0; });
}

}  // namespace

void definePaper(py::module_& m) {
  m.def(
      "covering", [](const Shape& polygon) { return many(paper::covering(polygon)); }, py::arg("polygon"),
      doc("paper.covering"));
  m.def(
      "in_influence_area",
      [](const Shape& polygon, EdgeIndex edge, const py::object& point, double length, paper::InfluenceKind kind) {
        const Points points = pointsFrom(point, "point");
        return Count().of(points, "point").answers(1, kCheap, [&](std::size_t i) {
          return paper::inInfluenceArea(polygon, edge, points[i], length, kind);
        });
      },
      py::arg("polygon"), py::arg("edge"), py::arg("point"), py::arg("length"), py::arg("kind"),
      doc("paper.in_influence_area"));
  m.def("influence_mask", &maskOf, py::arg("polygon"), py::arg("point"), py::arg("length"),
        doc("paper.influence_mask"));
  m.def(
      "bounded_influence_area",
      [](const Shape& polygon, EdgeIndex edge, double length) {
        const auto corners = paper::boundedInfluenceArea(polygon, edge, length);
        return arrayOf(std::vector<tricover::Vec2>(corners.begin(), corners.end()));
      },
      py::arg("polygon"), py::arg("edge"), py::arg("length"), doc("paper.bounded_influence_area"));
  m.def(
      "collide",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         double tolerance, tricover::Touching touching, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kDear, [&](const auto& at_a, const auto& at_b) {
          return paper::collide(a, at_a, b, at_b, {margin, tolerance, touching});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("tolerance") = 0.0, py::arg("touching") = tricover::Touching::Collides, py::arg("threads") = 0,
      doc("paper.collide"));
}

}  // namespace tricover_python
