// SPDX-License-Identifier: BSD-3-Clause
// A trajectory remembers what it was made of, which is what its pickle has: its legs alone don't say its last pose to
// the last bit.
#include <pybind11/stl.h>

#include <limits>
#include <tuple>
#include <utility>

#include "python/ways.h"

namespace tricover_python {
namespace {

using tricover::Trajectory;
using LegTuple = std::tuple<double, double, tricover::Motion>;

constexpr const char* kMadeBy = "_made_by";

/// A Python object, with the name of what made it and the arguments.
py::object made(const Trajectory& trajectory, const py::object& by) {
  py::object object = py::cast(trajectory);
  object.attr(kMadeBy) = by;
  return object;
}

std::vector<LegTuple> legsOf(const Trajectory& trajectory) {
  std::vector<LegTuple> legs;
  for (const tricover::Leg& leg : trajectory.legs()) legs.emplace_back(leg.begin, leg.end, leg.motion);
  return legs;
}

Trajectory ofLegs(const py::object& given) {
  if (py::isinstance<Poses>(given)) return Trajectory(onePose(given, "legs"));
  std::vector<LegTuple> tuples;
  try {
    tuples = given.cast<std::vector<LegTuple>>();
  } catch (const py::cast_error&) {
    throw py::type_error("legs: a list of (begin, end, motion) is wanted, or one pose as Poses, not " +
                         py::repr(given).cast<std::string>());
  }
  std::vector<tricover::Leg> legs;
  for (const auto& [begin, end, motion] : tuples) legs.push_back({begin, end, motion});
  return Trajectory(std::move(legs));
}

/// So many rows of three as there are times.
Array knotsFrom(const py::object& times, const py::object& knots, const char* name) {
  const Array rows = numbersFrom(knots, name), clock = numbersFrom(times, "times");
  if (clock.ndim() != 1 || rows.ndim() != 2 || rows.shape(0) != clock.shape(0) || rows.shape(1) != 3)
    throw std::invalid_argument(std::string(name) + ": its shape must be (n, 3) where that of times is (n,), not " +
                                shapeOf(rows) + " where that is " + shapeOf(clock));
  return rows;
}

Trajectory through(const py::object& times, const py::object& waypoints, const py::object& pivot) {
  const tricover::Vec2 about = pointFrom(pivot, "pivot");
  const Many<double> clock = timesFrom(times, "times");
  if (py::isinstance<Poses>(waypoints)) {
    const Poses& poses = waypoints.cast<const Poses&>();
    if (poses.is_one || poses.values.size() != clock.values.size())
      throw std::invalid_argument("waypoints: there must be as many poses as times");
    std::vector<tricover::TimedPose> given;
    for (std::size_t i = 0; i < poses.values.size(); ++i) given.push_back({clock.values[i], poses.values[i]});
    return Trajectory::through(given, about);
  }
  const Array rows = knotsFrom(times, waypoints, "waypoints");
  std::vector<tricover::Waypoint> given;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    given.push_back({clock.values[static_cast<std::size_t>(i)], {rows.at(i, 0), rows.at(i, 1)}, rows.at(i, 2)});
  return Trajectory::through(given, about);
}

Trajectory spline(const py::object& times, const py::object& places, const py::object& velocities,
                  const py::object& pivot) {
  const Array rows = knotsFrom(times, places, "places"), rates = knotsFrom(times, velocities, "velocities");
  const Many<double> clock = timesFrom(times, "times");
  std::vector<tricover::TimedKnot> knots;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    knots.push_back(
        {clock.values[static_cast<std::size_t>(i)],
         {{rows.at(i, 0), rows.at(i, 1)}, rows.at(i, 2), {rates.at(i, 0), rates.at(i, 1)}, rates.at(i, 2)}});
  return Trajectory::spline(knots, pointFrom(pivot, "pivot"));
}

Trajectory remade(const py::tuple& by) {
  const std::string name = by[0].cast<std::string>();
  if (name == "through") return through(by[1], by[2], by[3]);
  if (name == "spline") return spline(by[1], by[2], by[3], by[4]);
  return ofLegs(by[1]);
}

py::tuple stateOf(const py::object& self) {
  const auto& trajectory = self.cast<const Trajectory&>();
  py::object by = py::make_tuple("legs", legsOf(trajectory));
  if (trajectory.rests()) by = py::make_tuple("legs", justOne(trajectory.at(0)));
  if (py::hasattr(self, kMadeBy)) by = self.attr(kMadeBy);
  return py::make_tuple(1, by, trajectory.appears(), trajectory.vanishes());
}

py::object restored(const py::tuple& state) {
  if (state.size() != 4 || state[0].cast<int>() != 1)
    throw std::invalid_argument("this pickle is of another version of tricover");
  const py::tuple by = state[1];
  Trajectory trajectory = remade(by);
  if (state[2].cast<bool>()) trajectory = trajectory.appearing();
  if (state[3].cast<bool>()) trajectory = trajectory.vanishing();
  return made(trajectory, by);
}

bool same(const Trajectory& p, const Trajectory& q) {
  const double end = std::numeric_limits<double>::infinity();
  if (p.rests() != q.rests() || p.appears() != q.appears() || p.vanishes() != q.vanishes() ||
      p.legs().size() != q.legs().size() || p.at(end).matrix() != q.at(end).matrix())
    return false;
  return py::cast(legsOf(p)).equal(py::cast(legsOf(q)));
}

std::string textOf(const Trajectory& trajectory) {
  std::string result = "<tricover.Trajectory ";
  if (trajectory.rests()) return result + "that rests at " + text(trajectory.at(0)) + ">";
  const std::size_t legs = trajectory.legs().size();
  result += "of " + std::to_string(legs) + (legs == 1 ? " leg" : " legs") + ", from " + text(trajectory.begin()) +
            " to " + text(trajectory.end());
  return result + (trajectory.appears() ? ", appears" : "") + (trajectory.vanishes() ? ", vanishes>" : ">");
}

py::object withFlags(const py::object& self, const Trajectory& trajectory) {
  return py::hasattr(self, kMadeBy) ? made(trajectory, self.attr(kMadeBy)) : py::cast(trajectory);
}

void defineMaking(py::class_<Trajectory>& trajectory) {
  const py::tuple zero = py::make_tuple(0, 0);
  trajectory.def(py::init(&ofLegs), py::arg("legs"), doc("Trajectory.__init__"))
      .def_static(
          "through",
          [](const py::object& times, const py::object& waypoints, const py::object& pivot) {
            return made(through(times, waypoints, pivot), py::make_tuple("through", times, waypoints, pivot));
          },
          py::arg("times"), py::arg("waypoints"), py::arg("pivot") = zero, doc("Trajectory.through"))
      .def_static(
          "spline",
          [](const py::object& times, const py::object& places, const py::object& velocities, const py::object& pivot) {
            return made(spline(times, places, velocities, pivot),
                        py::make_tuple("spline", times, places, velocities, pivot));
          },
          py::arg("times"), py::arg("places"), py::arg("velocities"), py::arg("pivot") = zero, doc("Trajectory.spline"))
      .def(
          "appearing",
          [](const py::object& self) { return withFlags(self, self.cast<const Trajectory&>().appearing()); },
          doc("Trajectory.appearing"))
      .def(
          "vanishing",
          [](const py::object& self) { return withFlags(self, self.cast<const Trajectory&>().vanishing()); },
          doc("Trajectory.vanishing"))
      .def("__reduce__",
           [](const py::object& self) {
             return py::make_tuple(py::module_::import("tricover").attr("_trajectory"), stateOf(self));
           })
      .def("__eq__", &same, py::is_operator())
      .def(
          "__ne__", [](const Trajectory& p, const Trajectory& q) { return !same(p, q); }, py::is_operator())
      .def("__hash__", [](const Trajectory& self) { return py::hash(py::tuple(py::cast(legsOf(self)))); })
      .def("__repr__", &textOf);
}

}  // namespace

void defineTrajectory(py::module_& m) {
  py::class_<Trajectory> trajectory(m, "Trajectory", py::dynamic_attr(), doc("Trajectory"));
  m.def("_trajectory", [](int version, const py::tuple& by, bool appears, bool vanishes) {
    return restored(py::make_tuple(version, by, appears, vanishes));
  });
  defineMaking(trajectory);
  trajectory.def_property_readonly("legs", &legsOf, doc("Trajectory.legs"))
      .def_property_readonly("begin", &Trajectory::begin, doc("Trajectory.begin"))
      .def_property_readonly("end", &Trajectory::end, doc("Trajectory.end"))
      .def_property_readonly("appears", &Trajectory::appears, doc("Trajectory.appears"))
      .def_property_readonly("vanishes", &Trajectory::vanishes, doc("Trajectory.vanishes"))
      .def_property_readonly("rests", &Trajectory::rests, doc("Trajectory.rests"))
      .def(
          "is_there",
          [](const Trajectory& self, const py::object& time) -> py::object {
            const Many<double> times = timesFrom(time, "time");
            if (times.is_one) return py::bool_(self.isThere(times[0]));
            return arrayOf<bool>(times.values.size(), [&](std::size_t i) { return self.isThere(times[i]); });
          },
          py::arg("time"), doc("Trajectory.is_there"))
      .def(
          "at",
          [](const Trajectory& self, const py::object& time) {
            const Many<double> times = timesFrom(time, "time");
            Poses poses{{{}, times.is_one}};
            for (const double one : times.values) poses.values.push_back(self.at(one));
            return poses;
          },
          py::arg("time"), doc("Trajectory.at"))
      .def("part", &Trajectory::part, py::arg("from_time"), py::arg("until"), doc("Trajectory.part"));
}

}  // namespace tricover_python
