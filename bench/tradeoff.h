// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::bench {

/// Time against error of distances, times of impact and penetrations, ours at all settings and the rivals' at theirs,
/// against truths that exact arithmetic gave or confirmed. Writes `<directory>/values.md`, values.csv and values.dat,
/// which tradeoff.gp draws. False if one of ours is off by more than its setting allows.
bool runValueTradeoff(const std::string& directory, bool full);

/// Wrong collisions, and what distances, times of impact, penetrations and contacts are off by, with the scene moved
/// far from the origin, scaled, and squeezed to slivers, each method at its best settings, against exact arithmetic.
/// Writes
/// `<directory>/extremes.md`, .csv and .dat. False if one of ours is wrong, or off by more than it allows.
bool runExtremes(const std::string& directory, bool full);

}  // namespace tricover::bench
