// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <utility>

#include "python/module.h"

namespace tricover_python {
namespace {

using tricover::Polygon;

py::list ringsOf(const Polygon& polygon) {
  py::list rings;
  for (const tricover::Ring& ring : polygon.rings()) rings.append(arrayOf(ring));
  return rings;
}

/// One ring, or a sequence of them, which together are no array of two dimensions.
Polygon polygonFrom(const py::object& given, tricover::FillRule rule) {
  if (py::isinstance<Polygon>(given)) return given.cast<Polygon>();
  if (py::hasattr(given, "__geo_interface__")) return polygonFromGeo(given);
  if (const Array single = Array::ensure(given); single && single.ndim() == 2) {
    const tricover::Ring ring = verticesFrom(single, "rings");
    return Polygon(ring.data(), ring.size(), rule);
  }
  PyErr_Clear();
  if (!py::isinstance<py::iterable>(given))
    throw py::type_error(
        "rings: an array (n, 2) is wanted, or some of them, or an object with __geo_interface__, not a " +
        py::str(py::type::of(given).attr("__name__")).cast<std::string>());
  std::vector<tricover::Ring> rings;
  for (const py::handle ring : py::iter(given))
    rings.push_back(
        verticesFrom(py::reinterpret_borrow<py::object>(ring), "rings[" + std::to_string(rings.size()) + "]"));
  return Polygon(rings, rule);
}

/// Of another class, that Python finds another way to compare.
bool same(const Polygon& p, const Polygon& q) {
  return p.id() == q.id() ||
         (p.fillRule() == q.fillRule() && p.isComplement() == q.isComplement() && p.rings() == q.rings());
}

py::ssize_t hashOfPolygon(const Polygon& polygon) {
  std::vector<double> numbers = {static_cast<double>(polygon.fillRule()), polygon.isComplement() ? 1.0 : 0.0};
  for (const tricover::Ring& ring : polygon.rings()) {
    numbers.push_back(static_cast<double>(ring.size()));
    for (const tricover::Vec2& vertex : ring) numbers.push_back(vertex.x()), numbers.push_back(vertex.y());
  }
  return hashOf(std::move(numbers));
}

std::string textOf(const Polygon& polygon) {
  if (polygon.isComplement())
    return "<tricover.Polygon, a complement of " + std::to_string(polygon.vertexCount()) + " vertices>";
  if (polygon.rings().size() > 1 || polygon.vertexCount() > 8)
    return "<tricover.Polygon of " + std::to_string(polygon.vertexCount()) + " vertices in " +
           std::to_string(polygon.rings().size()) + (polygon.rings().size() > 1 ? " rings>" : " ring>");
  std::string vertices;
  for (const tricover::Vec2& vertex : polygon.rings()[0]) vertices += (vertices.empty() ? "" : ", ") + text(vertex);
  return "Polygon([" + vertices + "]" +
         (polygon.fillRule() == tricover::FillRule::NonZero ? ", FillRule.NON_ZERO)" : ")");
}

/// (2, 2)
py::array_t<double> arrayOfBox(const Eigen::AlignedBox2d& box) {
  return arrayOf(std::vector<tricover::Vec2>{box.min(), box.max()});
}

/// A complement is kept as what it is the complement of.
py::tuple stateOf(const Polygon& polygon) {
  const Polygon kept = polygon.isComplement() ? polygon.complement() : polygon;
  return py::make_tuple(1, ringsOf(kept), static_cast<int>(kept.fillRule()), polygon.isComplement());
}

Polygon restored(const py::tuple& state) {
  if (state.size() != 4 || state[0].cast<int>() != 1)
    throw std::invalid_argument("this pickle is of another version of tricover");
  const Polygon polygon = polygonFrom(state[1], static_cast<tricover::FillRule>(state[2].cast<int>()));
  return state[3].cast<bool>() ? polygon.complement() : polygon;
}

void defineMaking(py::class_<Polygon>& polygon) {
  polygon
      .def(py::init(&polygonFrom), py::arg("rings"), py::arg("fill_rule") = tricover::FillRule::EvenOdd,
           doc("Polygon.__init__"))
      .def_static("box", &Polygon::box, py::arg("width"), py::arg("height"), doc("Polygon.box"))
      .def_static(
          "point", [](const py::object& p) { return Polygon::point(pointFrom(p, "p")); }, py::arg("p"),
          doc("Polygon.point"))
      .def_static(
          "segment",
          [](const py::object& p, const py::object& q) {
            return Polygon::segment(pointFrom(p, "p"), pointFrom(q, "q"));
          },
          py::arg("p"), py::arg("q"), doc("Polygon.segment"))
      .def_static("from_geo", &polygonFromGeo, py::arg("geometry"), doc("Polygon.from_geo"))
      .def_property_readonly("__geo_interface__", &geoOf, doc("Polygon.__geo_interface__"))
      .def(py::pickle(&stateOf, &restored))
      .def("__copy__", [](const Polygon& self) { return self; })
      .def("__deepcopy__", [](const Polygon& self, const py::dict&) { return self; })
      .def("__eq__", &same, py::is_operator())
      .def(
          "__ne__", [](const Polygon& p, const Polygon& q) { return !same(p, q); }, py::is_operator())
      .def("__hash__", &hashOfPolygon)
      .def("__repr__", &textOf);
}

void defineProperties(py::class_<Polygon>& polygon) {
  polygon.def_property_readonly("rings", &ringsOf, doc("Polygon.rings"))
      .def_property_readonly("fill_rule", &Polygon::fillRule, doc("Polygon.fill_rule"))
      .def_property_readonly("id", &Polygon::id, doc("Polygon.id"))
      .def_property_readonly("vertex_count", &Polygon::vertexCount, doc("Polygon.vertex_count"))
      .def_property_readonly("edge_count", &Polygon::edgeCount, doc("Polygon.edge_count"))
      .def_property_readonly("is_complement", &Polygon::isComplement, doc("Polygon.is_complement"))
      .def_property_readonly("is_convex", &Polygon::isConvex, doc("Polygon.is_convex"))
      .def_property_readonly(
          "covering_origin", [](const Polygon& self) { return arrayOf(self.coveringOrigin()); },
          doc("Polygon.covering_origin"))
      .def_property_readonly("radius", &Polygon::radius, doc("Polygon.radius"))
      .def_property_readonly("area", &Polygon::area, doc("Polygon.area"))
      .def_property_readonly(
          "centroid", [](const Polygon& self) { return arrayOf(self.centroid()); }, doc("Polygon.centroid"))
      .def_property_readonly(
          "bounds", [](const Polygon& self) { return arrayOfBox(self.bounds()); }, doc("Polygon.bounds"));
}

void defineDerived(py::class_<Polygon>& polygon) {
  polygon.def("complement", &Polygon::complement, py::call_guard<py::gil_scoped_release>(), doc("Polygon.complement"))
      .def(
          "translated", [](const Polygon& self, const py::object& by) { return self.translated(pointFrom(by, "by")); },
          py::arg("by"), doc("Polygon.translated"))
      .def("scaled", &Polygon::scaled, py::arg("factor"), doc("Polygon.scaled"))
      .def(
          "transformed",
          [](const Polygon& self, const py::object& pose) { return self.transformed(onePose(pose, "pose")); },
          py::arg("pose"), doc("Polygon.transformed"))
      .def("simplified", &Polygon::simplified, py::arg("tolerance"), py::arg("side") = tricover::Simplify::Both,
           py::call_guard<py::gil_scoped_release>(), doc("Polygon.simplified"))
      .def(
          "bounds_at",
          [](const Polygon& self, const py::object& pose) -> py::object {
            const Poses poses = posesFrom(pose, "pose");
            if (poses.is_one) return arrayOfBox(self.bounds(poses[0]));
            py::array_t<double> boxes({static_cast<py::ssize_t>(poses.values.size()), py::ssize_t{2}, py::ssize_t{2}});
            double* number = boxes.mutable_data();
            for (const tricover::Pose& one : poses.values) {
              const auto box = self.bounds(one);
              for (const tricover::Vec2& corner : {box.min(), box.max()})
                *number++ = corner.x(), *number++ = corner.y();
            }
            return std::move(boxes);
          },
          py::arg("pose"), doc("Polygon.bounds_at"))
      .def(
          "edge_start", [](const Polygon& self, tricover::EdgeIndex edge) { return arrayOf(self.edgeStart(edge)); },
          py::arg("edge"), doc("Polygon.edge_start"))
      .def(
          "edge_end", [](const Polygon& self, tricover::EdgeIndex edge) { return arrayOf(self.edgeEnd(edge)); },
          py::arg("edge"), doc("Polygon.edge_end"))
      .def(
          "edge",
          [](const Polygon& self, tricover::EdgeIndex edge) {
            return arrayOf(std::vector<tricover::Vec2>{self.edgeStart(edge), self.edgeEnd(edge)});
          },
          py::arg("edge"), doc("Polygon.edge"));
}

}  // namespace

void definePolygon(py::module_& m) {
  py::class_<Polygon> polygon(m, "Polygon", doc("Polygon"));
  defineMaking(polygon);
  defineProperties(polygon);
  defineDerived(polygon);
  m.def(
      "prepare", [](const Shape& shape) { tricover::prepare(shape); }, py::arg("polygon"),
      py::call_guard<py::gil_scoped_release>(), doc("prepare"));
}

}  // namespace tricover_python
