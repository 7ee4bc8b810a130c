// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include <cstddef>

#include "tricover/collide.h"

namespace tricover_fcl {

/// Both are polygons. The shapes' margins come on top of the options'.
template <typename S>
std::size_t collidePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                            const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                            fcl::CollisionResult<S>& result);

}  // namespace tricover_fcl
