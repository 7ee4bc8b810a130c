// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measure.h"

namespace tricover::bench {

/// 500 round robots that move, through FCL's broadphase: discs of ours and FCL's spheres.
Result measureRoundFleet(const Settings& settings);

}  // namespace tricover::bench
