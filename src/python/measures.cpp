// SPDX-License-Identifier: BSD-3-Clause
// How far, and how deep.
#include "python/of_poses.h"

namespace tricover_python {
namespace {

void defineDistances(py::module_& m) {
  m.def(
      "distance",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         double relative_error, double absolute_error, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kCheap, [&](const auto& at_a, const auto& at_b) {
          return tricover::distance(a, at_a, b, at_b, {margin, relative_error, absolute_error});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("threads") = 0, doc("distance"));
  m.def(
      "distance_within",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double limit,
         double margin, double relative_error, double absolute_error, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kCheap, [&](const auto& at_a, const auto& at_b) {
          return tricover::distanceWithin(a, at_a, b, at_b, limit, {margin, relative_error, absolute_error});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("limit"), py::arg("margin") = 0.0,
      py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("threads") = 0, doc("distance_within"));
  m.def(
      "signed_distance",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         double relative_error, double absolute_error, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kDear, [&](const auto& at_a, const auto& at_b) {
          return tricover::signedDistance(a, at_a, b, at_b, {margin, relative_error, absolute_error});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("threads") = 0, doc("signed_distance"));
}

/// A query of two posed polygons without options.
template <typename Query>
void definePlain(py::module_& m, const char* name, const char* a_name, const char* b_name, const Query& query) {
  const std::string pose_a_name = std::string("pose_") + a_name, pose_b_name = std::string("pose_") + b_name;
  m.def(
      name,
      [=](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, std::size_t threads) {
        const auto at = [&](const tricover::Pose& at_a, const tricover::Pose& at_b) { return query(a, at_a, b, at_b); };
        return ofPoses(pose_a, pose_b, threads, kDear, at, pose_a_name, pose_b_name);
      },
      py::arg(a_name), py::arg(pose_a_name.c_str()), py::arg(b_name), py::arg(pose_b_name.c_str()),
      py::arg("threads") = 0, doc(name));
}

}  // namespace

void defineMeasures(py::module_& m) {
  using tricover::Polygon, tricover::Pose;
  defineDistances(m);
  m.def(
      "penetration",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         tricover::Touching touching, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kDear, [&](const auto& at_a, const auto& at_b) {
          return tricover::penetration(a, at_a, b, at_b, {margin, touching});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("touching") = tricover::Touching::Collides, py::arg("threads") = 0, doc("penetration"));
  definePlain(m, "depth", "a", "b", [](const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
    return tricover::depth(a, pose_a, b, pose_b);
  });
  definePlain(m, "excess", "part", "area",
              [](const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area) {
                return tricover::excess(part, pose_part, area, pose_area);
              });
  definePlain(m, "hausdorff_distance", "a", "b",
              [](const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
                return tricover::hausdorffDistance(a, pose_a, b, pose_b);
              });
}

}  // namespace tricover_python
