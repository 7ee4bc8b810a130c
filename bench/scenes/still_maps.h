// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "placed.h"
#include "target.h"

namespace tricover::bench {

/// A map of 8-gons, each a polygon of its own: by thread CPU time, the heap's bytes.
struct StillMapCost {
  std::string method;
  std::size_t bodies;
  double bytes;                 ///< a body, its polygon included, before anything but one query was asked
  double build_ns;              ///< a body, made of its vertices and added, until the first answer
  double first_ns;              ///< whether a hexagon collides, where nobody has asked yet
  double collides_ns;           ///< there once more
  double hexagon_ns, point_ns;  ///< its distance, and a point's, from the nearest body
  double answers;               ///< all of them added up: the same of all methods
};

/// Of 10,000 bodies and of that many.
std::vector<StillMapCost> measureStillMaps(std::size_t most);
std::vector<Target> judgeStillMaps(const std::vector<StillMapCost>& costs);

/// The nearest of 10,000 bodies with a SceneCache and without, by thread CPU time.
struct NearestCost {
  std::string walk;
  double none_ns, cached_ns;
};

std::vector<NearestCost> measureNearest();
std::vector<Target> judgeNearest(const std::vector<NearestCost>& costs);

}  // namespace tricover::bench
