// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos/geom/Geometry.h>
#include <geos/geom/prep/PreparedGeometry.h>

#include <memory>
#include <vector>

#include "geos_moved.h"
#include "tricover/polygon.h"

namespace tricover::bench {

/// GEOS's prepared geometry. Prepared is the polygon with more vertices, whichever it is; each query writes the other
/// one's coordinates in its frame.
class Geos {
 public:
  Geos(const Polygon& fixed, const Polygon& moving);

  void prepare(const std::vector<Pose>& poses);

  bool collide(std::size_t i) { return prepared_->intersects(moved_.at(poses_[i])); }

  /// By PreparedGeometry::distance, which indexes the prepared one's facets once and the other one's at each query; or
  /// by Geometry::distance, which compares all with all.
  double distance(std::size_t i, bool prepared) {
    const geos::geom::Geometry* moved = moved_.at(poses_[i]);
    return prepared ? prepared_->distance(moved) : still_->distance(moved);
  }

 private:
  bool fixed_is_prepared_;
  std::unique_ptr<geos::geom::Geometry> still_;
  GeosMoved moved_;
  std::unique_ptr<geos::geom::prep::PreparedGeometry> prepared_;
  std::vector<Pose> poses_;  ///< of the moved geometry in the prepared one's frame
};

class GeosDistance : public Geos {
 public:
  GeosDistance(const Polygon& fixed, const Polygon& moving, bool prepared) : Geos(fixed, moving), prepared_(prepared) {}
  double value(std::size_t i) { return distance(i, prepared_); }

 private:
  bool prepared_;
};

}  // namespace tricover::bench
