// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "tricover/polygon.h"

namespace tricover::bench {

/// boost::geometry::intersects and distance (which compares all edges with all) on polygons (on multi polygons where a
/// region has several parts). It knows no prepared geometry, so that each query writes the coordinates of the polygon
/// with fewer vertices in the other one's frame.
class BoostGeometry {
 public:
  BoostGeometry(const Polygon& fixed, const Polygon& moving);
  ~BoostGeometry();

  void prepare(const std::vector<Pose>& poses);
  bool collide(std::size_t i);
  double value(std::size_t i);  ///< the distance

 private:
  struct Shapes;

  bool fixed_is_still_;
  std::unique_ptr<Shapes> shapes_;  ///< keeps Boost's templates in one file
  std::vector<Pose> poses_;         ///< of the moved polygon in the other one's frame
};

}  // namespace tricover::bench
