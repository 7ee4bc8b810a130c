// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::bench {

/// What distances, times of impact, penetrations and contacts are off by with the scene moved far from the origin,
/// scaled, and squeezed to slivers, each method at its best settings, against exact arithmetic. Writes
/// `<directory>/value_extremes.md`, .csv and .dat. False if one of ours is off by more than it allows.
bool runValueExtremes(const std::string& directory, bool full);

}  // namespace tricover::bench
