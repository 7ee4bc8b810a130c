// SPDX-License-Identifier: BSD-3-Clause
// What meets on its way in a Scene.
#include <pybind11/stl.h>

#include <utility>

#include "python/scene_filter.h"
#include "python/ways.h"

namespace tricover_python {
namespace {

using tricover::Scene;

/// query(motion) for one or many; a pose is a motion that stays.
template <typename Query>
py::object ofWay(const py::object& motion, std::size_t threads, const Query& query) {
  const Way way = wayFrom(motion, "motion");
  const auto of = [&](const auto& ways) {
    return Count().of(ways, "motion").answers(threads, kDear, [&](std::size_t i) { return query(ways[i]); });
  };
  return way.trajectories.values.empty() ? of(way.motions) : of(way.trajectories);
}

/// Pairs of a body and its motion, or of a body and its trajectory, of which a pose is one, too.
struct MovingBodies {
  std::vector<tricover::BodyMotion> motions;
  std::vector<tricover::BodyTrajectory> trajectories;
};

MovingBodies movingFrom(const py::object& given) {
  const py::object items = py::isinstance<py::dict>(given) ? given.attr("items")() : given;
  MovingBodies result;
  std::size_t i = 0;
  for (const py::handle item : items) {
    const std::string name = "motions[" + std::to_string(i++) + "]";
    if (!py::isinstance<py::sequence>(item) || py::len(item) != 2)
      throw py::type_error(name + ": a pair (body, motion) is wanted");
    const py::sequence pair = py::reinterpret_borrow<py::sequence>(item);
    const tricover::BodyHandle body = py::object(pair[0]).cast<Body>().handle;
    const Way way = wayFrom(pair[1], name);
    requireOne(way, name);
    if (way.stays)
      throw py::type_error(name + ": it is a pose; a body that isn't named stays where it is in the scene");
    if (way.trajectories.values.empty()) result.motions.push_back({body, way.motions[0]});
    if (!way.trajectories.values.empty()) result.trajectories.push_back({body, way.trajectories[0]});
  }
  if (!result.motions.empty() && !result.trajectories.empty())
    throw py::type_error("motions: some are Motions and some are Trajectories; make one of a motion by " +
                         std::string("Trajectory([(begin, end, motion)])"));
  return result;
}

void defineSingle(py::class_<Scene>& scene) {
  scene
      .def(
          "first_impact",
          [](const Scene& self, const Shape& polygon, const py::object& motion, double margin, double time_error,
             Mask mask, std::optional<Body> ignored, bool ignore_initial, std::size_t threads) {
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            return ofWay(motion, threads, [&](const auto& way) {
              return self.firstImpact(polygon, way, {margin, time_error, ignore_initial}, filter);
            });
          },
          py::arg("polygon"), py::arg("motion"), py::arg("margin") = 0.0, py::arg("time_error") = 1e-6,
          py::arg("mask") = kAll, py::arg("ignored") = py::none(), py::arg("ignore_initial") = false,
          py::arg("threads") = 0, doc("Scene.first_impact"))
      .def(
          "least_distance",
          [](const Scene& self, const Shape& polygon, const py::object& motion, double margin, double absolute_error,
             Mask mask, std::optional<Body> ignored, std::size_t threads) {
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            return ofWay(motion, threads, [&](const auto& way) {
              return self.leastDistance(polygon, way, {margin, absolute_error}, filter);
            });
          },
          py::arg("polygon"), py::arg("motion"), py::arg("margin") = 0.0, py::arg("absolute_error") = 1e-6,
          py::arg("mask") = kAll, py::arg("ignored") = py::none(), py::arg("threads") = 0, doc("Scene.least_distance"))
      .def(
          "first_exit",
          [](const Scene& self, const Shape& polygon, const py::object& motion, double margin, Mask mask,
             std::optional<Body> ignored, std::size_t threads) {
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            return ofWay(motion, threads,
                         [&](const auto& way) { return self.firstExit(polygon, way, {margin}, filter); });
          },
          py::arg("polygon"), py::arg("motion"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none(), py::arg("threads") = 0, doc("Scene.first_exit"));
}

void defineAll(py::class_<Scene>& scene) {
  scene
      .def(
          "impacts",
          [](const Scene& self, const py::object& motions, double margin, double time_error, bool ignore_initial,
             std::size_t threads) {
            const MovingBodies moving = movingFrom(motions);
            const tricover::ImpactOptions options{margin, time_error, ignore_initial};
            std::vector<tricover::PairImpact> found;
            {
              const py::gil_scoped_release released;
              found = moving.trajectories.empty() ? self.impacts(moving.motions, options, parallelOn(threads))
                                                  : self.impacts(moving.trajectories, options, parallelOn(threads));
            }
            return one(found);
          },
          py::arg("motions"), py::arg("margin") = 0.0, py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false,
          py::arg("threads") = 0, doc("Scene.impacts"))
      .def(
          "conflicts",
          [](const Scene& self, const py::object& motions, double margin, double time_error, bool ignore_initial,
             std::size_t threads) {
            const MovingBodies moving = movingFrom(motions);
            std::vector<tricover::PairConflict> found;
            {
              const py::gil_scoped_release released;
              const tricover::ImpactOptions options{margin, time_error, ignore_initial};
              found = moving.trajectories.empty() ? self.conflicts(moving.motions, options, parallelOn(threads))
                                                  : self.conflicts(moving.trajectories, options, parallelOn(threads));
            }
            return one(found);
          },
          py::arg("motions"), py::arg("margin") = 0.0, py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false,
          py::arg("threads") = 0, doc("Scene.conflicts"));
}

}  // namespace

void defineSceneMotions(py::class_<Scene>& scene) {
  defineSingle(scene);
  defineAll(scene);
}

}  // namespace tricover_python
