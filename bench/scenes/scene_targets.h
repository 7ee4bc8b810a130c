// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "costs.h"
#include "frames.h"
#include "measure.h"
#include "target.h"

namespace tricover::bench {

/// All that is measured of scenes.
struct MeasuredScenes {
  std::vector<FramesResult> frames;
  std::vector<Result> layouts, maps, rays;
  std::vector<CrowdCost> crowds;
  FrameCost frame_on_threads;
  std::vector<MapCost> map_costs;
  BatchCost batch;
  FleetCost fleet;
};

std::vector<Target> judge(const MeasuredScenes& measured);

}  // namespace tricover::bench
