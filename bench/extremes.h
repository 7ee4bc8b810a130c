// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tricover::bench {

/// Wrong answers of each method with the scene moved far from the origin, scaled, and squeezed to slivers. Writes
/// `<directory>/extremes.md`, .csv and .dat. False if the exact method was wrong anywhere.
bool runExtremes(const std::string& directory, bool full);

}  // namespace tricover::bench
