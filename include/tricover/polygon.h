// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tricover/export.h"
#include "tricover/pose.h"

namespace tricover {

/// Vertices in order. The last one is joined to the first. Repeated and collinear vertices are allowed.
using Ring = std::vector<Vec2>;

/// The number of an edge: edges are numbered through the rings in order, from 0. Edge i of a ring joins the ring's
/// vertices i and i + 1. -1 is no edge.
using EdgeIndex = std::ptrdiff_t;

/// Which points the rings call inside, by how often they wind around the point.
enum class FillRule {
  EvenOdd,  ///< Inside is where the winding number is odd.
  NonZero,  ///< Inside is where the winding number isn't 0.
};

namespace detail {
struct PolygonData;
}

/// A closed planar region: every point that the fill rule calls inside, and every point of an edge.
///
/// It never changes. Copies are cheap: they share the data and the id. Threads may share a polygon. What queries derive
/// from it, its hierarchy, is built when first needed, once for all copies.
///
/// \snippet polygon.cpp polygon
class TRICOVER_EXPORT Polygon {
 public:
  /// Of rings and a fill rule. Throws std::invalid_argument, naming ring and vertex, for no ring, fewer than three
  /// vertices in a ring, a coordinate that is not finite, or more than 2^29 vertices in all (one more counted for each
  /// ring).
  explicit Polygon(const std::vector<Ring>& rings, FillRule fill = FillRule::EvenOdd);

  Polygon(const Polygon& other) noexcept;             ///< Moving copies, too, so that no polygon is without its data.
  Polygon& operator=(const Polygon& other) noexcept;  ///< Copies, too.
  ~Polygon();

  /// As they were given. A polygon keeps its vertices otherwise: the first call makes these, for all copies.
  const std::vector<Ring>& rings() const;
  FillRule fillRule() const;  ///< As it was given.

  /// What tells polygons apart. Copies share it, and no other polygon has it while the process lives. It means nothing
  /// in another process.
  std::uint64_t id() const;

  /// How many vertices all rings have.
  std::size_t vertexCount() const;

  /// How many edges there are, as many as vertices: the end of the edges' numbers.
  EdgeIndex edgeCount() const { return static_cast<EdgeIndex>(vertexCount()); }

  /// Where an edge starts. Throws std::out_of_range for an edge that isn't there.
  Vec2 edgeStart(EdgeIndex edge) const;
  /// Where an edge ends. Throws as edgeStart() does.
  Vec2 edgeEnd(EdgeIndex edge) const;

  /// S, the covering's origin: a point near the region's centroid, inside the bounding box.
  const Vec2& origin() const;

  /// The radius of the bounding disc around origin(): at least the distance to every vertex. It is rounded up, and
  /// infinity where it overflows.
  double radius() const;

  const detail::PolygonData& data() const { return *data_; }  ///< For the kernel.

 private:
  const detail::PolygonData* data_;
};

}  // namespace tricover
