// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover::support {

struct Case {
  Polygon a;
  Pose pose_a;
  Polygon b;
  Pose pose_b;
};

/// One way in which a pair can be degenerate; the same seed always makes the same case, and both outcomes are common.
struct Family {
  const char* name;
  Case (*make)(std::uint64_t seed);
};

const std::vector<Family>& families();

}  // namespace tricover::support
