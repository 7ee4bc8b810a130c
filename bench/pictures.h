// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "countries.h"

namespace tricover::bench {

/// Writes countries.svg (the main job with its hits), algorithm.svg (covering, influence areas and hits of one pair)
/// and workloads.svg (the kinds of Figure 11 on their trajectories).
void drawPictures(const Countries& countries, const std::string& directory);

}  // namespace tricover::bench
