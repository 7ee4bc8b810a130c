// SPDX-License-Identifier: BSD-3-Clause
#include "geos_moved.h"

#include <geos/geom/CoordinateSequence.h>

#include "geos_region.h"

namespace tricover::bench {
namespace {

std::vector<Ring> closedRings(const geos::geom::Geometry& region) {
  std::vector<Ring> rings;
  for (std::size_t part = 0; part < region.getNumGeometries(); ++part) {
    for (Ring& ring : ringsOfPart(region, part)) {
      ring.push_back(ring.front());
      rings.push_back(std::move(ring));
    }
  }
  return rings;
}

}  // namespace

void GeosMoved::Mover::filter_rw(geos::geom::CoordinateSequence& sequence, std::size_t i) {
  if (i != 0) return;
  const Ring& ring = rings_[next_++];
  const Eigen::Matrix2d linear = pose_->linear();
  const Vec2 translation = pose_->translation();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 v = linear * ring[k] + translation;
    sequence.setAt(geos::geom::Coordinate(v.x(), v.y()), k);
  }
}

GeosMoved::GeosMoved(const Polygon& polygon) : geometry_(geosRegion(polygon)), mover_(closedRings(*geometry_)) {}

}  // namespace tricover::bench
