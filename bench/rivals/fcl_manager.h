// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>

#include <memory>

namespace tricover::bench {

using FclManager = std::unique_ptr<fcl::BroadPhaseCollisionManagerd>;

/// FCL's two fastest managers. (SSaP, the interval tree and the hash took 1.1 to 260 times as long, wherever they were
/// timed; SaP loses pairs or hangs after rotations.)
inline FclManager makeFclManager(bool array_tree) {
  if (array_tree) return std::make_unique<fcl::DynamicAABBTreeCollisionManager_Arrayd>();
  return std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>();
}

}  // namespace tricover::bench
