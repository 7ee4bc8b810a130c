// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos/geom/CoordinateSequenceFilter.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/prep/PreparedGeometry.h>
#include <geos/index/strtree/TemplateSTRtree.h>

#include <memory>
#include <vector>

#include "scenes/placed.h"

namespace tricover::bench {

/// The region as a valid geometry of GEOS: a Polygon if it is in one part, else a MultiPolygon.
std::unique_ptr<geos::geom::Geometry> geosRegion(const Polygon& polygon);

/// The rings of one of its parts, the shell first; not closed.
std::vector<Ring> ringsOfPart(const geos::geom::Geometry& region, std::size_t part);

/// A polygon whose coordinates GEOS's C++ interface lets change in place.
class GeosMoved : geos::geom::CoordinateSequenceFilter {
 public:
  explicit GeosMoved(const Polygon& polygon);

  /// The geometry where the pose takes it, until the next call.
  const geos::geom::Geometry* at(const Pose& pose) {
    pose_ = &pose;
    next_ = 0;
    geometry_->apply_rw(*this);
    return geometry_.get();
  }

 private:
  /// Rewrites a whole sequence at its first coordinate.
  void filter_rw(geos::geom::CoordinateSequence& sequence, std::size_t i) override;
  bool isDone() const override { return next_ == rings_.size(); }
  bool isGeometryChanged() const override { return true; }

  std::unique_ptr<geos::geom::Geometry> geometry_;
  std::vector<Ring> rings_;  ///< in the order in which GEOS visits them, closed
  const Pose* pose_ = nullptr;
  std::size_t next_ = 0;
};

/// GEOS's prepared geometry. Prepared is the polygon with more vertices, whichever it is; each query writes the other
/// one's coordinates in its frame. `by_facets`: distances by PreparedGeometry::distance, which indexes the prepared
/// one's facets once and the other one's at each query; else by Geometry::distance, which compares all with all.
class Geos {
 public:
  Geos(const Polygon& fixed, const Polygon& moving, bool by_facets = true);

  void prepare(const std::vector<Pose>& poses);
  bool collide(std::size_t i) { return prepared_->intersects(moved_.at(poses_[i])); }
  double value(std::size_t i) {
    const geos::geom::Geometry* moved = moved_.at(poses_[i]);
    return by_facets_ ? prepared_->distance(moved) : still_->distance(moved);
  }

 private:
  bool by_facets_, fixed_is_prepared_;
  std::unique_ptr<geos::geom::Geometry> still_;
  GeosMoved moved_;
  std::unique_ptr<geos::geom::prep::PreparedGeometry> prepared_;
  std::vector<Pose> poses_;  ///< of the moved geometry in the prepared one's frame
};

/// GEOS's STRtree over prepared geometries.
class GeosTree {
 public:
  GeosTree(const Placement& placement, const Polygon& moving);

  void prepare(std::vector<Pose> poses) { poses_ = std::move(poses); }

  /// Whether it meets any of them.
  bool collide(std::size_t i);

 private:
  using Prepared = geos::geom::prep::PreparedGeometry;
  std::vector<std::unique_ptr<geos::geom::Geometry>> still_;
  std::vector<std::unique_ptr<Prepared>> prepared_;
  geos::index::strtree::TemplateSTRtree<const Prepared*> tree_;
  GeosMoved moved_;
  std::vector<Pose> poses_;
};

}  // namespace tricover::bench
