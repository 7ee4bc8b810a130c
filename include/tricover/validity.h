// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The ways in which the rings of a polygon can be at odds with the rules of GeoJSON, WKT and GIS (OGC Simple
/// Features).
enum class SelfCrossingKind {
  Crossing,          ///< Two edges cross at a point that is an end of neither.
  CrossingAtVertex,  ///< Rings cross where a vertex is on another edge, or equal to another vertex.
  Overlap,           ///< Two edges run along each other for more than a point.
  RepeatedRing,      ///< Two rings have the same vertices in the same cyclic order, forwards or backwards.
  NoArea,            ///< All vertices of a ring are on one line, or equal.
  HoleOutside,       ///< A ring runs the way that holes run, but the region is inside of it and not around it.
};

/// A place where rings cross or repeat.
struct SelfCrossing {
  SelfCrossingKind kind;  ///< The kind of it.
  Vec2 point;             ///< Where, in the polygon's frame. Rounded for Crossing, otherwise a vertex, exactly.
  std::size_t ring_a;     ///< A ring, by its number in Polygon::rings().
  std::size_t ring_b;     ///< The other ring, or the same one. For HoleOutside: the first shell.
  EdgeIndex edge_a;  ///< The edge of ring_a, numbered as in Polygon::edgeStart(). For whole rings: their first one.
  EdgeIndex edge_b;  ///< The edge of ring_b. Where rings cross at a vertex of theirs: the edge that starts there.
  std::string text;  ///< A sentence in plain words, with the rings, their vertices and the point.
};

/// Returns where the rings of a polygon cross themselves or each other, repeat each other, or have no area, and which
/// holes are outside of every shell. The list is sorted by edge_a, then edge_b; an empty list means a valid polygon.
///
/// Such a polygon is legal in every query, by its fill rule. Files for other programs need valid ones.
///
/// Every decision is exact; only points of crossings are rounded. Rings may touch, themselves or each other, at
/// points. Other libraries refuse some touches, as of a ring with itself.
///
/// The direction of a ring says whether it is meant as a hole: holes run against the first ring that has the region
/// inside and not around it. The fill rule doesn't ask for the direction under FillRule::EvenOdd, so HoleOutside is a
/// hint there. Rings that cross others are not tested for it.
///
/// Takes O((n + k) log n) for most polygons, with k pairs of edges that meet.
///
/// The search ends after `most`, which are then any, not the first ones.
///
/// \snippet validity.cpp self crossings
TRICOVER_EXPORT std::vector<SelfCrossing> selfCrossings(const Polygon& polygon,
                                                        std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace tricover
