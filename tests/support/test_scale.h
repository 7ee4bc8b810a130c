// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdlib>

namespace tricover::support {

/// `full`, or the share of it that the environment asks for (TRICOVER_TEST_SCALE=0.1): sanitizers and debug builds.
/// At least as many as it takes that cases aren't all alike.
inline int scaledCount(int full, int least = 1) {
  const char* scale = std::getenv("TRICOVER_TEST_SCALE");
  return scale ? std::max(least, static_cast<int>(full * std::atof(scale))) : full;
}

/// Whether that is less than all.
inline bool isScaledDown() { return scaledCount(1000) < 1000; }

}  // namespace tricover::support
