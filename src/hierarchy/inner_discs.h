// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Edges in floats, in units; of a large polygon those between every few vertices only. An edge ends at the same floats
/// as the next one begins at.
struct ThinnedOutline {
  explicit ThinnedOutline(const PolygonData& polygon);

  struct Edge {
    float x, y, end_y;
    float along_x, along_y, inverse_square;
    float slope;  ///< of x over y; of a level edge 0
  };
  std::vector<Edge> edges;
  bool is_even_odd;
};

/// Points, in units, and how deep in the region they are as far as floats and a thinned outline tell, negative outside.
struct DepthProbes {
  float x[kLanes], y[kLanes], depth[kLanes];
};
extern Simd<void(const ThinnedOutline& outline, DepthProbes& probes)> measureDepths;

/// A disc in a polygon's units, from S.
struct Disc {
  Vec2 center;
  double radius;
};

/// The radius of a disc around `center` that lies in the region, at most little more than `most`; 0 if that can't be
/// shown.
double provenRadius(const PolygonData& polygon, const Vec2& center, double most);

/// Up to `most` discs that are proven to lie in the region: around the deepest places of a grid over the root box and
/// the deepest near those, deepest first. No centre is within `spread` times the radius of a disc before it.
std::vector<Disc> discsOnGrid(const PolygonData& polygon, int along, int across, std::size_t most, double spread);

}  // namespace tricover::detail
