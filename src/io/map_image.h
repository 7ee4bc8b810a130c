// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/input.h"
#include "io/map_fields.h"
#include "tricover/occupancy_grid_io.h"

namespace tricover::detail {

constexpr std::size_t kMostPixels = 65535;  ///< along each side of an image
/// In all. A PNG file of a few megabytes can say that it has 4e9 of one colour.
constexpr std::size_t kMostCells = std::size_t{1} << 28;

/// \throws std::runtime_error for more than kMostCells
void checkSize(const Input& image, std::size_t width, std::size_t height);

/// The map of these fields and their image, PGM or PNG.
/// \throws std::runtime_error for what is no such image
OccupancyMap readMap(const MapFields& fields, const Input& image);

/// Reads an image's size and cells into a grid, whose other fields stay.
void readPgm(const Input& image, const MapFields& fields, OccupancyGrid& grid);
void readPng(const Input& image, const MapFields& fields, OccupancyGrid& grid);

/// In which mode writeMap() writes cells: scale if some are from 1 to 99.
MapMode modeOf(const OccupancyGrid& grid);

/// The files of a map whose YAML file names the image `image`.
struct MapFiles {
  std::string yaml, image;  ///< the bytes of each
};
/// \throws std::invalid_argument as writeOccupancyMap()
MapFiles writeMap(const OccupancyMap& map, const std::string& image);

/// The greys that stand for values of cells in an image.
struct CellGreys {
  MapMode mode;         ///< not raw
  bool is_transparent;  ///< whether unknown cells are transparent

  /// From 0 to 255. -1, 0 and 100 as map_saver writes them in mode trinary.
  std::uint8_t of(std::int8_t value) const {
    if (mode == MapMode::Scale) return static_cast<std::uint8_t>((255 * (100 - value) + 50) / 100);
    return value == kUnknownCell ? 205 : value == kFreeCell ? 254 : 0;
  }
};

/// The image files of a grid's cells.
std::string writePgm(const OccupancyGrid& grid, const CellGreys& greys);
std::string writePng(const OccupancyGrid& grid, const CellGreys& greys);

}  // namespace tricover::detail
