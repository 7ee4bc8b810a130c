// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measure.h"

namespace tricover::bench {

struct CrowdResult {
  Result result;
  double colliding;  ///< share of the objects that collide with another one
};

/// 2,000 outlines of 64 vertices, each turning and driving in a circle of its own, about 5 % of them in a collision. A
/// query is one frame: every object is moved, FCL's DynamicAABBTreeCollisionManager is updated and finds the pairs,
/// and each of them is asked. Methods: tricover's core without coherence, tricover's shapes and FCL's BVH meshes
/// through the unmodified fcl::collide, and the manager alone, without asking.
CrowdResult measureCrowd(const Settings& settings);

}  // namespace tricover::bench
