// SPDX-License-Identifier: BSD-3-Clause
#include "geos.h"

#include <geos/geom/CoordinateSequence.h>
#include <geos/geom/prep/PreparedGeometryFactory.h>

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

void Geos::Mover::filter_rw(geos::geom::CoordinateSequence& sequence, std::size_t i) {
  if (i != 0) return;
  const Ring& ring = rings_[next_++];
  const Eigen::Matrix2d linear = pose_->linear();
  const Vec2 translation = pose_->translation();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 v = linear * ring[k] + translation;
    sequence.setAt(geos::geom::Coordinate(v.x(), v.y()), k);
  }
}

Geos::Geos(const Polygon& fixed, const Polygon& moving)
    : fixed_is_prepared_(fixed.vertexCount() >= moving.vertexCount()),
      still_(geosRegion(fixed_is_prepared_ ? fixed : moving)),
      moved_(geosRegion(fixed_is_prepared_ ? moving : fixed)),
      prepared_(geos::geom::prep::PreparedGeometryFactory::prepare(still_.get())),
      mover_(closedRings(*moved_)) {
  prepared_->intersects(moved_.get());  // builds its indexes, which it puts off to the first query that needs them
}

void Geos::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  if (fixed_is_prepared_) return;
  for (Pose& pose : poses_) pose = pose.inverse(Eigen::Isometry);
}

}  // namespace tricover::bench
