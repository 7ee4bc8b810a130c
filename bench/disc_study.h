// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measure.h"

/// Discs: points with a margin.
namespace tricover::bench {

/// The core's polygons of 8 and 64 vertices against a disc, and beside it the same against an 8-gon of that size.
std::vector<Result> measureDiscs(const Settings& settings);

}  // namespace tricover::bench
