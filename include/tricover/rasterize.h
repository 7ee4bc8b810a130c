// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "tricover/collide_options.h"
#include "tricover/export.h"
#include "tricover/occupancy_grid_io.h"
#include "tricover/outline.h"
#include "tricover/polygon.h"

namespace tricover {

/// Returns the cells that a posed polygon meets: the footprint that a robot or an obstacle has in a costmap. Exact: a
/// cell is in the result if and only if collide() of the polygon and the cell says yes, with the same options.
///
/// A cell is a closed square between the corners that outline() of the grid uses, under the map's pose. A point on a
/// corner meets four cells. The values of the cells don't matter. With a margin the cells within the margin of the
/// polygon are in the result, too. Cells that the polygon only touches are left out by Touching::Allowed. A negative
/// margin is as precise as depth().
///
/// Whole blocks of cells are decided at once, so the time is of the order of the cells along the polygon's outline and
/// the number of results. Link tricover::io.
///
/// \return indices of cells, row * width + column, in ascending order
/// \throws std::invalid_argument for a grid that outline() refuses, for a pose and options that collide() refuses, and
/// for a pose of the map that checkPose() refuses
///
/// \snippet rasterize.cpp rasterize
TRICOVER_EXPORT std::vector<std::size_t> rasterize(const Polygon& polygon, const Pose& pose, const OccupancyMap& map,
                                                   const CollideOptions& options = {});

/// Returns the cells of a grid that is in the world as it is, under the identity, by the same rules.
/// \throws std::invalid_argument as for a map
/// \snippet rasterize.cpp rasterize grid
TRICOVER_EXPORT std::vector<std::size_t> rasterize(const Polygon& polygon, const Pose& pose, const OccupancyGrid& grid,
                                                   const CollideOptions& options = {});

}  // namespace tricover
