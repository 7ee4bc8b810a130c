// SPDX-License-Identifier: BSD-3-Clause
// Yes or no, contacts, and rays.
#include <pybind11/stl.h>

#include "python/of_poses.h"

namespace tricover_python {
namespace {

using tricover::Touching;

void defineBooleans(py::module_& m) {
  m.def(
      "collide",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         double tolerance, Touching touching, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kCheap, [&](const auto& at_a, const auto& at_b) {
          return tricover::collide(a, at_a, b, at_b, {margin, tolerance, touching});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("tolerance") = 0.0, py::arg("touching") = Touching::Collides, py::arg("threads") = 0, doc("collide"));
  m.def(
      "covers",
      [](const Shape& area, const py::object& pose_area, const Shape& part, const py::object& pose_part, double margin,
         std::size_t threads) {
        const auto at = [&](const tricover::Pose& at_area, const tricover::Pose& at_part) {
          return tricover::covers(area, at_area, part, at_part, {margin});
        };
        return ofPoses(pose_area, pose_part, threads, kDear, at, "pose_area", "pose_part");
      },
      py::arg("area"), py::arg("pose_area"), py::arg("part"), py::arg("pose_part"), py::arg("margin") = 0.0,
      py::arg("threads") = 0, doc("covers"));
}

void defineLocate(py::module_& m) {
  m.def(
      "locate",
      [](const Shape& polygon, const py::object& points, std::size_t threads) {
        const Points at = pointsFrom(points, "points");
        return Count().of(at, "points").answers(threads, kCheap, [&](std::size_t i) {
          return tricover::locate(polygon, at[i]);
        });
      },
      py::arg("polygon"), py::arg("points"), py::arg("threads") = 0, doc("locate"));
  m.def(
      "locate",
      [](const Shape& polygon, const py::object& pose, const py::object& points, std::size_t threads) {
        const Poses poses = posesFrom(pose, "pose");
        const Points at = pointsFrom(points, "points");
        return Count().of(poses, "pose").of(at, "points").answers(threads, kCheap, [&](std::size_t i) {
          return tricover::locate(polygon, poses[i], at[i]);
        });
      },
      py::arg("polygon"), py::arg("pose"), py::arg("points"), py::arg("threads") = 0);
}

void defineContacts(py::module_& m) {
  m.def(
      "contacts",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         std::optional<std::size_t> most, tricover::ContactDetail detail, Touching touching, std::size_t threads) {
        tricover::ContactOptions options;
        options.margin = margin;
        options.most = most.value_or(options.most);
        options.detail = detail;
        options.touching = touching;
        return ofPoses(pose_a, pose_b, threads, kDear, [&](const auto& at_a, const auto& at_b) {
          return tricover::contacts(a, at_a, b, at_b, options);
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("most") = py::none(), py::arg("detail") = tricover::ContactDetail::LocalDepth,
      py::arg("touching") = Touching::Collides, py::arg("threads") = 0, doc("contacts"));
  m.def(
      "crossings",
      [](const Shape& a, const py::object& pose_a, const Shape& b, const py::object& pose_b, double margin,
         Touching touching, std::size_t threads) {
        return ofPoses(pose_a, pose_b, threads, kDear, [&](const auto& at_a, const auto& at_b) {
          return tricover::crossings(a, at_a, b, at_b, {margin, touching});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("touching") = Touching::Collides, py::arg("threads") = 0, doc("crossings"));
}

/// castRay() or castRayAll().
template <typename Cast>
void defineRay(py::module_& m, const char* name, const Cast& cast) {
  m.def(
      name,
      [cast](const Shape& polygon, const py::object& pose, const py::object& from_point, const py::object& to_point,
             double margin, std::size_t threads) {
        const Poses at = posesFrom(pose, "pose");
        const Points from = pointsFrom(from_point, "from_point"), to = pointsFrom(to_point, "to_point");
        return Count()
            .of(at, "pose")
            .of(from, "from_point")
            .of(to, "to_point")
            .answers(threads, kCheap, [&](std::size_t i) { return cast(polygon, at[i], from[i], to[i], margin); });
      },
      py::arg("polygon"), py::arg("pose"), py::arg("from_point"), py::arg("to_point"), py::arg("margin") = 0.0,
      py::arg("threads") = 0, doc(name));
}

}  // namespace

void definePairs(py::module_& m) {
  using tricover::Polygon, tricover::Pose, tricover::Vec2;
  defineBooleans(m);
  defineLocate(m);
  defineContacts(m);
  defineRay(m, "cast_ray",
            [](const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to, double margin) {
              return tricover::castRay(polygon, pose, from, to, {margin});
            });
  defineRay(m, "cast_ray_all",
            [](const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to, double margin) {
              return tricover::castRayAll(polygon, pose, from, to, {margin});
            });
}

}  // namespace tricover_python
