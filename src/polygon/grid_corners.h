// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "numbers/errors.h"
#include "tricover/outline.h"

namespace tricover::detail {

/// The corners' coordinates along one axis.
inline std::vector<double> gridCorners(double origin, double resolution, std::size_t count) {
  std::vector<double> at;
  at.reserve(count + 1);
  for (std::size_t i = 0; i <= count; ++i) {
    at.push_back(origin + static_cast<double>(i) * resolution);
    if (!std::isfinite(at.back())) refuse("origin", "corner " + std::to_string(i) + " isn't finite");
    // Rounding is monotonic, so rings are right unless corners become one.
    if (i > 0 && !(at[i] > at[i - 1]))
      refuse("resolution", "corners " + std::to_string(i - 1) + " and " + std::to_string(i) +
                               " round to the same coordinate so far from 0");
  }
  return at;
}

inline void checkCells(const OccupancyGrid& grid) {
  if (grid.width != 0 && grid.height > std::numeric_limits<std::size_t>::max() / grid.width)
    refuse("height", "the number of cells overflows");
  if (grid.cells.size() != grid.width * grid.height)
    refuse("cells", std::to_string(grid.cells.size()) + " values for " + std::to_string(grid.width) + " x " +
                        std::to_string(grid.height) + " cells");
  if (!(grid.resolution > 0)) refuse("resolution", "it must be positive");
}

}  // namespace tricover::detail
