// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos/geom/Geometry.h>
#include <geos/geom/prep/PreparedGeometry.h>
#include <geos/index/strtree/TemplateSTRtree.h>

#include <memory>
#include <vector>

#include "geos_moved.h"
#include "scenes/placed.h"

namespace tricover::bench {

/// GEOS's STRtree over prepared geometries; the asking polygon's coordinates are rewritten in place.
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
