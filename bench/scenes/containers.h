// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "target.h"

namespace tricover::bench {

/// A part that is placed anew in a layout with its container, a polygon with a hole: ns a placement, thread CPU time.
struct ContainerCost {
  std::string parts, placing;
  double hits;                          ///< the share that collides
  double scan_ns, scene_ns, cached_ns;  ///< the scan looks at the container where a box leaves the hole alone
  bool same;                            ///< all gave the same answers
};

std::vector<ContainerCost> measureContainers();
std::vector<Target> judgeContainers(const std::vector<ContainerCost>& costs);

}  // namespace tricover::bench
