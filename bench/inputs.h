// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tricover/motion.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"
#include "workloads.h"

/// Poses, motions and outlines that are asked about.
namespace tricover::bench {

/// Table 2's trajectories, "gap 0.1" and "gap 0.01" on the circle, "contact", "near", "overlap".
const std::vector<std::string>& workloadNames();

/// Poses of the moving polygon on such a workload.
std::vector<Pose> posesOf(const std::string& workload, const Polygon& fixed, const Polygon& moving);

/// Random poses whose regions are apart: those of "contact", moved outwards to `low` .. `high` times the distance of
/// the origins. Apart from 1.03 on.
std::vector<Pose> separatedPoses(const Polygon& fixed, const Polygon& moving, double low, double high);

/// From near the fixed polygon, into it or past it, by half to twice the length, and turning by up to that angle either
/// way.
std::vector<Motion> randomMotions(const Polygon& fixed, const Polygon& moving, double length, double most_angle,
                                  std::uint64_t seed);

using Countries = std::vector<workloads::NamedPolygon>;

/// bench/data's, leaving out what spans the map: those outlines cross the antimeridian or go around the pole, so that
/// in the plane they are a stripe from edge to edge.
Countries readCountries();

}  // namespace tricover::bench
