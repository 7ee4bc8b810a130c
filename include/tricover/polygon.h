// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "tricover/pose.h"

namespace tricover {

/// Vertices in order; not closed: the last vertex joins the first. Repeated and collinear vertices are allowed.
using Ring = std::vector<Vec2>;

/// Which points the rings call inside, by their winding number: odd ones, or all but zero.
enum class FillRule { EvenOdd, NonZero };

namespace detail {
struct PolygonData;
}

/// A triangle (S, v, w) of the covering: S the origin, (v, w) an edge of the polygon. sign is that of its area:
/// 0 where the edge's line goes through S (paper, Definition 3).
struct CoveringTriangle {
  Vec2 s;    ///< S
  Vec2 v;    ///< where the edge starts
  Vec2 w;    ///< where it ends
  int sign;  ///< 1, 0 or -1
};

/// A closed planar region: every point that the fill rule calls inside, and every point of an edge.
/// Immutable; a copy shares the data and the id; safe to share between threads. What queries derive from a polygon
/// (its hierarchy) is built when first needed, once for all copies.
class Polygon {
 public:
  /// Throws std::invalid_argument, naming ring and vertex, for no ring, fewer than three vertices in a ring, or a
  /// coordinate that is not finite.
  explicit Polygon(std::vector<Ring> rings, FillRule fill = FillRule::EvenOdd);

  const std::vector<Ring>& rings() const;  ///< as they were given
  FillRule fillRule() const;               ///< as it was given

  /// Never given to another polygon while the process lives; copies share it.
  std::uint64_t id() const;

  /// Vertices of all rings, which is also the number of edges.
  std::size_t vertexCount() const;

  /// Edges are numbered through the rings in order: edge i of a ring joins its vertices i and i + 1.
  Vec2 edgeStart(std::size_t edge) const;
  Vec2 edgeEnd(std::size_t edge) const;  ///< see edgeStart

  /// S, the covering's origin: a point of doubles near the region's centroid, inside the bounding box.
  const Vec2& origin() const;

  /// Radius of the bounding disc around origin(): at least the distance to every vertex (rounded up; infinity where
  /// that overflows).
  double radius() const;

  /// The paper's covering: one triangle an edge, in edge order. O(n), made anew at each call.
  std::vector<CoveringTriangle> covering() const;

  const detail::PolygonData& data() const { return *data_; }  ///< for the kernel

 private:
  std::shared_ptr<const detail::PolygonData> data_;
};

}  // namespace tricover
