// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// The box around a posed polygon's vertices, as they are rounded.
inline Eigen::AlignedBox2d boundsOf(const tricover::Polygon& polygon,
                                    const tricover::Pose& pose = tricover::Pose::Identity()) {
  Eigen::AlignedBox2d box;
  for (const tricover::Ring& ring : polygon.rings()) {
    for (const tricover::Vec2& vertex : ring) box.extend(pose * vertex);
  }
  return box;
}

}  // namespace tricover_fcl
