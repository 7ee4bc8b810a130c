// SPDX-License-Identifier: BSD-3-Clause
// Polygons, and queries about two polygons, one pose or many at once.
#include <pybind11/stl.h>
#include <tricover/occupancy_grid_io.h>
#include <tricover/tricover.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "arrays.h"
#include "module.h"

namespace tricover_python {
namespace {

using tricover::Polygon;

/// One answer, or a list of them.
template <typename Answers, typename Convert>
py::object listOf(bool is_one, const Answers& answers, const Convert& convert) {
  if (is_one) return convert(answers[0]);
  py::list list;
  for (const auto& answer : answers) list.append(convert(answer));
  return std::move(list);
}

Polygon polygonFrom(const py::object& rings, tricover::FillRule rule) {
  // One ring, or a sequence of them, which together are no array of two dimensions.
  if (const Array one = Array::ensure(rings); one && one.ndim() == 2) {
    const tricover::Ring ring = pointsFrom(one, "rings");
    return Polygon(ring.data(), ring.size(), rule);
  }
  std::vector<tricover::Ring> result;
  for (const py::handle ring : py::iter(rings)) {
    const std::string name = "rings[" + std::to_string(result.size()) + "]";
    const Array vertices = Array::ensure(ring);
    if (!vertices) throw std::invalid_argument(name + ": it is no array of numbers");
    result.push_back(pointsFrom(vertices, name));
  }
  return Polygon(result, rule);
}

void definePolygon(py::module_& m) {
  py::enum_<tricover::Simplify>(m, "Simplify")
      .value("BOTH", tricover::Simplify::Both)
      .value("OUTWARDS", tricover::Simplify::Outwards);
  py::enum_<tricover::FillRule>(m, "FillRule")
      .value("EVEN_ODD", tricover::FillRule::EvenOdd)
      .value("NON_ZERO", tricover::FillRule::NonZero);
  py::class_<Polygon>(m, "Polygon", "A closed planar region of rings, arrays (n, 2). It never changes.")
      .def(py::init(&polygonFrom), py::arg("rings"), py::arg("fill_rule") = tricover::FillRule::EvenOdd)
      .def_property_readonly("rings",
                             [](const Polygon& polygon) {
                               py::list rings;
                               for (const tricover::Ring& ring : polygon.rings()) rings.append(arrayOf(ring));
                               return rings;
                             })
      .def_property_readonly("fill_rule", &Polygon::fillRule)
      .def_property_readonly("vertex_count", &Polygon::vertexCount)
      .def_property_readonly("is_complement", &Polygon::isComplement)
      .def("complement", &Polygon::complement)
      .def_property_readonly("origin", [](const Polygon& polygon) { return arrayOf(polygon.coveringOrigin()); })
      .def_property_readonly("radius", &Polygon::radius)
      .def_property_readonly("area", &Polygon::area)
      .def_property_readonly("centroid", [](const Polygon& polygon) { return arrayOf(polygon.centroid()); })
      .def_property_readonly("bounds",
                             [](const Polygon& polygon) {
                               const auto box = polygon.bounds();
                               return arrayOf(std::vector<tricover::Vec2>{box.min(), box.max()});
                             })
      .def_property_readonly("is_convex", &Polygon::isConvex)
      .def(
          "translated", [](const Polygon& polygon, const Array& by) { return polygon.translated(pointFrom(by, "by")); },
          py::arg("by"))
      .def("scaled", &Polygon::scaled, py::arg("factor"))
      .def(
          "transformed",
          [](const Polygon& polygon, const py::object& pose) { return polygon.transformed(onePose(pose, "pose")); },
          py::arg("pose"))
      .def(
          "bounds_at",
          [](const Polygon& polygon, const py::object& pose) {
            const auto box = polygon.bounds(onePose(pose, "pose"));
            return arrayOf(std::vector<tricover::Vec2>{box.min(), box.max()});
          },
          py::arg("pose"))
      .def("simplified", &Polygon::simplified, py::arg("tolerance"), py::arg("side") = tricover::Simplify::Both,
           py::call_guard<py::gil_scoped_release>())
      .def("edge",
           [](const Polygon& polygon, tricover::EdgeIndex edge) {
             return arrayOf(std::vector<tricover::Vec2>{polygon.edgeStart(edge), polygon.edgeEnd(edge)});
           })
      .def("__repr__", [](const Polygon& polygon) {
        return "<tricover.Polygon of " + std::to_string(polygon.vertexCount()) + " vertices>";
      });
  m.def(
      "point", [](const Array& p) { return tricover::Polygon::point(pointFrom(p, "p")); }, py::arg("p"));
  m.def(
      "segment",
      [](const Array& p, const Array& q) { return tricover::Polygon::segment(pointFrom(p, "p"), pointFrom(q, "q")); },
      py::arg("p"), py::arg("q"));
  m.def("box", &Polygon::box, py::arg("width"), py::arg("height"));
}

void defineMaps(py::module_& m) {
  m.def(
      "outline",
      // To bool, as NumPy casts: true unless it is 0. To int8, 0.9 and 256 were 0.
      [](const py::array_t<bool, py::array::c_style | py::array::forcecast>& cells, double resolution,
         const Array& origin) {
        if (cells.ndim() != 2) throw std::invalid_argument("cells: they must have the shape (height, width)");
        tricover::OccupancyGrid grid;
        grid.height = static_cast<std::size_t>(cells.shape(0));
        grid.width = static_cast<std::size_t>(cells.shape(1));
        grid.cells.assign(cells.data(), cells.data() + cells.size());
        grid.resolution = resolution;
        grid.origin = pointFrom(origin, "origin");
        return tricover::outline(grid);
      },
      py::arg("cells"), py::arg("resolution") = 1.0, py::arg("origin") = std::vector<double>{0, 0});
  m.def(
      "read_occupancy_map",
      [](const std::string& yaml) {
        const tricover::OccupancyMap map = tricover::readOccupancyMap(yaml);
        py::array_t<std::int8_t> cells(
            {static_cast<py::ssize_t>(map.grid.height), static_cast<py::ssize_t>(map.grid.width)});
        std::copy(map.grid.cells.begin(), map.grid.cells.end(), cells.mutable_data());
        return py::make_tuple(cells, map.grid.resolution, Poses{{map.pose}, true});
      },
      py::arg("yaml"));
}

void definePoses(py::module_& m) {
  m.def(
      "pose",
      [](double x, double y, double heading) {
        const Poses poses{{tricover::poseAt(x, y, heading)}, true};
        tricover::checkPose(poses[0]);
        return poses;
      },
      py::arg("x"), py::arg("y"), py::arg("heading") = 0.0);
  py::class_<Poses>(m, "Poses", "Poses, one or many, of x, y and heading: (3,) or (n, 3).")
      .def(py::init([](const Array& poses) { return posesFrom(poses, "poses"); }), py::arg("poses"))
      .def_static("from_matrices", &posesFromMatrices, py::arg("matrices"))
      .def(
          "__array__",
          [](const Poses& self, const py::object& type, const py::object&) {
            std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(self.poses.size()), 3, 3};
            if (self.is_one) shape.erase(shape.begin());
            py::array_t<double> matrices(shape);
            double* number = matrices.mutable_data();
            for (const tricover::Pose& pose : self.poses)
              for (int i = 0; i < 9; ++i) *number++ = pose(i / 3, i % 3);
            return type.is_none() ? py::object(matrices) : matrices.attr("astype")(type);
          },
          py::arg("dtype") = py::none(), py::arg("copy") = py::none());
}

/// Yes or no for each pair of poses.
template <typename Query>
py::object ofPoses(const py::object& pose_a, const char* name_a, const py::object& pose_b, const char* name_b,
                   std::size_t threads, const Query& query) {
  const Poses poses_a = posesFrom(pose_a, name_a), poses_b = posesFrom(pose_b, name_b);
  if (poses_a.is_one && poses_b.is_one) return py::bool_(query(poses_a[0], poses_b[0]));
  const std::size_t count = countOf(poses_a, poses_b, name_a, name_b);
  py::array_t<bool> answers(static_cast<py::ssize_t>(count));
  bool* const answer = answers.mutable_data();
  forEachInParallel(count, threads, [&](std::size_t i) { answer[i] = query(poses_a[i], poses_b[i]); });
  return std::move(answers);
}

void defineBooleans(py::module_& m) {
  py::enum_<tricover::Touching>(m, "Touching")
      .value("COLLIDES", tricover::Touching::Collides)
      .value("ALLOWED", tricover::Touching::Allowed);
  m.def(
      "collide",
      [](const Polygon& a, const py::object& pose_a, const Polygon& b, const py::object& pose_b, double margin,
         double tolerance, tricover::Touching touching, std::size_t threads) -> py::object {
        return ofPoses(pose_a, "pose_a", pose_b, "pose_b", threads, [&](const auto& at_a, const auto& at_b) {
          return collide(a, at_a, b, at_b, {margin, tolerance, touching});
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("tolerance") = 0.0, py::arg("touching") = tricover::Touching::Collides, py::arg("threads") = 0);
  m.def(
      "covers",
      [](const Polygon& area, const py::object& pose_area, const Polygon& part, const py::object& pose_part,
         double margin, std::size_t threads) {
        return ofPoses(
            pose_area, "pose_area", pose_part, "pose_part", threads,
            [&](const auto& at_area, const auto& at_part) { return covers(area, at_area, part, at_part, {margin}); });
      },
      py::arg("area"), py::arg("pose_area"), py::arg("part"), py::arg("pose_part"), py::arg("margin") = 0.0,
      py::arg("threads") = 0);
  // An int for Python, so that the arrays of locate() compare with it.
  const py::dict locations(py::arg("OUTSIDE") = static_cast<int>(tricover::Location::Outside),
                           py::arg("BOUNDARY") = static_cast<int>(tricover::Location::Boundary),
                           py::arg("INSIDE") = static_cast<int>(tricover::Location::Inside));
  const py::object location =
      py::module_::import("enum").attr("IntEnum")("Location", locations, py::arg("module") = "tricover");
  m.attr("Location") = location;
  m.def(
      "locate",
      [location](const Polygon& polygon, const Array& points, std::size_t threads) -> py::object {
        if (points.ndim() == 1)
          return location(static_cast<int>(tricover::locate(polygon, pointFrom(points, "points"))));
        const std::vector<tricover::Vec2> given = pointsFrom(points, "points");
        py::array_t<std::int8_t> answers(static_cast<py::ssize_t>(given.size()));
        std::int8_t* const answer = answers.mutable_data();
        forEachInParallel(given.size(), threads, [&](std::size_t i) {
          answer[i] = static_cast<std::int8_t>(tricover::locate(polygon, given[i]));
        });
        return std::move(answers);
      },
      py::arg("polygon"), py::arg("points"), py::arg("threads") = 0);
}

void defineMeasures(py::module_& m, const Records& records) {
  m.def(
      "distance",
      [records](const Polygon& a, const py::object& pose_a, const Polygon& b, const py::object& pose_b, double margin,
                std::size_t threads) {
        const Poses poses_a = posesFrom(pose_a, "pose_a"), poses_b = posesFrom(pose_b, "pose_b");
        std::vector<tricover::DistanceResult> found(countOf(poses_a, poses_b));
        forEachInParallel(found.size(), threads,
                          [&](std::size_t i) { found[i] = distance(a, poses_a[i], b, poses_b[i], {margin}); });
        if (poses_a.is_one && poses_b.is_one) return records.of(found[0]);
        return records.of(found);
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("threads") = 0);
  m.def(
      "penetration",
      [records](const Polygon& a, const py::object& pose_a, const Polygon& b, const py::object& pose_b, double margin,
                tricover::Touching touching, std::size_t threads) {
        const Poses poses_a = posesFrom(pose_a, "pose_a"), poses_b = posesFrom(pose_b, "pose_b");
        std::vector<std::optional<tricover::Penetration>> found(countOf(poses_a, poses_b));
        forEachInParallel(found.size(), threads, [&](std::size_t i) {
          found[i] = penetration(a, poses_a[i], b, poses_b[i], {margin, touching});
        });
        return listOf(poses_a.is_one && poses_b.is_one, found, [&](const auto& one) { return records.of(one); });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("touching") = tricover::Touching::Collides, py::arg("threads") = 0);
}

void defineSignedDistance(py::module_& m, const Records& records) {
  m.def(
      "signed_distance",
      [records](const Polygon& a, const py::object& pose_a, const Polygon& b, const py::object& pose_b, double margin,
                std::size_t threads) {
        const Poses poses_a = posesFrom(pose_a, "pose_a"), poses_b = posesFrom(pose_b, "pose_b");
        std::vector<tricover::SignedDistance> found(countOf(poses_a, poses_b));
        forEachInParallel(found.size(), threads,
                          [&](std::size_t i) { found[i] = signedDistance(a, poses_a[i], b, poses_b[i], {margin}); });
        return listOf(poses_a.is_one && poses_b.is_one, found, [&](const auto& one) { return records.of(one); });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("threads") = 0);
}

void defineContacts(py::module_& m, const Records& records) {
  py::enum_<tricover::ContactDetail>(m, "ContactDetail")
      .value("POINTS", tricover::ContactDetail::Points)
      .value("LOCAL_DEPTH", tricover::ContactDetail::LocalDepth)
      .value("GLOBAL_DEPTH", tricover::ContactDetail::GlobalDepth);
  m.def(
      "contacts",
      [records](const Polygon& a, const py::object& pose_a, const Polygon& b, const py::object& pose_b, double margin,
                std::optional<std::size_t> most, tricover::ContactDetail detail, tricover::Touching touching,
                std::size_t threads) {
        const Poses poses_a = posesFrom(pose_a, "pose_a"), poses_b = posesFrom(pose_b, "pose_b");
        tricover::ContactOptions options;
        options.margin = margin;
        if (most) options.most = *most;
        options.detail = detail;
        options.touching = touching;
        std::vector<std::vector<tricover::Contact>> found(countOf(poses_a, poses_b));
        forEachInParallel(found.size(), threads,
                          [&](std::size_t i) { found[i] = contacts(a, poses_a[i], b, poses_b[i], options); });
        return listOf(poses_a.is_one && poses_b.is_one, found, [&](const auto& parts) {
          py::list list;
          for (const tricover::Contact& part : parts) list.append(records.of(part));
          return py::object(list);
        });
      },
      py::arg("a"), py::arg("pose_a"), py::arg("b"), py::arg("pose_b"), py::arg("margin") = 0.0,
      py::arg("most") = py::none(), py::arg("detail") = tricover::ContactDetail::LocalDepth,
      py::arg("touching") = tricover::Touching::Collides, py::arg("threads") = 0);
}

void defineRays(py::module_& m, const Records& records) {
  m.def(
      "cast_ray",
      [records](const Polygon& polygon, const py::object& pose, const Array& from, const Array& to, double margin) {
        return records.of(castRay(polygon, onePose(pose, "pose"), pointFrom(from, "from_point"),
                                  pointFrom(to, "to_point"), {margin}));
      },
      py::arg("polygon"), py::arg("pose"), py::arg("from_point"), py::arg("to_point"), py::arg("margin") = 0.0);
  m.def(
      "cast_ray_all",
      [records](const Polygon& polygon, const py::object& pose, const Array& from, const Array& to, double margin) {
        py::list list;
        for (const auto& interval : castRayAll(polygon, onePose(pose, "pose"), pointFrom(from, "from_point"),
                                               pointFrom(to, "to_point"), {margin}))
          list.append(records.of(interval));
        return list;
      },
      py::arg("polygon"), py::arg("pose"), py::arg("from_point"), py::arg("to_point"), py::arg("margin") = 0.0);
}

}  // namespace

void definePairs(py::module_& m, const Records& records) {
  definePolygon(m);
  definePoses(m);
  defineMaps(m);
  defineBooleans(m);
  defineMeasures(m, records);
  defineSignedDistance(m, records);
  defineContacts(m, records);
  defineRays(m, records);
}

}  // namespace tricover_python
