// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Edges in floats, in units; of a large polygon those between every few vertices only.
struct ThinnedOutline {
  explicit ThinnedOutline(const PolygonData& polygon);

  struct Edge {
    float x, y, along_x, along_y, inverse_square;
  };
  std::vector<Edge> edges;
  FillRule fill;
};

/// Points, in units, and how deep in the region they are as far as floats and a thinned outline tell, negative outside.
struct DepthProbes {
  float x[kLanes], y[kLanes], depth[kLanes];
};
extern Simd<void(const ThinnedOutline& outline, DepthProbes& probes)> measureDepths;

/// The radius, in units, of a disc around `center` (also in units) that lies in the region, at most `most`; 0 if that
/// can't be shown.
double provenRadius(const PolygonData& polygon, const Vec2& center, double most);

}  // namespace tricover::detail
