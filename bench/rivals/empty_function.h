// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <memory>

namespace tricover::bench {

/// A geometry of no known type, whose collision function, once registered, answers "free" and does nothing else: what
/// fcl::collide costs whoever registers a function.
std::shared_ptr<fcl::CollisionGeometryd> emptyGeometry();

}  // namespace tricover::bench
