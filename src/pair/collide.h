// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/cache_contents.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// collide() for margins of 0 and more; the cache may be null.
bool collideWithin(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, Certificate* cache,
                   const CollideOptions& options);

}  // namespace tricover::detail
