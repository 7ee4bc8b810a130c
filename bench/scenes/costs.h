// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "countries.h"

namespace tricover::bench {

/// Bodies of equal density: what a frame costs for each body that moves, by thread CPU time.
struct CrowdCost {
  std::size_t bodies;
  double all_moving_ns, few_moving_ns;  ///< all of them, and one in a hundred
  double bytes;                         ///< a body, polygons left aside, after the first frame
  double build_ns;                      ///< a body: added, and the first frame
};
std::vector<CrowdCost> measureCrowdCosts();

/// Frames in which all bodies of a crowd move, by wall time.
struct FrameCost {
  std::size_t bodies;
  double serial_ns, threads_ns;  ///< a body, on one thread and on 2
  bool same;                     ///< both found the same pairs in each frame
};
FrameCost measureFrameOnThreads();

/// What answers one against many on the map of countries, made ready: until the first answer.
struct MapCost {
  std::string method;
  double bytes, build_ns;  ///< an obstacle
};
std::vector<MapCost> measureMapCosts(const Countries& countries);

/// Many poses of a robot in the map of countries, by wall time.
struct BatchCost {
  std::size_t poses;
  double one_by_one_ns, serial_ns, threads_ns;  ///< a pose: by collides() for one, for many, and for many on 2 threads
  bool same;                                    ///< all three gave the same answers
};
BatchCost measureBatch(const Countries& countries, bool full);

/// Robots on splines among obstacles: all conflicts with their times, by thread CPU time.
struct FleetCost {
  std::size_t robots, obstacles, conflicts;
  double scene_ms, swept_ms;  ///< Scene::impacts(); timeOfImpact() for all whose swept boxes meet in Boost's rtree
  double longest_difference;  ///< of two times of one conflict; infinite where one method knows a conflict more
};
FleetCost measureFleet(bool full);

}  // namespace tricover::bench
