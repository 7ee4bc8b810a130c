// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "convex/posed_vertices.h"
#include "distance/distance_result.h"
#include "distance/options.h"

namespace tricover::detail {

/// Where a's edges are nearest to a point b.
struct PointFoot {
  std::size_t edge;    ///< its position in a's path
  double distance;     ///< right to PosedVertices::kRelativeError
  double part;         ///< Foot::part()
  bool may_be_inside;  ///< the point isn't certainly outside of the region
};

/// Nothing where plain doubles don't do. `defect` is defectOf() the poses.
std::optional<PointFoot> nearestFoot(const PosedVertices& vertices, double defect);

/// Of a point b and anything; false where plain doubles don't do.
bool pointDistance(const DistancePair& pair, const DistanceQuery& options, DistanceResult& result);

}  // namespace tricover::detail
