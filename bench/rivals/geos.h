// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos/geom/CoordinateSequenceFilter.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/prep/PreparedGeometry.h>

#include <memory>
#include <vector>

#include "tricover/polygon.h"

namespace tricover::bench {

/// GEOS's prepared geometry, by its C++ interface, which lets coordinates change in place. Prepared is the polygon
/// with more vertices, whichever it is; each query writes the other one's coordinates in its frame.
class Geos {
 public:
  Geos(const Polygon& fixed, const Polygon& moving);

  void prepare(const std::vector<Pose>& poses);

  bool collide(std::size_t i) { return prepared_->intersects(moved(i)); }

  /// By PreparedGeometry::distance, which indexes the prepared one's facets once and the other one's at each query; or
  /// by Geometry::distance, which compares all with all.
  double distance(std::size_t i, bool prepared) {
    return prepared ? prepared_->distance(moved(i)) : still_->distance(moved(i));
  }

 private:
  /// Rewrites a whole sequence at its first coordinate.
  class Mover : public geos::geom::CoordinateSequenceFilter {
   public:
    explicit Mover(std::vector<Ring> rings) : rings_(std::move(rings)) {}
    void start(const Pose& pose) {
      pose_ = &pose;
      next_ = 0;
    }
    void filter_rw(geos::geom::CoordinateSequence& sequence, std::size_t i) override;
    bool isDone() const override { return next_ == rings_.size(); }
    bool isGeometryChanged() const override { return true; }

   private:
    std::vector<Ring> rings_;  ///< in the order in which GEOS visits them, closed
    const Pose* pose_ = nullptr;
    std::size_t next_ = 0;
  };

  const geos::geom::Geometry* moved(std::size_t i) {
    mover_.start(poses_[i]);
    moved_->apply_rw(mover_);
    return moved_.get();
  }

  bool fixed_is_prepared_;
  std::unique_ptr<geos::geom::Geometry> still_, moved_;
  std::unique_ptr<geos::geom::prep::PreparedGeometry> prepared_;
  Mover mover_;
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
