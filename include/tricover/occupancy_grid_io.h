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
  /// is occupied, -1 where it says neither, and from 1 to 99 what a map in mode scale or raw says beside these.
  OccupancyGrid grid;
  Pose pose = Pose::Identity();  ///< From that frame to the world: the file's origin, yaw included.
};

/// Reads a map of ROS's map_server: a YAML file and the PGM or PNG image that it names. nav2 and map_saver write the
/// same. Link tricover::io, which needs yaml-cpp and libpng.
///
/// outline() of the map is a polygon in the world. outline() of its grid alone is one in the grid's own frame, whose
/// pose in the world is OccupancyMap::pose.
///
/// The fields are `image` (a path from the YAML file's folder, or an absolute one), `resolution`, `origin` (x, y and
/// yaw), `negate`, `occupied_thresh`, `free_thresh` and `mode`, which is `trinary` where it is missing. Let p be
/// 1 - grey, or grey if `negate` is set, with a grey from 0 (black) to 1.
/// - `trinary`: a cell is 100 if p >= occupied_thresh. Otherwise it is 0 if p <= free_thresh, and -1 if neither holds.
/// - `scale`: where neither holds, a cell is round(100 (p - free_thresh) / (occupied_thresh - free_thresh)).
///   `trinary: false` of map_server's first versions means this mode.
/// - `raw`: a cell is round(255 grey) if that is at most 100, and otherwise -1.
///
/// Images have at most 65,535 pixels along a side and 2^28 (16,384 x 16,384) in all. PGM is text (P2) or one byte a
/// pixel (P5), whose header may end in CR LF if the file's size proves it. PNG may be of any kind. The grey of a colour
/// is the mean of red, green and blue, unless the YAML file's mode is raw, where the colours' mean is rounded. A pixel
/// that is not opaque is -1 in the modes trinary and scale. (Some versions of nav2 and map_server take
/// alpha for a fourth colour in mode trinary, which makes opaque unknown cells free.) An image's first row is the map's
/// last.
///
/// Folders, devices and pipes are refused.
/// \throws std::runtime_error for a file that can't be read or is no such map. The text has the file, the field, its
/// value and the limit. No memory is taken for pixels that the file doesn't hold.
///
/// \snippet occupancy_grid_io.cpp occupancy map
TRICOVER_EXPORT OccupancyMap readOccupancyMap(const std::string& yaml);

/// Writes a map's YAML file and its image, for readOccupancyMap(), map_server and nav2. Files of these names are
/// replaced, each only once all of it is written. After an error none of the two is written in part.
///
/// The mode is trinary if all cells are -1, 0 and 100, with map_saver's greys and thresholds, and otherwise scale, with
/// thresholds of 0 and 1. Reading gives the same cells, and the same resolution and translation bit for bit. A yaw from
/// -pi to pi, as poseAt() turns it into a pose, comes back bit for bit, too. The entries of any other rotation come
/// back within 1e-12.
///
/// `image` is its path as the YAML file is to name it: from the YAML file's folder, or an absolute one. It
/// ends in `.pgm` or `.png`, in any case. If it is empty, the image is beside the YAML file and has its name, with
/// `.pgm` in mode trinary and `.png` in mode scale. PGM keeps no unknown cells in mode scale.
/// \throws std::invalid_argument for a grid without cells, larger than an image may be, or with a value missing or
/// left over; for a cell that is not from -1 to 100 or that the image can't keep, which the text names; for a
/// resolution that is not positive and finite; for an origin of the grid that is not (0, 0); for a pose that
/// checkPose() refuses, that mirrors, or that no yaw gives within 1e-12; and for an image's path with another ending
/// \throws std::runtime_error for a file that can't be written. The text has the file.
///
/// \snippet occupancy_grid_io.cpp write
TRICOVER_EXPORT void writeOccupancyMap(const OccupancyMap& map, const std::string& yaml, const std::string& image = {});

/// Returns the outline() of a map's grid in the world, where the map is: every corner under the map's pose, rounded
/// there. Nothing if no cell is occupied.
///
/// \throws std::invalid_argument as outline() of the grid does, and for a pose that checkPose() refuses
///
/// \snippet occupancy_grid_io.cpp occupancy map
TRICOVER_EXPORT std::optional<Polygon> outline(
    const OccupancyMap& map, const IsOccupied& is_occupied = [](std::int8_t value) { return value != 0; });

}  // namespace tricover
