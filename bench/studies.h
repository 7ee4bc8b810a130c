// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "measure.h"

/// The studies of pairs, through FCL and beside its solvers.
namespace tricover::bench {

/// Collisions: all of 8 .. 1024 against all of 8 .. 1024 on every workload where `full`; else the diagonal, thinned
/// out, and the corner of many fixed against few moving vertices, and the grid of the paper's Figure 12: contours on
/// the circle. The paper's Algorithm 3 is timed on the diagonal's two trajectories of Table 2.
std::vector<Result> measureCollisions(bool full, const Settings& settings);

/// Distances on the study's trajectories and on random poses whose regions are apart: all kinds on the study's
/// diagonal, thinned out, and many fixed against few moving vertices; more sizes where `full`.
std::vector<Result> measureDistances(bool full, Settings settings);

/// Times of impact. "sliding" motions keep their direction, "turning" ones turn by up to 150 degrees either way. Both
/// come from near the fixed polygon, into it or past it.
std::vector<Result> measureImpacts(bool full, Settings settings);

/// Contacts of a body that rests or slides on another: the core with and without a cache, and Box2D's manifolds where
/// it takes the polygons.
std::vector<Result> measureContacts(const Settings& settings);

/// Through FCL: polygons of 4 (a rectangle), 8 and 64 vertices, and a disc, against discs of our own and FCL's sphere,
/// cylinder and capsule, beside FCL's own pairs of the same kind; collide and distance, in both orders of the operands.
std::vector<Result> measureRounds(Settings settings);

/// Soups of triangles, of needles and of overlapping rings on the study's workloads, with 15 to 1024 vertices. FCL's
/// BVH gets the same triangles, flat. GEOS and Boost are left out: such rings aren't a valid geometry; so are FCL's
/// convex solvers, which would have to ask each triangle against each.
std::vector<Result> measureSoups(const Settings& settings);

/// Writes algorithm.svg (covering, influence areas and hits of one pair) and workloads.svg (the kinds of Figure 11 on
/// their trajectories).
void drawPictures(const std::string& directory);

/// Writes what plots.gp draws of these results: times.dat, grid.dat, distance.dat and impact.dat in the directory.
void writePlotData(const std::vector<Result>& study, const std::vector<Result>& distances,
                   const std::vector<Result>& impacts, const std::string& directory);

}  // namespace tricover::bench
