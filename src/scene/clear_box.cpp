// SPDX-License-Identifier: BSD-3-Clause
#include "scene/clear_box.h"

#include <algorithm>
#include <cstddef>

#include "scene/bounds.h"

namespace tricover::detail {
namespace {

/// A body is large if the area of its box is this many times the seed's.
constexpr double kLarge = 8;

double area(const Bounds& b) { return (b.max_x - b.min_x) * (b.max_y - b.min_y); }

/// Makes `box` smaller by one side, so that it doesn't meet `edge` any more, still holds the seed and is as large as
/// possible. Returns false if there is no such side.
bool cut(Bounds& box, const Bounds& edge, const Bounds& seed) {
  if (!edge.meets(box)) return true;
  Bounds best = box;
  double most = -1;
  const auto consider = [&](bool possible, double Bounds::*side, double value) {
    Bounds smaller = box;
    smaller.*side = value;
    if (!possible || !(area(smaller) > most)) return;
    most = area(smaller);
    best = smaller;
  };
  consider(edge.max_x < seed.min_x, &Bounds::min_x, edge.max_x);
  consider(edge.max_y < seed.min_y, &Bounds::min_y, edge.max_y);
  consider(edge.min_x > seed.max_x, &Bounds::max_x, edge.min_x);
  consider(edge.min_y > seed.max_y, &Bounds::max_y, edge.min_y);
  box = best;
  return most >= 0;
}

}  // namespace

/// No edge, inflated by the margin, has a point inside the box that is left. Hence the boundary of the inflated region
/// has none there. The query in the seed didn't meet the region, and the seed is inside the box, hence the region has
/// none.
void ClearBox::learn(const PolygonData& polygon, const Pose& pose, double margin, const Bounds& body,
                     const Bounds& seed) const {
  if (!(area(body) > kLarge * area(seed)) || !body.contains(seed)) return;
  tries_.fetch_add(1, std::memory_order_relaxed);
  Bounds box = body;
  for (std::size_t ring = 0; ring < polygon.ringCount(); ++ring)
    for (EdgePosition edge = polygon.edgeBegin(ring); edge < polygon.edgeEnd(ring); ++edge)
      if (!cut(box, boundsOfEdge(polygon, edge, pose, margin), seed)) return;
  auto found = std::make_unique<const Bounds>(box);
  const Bounds* none = nullptr;
  if (known_.compare_exchange_strong(none, found.get(), std::memory_order_release, std::memory_order_relaxed))
    found.release();
}

}  // namespace tricover::detail
