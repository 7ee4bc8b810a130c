// SPDX-License-Identifier: BSD-3-Clause
#include "boost_geometry.h"

#include "boost_region.h"

namespace tricover::bench {

struct BoostGeometry::Shapes {
  BoostRegion still;
  BoostMoved moved;
};

BoostGeometry::BoostGeometry(const Polygon& fixed, const Polygon& moving)
    : fixed_is_still_(fixed.vertexCount() >= moving.vertexCount()) {
  const Polygon &still = fixed_is_still_ ? fixed : moving, &moved = fixed_is_still_ ? moving : fixed;
  shapes_ = std::make_unique<Shapes>(Shapes{boostRegion(still), BoostMoved(moved)});
}

BoostGeometry::~BoostGeometry() = default;

void BoostGeometry::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  if (fixed_is_still_) return;
  for (Pose& pose : poses_) pose = pose.inverse(Eigen::Isometry);
}

bool BoostGeometry::collide(std::size_t i) { return boostIntersects(shapes_->still, shapes_->moved.at(poses_[i])); }

double BoostGeometry::value(std::size_t i) {
  const BoostRegion &still = shapes_->still, &moved = shapes_->moved.at(poses_[i]);
  return still.size() == 1 && moved.size() == 1 ? boost::geometry::distance(still[0], moved[0])
                                                : boost::geometry::distance(still, moved);
}

}  // namespace tricover::bench
