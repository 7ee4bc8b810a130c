// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include <cstddef>

#include "tricover/collide.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Exactly one of the two is a polygon. Of the options, the margin counts.
template <typename S>
std::size_t collideMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                         const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                         const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                         fcl::CollisionResult<S>& result);

}  // namespace tricover_fcl
