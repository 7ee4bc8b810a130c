// SPDX-License-Identifier: BSD-3-Clause
#include "geos.h"

#include <geos/geom/prep/PreparedGeometryFactory.h>

#include "geos_region.h"

namespace tricover::bench {

Geos::Geos(const Polygon& fixed, const Polygon& moving)
    : fixed_is_prepared_(fixed.vertexCount() >= moving.vertexCount()),
      still_(geosRegion(fixed_is_prepared_ ? fixed : moving)),
      moved_(fixed_is_prepared_ ? moving : fixed),
      prepared_(geos::geom::prep::PreparedGeometryFactory::prepare(still_.get())) {
  // Builds its indexes, which it puts off to the first query that needs them.
  prepared_->intersects(moved_.at(Pose::Identity()));
}

void Geos::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  if (fixed_is_prepared_) return;
  for (Pose& pose : poses_) pose = pose.inverse(Eigen::Isometry);
}

}  // namespace tricover::bench
