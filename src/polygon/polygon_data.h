// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "polygon/derived.h"
#include "tricover/polygon.h"

namespace tricover::detail {

/// More positions than these don't fit into what is derived from a polygon, nor into memory as a rule.
constexpr std::size_t kMostPositions = std::size_t{1} << 29;

/// Throws std::invalid_argument for a path that is longer.
void requireCapacity(std::size_t positions);

/// What all copies of a polygon share. Rings lie one after another in `path`, each closed by a copy of its first
/// vertex, so that the edge at position e joins path[e] and path[e + 1]; ring r takes positions [ring_begin[r],
/// ring_begin[r + 1] - 1) and the closing vertex after them is no edge.
struct PolygonData {
  PolygonData(std::vector<Ring> rings_, FillRule fill_);

  std::size_t ringCount() const { return rings.size(); }
  std::size_t edgeBegin(std::size_t ring) const { return ring_begin[ring]; }
  std::size_t edgeEnd(std::size_t ring) const { return ring_begin[ring + 1] - 1; }

  /// Between positions in the path and the public numbering, which skips the closing vertices.
  std::size_t edgeNumber(std::size_t position) const {
    return ringCount() == 1 ? position : edgeNumberOfRings(position);
  }
  std::size_t edgePosition(std::size_t number) const;
  /// Throws std::out_of_range for what is no edge's number.
  std::size_t checkedEdgePosition(EdgeIndex number) const;

  std::size_t edgeNumberOfRings(std::size_t position) const;

  bool isDegenerate() const { return degenerate_edge != kNotDegenerate; }
  bool isPoint() const { return is_point; }

  /// False for the largest of polygons: no power of two is above their radius.
  bool fitsUnit() const { return radius <= unit; }

  /// A point of the polygon's frame from S, in units. Rounded by U. Quarters don't overflow, nor does what is between
  /// them in units.
  Vec2 inUnits(const Vec2& p) const {
    return extent < 0x1p1000 ? Vec2((p - origin) * inverse_unit) : Vec2((0.25 * p - 0.25 * origin) * inverse_unit * 4);
  }

  std::uint64_t id;
  Vec2 origin;    ///< S
  double radius;  ///< at least the distance from S to any vertex
  double extent;  ///< the largest |x| + |y| of a vertex or of S: scales the rounding errors
  /// A power of two, at least the radius (where that is finite and above 2^-1000) and below 2 radii; and 1 / unit.
  double unit, inverse_unit;
  FillRule fill;
  std::vector<Vec2> path;
  std::vector<std::size_t> ring_begin;
  std::vector<Ring> rings;
  /// The position of the one edge of a degenerate polygon, a segment or a point: what a margin makes a stadium or a
  /// disc of. S is on it but for rounding, and on a point exactly.
  static constexpr std::size_t kNotDegenerate = static_cast<std::size_t>(-1);
  std::size_t degenerate_edge;
  bool is_point;  ///< whether that edge has no length
  // The places of what is derived, and what has been paid for doing without.
  Derived hierarchy, discs;  ///< boxes around edges; discs in the region
  Rent hierarchy_rent{Stages::Hierarchy}, discs_rent{Stages::All}, starts_rent{Stages::Paid};
  Derived convexity;  ///< whether it is convex
  Derived starts;     ///< the starts of rings that need be asked for
  Derived cover;      ///< the discs that a search for a way apart asks first
  Derived outline;    ///< the convex outline that contacts go by
};

}  // namespace tricover::detail
