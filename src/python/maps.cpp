// SPDX-License-Identifier: BSD-3-Clause
// Grids of cells, and ROS's maps.
#include <pybind11/stl.h>
#include <tricover/occupancy_grid_io.h>
#include <tricover/rasterize.h>

#include <algorithm>
#include <utility>

#include "python/module.h"

namespace tricover_python {
namespace {

using tricover::OccupancyMap;
/// True unless it is 0, as NumPy casts. To int8, 0.9 and 256 were 0.
using Bits = py::array_t<bool, py::array::c_style | py::array::forcecast>;
using Bytes = py::array_t<std::int8_t, py::array::c_style>;

template <typename Cells>
tricover::OccupancyGrid gridOf(const Cells& cells, double resolution, const py::object& origin) {
  if (cells.ndim() != 2) throw std::invalid_argument("cells: they must have the shape (height, width)");
  tricover::OccupancyGrid grid;
  grid.height = static_cast<std::size_t>(cells.shape(0));
  grid.width = static_cast<std::size_t>(cells.shape(1));
  grid.cells.assign(cells.data(), cells.data() + cells.size());
  grid.resolution = resolution;
  grid.origin = pointFrom(origin, "origin");
  return grid;
}

OccupancyMap mapFrom(const py::object& cells, double resolution, const py::object& pose, const py::object& origin) {
  const py::array given = py::array::ensure(cells);
  if (!given || !py::isinstance<py::array_t<std::int8_t>>(given))
    throw py::type_error("cells: an array of int8 is wanted: 0 is free, 100 is occupied, -1 is unknown");
  return {gridOf(Bytes(given), resolution, origin), onePose(pose, "pose")};
}

py::array_t<std::int8_t> cellsOf(const OccupancyMap& map) {
  py::array_t<std::int8_t> cells({static_cast<py::ssize_t>(map.grid.height), static_cast<py::ssize_t>(map.grid.width)});
  std::copy(map.grid.cells.begin(), map.grid.cells.end(), cells.mutable_data());
  return cells;
}

std::optional<tricover::Polygon> outlineOf(const OccupancyMap& map, const py::object& occupied) {
  if (occupied.is_none()) return tricover::outline(map);
  OccupancyMap chosen{gridOf(Bits(occupied), map.grid.resolution, py::make_tuple(0, 0)), map.pose};
  chosen.grid.origin = map.grid.origin;
  if (chosen.grid.height != map.grid.height || chosen.grid.width != map.grid.width)
    throw std::invalid_argument("occupied: it must have the shape of cells, (" + std::to_string(map.grid.height) +
                                ", " + std::to_string(map.grid.width) + ")");
  return tricover::outline(chosen);
}

}  // namespace

void defineMaps(py::module_& m) {
  const py::tuple zero = py::make_tuple(0, 0);
  py::class_<OccupancyMap>(m, "OccupancyMap", doc("OccupancyMap"))
      .def(py::init(&mapFrom), py::arg("cells"), py::arg("resolution") = 1.0, py::arg("pose") = py::make_tuple(0, 0, 0),
           py::arg("origin") = zero, doc("OccupancyMap.__init__"))
      .def_property_readonly("cells", &cellsOf, doc("OccupancyMap.cells"))
      .def_property_readonly(
          "resolution", [](const OccupancyMap& self) { return self.grid.resolution; }, doc("OccupancyMap.resolution"))
      .def_property_readonly(
          "pose", [](const OccupancyMap& self) { return justOne(self.pose); }, doc("OccupancyMap.pose"))
      .def_property_readonly(
          "origin", [](const OccupancyMap& self) { return arrayOf(self.grid.origin); }, doc("OccupancyMap.origin"))
      .def("outline", &outlineOf, py::arg("occupied") = py::none(), doc("OccupancyMap.outline"))
      .def("__repr__",
           [](const OccupancyMap& self) {
             return "<tricover.OccupancyMap of " + std::to_string(self.grid.height) + " x " +
                    std::to_string(self.grid.width) + " cells of " + text(self.grid.resolution) + " at " +
                    text(self.pose) + ">";
           })
      .def(py::pickle(
          [](const OccupancyMap& self) {
            return py::make_tuple(1, cellsOf(self), self.grid.resolution, justOne(self.pose),
                                  arrayOf(self.grid.origin));
          },
          [](const py::tuple& state) {
            if (state.size() != 5 || state[0].cast<int>() != 1)
              throw std::invalid_argument("this pickle is of another version of tricover");
            return mapFrom(state[1], state[2].cast<double>(), state[3], state[4]);
          }));
  m.def(
      "outline",
      [](const Bits& cells, double resolution, const py::object& origin) {
        return tricover::outline(gridOf(cells, resolution, origin));
      },
      py::arg("cells"), py::arg("resolution") = 1.0, py::arg("origin") = zero, doc("outline"));
  m.def("read_occupancy_map", &tricover::readOccupancyMap, py::arg("yaml"), doc("read_occupancy_map"));
  m.def("write_occupancy_map", &tricover::writeOccupancyMap, py::arg("map"), py::arg("yaml"), py::arg("image") = "",
        doc("write_occupancy_map"));
  m.def(
      "rasterize",
      [](const Shape& polygon, const py::object& pose, const OccupancyMap& map, double margin, double tolerance,
         tricover::Touching touching) {
        const std::vector<std::size_t> cells =
            tricover::rasterize(polygon, onePose(pose, "pose"), map, {margin, tolerance, touching});
        return arrayOf<std::int64_t>(cells.size(), [&](std::size_t i) { return cells[i]; });
      },
      py::arg("polygon"), py::arg("pose"), py::arg("map"), py::arg("margin") = 0.0, py::arg("tolerance") = 0.0,
      py::arg("touching") = tricover::Touching::Collides, doc("rasterize"));
}

}  // namespace tricover_python
