// SPDX-License-Identifier: BSD-3-Clause
// What each file defines of the module. Scene's functions stand in two files.
#pragma once

#include "python/results.h"

namespace tricover_python {

void definePoses(py::module_& m);
void definePolygon(py::module_& m);
void definePairs(py::module_& m);
void defineMeasures(py::module_& m);
void defineMotion(py::module_& m);
void defineTrajectory(py::module_& m);
void defineImpacts(py::module_& m);
void defineScene(py::module_& m);
void defineSceneQueries(py::class_<tricover::Scene>& scene);
void defineSceneMotions(py::class_<tricover::Scene>& scene);
void defineMaps(py::module_& m);
void definePaper(py::module_& m);
void defineDrawing(py::module_& m);
void defineGeo(py::module_& m);
void defineRecording(py::module_& m);

/// The region of an object with __geo_interface__, or of such a dictionary.
tricover::Polygon polygonFromGeo(const py::object& given);
py::object geoOf(const tricover::Polygon& polygon);

}  // namespace tricover_python
