// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <type_traits>
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

/// On which side of its outline a simplified polygon may differ from the original.
enum class Simplify {
  Both,      ///< On either side, by at most the tolerance.
  Outwards,  ///< Only outside: the simplified region covers the original.
};

class Polygon;

namespace detail {
struct PolygonData;
const PolygonData& dataOf(const Polygon& polygon);
}  // namespace detail

/// A closed planar region: every point that the fill rule calls inside, and every point of an edge.
///
/// A polygon never changes. Copies are cheap: they share the data and the id. Threads may share a polygon. The first
/// queries that need a polygon's hierarchy build it, once for all copies.
///
/// \snippet polygon.cpp polygon
class TRICOVER_EXPORT Polygon {
 public:
  /// Makes a polygon from rings and a fill rule.
  /// \throws std::invalid_argument for no ring, for fewer than three vertices in a ring, for a coordinate that is not
  /// finite, and for a value that FillRule doesn't have. The text has ring and vertex.
  /// \throws std::length_error for more than 2^29 vertices in all, one more counted for each ring
  explicit Polygon(const std::vector<Ring>& rings, FillRule fill = FillRule::EvenOdd);
  /// Makes a polygon from rings in braces, by the same rules.
  explicit Polygon(std::initializer_list<Ring> rings, FillRule fill = FillRule::EvenOdd)
      : Polygon(std::vector<Ring>(rings), fill) {}
  /// A vertex of one ring in braces: `Polygon({{0, 0}, {1, 0}, {0, 1}})`.
  struct Vertex {
    Vertex(double x, double y) : at(x, y) {}  ///< By its coordinates.
    Vertex(const Vec2& p) : at(p) {}          ///< By a point.
    Vec2 at;                                  ///< Where it is.
  };
  /// Makes a polygon from one ring in braces, by the same rules.
  explicit Polygon(std::initializer_list<Vertex> ring, FillRule fill = FillRule::EvenOdd);
  /// Makes a polygon from one ring, by the same rules. (A template, so that braces mean rings.)
  template <typename OneRing, std::enable_if_t<std::is_same_v<OneRing, Ring>, int> = 0>
  explicit Polygon(const OneRing& ring, FillRule fill = FillRule::EvenOdd) : Polygon(ring.data(), ring.size(), fill) {}
  /// Makes a polygon from one ring of `count` contiguous vertices, which it copies. Cheaper than Polygon({ring}).
  /// \throws std::invalid_argument as for rings, and for a null pointer
  /// \throws std::length_error as for rings
  /// \snippet polygon.cpp raw
  Polygon(const Vec2* vertices, std::size_t count, FillRule fill = FillRule::EvenOdd);

  /// Returns the rectangle of that width, along x, and height, along y, around the origin of its frame.
  /// \throws std::invalid_argument for a length that is not finite and positive
  /// \snippet shapes.cpp box
  static Polygon box(double width, double height);
  /// Returns the polygon that is this point and nothing else: one ring of three equal vertices. With a margin of r it
  /// is an exact closed disc of radius r, in every query that takes a margin. Distances and impacts name its edge 0.
  /// \throws std::invalid_argument for a coordinate that is not finite
  /// \snippet shapes.cpp point
  static Polygon point(const Vec2& p);
  /// Returns the polygon that is the closed segment from p to q and nothing else: one ring of p, q and q once more.
  /// With a margin of r it is an exact capsule: every point within r of the segment. Distances and impacts name its
  /// edge 0, from p to q. If p and q are equal, it is that point.
  /// \throws std::invalid_argument for a coordinate that is not finite
  /// \snippet shapes.cpp segment
  static Polygon segment(const Vec2& p, const Vec2& q);

  Polygon(const Polygon& other) noexcept;             ///< Moving copies, too, so that no polygon is without its data.
  Polygon& operator=(const Polygon& other) noexcept;  ///< Copies, too.
  ~Polygon();

  /// As they were given. A polygon keeps its vertices otherwise: the first call makes these, for all copies.
  const std::vector<Ring>& rings() const;
  FillRule fillRule() const;  ///< As it was given; see complement().
  bool isComplement() const;  ///< Whether complement() made it, and its region is unbounded.

  /// Tells polygons apart. Copies share the id, and no other polygon has it while the process lives, not even one that
  /// another copy of this library in the process makes (plugins). It is never 0, and means nothing in another process.
  std::uint64_t id() const;

  /// How many vertices all rings have.
  std::size_t vertexCount() const;

  /// How many edges there are, as many as vertices: the end of the edges' numbers.
  EdgeIndex edgeCount() const { return static_cast<EdgeIndex>(vertexCount()); }

  /// Where an edge starts.
  /// \throws std::out_of_range for an edge that isn't there
  Vec2 edgeStart(EdgeIndex edge) const;
  /// Where an edge ends.
  /// \throws std::out_of_range for an edge that isn't there
  Vec2 edgeEnd(EdgeIndex edge) const;

  /// S, the covering's origin: a point near the region's centroid, inside the bounding box.
  const Vec2& coveringOrigin() const;

  /// The radius of the bounding disc around coveringOrigin(): at least the distance to every vertex. It is rounded up,
  /// and infinity where it overflows.
  double radius() const;

  /// The area of the region, by its fill rule: holes count as holes whichever way their rings run, and what two rings
  /// share, or one covers twice, as the rule says. Rounded, by about 2^-50 of the length of all edges times radius();
  /// 0 or infinity beyond the range of doubles.
  ///
  /// It sweeps the edges from below each time, in O(n log n) for most; n times as many as there are beside each other
  /// at the worst, and so are the crossings. \snippet polygon.cpp measures
  double area() const;
  /// The region's centre of gravity, rounded likewise, relative to its area; the middle of bounds() for what has no
  /// area.
  Vec2 centroid() const;
  /// The smallest box around it, along the axes of its frame. Exact.
  Eigen::AlignedBox2d bounds() const;
  /// A box in the world, along its axes, around the polygon under a pose: larger than the smallest one by rounding at
  /// most.
  /// \throws std::invalid_argument for a pose that checkPose() refuses
  Eigen::AlignedBox2d bounds(const Pose& pose) const;
  /// Whether it is one ring that has an area, turns one way and goes around once; straight and repeated vertices don't
  /// matter. Exact, and kept from the first call on. (A region may be convex by rings that aren't, as two halves of a
  /// square: that isn't looked for.)
  bool isConvex() const;

  /// Moved for good: every vertex plus `by`, rounded.
  /// \throws std::invalid_argument where a vertex isn't finite
  /// \snippet polygon.cpp measures
  Polygon translated(const Vec2& by) const;
  /// Returns the polygon that this one is under a pose: every vertex R p + t, rounded.
  /// \throws std::invalid_argument for a pose that checkPose() refuses, and where a vertex isn't finite
  /// \snippet polygon.cpp measures
  Polygon transformed(const Pose& pose) const;
  /// Larger or smaller, about the origin of its frame: every coordinate times `factor`, rounded.
  /// \throws std::invalid_argument for a factor that isn't positive and finite, and where a vertex isn't finite
  /// \snippet polygon.cpp measures
  Polygon scaled(double factor) const;
  /// Returns a polygon with fewer vertices, as a rule. No point of either region is farther than `tolerance` from the
  /// other region. This holds exactly, under either fill rule, and for rings that cross or touch.
  ///
  /// Simplify::Both keeps some of the vertices, among them the first one of each ring. Rings that did not cross may
  /// cross afterwards. A ring smaller than the tolerance becomes a segment or a point, as segment() and point() write
  /// them. The method is that of Douglas and Peucker. It takes O(n log n) for most polygons.
  ///
  /// Simplify::Outwards returns a region that covers this one exactly: a body that is free of the new region is free
  /// of this one. Corners may be new points, and holes become smaller. A ring without area stays as it is, and so does
  /// a ring that cannot be proven to be covered. It takes some tens of microseconds a vertex, and more where hundreds
  /// of edges lie on one line.
  ///
  /// \throws std::invalid_argument for a tolerance that is negative or not finite, and for a complement() outwards
  /// \snippet polygon.cpp simplified
  Polygon simplified(double tolerance, Simplify side = Simplify::Both) const;
  /// Returns the closure of what is outside of the region, which is unbounded. Its rings are this polygon's, and its
  /// edges have their numbers, unless edges have the region on both sides or on none, as those that two rings share:
  /// such edges are left out, and rings are joined anew from the others. The fill rule is FillRule::EvenOdd. Exact.
  ///
  /// Legal in all queries but penetration(), and contacts() with ContactDetail::GlobalDepth
  /// there: these two refuse it, even where it is apart. Two complements always collide. A complement isn't convex. Its
  /// area(), bounds() and radius() are infinite, and its centroid() is the middle of its rings' box. Where a precision
  /// depends on a polygon's size or points, these are its rings'. It stays one when it is translated(), transformed(),
  /// scaled() or simplified() (not outwards), and complement() of it is the closure of the region's inside. In a Scene,
  /// it is near every other body.
  ///
  /// Takes O(n log n) for most polygons.
  /// \throws std::invalid_argument for a polygon that has no area; and under FillRule::NonZero where an edge is inside
  /// of the region beyond a crossing that is no vertex: doubles do not hold that point. The text has ring and vertex.
  /// \snippet polygon.cpp complement
  Polygon complement() const;

 private:
  friend const detail::PolygonData& detail::dataOf(const Polygon& polygon);
  enum class Adopt { Data };
  Polygon(Adopt, const detail::PolygonData* data) : data_(data) {}
  Polygon withRings(const std::vector<Ring>& rings) const;  ///< With the same fill.
  template <typename Map>
  Polygon mapped(const Map& map) const;

  const detail::PolygonData* data_;
};

}  // namespace tricover
