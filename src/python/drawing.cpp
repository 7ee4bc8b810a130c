// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "python/shown.h"
#include "python/ways.h"

namespace tricover_python {
namespace {

using tricover::SvgDrawing;

void defineShapes(py::class_<SvgDrawing>& drawing) {
  drawing.def(py::init<double>(), py::arg("width_px") = 800.0, doc("SvgDrawing.__init__"))
      .def(
          "polygon",
          [](SvgDrawing& self, const Shape& polygon, const py::object& pose, const std::string& fill,
             const std::string& stroke, double margin) {
            for (const tricover::Pose& one : posesFrom(pose, "pose").values)
              self.polygon(polygon, one, fill, stroke, margin);
          },
          py::arg("polygon"), py::arg("pose"), py::arg("fill"), py::arg("stroke") = "#333", py::arg("margin") = 0.0,
          doc("SvgDrawing.polygon"))
      .def("scene", &SvgDrawing::scene, py::arg("scene"), py::arg("fill") = "#e7e5e4", py::arg("stroke") = "#333",
           doc("SvgDrawing.scene"))
      .def(
          "polyline",
          [](SvgDrawing& self, const py::object& points, const std::string& stroke) {
            self.polyline(verticesFrom(points, "points"), stroke);
          },
          py::arg("points"), py::arg("stroke"), doc("SvgDrawing.polyline"))
      .def(
          "text",
          [](SvgDrawing& self, const py::object& position, const std::string& written) {
            self.text(pointFrom(position, "position"), written);
          },
          py::arg("position"), py::arg("text"), doc("SvgDrawing.text"))
      .def("save", &SvgDrawing::save, py::arg("path"), doc("SvgDrawing.save"))
      .def("__str__", &SvgDrawing::str)
      .def("_repr_svg_", &SvgDrawing::str);
}

void defineInsides(py::class_<SvgDrawing>& drawing) {
  drawing
      .def(
          "covering",
          [](SvgDrawing& self, const Shape& polygon, const py::object& pose) {
            self.covering(polygon, onePose(pose, "pose"));
          },
          py::arg("polygon"), py::arg("pose"), doc("SvgDrawing.covering"))
      .def(
          "influence_areas",
          [](SvgDrawing& self, const Shape& polygon, const py::object& pose, double length, const std::string& fill) {
            self.influenceAreas(polygon, onePose(pose, "pose"), length, fill);
          },
          py::arg("polygon"), py::arg("pose"), py::arg("length"), py::arg("fill") = "#f59e0b",
          doc("SvgDrawing.influence_areas"))
      .def(
          "boxes",
          [](SvgDrawing& self, const Shape& polygon, const py::object& pose, int level, const std::string& stroke) {
            self.boxes(polygon, onePose(pose, "pose"), level, stroke);
          },
          py::arg("polygon"), py::arg("pose"), py::arg("level"), py::arg("stroke") = "#7c3aed", doc("SvgDrawing.boxes"))
      .def(
          "inner_discs",
          [](SvgDrawing& self, const Shape& polygon, const py::object& pose, const std::string& fill) {
            self.innerDiscs(polygon, onePose(pose, "pose"), fill);
          },
          py::arg("polygon"), py::arg("pose"), py::arg("fill") = "#16a34a", doc("SvgDrawing.inner_discs"));
}

void defineAnswers(py::class_<SvgDrawing>& drawing) {
  drawing
      .def(
          "hits",
          [](SvgDrawing& self, const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b) {
            self.hits(a, onePose(pose_a, "pose_a"), b, onePose(pose_b, "pose_b"));
          },
          py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), doc("SvgDrawing.hits"))
      .def(
          "nearest", [](SvgDrawing& self, const py::object& result) { self.nearest(distanceFrom(result)); },
          py::arg("result"), doc("SvgDrawing.nearest"))
      .def(
          "contacts", [](SvgDrawing& self, const py::object& contacts) { self.contacts(contactsFrom(contacts)); },
          py::arg("contacts"), doc("SvgDrawing.contacts"))
      .def(
          "impact",
          [](SvgDrawing& self, const py::object& impact, const std::string& stroke) {
            self.impact(impactFrom(impact), stroke);
          },
          py::arg("impact"), py::arg("stroke") = "#dc2626", doc("SvgDrawing.impact"))
      .def(
          "motions",
          [](SvgDrawing& self, const Shape& a, const tricover::Motion& motion_a, const Shape& b,
             const tricover::Motion& motion_b,
             const py::object& impact) { self.impact(a, motion_a, b, motion_b, impactFrom(impact)); },
          py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("impact"),
          doc("SvgDrawing.motions"));
}

}  // namespace

void defineDrawing(py::module_& m) {
  py::class_<SvgDrawing> drawing(m, "SvgDrawing", doc("SvgDrawing"));
  defineShapes(drawing);
  defineInsides(drawing);
  defineAnswers(drawing);
}

}  // namespace tricover_python
