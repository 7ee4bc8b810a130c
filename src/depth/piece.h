// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "depth/peak.h"
#include "numbers/segment.h"

namespace tricover::detail {

/// A part of the part: a chain of several edges, or a simplex (an edge, or a triangle of the plane).
struct Piece {
  bool operator<(const Piece& other) const { return least > other.least; }

  double least;                                      ///< minus the upper bound of distances in it
  int corners;                                       ///< 2 or 3; 0 for a chain
  bool is_known = true;                              ///< whether it is certainly outside of the area
  std::size_t from = 0, to = 0;                      ///< a chain's points; an edge is `from`
  std::size_t at = 0;                                ///< the chain's point to look at next
  std::array<Vec2, 3> corner = {};                   ///< a simplex'
  Vec2 place = Vec2::Zero();                         ///< the place in it to look at next
  std::array<EdgePosition, Peak::kMost> edges = {};  ///< of the area, some that are near, the lowest at the place first
  std::size_t edge_count = 0;
  int looks = 0;  ///< at its peak, since it was cut

  /// Returns whether it is another one. If there are too many, the one that bounds least at the place goes.
  bool addEdge(EdgePosition edge) {
    for (std::size_t k = 0; k < edge_count; ++k)
      if (edges[k] == edge) return false;
    if (edge_count < edges.size()) ++edge_count;
    for (std::size_t k = edge_count - 1; k > 0; --k) edges[k] = edges[k - 1];
    edges[0] = edge;
    return true;
  }
};

/// The place in a simplex that has these barycentric coordinates.
inline Vec2 placeIn(const Piece& simplex, const OfCorners& coordinates) {
  Vec2 place = Vec2::Zero();
  for (int c = 0; c < simplex.corners; ++c) {
    const auto corner = static_cast<std::size_t>(c);
    place += coordinates[corner] * simplex.corner[corner];
  }
  return place;
}

// Triangles.

inline Vec2 centerOf(const Piece& cell) { return (cell.corner[0] + cell.corner[1] + cell.corner[2]) / 3; }

inline double reachOf(const Piece& cell, const Vec2& place) {
  double reach = 0;
  for (const Vec2& corner : cell.corner) reach = std::max(reach, (corner - place).norm());
  return reach;
}

inline std::size_t longestSideOf(const Piece& cell) {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t c = 0; c < 3; ++c)
    if (const double side = (cell.corner[(c + 1) % 3] - cell.corner[c]).norm(); side > length)
      length = side, longest = c;
  return longest;
}

inline double heightOf(const Piece& cell) {
  const std::size_t side = longestSideOf(cell);
  const Vec2 &v = cell.corner[side], along = cell.corner[(side + 1) % 3] - v;
  const double length = along.norm();
  return length > 0 ? std::abs(cross(along, cell.corner[(side + 2) % 3] - v)) / length : 0;
}

/// Whether a point is in it, and on none of its sides.
inline bool isInside(const Piece& cell, const Vec2& p) {
  const auto turn = [&](std::size_t c) { return cross(cell.corner[(c + 1) % 3] - cell.corner[c], p - cell.corner[c]); };
  return (turn(0) > 0 && turn(1) > 0 && turn(2) > 0) || (turn(0) < 0 && turn(1) < 0 && turn(2) < 0);
}

}  // namespace tricover::detail
