// SPDX-License-Identifier: BSD-3-Clause
// tricover::Scene.
#include <pybind11/stl.h>

#include <cstdint>
#include <utility>

#include "arrays.h"
#include "module.h"

namespace tricover_python {
namespace {

using tricover::BodyHandle;
using tricover::Polygon;
using tricover::Scene;

tricover::BodyFilter filterFrom(Mask mask, std::optional<BodyHandle> ignored) {
  return {mask.bits, ignored.value_or(tricover::kNoBody)};
}

std::vector<Body> bodiesOf(const std::vector<BodyHandle>& handles) {
  std::vector<Body> result;
  for (const BodyHandle handle : handles) result.push_back({handle});
  return result;
}

std::vector<std::pair<Body, Body>> pairsOf(const std::vector<tricover::BodyPair>& pairs) {
  std::vector<std::pair<Body, Body>> result;
  for (const tricover::BodyPair& pair : pairs) result.push_back({{pair.first}, {pair.second}});
  return result;
}

tricover::Parallel parallelOn(std::size_t threads) {
  return
      [threads](std::size_t count, const std::function<void(std::size_t)>& task) { inParallel(threads, count, task); };
}

void defineBodies(py::class_<Scene>& scene, const Records& records) {
  scene.def(py::init<>())
      .def("__copy__", [](const Scene& other) { return Scene(other); })
      .def(
          "__deepcopy__", [](const Scene& other, const py::dict&) { return Scene(other); }, py::arg("memo"))
      .def("__len__", &Scene::size)
      .def("__contains__", &Scene::contains)
      .def(
          "add",
          [](Scene& self, const Polygon& polygon, const py::object& pose, double margin, Mask category, Mask mask,
             tricover::Touching touching) {
            return Body{self.add(polygon, onePose(pose, "pose"), {margin, category.bits, mask.bits, touching})};
          },
          py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("category") = 1,
          py::arg("mask") = tricover::kEveryCategory, py::arg("touching") = tricover::Touching::Collides)
      .def(
          "set_options",
          [](Scene& self, BodyHandle body, double margin, Mask category, Mask mask, tricover::Touching touching) {
            self.setOptions(body, {margin, category.bits, mask.bits, touching});
          },
          py::arg("body"), py::arg("margin") = 0.0, py::arg("category") = 1, py::arg("mask") = tricover::kEveryCategory,
          py::arg("touching") = tricover::Touching::Collides)
      .def(
          "options", [records](const Scene& self, BodyHandle body) { return records.of(self.options(body)); },
          py::arg("body"))
      .def("remove", &Scene::remove, py::arg("body"))
      .def(
          "move", [](Scene& self, BodyHandle body, const py::object& pose) { self.move(body, onePose(pose, "pose")); },
          py::arg("body"), py::arg("pose"))
      .def_property_readonly("bodies", [](const Scene& self) { return bodiesOf(self.bodies()); })
      .def("polygon", &Scene::polygon, py::arg("body"))
      .def(
          "pose",
          [](const Scene& self, BodyHandle body) {
            return Poses{{self.pose(body)}, true};
          },
          py::arg("body"))
      .def(
          "collisions",
          [](Scene& self, std::size_t threads) {
            const py::gil_scoped_release released;
            return pairsOf(self.collisions(threads == 1 ? tricover::Parallel() : parallelOn(threads)));
          },
          py::arg("threads") = 1)
      .def_property_readonly("began", [](const Scene& self) { return pairsOf(self.began()); })
      .def_property_readonly("ended", [](const Scene& self) { return pairsOf(self.ended()); });
}

constexpr std::uint32_t kAll = tricover::kEveryCategory;

void defineBooleans(py::class_<Scene>& scene) {
  scene
      .def(
          "collides",
          [](const Scene& self, const Polygon& polygon, const py::object& pose, double margin, double tolerance,
             Mask mask, std::optional<BodyHandle> ignored, tricover::Touching touching,
             std::size_t threads) -> py::object {
            const tricover::CollideOptions options{margin, tolerance, touching};
            const Poses poses = posesFrom(pose, "pose");
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            if (poses.is_one) return py::bool_(self.collides(polygon, poses[0], options, filter));
            std::vector<bool> found;
            {
              const py::gil_scoped_release released;
              found = self.collides(polygon, poses.poses, options, filter, parallelOn(threads));
            }
            return arrayOf<bool>(found.size(), [&](std::size_t i) { return found[i]; });
          },
          py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("tolerance") = 0.0,
          py::arg("mask") = kAll, py::arg("ignored") = py::none(), py::arg("touching") = tricover::Touching::Collides,
          py::arg("threads") = 0)
      .def(
          "covers",
          [](const Scene& self, const Polygon& polygon, const py::object& pose, double margin, Mask mask,
             std::optional<BodyHandle> ignored) {
            return self.covers(polygon, onePose(pose, "pose"), {margin}, filterFrom(mask, ignored));
          },
          py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none())
      .def(
          "colliding",
          [](const Scene& self, const Polygon& polygon, const py::object& pose, double margin, Mask mask,
             std::optional<BodyHandle> ignored, tricover::Touching touching) {
            return bodiesOf(
                self.colliding(polygon, onePose(pose, "pose"), {margin, 0, touching}, filterFrom(mask, ignored)));
          },
          py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none(), py::arg("touching") = tricover::Touching::Collides);
}

void defineMeasures(py::class_<Scene>& scene, const Records& records) {
  scene
      .def(
          "nearest",
          [records](const Scene& self, const Polygon& polygon, const py::object& pose, Mask mask,
                    std::optional<BodyHandle> ignored) -> py::object {
            const auto found = self.nearest(polygon, onePose(pose, "pose"), {}, filterFrom(mask, ignored));
            if (!found) return py::none();
            return py::make_tuple(Body{found->body}, records.of(found->result));
          },
          py::arg("polygon"), py::arg("pose"), py::arg("mask") = kAll, py::arg("ignored") = py::none())
      .def(
          "cast_ray",
          [records](const Scene& self, const Array& from, const Array& to, double margin, Mask mask,
                    std::optional<BodyHandle> ignored) -> py::object {
            const auto found = self.castRay(pointFrom(from, "from_point"), pointFrom(to, "to_point"), {margin},
                                            filterFrom(mask, ignored));
            if (!found) return py::none();
            return py::make_tuple(Body{found->body}, records.of(found->hit));
          },
          py::arg("from_point"), py::arg("to_point"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none())
      .def(
          "cast_ray_all",
          [records](const Scene& self, const Array& from, const Array& to, double margin, Mask mask,
                    std::optional<BodyHandle> ignored) {
            py::list list;
            for (const tricover::BodyRayInterval& one : self.castRayAll(
                     pointFrom(from, "from_point"), pointFrom(to, "to_point"), {margin}, filterFrom(mask, ignored)))
              list.append(py::make_tuple(Body{one.body}, records.of(one.interval)));
            return list;
          },
          py::arg("from_point"), py::arg("to_point"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none());
}

/// Of Motions, or of Trajectories.
template <typename Way, typename Moving>
void defineImpacts(py::class_<Scene>& scene, const Records& records) {
  scene
      .def(
          "first_impact",
          [records](const Scene& self, const Polygon& polygon, const Way& motion, double margin, double time_error,
                    Mask mask, std::optional<BodyHandle> ignored, bool ignore_initial) -> py::object {
            const auto found =
                self.firstImpact(polygon, motion, {margin, time_error, ignore_initial}, filterFrom(mask, ignored));
            if (!found) return py::none();
            return py::make_tuple(Body{found->body}, records.of(found->impact));
          },
          py::arg("polygon"), py::arg("motion"), py::arg("margin") = 0.0, py::arg("time_error") = 1e-6,
          py::arg("mask") = kAll, py::arg("ignored") = py::none(), py::arg("ignore_initial") = false)
      .def(
          "impacts",
          [records](const Scene& self, const std::vector<std::pair<BodyHandle, Way>>& motions, double margin,
                    double time_error, bool ignore_initial, std::size_t threads) {
            std::vector<Moving> given;
            for (const auto& [body, motion] : motions) given.push_back({body, motion});
            std::vector<tricover::PairImpact> found;
            {
              const py::gil_scoped_release released;
              found = self.impacts(given, {margin, time_error, ignore_initial}, parallelOn(threads));
            }
            py::list list;
            for (const tricover::PairImpact& one : found)
              list.append(py::make_tuple(Body{one.pair.first}, Body{one.pair.second}, records.of(one.impact)));
            return list;
          },
          py::arg("motions"), py::arg("margin") = 0.0, py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false,
          py::arg("threads") = 0);
}

void defineConflicts(py::class_<Scene>& scene, const Records& records) {
  scene.def(
      "conflicts",
      [records](const Scene& self, const std::vector<std::pair<BodyHandle, tricover::Trajectory>>& trajectories,
                double margin, double time_error, bool ignore_initial, std::size_t threads) {
        std::vector<tricover::BodyTrajectory> given;
        for (const auto& [body, trajectory] : trajectories) given.push_back({body, trajectory});
        std::vector<tricover::PairConflict> found;
        {
          const py::gil_scoped_release released;
          found = self.conflicts(given, {margin, time_error, ignore_initial}, parallelOn(threads));
        }
        py::list list;
        for (const tricover::PairConflict& one : found)
          list.append(py::make_tuple(Body{one.pair.first}, Body{one.pair.second}, records.of(one.conflict)));
        return list;
      },
      py::arg("trajectories"), py::arg("margin") = 0.0, py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false,
      py::arg("threads") = 0);
}

}  // namespace

void defineScene(py::module_& m, const Records& records) {
  py::class_<Scene> scene(m, "Scene", "Many polygons under poses of their own, and what collides among them.");
  defineBodies(scene, records);
  defineBooleans(scene);
  defineMeasures(scene, records);
  defineImpacts<tricover::Motion, tricover::BodyMotion>(scene, records);
  defineImpacts<tricover::Trajectory, tricover::BodyTrajectory>(scene, records);
  defineConflicts(scene, records);
}

}  // namespace tricover_python
