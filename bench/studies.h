// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "countries.h"
#include "measure.h"
#include "poses.h"
#include "workloads.h"

/// What is timed, one study a file.
namespace tricover::bench {

/// Kinds, vertices of both polygons, workloads.
struct Cell {
  workloads::Kind kind;
  std::size_t vertices_fixed, vertices_moving;
  std::vector<std::string> workloads;
};

/// The fixed polygon and the moving one.
std::pair<Polygon, Polygon> polygonsOf(const Cell& cell);

/// Table 2's trajectories, "gap 0.1" and "gap 0.01" on the circle, "contact", "near", "overlap".
const std::vector<std::string>& workloadNames();
bool isCoherent(const std::string& workload);

/// Collisions: all of 8 .. 1024 against all of 8 .. 1024 on every workload where `full`; else the diagonal, thinned
/// out, and the corner of many fixed against few moving vertices, and the grid of the paper's Figure 12: contours on
/// the circle. The paper's Algorithm 3 is timed on the diagonal's two trajectories of Table 2.
std::vector<Cell> studyCells(bool full);
std::vector<Result> measureCell(const Cell& cell, const Settings& settings);

/// Distances on the study's trajectories and on random poses whose regions are apart: all kinds on the study's
/// diagonal, thinned out, and many fixed against few moving vertices; more sizes where `full`.
std::vector<Cell> distanceCells(bool full);
std::vector<Result> measureDistances(const Cell& cell, const Settings& settings);

/// Times of impact. "sliding" motions keep their direction, "turning" ones turn by up to 150 degrees either way. Both
/// come from near the fixed polygon, into it or past it.
std::vector<Cell> impactCells(bool full);
std::vector<Result> measureImpacts(const Cell& cell, const Settings& settings);

/// Contacts of a body that rests or slides on another: the core with and without a cache, and Box2D's manifolds where
/// it takes the polygons.
std::vector<Result> measureContacts(const Settings& settings);

/// Through FCL: polygons of 4 (a rectangle), 8 and 64 vertices, and a disc, against discs of our own and FCL's sphere,
/// cylinder and capsule, beside FCL's own pairs of the same kind; collide and distance, in both orders of the operands.
std::vector<Result> measureRounds(const Settings& settings);

/// Soups of triangles, of needles and of overlapping rings on the study's workloads, with 15 to 1024 vertices. FCL's
/// BVH gets the same triangles, flat. GEOS and Boost are left out: such rings aren't a valid geometry; so are FCL's
/// convex solvers, which would have to ask each triangle against each.
std::vector<Result> measureSoups(const Settings& settings);

/// Writes countries.svg (the main job with its hits), algorithm.svg (covering, influence areas and hits of one pair)
/// and workloads.svg (the kinds of Figure 11 on their trajectories).
void drawPictures(const Countries& countries, const std::string& directory);

/// Writes what plots.gp draws of these results: times.dat, grid.dat, distance.dat and impact.dat in the directory.
void writePlotData(const std::vector<Result>& study, const std::vector<Result>& distances,
                   const std::vector<Result>& impacts, const std::string& directory);

}  // namespace tricover::bench
