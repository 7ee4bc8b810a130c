// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

namespace tricover::bench {

/// fcl::continuousCollide of two robots that both follow an fcl::SplineMotion, as a fleet planner asks it: by
/// conservative advancement and by CCDC_NAIVE with 15 samples; footprints of ours and FCL's prisms, discs of ours and
/// FCL's spheres. All motions are asked about, so that the misses are counted among all.
std::vector<Result> measureSplines(const Settings& settings);

}  // namespace tricover::bench
