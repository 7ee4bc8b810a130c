// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "countries.h"
#include "measure.h"

/// One polygon against many that are at rest: does it collide with any of them?
namespace tricover::bench {

/// A part in a tight layout of 80, by its number of vertices and by how it is placed. Each of eight parts in turn is
/// taken out and placed anew. Where `full`, with all of FCL's managers, else with the fastest.
std::vector<Result> measureLayouts(const Settings& settings, bool full);

/// A fork lift of 12 vertices in maps of 10,000 obstacles, at random poses and along a planner's path.
std::vector<Result> measureMaps(const Countries& countries, const Settings& settings, bool full);

/// The nearest hit of each of 360 rays around some poses in those maps.
std::vector<Result> measureRays(const Countries& countries, const Settings& settings);

}  // namespace tricover::bench
