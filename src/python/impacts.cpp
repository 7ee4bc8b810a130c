// SPDX-License-Identifier: BSD-3-Clause
// When two polygons meet on their way, of motions or of trajectories, one pair or many.
#include "python/ways.h"

namespace tricover_python {
namespace {

/// The answers of query(way_a, way_b), which takes two motions or two trajectories.
template <typename Query>
py::object ofWays(const py::object& motion_a, const py::object& motion_b, std::size_t threads, const Query& query) {
  Way a = wayFrom(motion_a, "motion_a"), b = wayFrom(motion_b, "motion_b");
  makeAlike(a, b, "motion_a", "motion_b");
  const auto of = [&](const auto& ways_a, const auto& ways_b) {
    return Count().of(ways_a, "motion_a").of(ways_b, "motion_b").answers(threads, kDear, [&](std::size_t i) {
      return query(ways_a[i], ways_b[i]);
    });
  };
  return a.trajectories.values.empty() ? of(a.motions, b.motions) : of(a.trajectories, b.trajectories);
}

}  // namespace

void defineImpacts(py::module_& m) {
  m.def(
      "time_of_impact",
      [](const Shape& a, const py::object& motion_a, const Shape& b, const py::object& motion_b, double margin,
         double time_error, bool ignore_initial, std::size_t threads) {
        return ofWays(motion_a, motion_b, threads, [&](const auto& on_a, const auto& on_b) {
          return tricover::timeOfImpact(a, on_a, b, on_b, {margin, time_error, ignore_initial});
        });
      },
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("margin") = 0.0,
      py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false, py::arg("threads") = 0, doc("time_of_impact"));
  m.def(
      "conflicts",
      [](const Shape& a, const py::object& motion_a, const Shape& b, const py::object& motion_b, double margin,
         double time_error, bool ignore_initial, std::size_t threads) {
        return ofWays(motion_a, motion_b, threads, [&](const auto& on_a, const auto& on_b) {
          return tricover::conflicts(a, on_a, b, on_b, {margin, time_error, ignore_initial});
        });
      },
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("margin") = 0.0,
      py::arg("time_error") = 1e-6, py::arg("ignore_initial") = false, py::arg("threads") = 0, doc("conflicts"));
  m.def(
      "least_distance",
      [](const Shape& a, const py::object& motion_a, const Shape& b, const py::object& motion_b, double margin,
         double absolute_error, std::size_t threads) {
        return ofWays(motion_a, motion_b, threads, [&](const auto& on_a, const auto& on_b) {
          return tricover::leastDistance(a, on_a, b, on_b, {margin, absolute_error});
        });
      },
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::arg("margin") = 0.0,
      py::arg("absolute_error") = 1e-6, py::arg("threads") = 0, doc("least_distance"));
}

}  // namespace tricover_python
