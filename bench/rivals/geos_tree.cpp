// SPDX-License-Identifier: BSD-3-Clause
#include "geos_tree.h"

#include <geos/geom/prep/PreparedGeometryFactory.h>

#include "geos_region.h"

namespace tricover::bench {

GeosTree::GeosTree(const Placement& placement, const Polygon& moving) : tree_(10, placement.size()), moved_(moving) {
  for (const Placed& placed : placement) {
    still_.push_back(geosRegion(posed(placed.polygon, placed.pose)));
    prepared_.push_back(geos::geom::prep::PreparedGeometryFactory::prepare(still_.back().get()));
    tree_.insert(*still_.back()->getEnvelopeInternal(), prepared_.back().get());
    // Builds its indexes, which it puts off to the first query that needs them.
    prepared_.back()->intersects(moved_.at(placed.pose));
  }
}

bool GeosTree::collide(std::size_t i) {
  const geos::geom::Geometry* moved = moved_.at(poses_[i]);
  bool hit = false;
  tree_.query(*moved->getEnvelopeInternal(), [&](const Prepared* prepared) {
    hit = prepared->intersects(moved);
    return !hit;
  });
  return hit;
}

}  // namespace tricover::bench
