// SPDX-License-Identifier: BSD-3-Clause
#include "python/shown.h"

#include <algorithm>

namespace tricover_python {
namespace {

tricover::Vec2 vectorIn(const py::object& record, const char* field) { return pointFrom(record.attr(field), field); }

template <typename Value>
Value valueIn(const py::object& record, const char* field) {
  return record.attr(field).cast<Value>();
}

void require(const py::object& given, const char* wanted) {
  if (!py::isinstance(given, resultClass(wanted)))
    throw py::type_error(std::string(wanted) + " of one pair is wanted, not a " +
                         py::str(py::type::of(given).attr("__name__")).cast<std::string>());
}

}  // namespace

tricover::DistanceResult distanceFrom(const py::object& given) {
  require(given, "Distance");
  return {valueIn<double>(given, "distance"), vectorIn(given, "point_a"), vectorIn(given, "point_b"),
          valueIn<tricover::EdgeIndex>(given, "edge_a"), valueIn<tricover::EdgeIndex>(given, "edge_b")};
}

tricover::LeastDistance leastDistanceFrom(const py::object& given) {
  require(given, "LeastDistance");
  tricover::LeastDistance least{};
  least.distance = valueIn<double>(given, "distance");
  least.lower_bound = valueIn<double>(given, "lower_bound");
  least.time = valueIn<double>(given, "time");
  least.point_a = vectorIn(given, "point_a");
  least.point_b = vectorIn(given, "point_b");
  return least;
}

tricover::Impact impactFrom(const py::object& given) {
  require(given, "Impact");
  return {valueIn<double>(given, "time"),
          vectorIn(given, "point"),
          vectorIn(given, "normal"),
          valueIn<tricover::EdgeIndex>(given, "edge_a"),
          valueIn<tricover::EdgeIndex>(given, "edge_b"),
          valueIn<bool>(given, "budget_ended")};
}

tricover::Conflict conflictFrom(const py::object& given) {
  require(given, "Conflict");
  tricover::Conflict conflict{};
  conflict.impact = impactFrom(given.attr("impact"));
  conflict.end = valueIn<double>(given, "end");
  conflict.budget_ended = valueIn<bool>(given, "budget_ended");
  conflict.meets_at_end = valueIn<bool>(given, "meets_at_end");
  return conflict;
}

tricover::RayHit rayHitFrom(const py::object& given) {
  require(given, "RayHit");
  return {valueIn<double>(given, "fraction"), vectorIn(given, "point"), vectorIn(given, "normal"),
          valueIn<tricover::EdgeIndex>(given, "edge")};
}

tricover::BodyPair pairFrom(const py::object& given) {
  if (!py::isinstance<py::sequence>(given) || py::len(given) != 2)
    throw py::type_error("a pair of two bodies is wanted, not " + py::repr(given).cast<std::string>());
  return {py::object(given[py::int_(0)]).cast<Body>().handle, py::object(given[py::int_(1)]).cast<Body>().handle};
}

std::vector<tricover::Contact> contactsFrom(const py::object& given) {
  std::vector<tricover::Contact> contacts;
  for (const py::handle item : given) {
    const py::object record = py::reinterpret_borrow<py::object>(item);
    require(record, "Contact");
    tricover::Contact contact{};
    contact.point = vectorIn(record, "point");
    contact.normal = vectorIn(record, "normal");
    contact.depth = valueIn<double>(record, "depth");
    contact.edge_a = contact.edge_b = -1;
    const std::vector<tricover::Vec2> points = verticesFrom(record.attr("points"), "points");
    contact.count = std::min<std::size_t>(2, points.size());
    for (std::size_t k = 0; k < 2 && !points.empty(); ++k)
      contact.points[k] = {points[std::min(k, points.size() - 1)], contact.depth};
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace tricover_python
