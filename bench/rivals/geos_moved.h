// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos/geom/CoordinateSequenceFilter.h>
#include <geos/geom/Geometry.h>

#include <memory>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::bench {

/// A polygon whose coordinates GEOS's C++ interface lets change in place.
class GeosMoved {
 public:
  explicit GeosMoved(const Polygon& polygon);

  /// The geometry where the pose takes it, until the next call.
  const geos::geom::Geometry* at(const Pose& pose) {
    mover_.start(pose);
    geometry_->apply_rw(mover_);
    return geometry_.get();
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

  std::unique_ptr<geos::geom::Geometry> geometry_;
  Mover mover_;
};

}  // namespace tricover::bench
