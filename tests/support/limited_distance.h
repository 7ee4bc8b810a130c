// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "tricover/distance.h"

namespace tricover::support {

struct LimitedOptions : DistanceOptions {
  double limit = std::numeric_limits<double>::infinity();
};

/// distanceWithin(), and infinity, without points and edges, for nothing: so that tests ask with a limit or without.
inline DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                               const LimitedOptions& options) {
  const Vec2 none = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return distanceWithin(a, pose_a, b, pose_b, options.limit, options)
      .value_or(DistanceResult{std::numeric_limits<double>::infinity(), none, none, -1, -1});
}

inline DistanceResult distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                               PairCache& cache, const LimitedOptions& options) {
  const Vec2 none = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return distanceWithin(a, pose_a, b, pose_b, options.limit, cache, options)
      .value_or(DistanceResult{std::numeric_limits<double>::infinity(), none, none, -1, -1});
}

}  // namespace tricover::support
