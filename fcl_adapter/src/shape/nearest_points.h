// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/distance.h"

namespace tricover_fcl {

/// Nearest points of polygons become those of the polygons grown by their margins, whose sum DistanceOptions::margin
/// was: each goes towards the other by its own margin. Where the margins meet, both become one point that is within
/// either.
inline void moveByMargins(tricover::DistanceResult& found, double margin_a, double margin_b) {
  const tricover::Vec2 between = found.point_b - found.point_a;
  if (found.distance > 0) {
    const tricover::Vec2 towards = between.stableNormalized();
    found.point_a += margin_a * towards;
    found.point_b -= margin_b * towards;
  } else {
    if (margin_a > 0) found.point_a += margin_a / (margin_a + margin_b) * between;
    found.point_b = found.point_a;
  }
}

}  // namespace tricover_fcl
