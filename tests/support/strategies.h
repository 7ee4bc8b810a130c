// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/collide.h"
#include "tricover/paper.h"

namespace tricover::support {

/// Both ways to whether two polygons collide, which have to say the same.
enum class Strategy { Hierarchy, Paper };

inline const char* nameOf(Strategy strategy) { return strategy == Strategy::Paper ? "Paper" : "Hierarchy"; }

struct StrategyCaches {
  PairCache of_pair;
  paper::MaskCache of_mask;
};

inline bool collide(Strategy strategy, const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                    const CollideOptions& options = {}) {
  return strategy == Strategy::Paper ? paper::collide(a, pose_a, b, pose_b, options)
                                     : tricover::collide(a, pose_a, b, pose_b, options);
}

inline bool collide(Strategy strategy, const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                    StrategyCaches& caches, const CollideOptions& options = {}) {
  return strategy == Strategy::Paper ? paper::collide(a, pose_a, b, pose_b, caches.of_mask, options)
                                     : tricover::collide(a, pose_a, b, pose_b, caches.of_pair, options);
}

}  // namespace tricover::support
