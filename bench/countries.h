// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "measure.h"
#include "workloads.h"

/// The main job: one country is driven among all the others.
namespace tricover::bench {

using Countries = std::vector<workloads::NamedPolygon>;

/// Reads workloads::readPolygons' format, leaving out what spans the map: those outlines cross the antimeridian or go
/// around the pole, so that in the plane they are a stripe from edge to edge.
Countries readCountries(std::istream& in);

/// The country whose name ends with "_<name>". Throws std::invalid_argument if there is none.
std::size_t findCountry(const Countries& countries, const std::string& name);

/// The polygon with its origin() shifted to (0, 0), as one authors a shape that is to turn.
Polygon centred(const Polygon& polygon);

/// A circle around the Atlantic, turning with it; or straight from the Atlantic through Eurasia
/// to the Pacific. Poses of a centred polygon.
std::vector<Pose> circularDrive(std::size_t positions = workloads::kCircularPositions);
std::vector<Pose> linearDrive(std::size_t positions = workloads::kLinearPositions);

/// Times the scene by tricover's core alone and, through FCL's broadphase (DynamicAABBTreeCollisionManager) and the
/// unmodified fcl::collide, by tricover's shapes, by prisms of the convex pieces and by flat BVH meshes.
Result measureDrive(std::shared_ptr<const Countries> countries, const std::string& mover, const std::string& trajectory,
                    const Settings& settings);

}  // namespace tricover::bench
