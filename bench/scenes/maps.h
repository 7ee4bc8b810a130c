// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "inputs.h"
#include "placed.h"

namespace tricover::bench {

/// Countries' outlines in rows, each centred, turned anyhow and 40 to 130 across, 100 apart.
Placement countriesMap(const Countries& countries, std::size_t obstacles);

/// Racks of 100 x 12 back to back, in blocks along aisles of 30, each a little off.
Placement warehouseMap(std::size_t racks);

/// Both, of 10,000 obstacles.
struct NamedMap {
  std::string name;
  Placement bodies;
};
std::vector<NamedMap> allMaps(const Countries& countries);

/// A fork lift of 12 vertices, 24 x 12.
Polygon forkLift();

/// Anywhere in the map, turned anyhow.
std::vector<Pose> randomPoses(const Placement& map, std::size_t count, std::uint64_t seed);

/// The poses that a planner that grows a tree asks about: from a random free pose in small steps towards another one
/// nearby, until it is reached or a step collides; then from the next free pose.
std::vector<Pose> plannerPath(const Placement& map, const Polygon& robot, std::size_t count, std::uint64_t seed);

/// A turn of rays from each of some free places of the robot.
constexpr std::size_t kRaysPerTurn = 360;
std::vector<Ray> raysAround(const Placement& map, const Polygon& robot, std::size_t places, double length,
                            std::uint64_t seed);

}  // namespace tricover::bench
