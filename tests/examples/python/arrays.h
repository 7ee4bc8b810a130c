// SPDX-License-Identifier: BSD-3-Clause
// NumPy's arrays as tricover's points, rings and poses, and batches of queries on threads.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <tricover/polygon.h>
#include <tricover/pose.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tricover_python {

namespace py = pybind11;
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline std::string shapeOf(const Array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  return text + (array.ndim() == 1 ? ",)" : ")");
}

inline tricover::Vec2 pointFrom(const Array& array, const char* name) {
  if (array.ndim() != 1 || array.shape(0) != 2)
    throw std::invalid_argument(std::string(name) + ": it must have the shape (2,), not " + shapeOf(array));
  return {array.at(0), array.at(1)};
}

inline std::vector<tricover::Vec2> pointsFrom(const Array& array, const std::string& name) {
  if (array.ndim() != 2 || array.shape(1) != 2)
    throw std::invalid_argument(name + ": it must have the shape (n, 2), not " + shapeOf(array));
  std::vector<tricover::Vec2> points;
  points.reserve(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i) points.emplace_back(array.at(i, 0), array.at(i, 1));
  return points;
}

/// (n, 2), of one point an array (2,).
inline py::array_t<double> arrayOf(const tricover::Vec2& point) {
  py::array_t<double> array(2);
  array.mutable_at(0) = point.x();
  array.mutable_at(1) = point.y();
  return array;
}
inline py::array_t<double> arrayOf(const std::vector<tricover::Vec2>& points) {
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  std::transform(points.begin(), points.end(), reinterpret_cast<tricover::Vec2*>(array.mutable_data()),
                 [](const tricover::Vec2& point) { return point; });
  return array;
}
template <typename Value, typename Of>
py::array_t<Value> arrayOf(std::size_t count, const Of& of) {
  py::array_t<Value> array(static_cast<py::ssize_t>(count));
  Value* const values = array.mutable_data();
  for (std::size_t i = 0; i < count; ++i) values[i] = of(i);
  return array;
}

/// Poses as a caller gave them: one, or many.
struct Poses {
  std::vector<tricover::Pose> poses;
  bool is_one = true;

  const tricover::Pose& operator[](std::size_t i) const { return poses[is_one ? 0 : i]; }
};

/// x, y and heading: (3,) for one pose, (n, 3) for many.
inline Poses posesFrom(const Array& array, const std::string& name) {
  if (array.ndim() < 1 || array.ndim() > 2 || array.shape(array.ndim() - 1) != 3)
    throw std::invalid_argument(name + ": it must have the shape (3,) or (n, 3), not " + shapeOf(array) +
                                "; give matrices as Poses.from_matrices(matrices)");
  Poses result{{}, array.ndim() == 1};
  const auto count = static_cast<std::size_t>(result.is_one ? 1 : array.shape(0));
  for (std::size_t i = 0; i < count; ++i) {
    const double* const p = array.data() + 3 * i;
    result.poses.emplace_back(Eigen::Translation2d(p[0], p[1]) * Eigen::Rotation2Dd(p[2]));
    tricover::checkPose(result.poses.back(), (result.is_one ? name : name + "[" + std::to_string(i) + "]").c_str());
  }
  return result;
}

/// Homogeneous matrices: (3, 3) for one pose, (n, 3, 3) for many.
inline Poses posesFromMatrices(const Array& array) {
  const py::ssize_t dimensions = array.ndim();
  if (dimensions < 2 || dimensions > 3 || array.shape(dimensions - 1) != 3 || array.shape(dimensions - 2) != 3)
    throw std::invalid_argument("matrices: they must have the shape (3, 3) or (n, 3, 3), not " + shapeOf(array));
  Poses result{{}, dimensions == 2};
  const auto count = static_cast<std::size_t>(result.is_one ? 1 : array.shape(0));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = result.is_one ? "matrices" : "matrices[" + std::to_string(i) + "]";
    const double* const m = array.data() + 9 * i;
    if (m[6] != 0 || m[7] != 0 || m[8] != 1) throw std::invalid_argument(name + ": its last row is not 0, 0, 1");
    result.poses.push_back(tricover::Pose::Identity());
    result.poses.back().matrix().topRows<2>() << m[0], m[1], m[2], m[3], m[4], m[5];
    tricover::checkPose(result.poses.back(), name.c_str());
  }
  return result;
}

/// Poses, or an array of x, y and heading. One array may be both three poses and a matrix: it is refused.
inline Poses posesFrom(const py::object& given, const std::string& name) {
  if (py::isinstance<Poses>(given)) return given.cast<Poses>();
  const Array array = Array::ensure(given);
  if (!array) throw py::type_error(name + ": it is no array of numbers");
  if (array.ndim() == 2 && array.shape(0) == 3 && array.shape(1) == 3 && array.at(2, 0) == 0 && array.at(2, 1) == 0 &&
      array.at(2, 2) == 1)
    throw std::invalid_argument(name + ": it may be a matrix or three poses; give Poses.from_matrices(matrix) or " +
                                "Poses(three)");
  return posesFrom(array, name);
}

inline tricover::Pose onePose(const py::object& given, const char* name) {
  const Poses poses = posesFrom(given, name);
  if (!poses.is_one) throw std::invalid_argument(std::string(name) + ": one pose is wanted");
  return poses[0];
}

/// How many queries two sets of poses are.
inline std::size_t countOf(const Poses& a, const Poses& b, const char* name_a = "pose_a",
                           const char* name_b = "pose_b") {
  if (!a.is_one && !b.is_one && a.poses.size() != b.poses.size())
    throw std::invalid_argument(std::string(name_b) + ": there are " + std::to_string(b.poses.size()) + ", but of " +
                                name_a + " " + std::to_string(a.poses.size()));
  return a.is_one ? b.poses.size() : a.poses.size();
}

/// tricover::Parallel on so many threads, 0: as many as there are processors. The error of the first task that has one
/// is thrown on. Doesn't need the GIL.
inline void inParallel(std::size_t threads, std::size_t count, const std::function<void(std::size_t)>& task) {
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = std::min(threads, count);
  std::vector<std::exception_ptr> errors(count);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        errors[i] = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

/// Calls query(i) for every i in [0, count) on threads, some hundreds to a task, while other Python threads run.
template <typename Query>
void forEachInParallel(std::size_t count, std::size_t threads, const Query& query) {
  const py::gil_scoped_release released;
  constexpr std::size_t kEach = 256;
  inParallel(threads, (count + kEach - 1) / kEach, [&](std::size_t task) {
    for (std::size_t i = task * kEach; i < std::min(count, (task + 1) * kEach); ++i) query(i);
  });
}

}  // namespace tricover_python
