// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "countries.h"
#include "measure.h"
#include "tricover/pose.h"

/// The main job: one country is driven among all the others.
namespace tricover::bench {

/// A circle around the Atlantic, turning with it; or straight from the Atlantic through Eurasia
/// to the Pacific. Poses of a centred polygon.
std::vector<Pose> circularDrive(std::size_t positions = workloads::kCircularPositions);
std::vector<Pose> linearDrive(std::size_t positions = workloads::kLinearPositions);

/// Times the scene by tricover's core alone and, through FCL's broadphase (DynamicAABBTreeCollisionManager) and the
/// unmodified fcl::collide, by tricover's shapes, by prisms of the convex pieces and by flat BVH meshes.
Result measureDrive(std::shared_ptr<const Countries> countries, const std::string& mover, const std::string& trajectory,
                    const Settings& settings);

}  // namespace tricover::bench
