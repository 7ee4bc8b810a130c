// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <stdexcept>
#include <string>

namespace tricover_fcl {

/// A query that tricover has no answer to yet. A type of its own so that the probe knows it for ours.
struct UnsupportedPair : std::logic_error {
  using std::logic_error::logic_error;
};

template <typename S>
std::string typeName(const fcl::CollisionGeometry<S>& geometry);

template <typename S>
[[noreturn]] void throwUnsupported(const char* operation, const fcl::CollisionGeometry<S>& o1,
                                   const fcl::CollisionGeometry<S>& o2) {
  throw UnsupportedPair(std::string("tricover: ") + operation + " of " + typeName(o1) + " and " + typeName(o2) +
                        " is not supported");
}

}  // namespace tricover_fcl
