// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tricover/export.h"
#include "tricover/outline.h"
#include "tricover/pose.h"

namespace tricover {

/// A map as ROS's map_server keeps it in files, and where it lies in the world.
struct OccupancyMap {
  /// In a frame of its own, its lower left corner at (0, 0), in metres. Cells are 0 where the map is free, 100 where it
  /// is occupied, and -1 where it says neither.
  OccupancyGrid grid;
  Pose pose;  ///< From that frame to the world: the file's origin, yaw included.
};

/// Reads a map of ROS's map_server: a YAML file and the PGM image that it names. nav2 and map_saver write the same.
/// Link tricover::io, which needs yaml-cpp.
///
/// outline() of the map is a polygon in the world. outline() of its grid alone is one in the grid's own frame, whose
/// pose in the world is OccupancyMap::pose.
///
/// The fields are `image` (a path from the YAML file's folder, or an absolute one), `resolution`, `origin` (x, y and
/// yaw), `negate`, `occupied_thresh` and `free_thresh`. `mode` may be `trinary`, in any case; map_server's modes scale
/// and raw are refused, and so is `trinary: false` of its first versions, which means scale. With p = 1 - grey, or grey
/// if `negate` is set, a cell is occupied if p >= occupied_thresh. Otherwise it is free if p <= free_thresh, and
/// unknown if neither holds.
///
/// Images are grey, of at most 65,535 x 65,535 pixels, as text (P2) or of one byte a pixel (P5). Their first row is the
/// map's last. A P5 header may end in CR LF if the file's size proves it.
///
/// \param yaml the YAML file's path. Folders, devices and pipes are refused.
/// \throws std::runtime_error for a file that can't be read or is no such map. The text has the file, the field, its
/// value and the limit. No memory is taken for pixels that the file is too short to have.
///
/// \snippet occupancy_grid_io.cpp occupancy map
TRICOVER_EXPORT OccupancyMap readOccupancyMap(const std::string& yaml);

/// Returns the outline() of a map's grid in the world, where the map is: every corner under the map's pose, rounded
/// there. Nothing if no cell is occupied.
///
/// \throws std::invalid_argument as outline() of the grid does, and for a pose that checkPose() refuses
///
/// \snippet occupancy_grid_io.cpp occupancy map
TRICOVER_EXPORT std::optional<Polygon> outline(
    const OccupancyMap& map, const IsOccupied& is_occupied = [](std::int8_t value) { return value != 0; });

}  // namespace tricover
