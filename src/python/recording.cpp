// SPDX-License-Identifier: BSD-3-Clause
#include <tricover/recording.h>

#include <string>

#include "python/shown.h"
#include "python/ways.h"

namespace tricover_python {
namespace {

using tricover::SceneRecording;

std::optional<tricover::TimeInterval> intervalFrom(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  const tricover::Vec2 interval = pointFrom(given, "when");
  return tricover::TimeInterval{interval.x(), interval.y()};
}

/// Of the items of a list, what from(item) makes of each.
template <typename From>
auto listFrom(const py::object& given, const From& from) {
  std::vector<decltype(from(given))> list;
  for (const py::handle item : given) list.push_back(from(py::reinterpret_borrow<py::object>(item)));
  return list;
}

void addTrajectories(SceneRecording& self, const tricover::Scene& scene, const py::object& given) {
  const py::object items = py::isinstance<py::dict>(given) ? given.attr("items")() : given;
  self.trajectories(scene, listFrom(items, [](const py::object& item) {
                      if (!py::isinstance<py::sequence>(item) || py::len(item) != 2 ||
                          !py::isinstance<tricover::Trajectory>(py::object(item[py::int_(1)])))
                        throw py::type_error("trajectories: pairs (body, Trajectory) are wanted, not " +
                                             py::repr(item).cast<std::string>());
                      return tricover::BodyTrajectory{py::object(item[py::int_(0)]).cast<Body>().handle,
                                                      py::object(item[py::int_(1)]).cast<tricover::Trajectory>()};
                    }));
}

/// A notebook's cell shows the page in a frame: a page has scripts and styles of its own.
std::string framed(const SceneRecording& recording) {
  const py::object escaped = py::module_::import("html").attr("escape")(recording.str());
  return "<iframe style=\"width: 100%; height: 600px; border: 0\" srcdoc=\"" + escaped.cast<std::string>() +
         "\"></iframe>";
}

void defineBodies(py::class_<SceneRecording>& recording) {
  recording.def(py::init<const std::string&>(), py::arg("title") = "Recording", doc("SceneRecording.__init__"))
      .def(
          "frame",
          [](SceneRecording& self, double time, const tricover::Scene& scene, const py::object& meeting) {
            self.frame(time, scene, listFrom(meeting, &pairFrom));
          },
          py::arg("time"), py::arg("scene"), py::arg("meeting") = py::tuple(), doc("SceneRecording.frame"))
      .def("trajectories", &addTrajectories, py::arg("scene"), py::arg("trajectories"),
           doc("SceneRecording.trajectories"))
      .def(
          "name", [](SceneRecording& self, Body body, const std::string& name) { self.name(body.handle, name); },
          py::arg("body"), py::arg("name"), doc("SceneRecording.name"))
      .def("save", &SceneRecording::save, py::arg("path"), doc("SceneRecording.save"))
      .def("__copy__", [](const SceneRecording& self) { return self; })
      .def("__str__", &SceneRecording::str)
      .def("_repr_html_", &framed);
}

void defineShown(py::class_<SceneRecording>& recording) {
  recording
      .def(
          "conflicts",
          [](SceneRecording& self, const py::object& conflicts) {
            self.conflicts(listFrom(conflicts, [](const py::object& one) {
              return tricover::PairConflict{pairFrom(one.attr("pair")), conflictFrom(one.attr("conflict"))};
            }));
          },
          py::arg("conflicts"), doc("SceneRecording.conflicts"))
      .def(
          "impacts",
          [](SceneRecording& self, const py::object& impacts) {
            self.impacts(listFrom(impacts, [](const py::object& one) {
              return tricover::PairImpact{pairFrom(one.attr("pair")), impactFrom(one.attr("impact"))};
            }));
          },
          py::arg("impacts"), doc("SceneRecording.impacts"))
      .def(
          "contacts",
          [](SceneRecording& self, const py::object& contacts, const py::object& when) {
            self.contacts(contactsFrom(contacts), intervalFrom(when));
          },
          py::arg("contacts"), py::arg("when") = py::none(), doc("SceneRecording.contacts"))
      .def(
          "nearest",
          [](SceneRecording& self, const py::object& result, const py::object& when) {
            if (!py::isinstance(result, resultClass("LeastDistance")))
              return self.nearest(distanceFrom(result), intervalFrom(when));
            if (!when.is_none()) throw py::type_error("when: a LeastDistance has a time of its own");
            self.nearest(leastDistanceFrom(result));
          },
          py::arg("result"), py::arg("when") = py::none(), doc("SceneRecording.nearest"))
      .def(
          "ray",
          [](SceneRecording& self, const py::object& from, const py::object& to, const py::object& hit,
             const py::object& when) {
            std::optional<tricover::BodyRayHit> met;
            if (!hit.is_none())
              met = tricover::BodyRayHit{hit.attr("body").cast<Body>().handle, rayHitFrom(hit.attr("hit"))};
            self.ray(pointFrom(from, "from_point"), pointFrom(to, "to_point"), met, intervalFrom(when));
          },
          py::arg("from_point"), py::arg("to_point"), py::arg("hit") = py::none(), py::arg("when") = py::none(),
          doc("SceneRecording.ray"))
      .def(
          "text",
          [](SceneRecording& self, const py::object& position, const std::string& written, const py::object& when) {
            self.text(pointFrom(position, "position"), written, intervalFrom(when));
          },
          py::arg("position"), py::arg("text"), py::arg("when") = py::none(), doc("SceneRecording.text"));
}

}  // namespace

void defineRecording(py::module_& m) {
  py::class_<SceneRecording> recording(m, "SceneRecording", doc("SceneRecording"));
  defineBodies(recording);
  defineShown(recording);
}

}  // namespace tricover_python
