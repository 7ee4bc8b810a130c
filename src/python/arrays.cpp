// SPDX-License-Identifier: BSD-3-Clause
#include "python/arrays.h"

#include <algorithm>
#include <stdexcept>

namespace tricover_python {
namespace {

[[noreturn]] void refuseShape(const std::string& name, const char* wanted, const Array& array,
                              const char* remedy = "") {
  throw std::invalid_argument(name + ": it must have the shape " + wanted + ", not " + shapeOf(array) + remedy);
}

std::string numbered(const std::string& name, bool is_one, std::size_t i) {
  return is_one ? name : name + "[" + std::to_string(i) + "]";
}

/// Poses in a list, one after the other.
Poses joined(const py::sequence& given, const std::string& name) {
  Poses result{{{}, false}};
  for (const py::handle one : given) {
    if (!py::isinstance<Poses>(one)) throw py::type_error(name + ": some of its items are Poses, and some are not");
    const auto& poses = one.cast<const Poses&>().values;
    result.values.insert(result.values.end(), poses.begin(), poses.end());
  }
  return result;
}

}  // namespace

std::string shapeOf(const Array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

Array numbersFrom(const py::object& given, const std::string& name) {
  const std::string type = py::str(py::type::of(given).attr("__name__")).cast<std::string>();
  if (py::isinstance<tricover::Polygon>(given) || py::hasattr(given, "__geo_interface__"))
    throw py::type_error(name + ": it is no array of numbers, but a polygon or another geometry (" + type +
                         "); the order of arguments is a, pose_a, b, pose_b");
  Array array = Array::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(name + ": it is no array of numbers, but a " + type +
                         "; if it is a list, its items may be of different lengths");
  }
  return array;
}

tricover::Vec2 pointFrom(const py::object& given, const std::string& name) {
  const Array array = numbersFrom(given, name);
  if (array.ndim() != 1 || array.shape(0) != 2) refuseShape(name, "(2,)", array);
  return {array.at(0), array.at(1)};
}

std::vector<tricover::Vec2> verticesFrom(const py::object& given, const std::string& name) {
  const Array array = numbersFrom(given, name);
  if (array.ndim() != 2 || array.shape(1) != 2) refuseShape(name, "(n, 2)", array);
  std::vector<tricover::Vec2> points;
  points.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i) points.emplace_back(array.at(i, 0), array.at(i, 1));
  return points;
}

Points pointsFrom(const py::object& given, const std::string& name) {
  const Array array = numbersFrom(given, name);
  if (array.ndim() == 1) return {{pointFrom(array, name)}, true};
  if (array.ndim() != 2 || array.shape(1) != 2) refuseShape(name, "(2,) or (n, 2)", array);
  return {verticesFrom(array, name), false};
}

Poses posesFrom(const py::object& given, const std::string& name, bool three) {
  if (py::isinstance<Poses>(given)) return given.cast<Poses>();
  if ((py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) && py::len(given) > 0 &&
      py::isinstance<Poses>(given[py::int_(0)]))
    return joined(given, name);
  const Array array = numbersFrom(given, name);
  if (!three && array.ndim() == 2 && array.shape(0) == 3 && array.shape(1) == 3 && array.at(2, 0) == 0 &&
      array.at(2, 1) == 0 && array.at(2, 2) == 1)
    throw std::invalid_argument(name + ": it may be a matrix or three poses; give Poses.from_matrices(matrix) or " +
                                "Poses(three)");
  if (array.ndim() < 1 || array.ndim() > 2 || array.shape(array.ndim() - 1) != 3)
    refuseShape(name, "(3,) or (n, 3)", array, "; give matrices as Poses.from_matrices(matrices)");
  Poses result{{{}, array.ndim() == 1}};
  const auto count = static_cast<std::size_t>(result.is_one ? 1 : array.shape(0));
  for (std::size_t i = 0; i < count; ++i) {
    const double* const p = array.data() + 3 * i;
    result.values.push_back(tricover::poseAt(p[0], p[1], p[2]));
    tricover::checkPose(result.values.back(), numbered(name, result.is_one, i).c_str());
  }
  return result;
}

Poses posesFromMatrices(const py::object& given) {
  const Array array = numbersFrom(given, "matrices");
  const py::ssize_t dimensions = array.ndim();
  if (dimensions < 2 || dimensions > 3 || array.shape(dimensions - 1) != 3 || array.shape(dimensions - 2) != 3)
    throw std::invalid_argument("matrices: they must have the shape (3, 3) or (n, 3, 3), not " + shapeOf(array));
  Poses result{{{}, dimensions == 2}};
  const auto count = static_cast<std::size_t>(result.is_one ? 1 : array.shape(0));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = numbered("matrices", result.is_one, i);
    const double* const m = array.data() + 9 * i;
    if (m[6] != 0 || m[7] != 0 || m[8] != 1) throw std::invalid_argument(name + ": its last row is not 0, 0, 1");
    result.values.push_back(tricover::Pose::Identity());
    result.values.back().matrix().topRows<2>() << m[0], m[1], m[2], m[3], m[4], m[5];
  }
  return result;
}

tricover::Pose onePose(const py::object& given, const std::string& name) {
  const Poses poses = posesFrom(given, name);
  if (!poses.is_one)
    throw std::invalid_argument(name + ": one pose is wanted, (3,), and these are " +
                                std::to_string(poses.values.size()) + "; take one of them, as " + name + "[0]");
  return poses[0];
}

py::array_t<double> matricesOf(const Poses& poses) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(poses.values.size()), 3, 3};
  if (poses.is_one) shape.erase(shape.begin());
  py::array_t<double> matrices(shape);
  double* number = matrices.mutable_data();
  for (const tricover::Pose& pose : poses.values)
    for (int i = 0; i < 9; ++i) *number++ = pose(i / 3, i % 3);
  return matrices;
}

py::array_t<double> arrayOf(const tricover::Vec2& point) {
  py::array_t<double> array(2);
  array.mutable_at(0) = point.x();
  array.mutable_at(1) = point.y();
  return array;
}

py::array_t<double> arrayOf(const std::vector<tricover::Vec2>& points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  double* number = array.mutable_data();
  for (const tricover::Vec2& point : points) *number++ = point.x(), *number++ = point.y();
  return array;
}

py::ssize_t hashOf(std::vector<double> numbers) {
  for (double& number : numbers) number += 0.0;
  return py::hash(py::bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)));
}

std::string text(double number) { return py::repr(py::float_(number)).cast<std::string>(); }

std::string text(const tricover::Vec2& point) { return "(" + text(point.x()) + ", " + text(point.y()) + ")"; }

std::string text(const tricover::Pose& pose) {
  const tricover::Vec2 at = pose.translation();
  const double heading = std::atan2(pose(1, 0), pose(0, 0));
  if (tricover::poseAt(at.x(), at.y(), heading).matrix() == pose.matrix())
    return "pose_at(" + text(at.x()) + ", " + text(at.y()) + ", " + text(heading) + ")";
  return "Poses.from_matrices(" + py::repr(matricesOf(justOne(pose)).attr("tolist")()).cast<std::string>() + ")";
}

}  // namespace tricover_python
