// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/errors.h"
#include "polygon/cache_contents.h"
#include "polygon/polygon_data.h"
#include "tricover/collide_options.h"

namespace tricover::detail {

inline void checkOptions(const CollideOptions& options) {
  requireFiniteMargin(options.margin, "margin");
  requireFiniteNotNegative(options.tolerance, "tolerance");
  requireTouching(options.touching);
}

/// collide() with any margin, for operands and options that have been checked. `defect` is defectOf() the poses. The
/// cache may be null.
bool collideChecked(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b, double defect,
                    Certificate* cache, const CollideOptions& options);

}  // namespace tricover::detail
