// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "countries.h"

namespace tricover::bench {

/// Writes crowd.svg (a frame of moving outlines), layout.svg (a part among the others, placed anew), rays.svg (rays from
/// a robot in the map of countries, and in the warehouse) and configurations.svg (where it may be there, at some
/// headings). Colours are the scene's answers.
void drawScenes(const Countries& countries, const std::string& directory);

}  // namespace tricover::bench
