// SPDX-License-Identifier: BSD-3-Clause
// Motions, trajectories of many, and when two polygons meet on them.
#include <pybind11/stl.h>

#include <optional>
#include <tuple>
#include <utility>

#include "arrays.h"
#include "module.h"

namespace tricover_python {
namespace {

using tricover::Motion;
using tricover::Polygon;
using tricover::Trajectory;

const std::vector<double> kNoPivot = {0, 0};

/// x, y and heading, and their rates.
tricover::SplineEnd splineEnd(const double* place, const double* rates) {
  return {{place[0], place[1]}, place[2], {rates[0], rates[1]}, rates[2]};
}

void defineMotion(py::module_& m) {
  py::class_<Motion>(m, "Motion", "A planar rigid motion from time 0 to time 1.")
      .def_static(
          "still", [](const py::object& pose) { return Motion::still(onePose(pose, "pose")); }, py::arg("pose"))
      .def_static(
          "translation",
          [](const py::object& start, const Array& shift) {
            return Motion::translation(onePose(start, "start"), pointFrom(shift, "shift"));
          },
          py::arg("start"), py::arg("shift"))
      .def_static(
          "between",
          [](const py::object& start, const py::object& end, const Array& pivot) {
            return Motion::between(onePose(start, "start"), onePose(end, "end"), pointFrom(pivot, "pivot"));
          },
          py::arg("start"), py::arg("end"), py::arg("pivot") = kNoPivot)
      .def_static(
          "spline",
          [](const Array& begin, const Array& begin_velocity, const Array& end, const Array& end_velocity,
             const Array& pivot) {
            const auto end_of = [](const Array& place, const Array& velocity, const std::string& name) {
              for (const Array* const array : {&place, &velocity})
                if (array->ndim() != 1 || array->shape(0) != 3)
                  throw std::invalid_argument(name + ": x, y and heading are wanted, not " + shapeOf(*array));
              return splineEnd(place.data(), velocity.data());
            };
            return Motion::spline(end_of(begin, begin_velocity, "begin"), end_of(end, end_velocity, "end"),
                                  pointFrom(pivot, "pivot"));
          },
          py::arg("begin"), py::arg("begin_velocity"), py::arg("end"), py::arg("end_velocity"),
          py::arg("pivot") = kNoPivot)
      .def(
          "at",
          [](const Motion& motion, double time) {
            return Poses{{motion.at(time)}, true};
          },
          py::arg("time"))
      .def("part", &Motion::part, py::arg("from_time"), py::arg("until"));
}

/// So many rows of three as there are times.
void requireKnots(const Array& times, const Array& knots, const char* name) {
  if (times.ndim() != 1 || knots.ndim() != 2 || knots.shape(0) != times.shape(0) || knots.shape(1) != 3)
    throw std::invalid_argument(std::string(name) + ": its shape must be (n, 3) where that of times is (n,), not " +
                                shapeOf(knots) + " where that is " + shapeOf(times));
}

void defineTrajectory(py::module_& m) {
  using LegTuple = std::tuple<double, double, Motion>;
  py::class_<Trajectory>(m, "Trajectory", "Motions one after the other, by a clock; before and after them it rests.")
      .def(py::init([](const std::vector<LegTuple>& legs) {
             std::vector<tricover::Leg> given;
             for (const auto& [begin, end, motion] : legs) given.push_back({begin, end, motion});
             return Trajectory(std::move(given));
           }),
           py::arg("legs"))
      .def(py::init([](const Poses& pose) { return Trajectory(onePose(py::cast(pose), "pose")); }), py::arg("pose"))
      .def("appearing", &Trajectory::appearing)
      .def("vanishing", &Trajectory::vanishing)
      .def_property_readonly("appears", &Trajectory::appears)
      .def_property_readonly("vanishes", &Trajectory::vanishes)
      .def_property_readonly("rests", &Trajectory::rests)
      .def("is_there", &Trajectory::isThere, py::arg("time"))
      .def_static(
          "through",
          [](const Array& times, const Array& waypoints, const Array& pivot) {
            requireKnots(times, waypoints, "waypoints");
            std::vector<tricover::Waypoint> given;
            for (py::ssize_t i = 0; i < times.shape(0); ++i)
              given.push_back({times.at(i), {waypoints.at(i, 0), waypoints.at(i, 1)}, waypoints.at(i, 2)});
            return Trajectory::through(given, pointFrom(pivot, "pivot"));
          },
          py::arg("times"), py::arg("waypoints"), py::arg("pivot") = kNoPivot)
      .def_static(
          "spline",
          [](const Array& times, const Array& places, const Array& velocities, const Array& pivot) {
            requireKnots(times, places, "places");
            requireKnots(times, velocities, "velocities");
            std::vector<tricover::TimedKnot> knots;
            for (py::ssize_t i = 0; i < times.shape(0); ++i)
              knots.push_back({times.at(i), splineEnd(places.data() + 3 * i, velocities.data() + 3 * i)});
            return Trajectory::spline(knots, pointFrom(pivot, "pivot"));
          },
          py::arg("times"), py::arg("places"), py::arg("velocities"), py::arg("pivot") = kNoPivot)
      .def_property_readonly("legs",
                             [](const Trajectory& trajectory) {
                               std::vector<LegTuple> legs;
                               for (const tricover::Leg& leg : trajectory.legs())
                                 legs.emplace_back(leg.begin, leg.end, leg.motion);
                               return legs;
                             })
      .def_property_readonly("begin", &Trajectory::begin)
      .def_property_readonly("end", &Trajectory::end)
      .def(
          "at",
          [](const Trajectory& trajectory, double time) {
            return Poses{{trajectory.at(time)}, true};
          },
          py::arg("time"))
      .def("part", &Trajectory::part, py::arg("from_time"), py::arg("until"));
}

/// Of two Motions, or of two Trajectories.
template <typename Way>
void defineImpacts(py::module_& m, const Records& records) {
  m.def(
      "time_of_impact",
      [records](const Polygon& a, const Way& motion_a, const Polygon& b, const Way& motion_b, double margin,
                double time_error, bool ignore_initial) {
        std::optional<tricover::Impact> found;
        {
          const py::gil_scoped_release released;
          found = timeOfImpact(a, motion_a, b, motion_b, {margin, time_error, ignore_initial});
        }
        return records.of(found);
      },
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("margin") = 0.0,
      py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false);
  m.def(
      "conflicts",
      [records](const Polygon& a, const Way& motion_a, const Polygon& b, const Way& motion_b, double margin,
                double time_error, bool ignore_initial) {
        std::vector<tricover::Conflict> found;
        {
          const py::gil_scoped_release released;
          found = conflicts(a, motion_a, b, motion_b, {margin, time_error, ignore_initial});
        }
        py::list list;
        for (const tricover::Conflict& conflict : found) list.append(records.of(conflict));
        return list;
      },
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("margin") = 0.0,
      py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false);
  m.def(
      "least_distance",
      [records](const Polygon& a, const Way& motion_a, const Polygon& b, const Way& motion_b, double margin,
                double error) {
        tricover::LeastDistance found;
        {
          const py::gil_scoped_release released;
          found = leastDistance(a, motion_a, b, motion_b, {margin, error});
        }
        return records.of(found);
      },
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("margin") = 0.0,
      py::arg("error") = 1e-6);
}

}  // namespace

void defineMotions(py::module_& m, const Records& records) {
  defineMotion(m);
  defineTrajectory(m);
  defineImpacts<Motion>(m, records);
  defineImpacts<Trajectory>(m, records);
}

}  // namespace tricover_python
