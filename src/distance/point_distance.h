// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "distance/distance_result.h"
#include "distance/options.h"

namespace tricover::detail {

/// Of a point b and anything; false where its edges are no way to tell.
bool pointDistance(const PosedVertices& pair, const DistanceQuery& options, DistanceResult& result);

}  // namespace tricover::detail
