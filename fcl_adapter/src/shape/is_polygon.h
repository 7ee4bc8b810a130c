// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <typeinfo>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// By its class, because fcl::TriangleP shares the node type. That is asked first: classes that differ are compared by
/// their names.
template <typename S>
bool isPolygon(const fcl::CollisionGeometry<S>& geometry) {
  return geometry.getNodeType() == fcl::GEOM_TRIANGLE && typeid(geometry) == typeid(PolygonShape<S>);
}

}  // namespace tricover_fcl
