// SPDX-License-Identifier: BSD-3-Clause
// `import tricover`: what tricover.pyi lists.
#include "module.h"

#include "arrays.h"

namespace tricover_python {

Records::Records(py::module_& m) {
  const py::object namedtuple = py::module_::import("collections").attr("namedtuple");
  const auto define = [&](const char* name, const char* fields) {
    py::object type = namedtuple(name, fields, py::arg("module") = "tricover");
    m.attr(name) = type;
    return type;
  };
  distance_ = define("Distance", "distance point_a point_b edge_a edge_b");
  penetration_ = define("Penetration", "depth normal lower_bound optimal translation point_a point_b edge_a edge_b");
  contact_ = define("Contact", "point normal depth edge_a edge_b points depths");
  impact_ = define("Impact", "time point normal edge_a edge_b budget_ended");
  conflict_ = define("Conflict", "impact end budget_ended");
  body_options_ = define("BodyOptions", "margin category mask touching");
  ray_hit_ = define("RayHit", "fraction point normal edge");
  ray_interval_ = define("RayInterval", "begin end");
  signed_distance_ = define("SignedDistance", "distance normal point_a point_b edge_a edge_b");
  least_distance_ = define("LeastDistance", "distance lower_bound time point_a point_b edge_a edge_b budget_ended");
}

py::object Records::of(const tricover::DistanceResult& r) const {
  return distance_(r.distance, arrayOf(r.point_a), arrayOf(r.point_b), r.edge_a, r.edge_b);
}

py::object Records::of(const std::vector<tricover::DistanceResult>& results) const {
  const std::size_t n = results.size();
  std::vector<tricover::Vec2> points_a, points_b;
  for (const tricover::DistanceResult& r : results) points_a.push_back(r.point_a), points_b.push_back(r.point_b);
  return distance_(arrayOf<double>(n, [&](std::size_t i) { return results[i].distance; }), arrayOf(points_a),
                   arrayOf(points_b), arrayOf<tricover::EdgeIndex>(n, [&](std::size_t i) { return results[i].edge_a; }),
                   arrayOf<tricover::EdgeIndex>(n, [&](std::size_t i) { return results[i].edge_b; }));
}

py::object Records::of(const tricover::Penetration& p) const {
  return penetration_(p.depth, arrayOf(p.normal), p.lower_bound, p.optimal, arrayOf(p.translation), arrayOf(p.point_a),
                      arrayOf(p.point_b), p.edge_a, p.edge_b);
}

py::object Records::of(const tricover::Contact& c) const {
  std::vector<tricover::Vec2> points;
  for (std::size_t k = 0; k < c.count; ++k) points.push_back(c.points[k].point);
  return contact_(arrayOf(c.point), arrayOf(c.normal), c.depth, c.edge_a, c.edge_b, arrayOf(points),
                  arrayOf<double>(c.count, [&](std::size_t k) { return c.points[k].depth; }));
}

py::object Records::of(const tricover::Impact& i) const {
  return impact_(i.time, arrayOf(i.point), arrayOf(i.normal), i.edge_a, i.edge_b, i.budget_ended);
}

py::object Records::of(const tricover::Conflict& c) const { return conflict_(of(c.impact), c.end, c.budget_ended); }

py::object Records::of(const tricover::BodyOptions& o) const {
  return body_options_(o.margin, o.category, o.mask, o.touching);
}

py::object Records::of(const tricover::RayHit& h) const {
  return ray_hit_(h.fraction, arrayOf(h.point), arrayOf(h.normal), h.edge);
}

py::object Records::of(const tricover::RayInterval& i) const { return ray_interval_(of(i.begin), of(i.end)); }

py::object Records::of(const tricover::SignedDistance& r) const {
  return signed_distance_(r.distance, arrayOf(r.normal), arrayOf(r.point_a), arrayOf(r.point_b), r.edge_a, r.edge_b);
}

py::object Records::of(const tricover::LeastDistance& r) const {
  return least_distance_(r.distance, r.lower_bound, r.time, arrayOf(r.point_a), arrayOf(r.point_b), r.edge_a, r.edge_b,
                         r.budget_ended);
}

}  // namespace tricover_python

PYBIND11_MODULE(tricover, m) {
  m.doc() = "Exact collision detection between 2D polygons.";
  const tricover_python::Records records(m);
  namespace py = pybind11;
  const py::dict members(py::arg("__module__") = "tricover", py::arg("__slots__") = py::tuple(),
                         py::arg("__doc__") = "A handle of a Scene's body: an int that is no mask.");
  m.attr("Body") = py::type::of(py::type::of(py::int_()))("Body", py::make_tuple(py::type::of(py::int_())), members);
  definePairs(m, records);
  defineMotions(m, records);
  defineScene(m, records);
}
