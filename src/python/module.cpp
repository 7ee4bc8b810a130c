// SPDX-License-Identifier: BSD-3-Clause
// tricover._tricover: what _tricover.pyi lists. tricover/__init__.py hands it on.
#include "python/module.h"

PYBIND11_MODULE(_tricover, m) {
  using namespace tricover_python;
  m.doc() = "The compiled part of tricover.";
  py::options options;
  options.disable_function_signatures();  // the docstrings begin with them, as Python reads signatures
  m.attr("__module__") = "tricover";      // where users find what is defined below
  definePoses(m);
  definePolygon(m);
  definePairs(m);
  defineMeasures(m);
  defineMotion(m);
  defineTrajectory(m);
  defineImpacts(m);
  defineScene(m);
  defineMaps(m);
  defineDrawing(m);
  defineGeo(m);
  defineRecording(m);
  py::module_ paper = m.def_submodule("_paper");
  paper.attr("__module__") = "tricover.paper";
  definePaper(paper);
  py::delattr(m, "__module__");
  m.attr("NO_BODY") = tricover::kNoBody;
  m.attr("EVERY_CATEGORY") = tricover::kEveryCategory;
  m.attr("RIGID_TOLERANCE") = tricover::kRigidTolerance;
  m.attr("__version__") = tricover::version();
}
