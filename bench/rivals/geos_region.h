// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geos/geom/Geometry.h>

#include <memory>
#include <vector>

#include "tricover/polygon.h"

namespace tricover::bench {

/// The region as a valid geometry of GEOS: a Polygon if it is in one part, else a MultiPolygon.
std::unique_ptr<geos::geom::Geometry> geosRegion(const Polygon& polygon);

/// The rings of one of its parts, the shell first; not closed.
std::vector<Ring> ringsOfPart(const geos::geom::Geometry& region, std::size_t part);

}  // namespace tricover::bench
