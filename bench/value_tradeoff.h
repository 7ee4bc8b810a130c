// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::bench {

/// Time against error of distances, times of impact and penetrations, ours at all settings and the rivals' at theirs,
/// against truths that exact arithmetic gave or confirmed. Writes `<directory>/values.md`, values.csv and values.dat,
/// which tradeoff.gp draws. False if one of ours is off by more than its setting allows.
bool runValueTradeoff(const std::string& directory, bool full);

}  // namespace tricover::bench
