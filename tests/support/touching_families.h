// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "families.h"

namespace tricover::support {

/// Pairs that often touch without overlapping: on lattices, turned exactly, of all sizes, and off by an ulp here and
/// there. Overlaps, touches and pairs apart are all common.
const std::vector<Family>& touchingFamilies();

}  // namespace tricover::support
