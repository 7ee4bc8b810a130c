// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "python/ways.h"

namespace tricover_python {
namespace {

using tricover::Motion;

/// x, y and heading, and their rates.
tricover::SplineEnd splineEnd(const py::object& place, const py::object& rates, const std::string& name) {
  const Array places = numbersFrom(place, name), velocities = numbersFrom(rates, name + "_velocity");
  for (const Array* const array : {&places, &velocities})
    if (array->ndim() != 1 || array->shape(0) != 3)
      throw std::invalid_argument(name + ": x, y and heading are wanted, not " + shapeOf(*array));
  return {{places.at(0), places.at(1)}, places.at(2), {velocities.at(0), velocities.at(1)}, velocities.at(2)};
}

Motion motionFrom(const py::object& start, const py::object& shift, double angle, const py::object& pivot,
                  const py::object& shift_2, const py::object& shift_3, double angle_2, double angle_3) {
  Motion motion;
  motion.start = onePose(start, "start");
  motion.shift = pointFrom(shift, "shift");
  motion.angle = angle;
  motion.pivot = pointFrom(pivot, "pivot");
  motion.shift_2 = pointFrom(shift_2, "shift_2");
  motion.shift_3 = pointFrom(shift_3, "shift_3");
  motion.angle_2 = angle_2;
  motion.angle_3 = angle_3;
  tricover::checkMotion(motion);
  return motion;
}

/// All of its numbers.
std::vector<double> numbersOf(const Motion& m) {
  std::vector<double> numbers = {m.angle, m.angle_2, m.angle_3};
  for (int i = 0; i < 6; ++i) numbers.push_back(m.start(i / 3, i % 3));
  for (const tricover::Vec2* const v : {&m.shift, &m.pivot, &m.shift_2, &m.shift_3})
    numbers.push_back(v->x()), numbers.push_back(v->y());
  return numbers;
}

std::string textOf(const Motion& m) {
  std::string result = "Motion(" + text(m.start);
  const auto add = [&](const char* name, const tricover::Vec2& value) {
    if (value != tricover::Vec2::Zero()) result += std::string(", ") + name + "=" + text(value);
  };
  add("shift", m.shift);
  if (m.angle != 0) result += ", angle=" + text(m.angle);
  add("pivot", m.pivot);
  add("shift_2", m.shift_2);
  add("shift_3", m.shift_3);
  if (m.angle_2 != 0) result += ", angle_2=" + text(m.angle_2);
  if (m.angle_3 != 0) result += ", angle_3=" + text(m.angle_3);
  return result + ")";
}

Motion ofControlPoints(const py::object& positions, const py::object& angles, const py::object& pivot) {
  const std::vector<tricover::Vec2> points = verticesFrom(positions, "positions");
  const Many<double> turns = timesFrom(angles, "angles");
  if (points.size() != 4 || turns.is_one || turns.values.size() != 4)
    throw std::invalid_argument("positions and angles: four are wanted, (4, 2) and (4,)");
  std::array<tricover::Vec2, 4> four_points;
  std::array<double, 4> four_angles;
  std::copy(points.begin(), points.end(), four_points.begin());
  std::copy(turns.values.begin(), turns.values.end(), four_angles.begin());
  return Motion::spline(four_points, four_angles, pointFrom(pivot, "pivot"));
}

void defineMaking(py::class_<Motion>& motion) {
  const py::tuple zero = py::make_tuple(0, 0);
  motion
      .def(py::init(&motionFrom), py::arg("start"), py::arg("shift") = zero, py::arg("angle") = 0.0,
           py::arg("pivot") = zero, py::arg("shift_2") = zero, py::arg("shift_3") = zero, py::arg("angle_2") = 0.0,
           py::arg("angle_3") = 0.0, doc("Motion.__init__"))
      .def_static(
          "still", [](const py::object& pose) { return Motion::still(onePose(pose, "pose")); }, py::arg("pose"),
          doc("Motion.still"))
      .def_static(
          "translation",
          [](const py::object& start, const py::object& shift) {
            return Motion::translation(onePose(start, "start"), pointFrom(shift, "shift"));
          },
          py::arg("start"), py::arg("shift"), doc("Motion.translation"))
      .def_static(
          "arc",
          [](const py::object& start, const py::object& centre, double angle) {
            return Motion::arc(onePose(start, "start"), pointFrom(centre, "centre"), angle);
          },
          py::arg("start"), py::arg("centre"), py::arg("angle"), doc("Motion.arc"))
      .def_static(
          "between",
          [](const py::object& start, const py::object& end, const py::object& pivot) {
            return Motion::between(onePose(start, "start"), onePose(end, "end"), pointFrom(pivot, "pivot"));
          },
          py::arg("start"), py::arg("end"), py::arg("pivot") = zero, doc("Motion.between"))
      .def_static(
          "spline",
          [](const py::object& begin, const py::object& begin_velocity, const py::object& end,
             const py::object& end_velocity, const py::object& pivot) {
            return Motion::spline(splineEnd(begin, begin_velocity, "begin"), splineEnd(end, end_velocity, "end"),
                                  pointFrom(pivot, "pivot"));
          },
          py::arg("begin"), py::arg("begin_velocity"), py::arg("end"), py::arg("end_velocity"), py::arg("pivot") = zero,
          doc("Motion.spline"))
      .def_static("b_spline", &ofControlPoints, py::arg("positions"), py::arg("angles"), py::arg("pivot") = zero,
                  doc("Motion.b_spline"));
}

template <tricover::Vec2 Motion::*field>
py::object vectorOf(const Motion& motion) {
  return arrayOf(motion.*field);
}

}  // namespace

void defineMotion(py::module_& m) {
  py::class_<Motion> motion(m, "Motion", doc("Motion"));
  defineMaking(motion);
  motion
      .def_property_readonly(
          "start", [](const Motion& self) { return justOne(self.start); }, doc("Motion.start"))
      .def_property_readonly("shift", &vectorOf<&Motion::shift>, doc("Motion.shift"))
      .def_readonly("angle", &Motion::angle, doc("Motion.angle"))
      .def_property_readonly("pivot", &vectorOf<&Motion::pivot>, doc("Motion.pivot"))
      .def_property_readonly("shift_2", &vectorOf<&Motion::shift_2>, doc("Motion.shift_2"))
      .def_property_readonly("shift_3", &vectorOf<&Motion::shift_3>, doc("Motion.shift_3"))
      .def_readonly("angle_2", &Motion::angle_2, doc("Motion.angle_2"))
      .def_readonly("angle_3", &Motion::angle_3, doc("Motion.angle_3"))
      .def(
          "at",
          [](const Motion& self, const py::object& time) {
            const Many<double> times = timesFrom(time, "time");
            Poses poses{{{}, times.is_one}};
            for (const double one : times.values) poses.values.push_back(self.at(one));
            return poses;
          },
          py::arg("time"), doc("Motion.at"))
      .def("part", &Motion::part, py::arg("from_time"), py::arg("until"), doc("Motion.part"))
      .def(py::pickle(
          [](const Motion& self) {
            return py::make_tuple(1, matricesOf(justOne(self.start)), arrayOf(self.shift), self.angle,
                                  arrayOf(self.pivot), arrayOf(self.shift_2), arrayOf(self.shift_3), self.angle_2,
                                  self.angle_3);
          },
          [](const py::tuple& state) {
            if (state.size() != 9 || state[0].cast<int>() != 1)
              throw std::invalid_argument("this pickle is of another version of tricover");
            return motionFrom(py::cast(posesFromMatrices(state[1])), state[2], state[3].cast<double>(), state[4],
                              state[5], state[6], state[7].cast<double>(), state[8].cast<double>());
          }))
      .def(
          "__eq__", [](const Motion& p, const Motion& q) { return numbersOf(p) == numbersOf(q); }, py::is_operator())
      .def(
          "__ne__", [](const Motion& p, const Motion& q) { return numbersOf(p) != numbersOf(q); }, py::is_operator())
      .def("__hash__", [](const Motion& self) { return hashOf(numbersOf(self)); })
      .def("__repr__", &textOf);
}

}  // namespace tricover_python
