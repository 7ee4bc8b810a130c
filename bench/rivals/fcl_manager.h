// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/broadphase/broadphase_collision_manager.h>

#include <memory>
#include <string>
#include <vector>

namespace tricover::bench {

using FclManager = std::unique_ptr<fcl::BroadPhaseCollisionManagerd>;

/// "tree", "array tree", "SSaP", "interval tree" or "hash": FCL's managers that bear this. (SaP loses pairs or hangs
/// after turns.) The hash's cells are as large as an object in `cell`, over `low` .. `high`.
FclManager makeFclManager(const std::string& name, const fcl::Vector3d& low, const fcl::Vector3d& high, double cell);

const std::vector<std::string>& fclManagers();

}  // namespace tricover::bench
