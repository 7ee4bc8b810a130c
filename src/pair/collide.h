// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/cache_contents.h"
#include "polygon/polygon_data.h"
#include "tricover/collide_options.h"

namespace tricover::detail {

/// collide() with options that have been checked, a margin of 0 or more, and touching as a collision unless there is a
/// margin or a tolerance. `defect` is defectOf() the poses. The cache may be null.
bool collide(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, double defect,
             Certificate* cache, const CollideOptions& options);

}  // namespace tricover::detail
