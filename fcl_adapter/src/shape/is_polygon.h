// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <typeinfo>

#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Whether it is one as far as the description of its class tells at a glance.
template <typename S>
bool isPlainlyPolygon(const fcl::CollisionGeometry<S>& geometry) {
  return &typeid(geometry) == &typeid(PolygonShape<S>);
}

/// By its class, because fcl::TriangleP shares the node type. Most often one class has one description; where shared
/// libraries have their own, names are compared, which takes longer and is left out for other node types.
template <typename S>
bool isPolygon(const fcl::CollisionGeometry<S>& geometry) {
  return isPlainlyPolygon(geometry) ||
         (geometry.getNodeType() == fcl::GEOM_TRIANGLE && typeid(geometry) == typeid(PolygonShape<S>));
}

}  // namespace tricover_fcl
