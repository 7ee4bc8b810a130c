// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// A map of square cells, each with a value, laid out like ROS's nav_msgs/OccupancyGrid. readOccupancyMap() of
/// tricover::io reads one from files.
struct OccupancyGrid {
  std::size_t width = 0;           ///< The number of cells along x.
  std::size_t height = 0;          ///< The number of cells along y.
  std::vector<std::int8_t> cells;  ///< width * height values, row by row from the lowest y, each row from the lowest x.
  double resolution = 1;           ///< The side of a cell, in the polygon's units of length.
  Vec2 origin = Vec2::Zero();      ///< The lower left corner of the first cell, in the polygon's frame.
};

/// Whether a cell with this value belongs to the region.
using IsOccupied = std::function<bool(std::int8_t)>;

/// The union of the occupied cells, as one polygon of traced outlines with holes; nothing if no cell is occupied. By
/// default every value but 0 is occupied: in ROS's convention -1 is unknown and 1 to 100 are degrees of certainty, so
/// that what is unknown is in the way. For the grid of an OccupancyMap, the polygon's pose is OccupancyMap::pose.
///
/// Every vertex is a corner of the grid where the outline turns: (origin.x + i * resolution, origin.y + j * resolution)
/// with two roundings a coordinate. Rings run with the region on their left. Cells that share a corner only belong to
/// rings of their own, which touch there; the region is the same either way. Cost: linear in the number of cells.
///
/// \throws std::invalid_argument if a cell value is missing or left over, if resolution isn't positive, if a corner
/// isn't finite, if neighbouring corners round to the same coordinate, or for an empty function
///
/// \snippet outline.cpp outline
TRICOVER_EXPORT std::optional<Polygon> outline(
    const OccupancyGrid& grid, const IsOccupied& is_occupied = [](std::int8_t value) { return value != 0; });

}  // namespace tricover
