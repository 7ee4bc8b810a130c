// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "inputs.h"
#include "measure.h"

/// Studies of many bodies at once.
namespace tricover::bench {

/// A part in a tight layout of 80, by its number of vertices and by how it is placed. Each of eight parts in turn is
/// taken out and placed anew.
std::vector<Result> measureLayouts(const Settings& settings);

/// A fork lift of 12 vertices in maps of 10,000 obstacles, at random poses and along a planner's path.
std::vector<Result> measureMaps(const Countries& countries, const Settings& settings);

/// The nearest hit of each of 360 rays around some poses in those maps.
std::vector<Result> measureRays(const Countries& countries, Settings settings);

/// All conflicts of robots on splines with each other and with obstacles: Scene::impacts() beside timeOfImpact() of the
/// pairs whose swept boxes meet. Writes fleet.html, a recording of it.
std::vector<Result> measureFleet(const std::string& directory, bool full);

/// Many against many: 2,000 outlines, each turning and driving in a circle of its own, about 5 % of them in a
/// collision. A query is one frame: every object is moved, and all pairs that collide are wanted. First contours of 64
/// vertices, then convex polygons of 8, which Box2D takes.
std::vector<Result> measureFrames(const Settings& settings);

/// The cost of a frame of 1,000 to 100,000 outlines for each moving body, with one thread and with two.
std::vector<Result> measureCrowds();

}  // namespace tricover::bench
