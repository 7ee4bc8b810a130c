// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <iostream>
#include <string>
#include <typeinfo>

#include "numbers/errors.h"

/// How the adapter says no, in the core's words.
namespace tricover_fcl {

/// Throws std::invalid_argument: a value that no query can take.
using tricover::detail::refuse;

/// Throws std::logic_error: a question that tricover doesn't answer, though its values are right.
[[noreturn]] void refuseQuestion(const std::string& field, const std::string& wrong, const std::string& instead);

/// The class as C++ spells it.
std::string className(const std::type_info& type);

/// An operation about a geometry that FCL has no function for, either: names both classes.
template <typename S>
[[noreturn]] void refusePair(const char* operation, const fcl::CollisionGeometry<S>& o1,
                             const fcl::CollisionGeometry<S>& o2) {
  refuseQuestion(operation, "not supported for " + className(typeid(o1)) + " and " + className(typeid(o2)),
                 "make a triangle a PolygonShape or an fcl::BVHModel, and others of FCL's shapes, meshes or octrees");
}

/// Warns as FCL does about a pair that it has no function for: fcl::TriangleP's row is ours, but not its pairs.
template <typename S>
void warnAsFcl(const char* function, const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2) {
  std::cerr << "Warning: " << function << " function between node type " << o1.getNodeType() << " and node type "
            << o2.getNodeType() << " is not supported\n";
}

}  // namespace tricover_fcl
