// SPDX-License-Identifier: BSD-3-Clause
#include "python/results.h"

namespace tricover_python {

py::object one(const tricover::Contact& c) {
  std::vector<tricover::Vec2> points;
  for (std::size_t k = 0; k < c.count; ++k) points.push_back(c.points[k].point);
  return resultClass("Contact")(arrayOf(c.point), arrayOf(c.normal), c.depth, c.edge_a, c.edge_b, arrayOf(points),
                                arrayOf<double>(c.count, [&](std::size_t k) { return c.points[k].depth; }));
}

py::object one(const tricover::SelfCrossing& c) {
  return resultClass("SelfCrossing")(py::cast(c.kind), arrayOf(c.point), c.ring_a, c.ring_b, c.edge_a, c.edge_b,
                                     c.text);
}

py::object one(const std::vector<tricover::Crossing>& crossings) { return many(crossings); }

}  // namespace tricover_python
