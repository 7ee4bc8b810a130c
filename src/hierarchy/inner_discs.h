// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Edges in floats, in units; of a large polygon those between every few vertices only. An edge ends at the same floats
/// as the next one begins at.
struct ThinnedOutline {
  explicit ThinnedOutline(const PolygonData& polygon);
  /// Whether it has all edges of a polygon.
  static bool isWhole(const PolygonData& polygon) { return polygon.path.size() < kSearched; }

  struct Edge {
    float x, y, end_y;
    float to_end_x, to_end_y;  ///< as floats see it
    float along_x, along_y, inverse_square;
  };
  static constexpr std::size_t kSearched = 128;
  std::vector<Edge> edges;
  FillRule fill;
};

/// Points, in units, and how deep in the region they are as far as floats and a thinned outline tell, negative outside.
struct DepthProbes {
  float x[kLanes], y[kLanes], depth[kLanes];
};
extern Simd<void(const ThinnedOutline& outline, DepthProbes& probes)> measureDepths;

/// A point that is so far from all edges is on the side that it is seen on, if the outline is whole:
///   the floats' outline, whose vertices are moved by less than 2^-23, winds around it as the polygon does;
///   which edges cross the point's height is told exactly, and of one vertex alike for both its edges;
///   of an edge that crosses it and rises by r, the point is kSurelyBeside - 2^-23 to the left or the right: so its
///   cross product is at least r times that, and errs by less than r 2^-19: by three roundings of either product and
///   one of their difference, of r and lengths up to 4. (No coordinate but 0 is below 2^-60, so that nothing
///   underflows.)
constexpr double kSurelyBeside = 0x1p-16;

/// The radius, in units, of a disc around `center` (also in units) that lies in the region, at most `most`; 0 if that
/// can't be shown.
double provenRadius(const PolygonData& polygon, const Vec2& center, double most);

}  // namespace tricover::detail
