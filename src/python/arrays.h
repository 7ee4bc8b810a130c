// SPDX-License-Identifier: BSD-3-Clause
// NumPy's arrays as tricover's points and poses.
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "python/casters.h"

namespace tricover_python {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// "(2, 3)".
std::string shapeOf(const Array& array);
/// An array of doubles.
/// \throws py::type_error, with the name and what to do, for anything else
Array numbersFrom(const py::object& given, const std::string& name);

/// Some operands of a query: one, which serves all, or many.
template <typename Value>
struct Many {
  std::vector<Value> values;
  bool is_one = true;

  const Value& operator[](std::size_t i) const { return values[is_one ? 0 : i]; }
};

using Points = Many<tricover::Vec2>;
struct Poses : Many<tricover::Pose> {};

tricover::Vec2 pointFrom(const py::object& given, const std::string& name);                  ///< (2,)
std::vector<tricover::Vec2> verticesFrom(const py::object& given, const std::string& name);  ///< (n, 2)
Points pointsFrom(const py::object& given, const std::string& name);                         ///< (2,) or (n, 2)

/// Poses, some of them in a list, or an array of x, y and heading: (3,) or (n, 3). One array may be both three poses
/// and a matrix: it is refused unless `three` says that it is three poses.
Poses posesFrom(const py::object& given, const std::string& name, bool three = false);
Poses posesFromMatrices(const py::object& given);  ///< (3, 3) or (n, 3, 3)
tricover::Pose onePose(const py::object& given, const std::string& name);
inline Poses justOne(const tricover::Pose& pose) { return {{{pose}, true}}; }
/// (3, 3) or (n, 3, 3)
py::array_t<double> matricesOf(const Poses& poses);

py::array_t<double> arrayOf(const tricover::Vec2& point);
py::array_t<double> arrayOf(const std::vector<tricover::Vec2>& points);
template <typename Value, typename Of>
py::array_t<Value> arrayOf(std::size_t count, const Of& of) {
  py::array_t<Value> array(static_cast<py::ssize_t>(count));
  Value* const values = array.mutable_data();
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<Value>(of(i));
  return array;
}
/// Of Python's hash() of the bytes of numbers, where -0.0 is 0.0.
py::ssize_t hashOf(std::vector<double> numbers);
/// As Python writes it: the shortest text that gives the same number.
std::string text(double number);
std::string text(const tricover::Vec2& point);
std::string text(const tricover::Pose& pose);

/// The text of a docstring, from the stubs; an error where there is none.
const char* doc(const char* name);

}  // namespace tricover_python
