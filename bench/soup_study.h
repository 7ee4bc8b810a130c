// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

namespace tricover::bench {

/// Soups of triangles, of needles and of overlapping rings on the study's workloads, with 15 to 1024 vertices. FCL's
/// BVH gets the same triangles, flat. GEOS and Boost are left out: such rings aren't a valid geometry; so are FCL's
/// convex solvers, which would have to ask each triangle against each.
std::vector<Result> measureSoups(const Settings& settings);

}  // namespace tricover::bench
