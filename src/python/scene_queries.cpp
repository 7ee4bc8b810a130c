// SPDX-License-Identifier: BSD-3-Clause
// What a polygon under a pose, or many, or a ray, meets in a Scene.
#include <pybind11/stl.h>

#include "python/scene_filter.h"

namespace tricover_python {
namespace {

using tricover::Scene;
using tricover::Touching;

/// Whether, or which bodies, collide: alike but for the query.
template <typename Query>
void defineColliding(py::class_<Scene>& scene, const char* name, const char* documented, const Query& query) {
  scene.def(
      name,
      [query](const Scene& self, const Shape& polygon, const py::object& pose, double margin, double tolerance,
              Mask mask, std::optional<Body> ignored, Touching touching, std::size_t threads) {
        const Poses poses = posesFrom(pose, "pose");
        const tricover::BodyFilter filter = filterFrom(mask, ignored);
        return Count().of(poses, "pose").answers(threads, kCheap, [&](std::size_t i) {
          return query(self, polygon, poses[i], tricover::CollideOptions{margin, tolerance, touching}, filter);
        });
      },
      py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("tolerance") = 0.0, py::arg("mask") = kAll,
      py::arg("ignored") = py::none(), py::arg("touching") = Touching::Collides, py::arg("threads") = 0,
      doc(documented));
}

void defineBooleans(py::class_<Scene>& scene) {
  using tricover::BodyFilter, tricover::CollideOptions, tricover::Polygon, tricover::Pose;
  defineColliding(scene, "collides", "Scene.collides",
                  [](const Scene& self, const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) { return self.collides(polygon, pose, options, filter); });
  defineColliding(scene, "any_colliding", "Scene.any_colliding",
                  [](const Scene& self, const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) { return self.anyColliding(polygon, pose, options, filter); });
  defineColliding(scene, "colliding", "Scene.colliding",
                  [](const Scene& self, const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) { return self.colliding(polygon, pose, options, filter); });
  scene.def(
      "covers",
      [](const Scene& self, const Shape& polygon, const py::object& pose, double margin, Mask mask,
         std::optional<Body> ignored, std::size_t threads) {
        const Poses poses = posesFrom(pose, "pose");
        const BodyFilter filter = filterFrom(mask, ignored);
        return Count().of(poses, "pose").answers(threads, kDear, [&](std::size_t i) {
          return self.covers(polygon, poses[i], {margin}, filter);
        });
      },
      py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
      py::arg("ignored") = py::none(), py::arg("threads") = 0, doc("Scene.covers"));
}

void defineNearest(py::class_<Scene>& scene) {
  scene
      .def(
          "nearest",
          [](const Scene& self, const Shape& polygon, const py::object& pose, double margin, double relative_error,
             double absolute_error, Mask mask, std::optional<Body> ignored, std::size_t threads) {
            const Poses poses = posesFrom(pose, "pose");
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            return Count().of(poses, "pose").answers(threads, kCheap, [&](std::size_t i) {
              return self.nearest(polygon, poses[i], {margin, relative_error, absolute_error}, filter);
            });
          },
          py::arg("polygon"), py::arg("pose"), py::arg("margin") = 0.0, py::arg("relative_error") = 0.0,
          py::arg("absolute_error") = 0.0, py::arg("mask") = kAll, py::arg("ignored") = py::none(),
          py::arg("threads") = 0, doc("Scene.nearest"))
      .def(
          "nearest_within",
          [](const Scene& self, const Shape& polygon, const py::object& pose, double limit, double margin,
             double relative_error, double absolute_error, Mask mask, std::optional<Body> ignored,
             std::size_t threads) {
            const Poses poses = posesFrom(pose, "pose");
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            return Count().of(poses, "pose").answers(threads, kCheap, [&](std::size_t i) {
              return self.nearestWithin(polygon, poses[i], limit, {margin, relative_error, absolute_error}, filter);
            });
          },
          py::arg("polygon"), py::arg("pose"), py::arg("limit"), py::arg("margin") = 0.0,
          py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none(), py::arg("threads") = 0, doc("Scene.nearest_within"))
      .def(
          "nearest_k",
          [](const Scene& self, const Shape& polygon, const py::object& pose, std::size_t most, double limit,
             double margin, double relative_error, double absolute_error, Mask mask, std::optional<Body> ignored,
             std::size_t threads) {
            const Poses poses = posesFrom(pose, "pose");
            const tricover::BodyFilter filter = filterFrom(mask, ignored);
            return Count().of(poses, "pose").answers(threads, kCheap, [&](std::size_t i) {
              return self.nearestK(polygon, poses[i], most, limit, {margin, relative_error, absolute_error}, filter);
            });
          },
          py::arg("polygon"), py::arg("pose"), py::arg("most"),
          py::arg("limit") = std::numeric_limits<double>::infinity(), py::arg("margin") = 0.0,
          py::arg("relative_error") = 0.0, py::arg("absolute_error") = 0.0, py::arg("mask") = kAll,
          py::arg("ignored") = py::none(), py::arg("threads") = 0, doc("Scene.nearest_k"));
}

/// Scene::castRay() or castRayAll().
template <typename Cast>
void defineRay(py::class_<Scene>& scene, const char* name, const char* documented, const Cast& cast) {
  scene.def(
      name,
      [cast](const Scene& self, const py::object& from_point, const py::object& to_point, double margin, Mask mask,
             std::optional<Body> ignored, std::size_t threads) {
        const Points from = pointsFrom(from_point, "from_point"), to = pointsFrom(to_point, "to_point");
        const tricover::BodyFilter filter = filterFrom(mask, ignored);
        return Count().of(from, "from_point").of(to, "to_point").answers(threads, kCheap, [&](std::size_t i) {
          return cast(self, from[i], to[i], {margin}, filter);
        });
      },
      py::arg("from_point"), py::arg("to_point"), py::arg("margin") = 0.0, py::arg("mask") = kAll,
      py::arg("ignored") = py::none(), py::arg("threads") = 0, doc(documented));
}

}  // namespace

void defineSceneQueries(py::class_<Scene>& scene) {
  using tricover::BodyFilter, tricover::RayOptions, tricover::Vec2;
  defineBooleans(scene);
  defineNearest(scene);
  defineRay(scene, "cast_ray", "Scene.cast_ray",
            [](const Scene& self, const Vec2& from, const Vec2& to, const RayOptions& options,
               const BodyFilter& filter) { return self.castRay(from, to, options, filter); });
  defineRay(scene, "cast_ray_all", "Scene.cast_ray_all",
            [](const Scene& self, const Vec2& from, const Vec2& to, const RayOptions& options,
               const BodyFilter& filter) { return self.castRayAll(from, to, options, filter); });
}

}  // namespace tricover_python
