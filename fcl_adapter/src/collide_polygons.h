// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>

#include <cstddef>
#include <typeinfo>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

template <typename S>
bool isPolygon(const fcl::CollisionGeometry<S>& geometry) {
  return typeid(geometry) == typeid(PolygonShape<S>);
}

/// Both are polygons.
template <typename S>
std::size_t collidePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result);

}  // namespace tricover_fcl
