// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <typeinfo>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// By its class, because fcl::TriangleP shares the node type. Most often one class has one description; where shared
/// libraries have their own, names are compared, which takes longer and is left out for other node types.
template <typename S>
bool isPolygon(const fcl::CollisionGeometry<S>& geometry) {
  const std::type_info &type = typeid(geometry), &ours = typeid(PolygonShape<S>);
  return &type == &ours || (geometry.getNodeType() == fcl::GEOM_TRIANGLE && type == ours);
}

}  // namespace tricover_fcl
