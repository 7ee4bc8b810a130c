// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// The box around a posed polygon's vertices, as they are rounded.
inline Eigen::AlignedBox2d boundsOf(const tricover::Polygon& polygon,
                                    const tricover::Pose& pose = tricover::Pose::Identity()) {
  Eigen::AlignedBox2d box;
  for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e) box.extend(pose * polygon.edgeStart(e));
  return box;
}

}  // namespace tricover_fcl
