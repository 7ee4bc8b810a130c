// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <utility>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::bench {

using BoostPoint = boost::geometry::model::d2::point_xy<double>;
using BoostPolygon = boost::geometry::model::polygon<BoostPoint>;
using BoostRegion = boost::geometry::model::multi_polygon<BoostPolygon>;

/// One polygon a part of the region, rings turned the way Boost wants them.
BoostRegion boostRegion(const Polygon& polygon);

/// A region whose coordinates are rewritten in place.
class BoostMoved {
 public:
  explicit BoostMoved(const Polygon& polygon) : original_(boostRegion(polygon)), moved_(original_) {}

  /// The region where the pose takes it, until the next call.
  const BoostRegion& at(const Pose& pose);

 private:
  BoostRegion original_, moved_;
};

inline bool boostIntersects(const BoostRegion& a, const BoostRegion& b) {
  return a.size() == 1 && b.size() == 1 ? boost::geometry::intersects(a[0], b[0]) : boost::geometry::intersects(a, b);
}

}  // namespace tricover::bench
