// SPDX-License-Identifier: BSD-3-Clause
// __geo_interface__, in and out, by way of tricover._geo.
#include "python/module.h"

namespace tricover_python {

tricover::Polygon polygonFromGeo(const py::object& given) {
  return py::module_::import("tricover._geo").attr("polygon_from")(given).cast<tricover::Polygon>();
}

py::object geoOf(const tricover::Polygon& polygon) {
  return py::module_::import("tricover._geo").attr("geometry_of")(polygon);
}

}  // namespace tricover_python
