// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

namespace tricover::bench {

struct FramesResult {
  Result result;
  double colliding;  ///< share of the objects that collide with another one
};

/// Many against many: 2,000 outlines, each turning and driving in a circle of its own, about 5 % of them in a
/// collision. A query is one frame: every object is moved, and all pairs that collide are wanted. First contours of 64
/// vertices, then convex polygons of 8, which Box2D takes. Where `full`, with all of FCL's managers, else with the
/// fastest.
std::vector<FramesResult> measureFrames(const Settings& settings, bool full);

}  // namespace tricover::bench
