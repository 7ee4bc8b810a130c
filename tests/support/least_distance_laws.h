// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <string>

#include "tricover/least_distance.h"

/// What leastDistance() promises, beside distances at many times on the way.
namespace tricover::support {

/// What time_of_impact.h calls L, without a margin: coming within 1e-13 of it may count as a contact.
double lengthOf(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b);

/// The square of the least distance of polygons that are only shifted: a vertex's path is a segment, and the distance
/// is least where a vertex of one is nearest to the other. Exact where sums of poses, vertices and shifts are.
mpq_class leastSquared(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b);

/// What is wrong with the result beside so many samples and the time of impact; empty if nothing is.
std::string wrongLeastDistance(const Polygon& a, const Motion& motion_a, const Polygon& b, const Motion& motion_b,
                               const LeastDistanceOptions& options, const LeastDistance& found, int samples);
std::string wrongLeastDistance(const Polygon& a, const Trajectory& trajectory_a, const Polygon& b,
                               const Trajectory& trajectory_b, const LeastDistanceOptions& options,
                               const LeastDistance& found, int samples);

}  // namespace tricover::support
