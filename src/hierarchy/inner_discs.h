// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hierarchy/hierarchy.h"

namespace tricover::detail {

/// Edges in floats, in units; of a large polygon those between every few vertices only. An edge ends at the same floats
/// as the next one begins at.
struct ThinnedOutline {
  static constexpr std::size_t kSearched = 128;
  explicit ThinnedOutline(const PolygonData& polygon);
  /// Whether it has all edges of a polygon.
  static bool isWhole(const PolygonData& polygon) { return polygon.path.size() < kSearched; }

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

/// By how much a measured depth is too large at most, of points with |x| + |y| < 4 in units from S; in 2^-24:
///   by edges  13 |u| + 8 D, see besideSegment(), with |u| <= 2 and D <= 5                                66
///             the vertices, rounded to floats, and what is 0 of them below 2^-60                          2
///             an edge of 2^-33 at most that is taken for its start                                        1
///   by lines  of n p - d the products' factors and themselves, |n| being 1; d; two differences   4 + 4 + 1 + 10
///             an edge of 2^-30 or more, turned by less than 2^-21 by its vertices, rounded by U from S,
///             over 5 at most                                                                             40
constexpr double kDepthError = 0x1p-17;
static_assert(66 + 2 + 1 < 128 && 4 + 4 + 1 + 10 + 40 < 128);

/// A point that is as deep as this, as measured by all edges, is on the side that it is seen on:
///   the floats' outline, whose vertices are moved by less than 2^-23, winds around it as the polygon does;
///   which edges cross the point's height is told exactly, and of one vertex alike for both its edges;
///   an edge that crosses it is kSurelyBeside - kDepthError - 2^-23 to the left or the right, or more, and where is
///   told by five roundings of what is within its width, at most 2, and one of the way from its start, below 8: 18
///   2^-24.
/// (No coordinate but 0 is below 2^-60, so that no slope overflows; what underflows is far below that error.)
constexpr double kSurelyBeside = 0x1p-15;

/// The radius, in units, of a disc around `center` (also in units) that lies in the region, by the depth there that was
/// measured, more than which it need not be; 0 if that can't be shown.
double provenRadius(const PolygonData& polygon, const Vec2& center, float depth);

}  // namespace tricover::detail
