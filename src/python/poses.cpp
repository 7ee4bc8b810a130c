// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "python/module.h"

namespace tricover_python {
namespace {

std::size_t indexOf(const Poses& poses, py::ssize_t i) {
  const auto count = static_cast<py::ssize_t>(poses.values.size());
  if (poses.is_one) throw py::type_error("this is one pose, and has no items");
  if (i < -count || i >= count) throw py::index_error("there are " + std::to_string(count) + " poses");
  return static_cast<std::size_t>(i < 0 ? i + count : i);
}

Poses some(const Poses& poses, const py::slice& slice) {
  if (poses.is_one) throw py::type_error("this is one pose, and has no items");
  std::size_t start = 0, stop = 0, step = 0, length = 0;
  if (!slice.compute(poses.values.size(), &start, &stop, &step, &length)) throw py::error_already_set();
  Poses result{{{}, false}};
  for (std::size_t i = 0; i < length; ++i, start += step) result.values.push_back(poses.values[start]);
  return result;
}

bool same(const Poses& p, const Poses& q) {
  if (p.is_one != q.is_one || p.values.size() != q.values.size()) return false;
  for (std::size_t i = 0; i < p.values.size(); ++i)
    if (p.values[i].matrix() != q.values[i].matrix()) return false;
  return true;
}

py::ssize_t hashOfPoses(const Poses& poses) {
  std::vector<double> numbers = {poses.is_one ? 1.0 : 0.0};
  for (const tricover::Pose& pose : poses.values)
    for (int i = 0; i < 6; ++i) numbers.push_back(pose(i / 3, i % 3));
  return hashOf(std::move(numbers));
}

std::string textOf(const Poses& poses) {
  if (poses.is_one) return text(poses[0]);
  if (poses.values.size() > 3) return "<tricover.Poses, " + std::to_string(poses.values.size()) + " of them>";
  return "Poses.from_matrices(" + py::repr(matricesOf(poses).attr("tolist")()).cast<std::string>() + ")";
}

py::object positions(const Poses& poses) {
  if (poses.is_one) return arrayOf(tricover::Vec2(poses[0].translation()));
  std::vector<tricover::Vec2> points;
  for (const tricover::Pose& pose : poses.values) points.push_back(pose.translation());
  return arrayOf(points);
}

py::object headings(const Poses& poses) {
  const auto heading = [](const tricover::Pose& pose) { return std::atan2(pose(1, 0), pose(0, 0)); };
  if (poses.is_one) return py::float_(heading(poses[0]));
  return arrayOf<double>(poses.values.size(), [&](std::size_t i) { return heading(poses[i]); });
}

Poses checked(const py::object& matrices) {
  Poses poses = posesFromMatrices(matrices);
  for (std::size_t i = 0; i < poses.values.size(); ++i)
    tricover::checkPose(poses.values[i], poses.is_one ? "matrices" : ("matrices[" + std::to_string(i) + "]").c_str());
  return poses;
}

Poses nearestRigid(const py::object& matrices) {
  Poses poses = posesFromMatrices(matrices);
  for (std::size_t i = 0; i < poses.values.size(); ++i)
    poses.values[i] = tricover::nearestRigid(
        poses.values[i], poses.is_one ? "matrices" : ("matrices[" + std::to_string(i) + "]").c_str());
  return poses;
}

}  // namespace

void definePoses(py::module_& m) {
  py::class_<Poses>(m, "Poses", doc("Poses"))
      .def(py::init([](const py::object& poses) { return posesFrom(poses, "poses", true); }), py::arg("poses"),
           doc("Poses.__init__"))
      .def_static("from_matrices", &checked, py::arg("matrices"), doc("Poses.from_matrices"))
      .def_static("nearest_rigid", &nearestRigid, py::arg("matrices"), doc("Poses.nearest_rigid"))
      .def_property_readonly(
          "is_one", [](const Poses& self) { return self.is_one; }, doc("Poses.is_one"))
      .def_property_readonly("matrices", &matricesOf, doc("Poses.matrices"))
      .def_property_readonly("positions", &positions, doc("Poses.positions"))
      .def_property_readonly("headings", &headings, doc("Poses.headings"))
      .def("__len__",
           [](const Poses& self) {
             if (self.is_one) throw py::type_error("this is one pose, and has no length");
             return self.values.size();
           })
      .def("__getitem__", [](const Poses& self, py::ssize_t i) { return justOne(self.values[indexOf(self, i)]); })
      .def("__getitem__", &some)
      .def(
          "__array__",
          [](const Poses& self, const py::object& type, const py::object&) {
            const py::array_t<double> matrices = matricesOf(self);
            return type.is_none() ? py::object(matrices) : matrices.attr("astype")(type);
          },
          py::arg("dtype") = py::none(), py::arg("copy") = py::none())
      .def(py::pickle([](const Poses& self) { return py::make_tuple(1, matricesOf(self)); },
                      [](const py::tuple& state) {
                        if (state.size() != 2 || state[0].cast<int>() != 1)
                          throw std::invalid_argument("this pickle is of another version of tricover");
                        return posesFromMatrices(state[1]);
                      }))
      .def("__eq__", &same, py::is_operator())
      .def(
          "__ne__", [](const Poses& p, const Poses& q) { return !same(p, q); }, py::is_operator())
      .def("__hash__", &hashOfPoses)
      .def("__repr__", &textOf);
  m.def(
      "pose_at",
      [](double x, double y, double heading) {
        const tricover::Pose pose = tricover::poseAt(x, y, heading);
        tricover::checkPose(pose);
        return justOne(pose);
      },
      py::arg("x"), py::arg("y"), py::arg("heading") = 0.0, doc("pose_at"));
}

}  // namespace tricover_python
