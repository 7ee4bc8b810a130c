// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"

namespace tricover::bench {

/// What one edge of a polygon costs.
struct Footprint {
  std::string kind;
  std::size_t vertices;
  double bytes;  ///< on the heap, beyond the rings that were given, once every kind of boolean query has been asked
  double ns;     ///< from rings to a polygon with all that collide derives from it
};

std::vector<Footprint> measureFootprints(const Settings& settings);

}  // namespace tricover::bench
