// SPDX-License-Identifier: BSD-3-Clause
// A Scene's bodies, and what collides among them.
#include <pybind11/stl.h>

#include <utility>

#include "python/module.h"

namespace tricover_python {
namespace {

using tricover::BodyHandle;
using tricover::Polygon;
using tricover::Scene;
using tricover::Touching;

/// One polygon, or a list of them.
Many<Polygon> polygonsFrom(const py::object& given) {
  if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) return {{given.cast<Shape>()}, true};
  Many<Polygon> result{{}, false};
  for (const py::handle one : given) result.values.push_back(one.cast<Shape>());
  return result;
}

py::object add(Scene& self, const py::object& polygon, const py::object& pose, const tricover::BodyOptions& options) {
  const Many<Polygon> polygons = polygonsFrom(polygon);
  const Poses poses = posesFrom(pose, "pose");
  if (polygons.is_one && poses.is_one) return one(self.add(polygons[0], poses[0], options));
  const std::size_t count = polygons.is_one ? poses.values.size() : polygons.values.size();
  if (!polygons.is_one && !poses.is_one && poses.values.size() != count)
    throw std::invalid_argument("pose: there are " + std::to_string(poses.values.size()) + ", but of polygon " +
                                std::to_string(count));
  std::vector<tricover::BodyPlacement> bodies;
  for (std::size_t i = 0; i < count; ++i) bodies.push_back({polygons[i], poses[i], options});
  return one(self.add(bodies));
}

void move(Scene& self, const py::object& body, const py::object& pose, std::size_t threads) {
  const Poses poses = posesFrom(pose, "pose");
  if (poses.is_one) return self.move(body.cast<Body>().handle, poses[0]);
  const auto bodies = body.cast<std::vector<Body>>();
  if (bodies.size() != poses.values.size())
    throw std::invalid_argument("pose: there are " + std::to_string(poses.values.size()) + ", but of body " +
                                std::to_string(bodies.size()));
  std::vector<tricover::BodyPose> moves;
  for (std::size_t i = 0; i < bodies.size(); ++i) moves.push_back({bodies[i].handle, poses[i]});
  const py::gil_scoped_release released;
  self.move(moves, parallelOn(threads));
}

void defineBodies(py::class_<Scene>& scene) {
  scene.def(py::init<>(), doc("Scene.__init__"))
      .def("__copy__", [](const Scene& other) { return Scene(other); })
      .def(
          "__deepcopy__", [](const Scene& other, const py::dict&) { return Scene(other); }, py::arg("memo"))
      .def("__len__", &Scene::size)
      .def("__contains__", [](const Scene& self, Body body) { return self.contains(body.handle); })
      .def("__repr__",
           [](const Scene& self) { return "<tricover.Scene of " + std::to_string(self.size()) + " bodies>"; })
      .def(
          "add",
          [](Scene& self, const py::object& polygon, const py::object& pose, double margin, Mask category, Mask mask,
             Touching touching) {
            return add(self, polygon, pose, {margin, category.bits, mask.bits, touching});
          },
          py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("category") = 1,
          py::arg("mask") = tricover::kEveryCategory, py::arg("touching") = Touching::Collides, doc("Scene.add"))
      .def(
          "set_options",
          [](Scene& self, Body body, double margin, Mask category, Mask mask, Touching touching) {
            self.setOptions(body.handle, {margin, category.bits, mask.bits, touching});
          },
          py::arg("body"), py::arg("margin") = 0.0, py::arg("category") = 1, py::arg("mask") = tricover::kEveryCategory,
          py::arg("touching") = Touching::Collides, doc("Scene.set_options"))
      .def(
          "options", [](const Scene& self, Body body) { return one(self.options(body.handle)); }, py::arg("body"),
          doc("Scene.options"))
      .def(
          "set_ignored",
          [](Scene& self, Body a, Body b, bool ignored) { self.setIgnored(a.handle, b.handle, ignored); }, py::arg("a"),
          py::arg("b"), py::arg("ignored") = true, doc("Scene.set_ignored"))
      .def(
          "is_ignored", [](const Scene& self, Body a, Body b) { return self.isIgnored(a.handle, b.handle); },
          py::arg("a"), py::arg("b"), doc("Scene.is_ignored"))
      .def(
          "remove", [](Scene& self, Body body) { self.remove(body.handle); }, py::arg("body"), doc("Scene.remove"))
      .def("move", &move, py::arg("body"), py::arg("pose"), py::arg("threads") = 0, doc("Scene.move"))
      .def_property_readonly(
          "bodies", [](const Scene& self) { return one(self.bodies()); }, doc("Scene.bodies"))
      .def(
          "polygon", [](const Scene& self, Body body) { return self.polygon(body.handle); }, py::arg("body"),
          doc("Scene.polygon"))
      .def(
          "pose", [](const Scene& self, Body body) { return justOne(self.pose(body.handle)); }, py::arg("body"),
          doc("Scene.pose"))
      .def_static(
          "index_of", [](Body body) { return Scene::indexOf(body.handle); }, py::arg("body"), doc("Scene.index_of"));
}

void defineCollisions(py::class_<Scene>& scene) {
  scene
      .def(
          "collisions",
          [](Scene& self, std::size_t threads) {
            std::vector<tricover::BodyPair> found;
            {
              const py::gil_scoped_release released;
              found = self.collisions(threads == 1 ? tricover::Parallel() : parallelOn(threads));
            }
            return one(found);
          },
          py::arg("threads") = 1, doc("Scene.collisions"))
      .def(
          "contacts",
          [](Scene& self, tricover::ContactDetail detail, std::size_t threads) {
            std::vector<tricover::PairContact> found;
            {
              const py::gil_scoped_release released;
              found = self.contacts(detail, threads == 1 ? tricover::Parallel() : parallelOn(threads));
            }
            return one(found);
          },
          py::arg("detail") = tricover::ContactDetail::LocalDepth, py::arg("threads") = 1, doc("Scene.contacts"))
      .def_property_readonly(
          "began", [](const Scene& self) { return one(self.began()); }, doc("Scene.began"))
      .def_property_readonly(
          "ended", [](const Scene& self) { return one(self.ended()); }, doc("Scene.ended"));
}

}  // namespace

void defineScene(py::module_& m) {
  py::class_<Scene> scene(m, "Scene", doc("Scene"));
  defineBodies(scene);
  defineCollisions(scene);
  defineSceneQueries(scene);
  defineSceneMotions(scene);
}

}  // namespace tricover_python
