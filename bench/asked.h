// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

/// Studies of the core alone: a job a study, and a method a column.
namespace tricover::bench {

/// Contacts by their detail, and penetration, beside `crossings` and GEOS's whole overlay of the same poses.
std::vector<Result> measureContactCosts();

/// Every query that takes a cache, with one ("cached") and without ("none"): triangles to outlines of 512 vertices,
/// resting on each other, close to each other, in steps and in jumps.
std::vector<Result> measureCaches();

/// A speckled map as one polygon, beside a Scene with a body for every island.
std::vector<Result> measureIslands();

/// Bodies that rotate or slide close to another one: a column a gap.
std::vector<Result> measureGaps();

/// Bodies that start in contact, or whose contact lasts: a column a time_error.
std::vector<Result> measureLastingContact();

/// Maps, combs and noise simplified outwards: nanoseconds a vertex.
std::vector<Result> measureSimplification();

/// A part that is placed anew in a layout with its container, a polygon with a hole: a Scene beside a scan of boxes.
std::vector<Result> measureContainers();

/// A car in an area, and in the union of a scene's areas, beside GEOS's prepared geometry.
std::vector<Result> measureCovers();

/// A map of 10,000 and of a million 8-gons, each a polygon of its own, beside Boost's rtree. Its rows "bytes a body"
/// are bytes.
std::vector<Result> measureStillMaps();

/// Robots in maps of rooms, and in those of the folder that the environment's MAPS names: random poses, free ones near walls, drives;
/// beside a loop over the map's cells.
std::vector<Result> measureRobots();

}  // namespace tricover::bench
