// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::bench {

/// Poses of the moving polygon: "circular", "linear", "gap 0.1", "gap 0.01", "contact", "near" or "overlap".
std::vector<Pose> posesOf(const std::string& workload, const Polygon& fixed, const Polygon& moving);

/// Random poses whose regions are apart: those of "contact", moved outwards to `low` .. `high` times the distance of
/// the origins. Apart from 1.03 on.
std::vector<Pose> separatedPoses(const Polygon& fixed, const Polygon& moving, double low, double high);

}  // namespace tricover::bench
