// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Reads a map of ROS's map_server (nav2 and map_saver write the same): a YAML file, and the PGM image that it names,
/// by a path from the YAML file's folder or an absolute one.
///
/// Of YAML, lines `key: value` are read: `image`, `resolution`, `origin: [x, y, yaw]`, `negate`, `occupied_thresh`,
/// `free_thresh`, and `mode`, which may be `trinary`. With p = 1 - grey, or grey if `negate` is 1, a cell is occupied
/// where p > occupied_thresh, free where p < free_thresh, and unknown in between. Images are grey, of at most 65,535 x
/// 65,535 pixels, as text (P2) or of one byte a pixel (P5); their first row is the map's last.
///
/// Throws std::runtime_error, naming the file and what is wrong in it, before any memory is taken for pixels that the
/// file is too short to have. What is no plain file (a folder, a device, a pipe) is refused.
///
/// \snippet occupancy_grid_io.cpp occupancy map
TRICOVER_EXPORT OccupancyMap readOccupancyMap(const std::string& yaml);

}  // namespace tricover
