// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "polygon/derived.h"
#include "polygon/edge_position.h"
#include "tricover/polygon.h"

namespace tricover::detail {

/// More positions than these don't fit into what is derived from a polygon, nor into memory as a rule.
constexpr std::size_t kMostPositions = std::size_t{1} << 29;

/// Throws std::invalid_argument for a path that is longer.
void requireCapacity(std::size_t positions);

/// Rings one after another, each closed by a copy of its first vertex: those lie in memory right behind this head, and
/// behind them where the rings begin and where the last one ends, and the numbers of a polygon with repeats.
class Path {
 public:
  Path(std::size_t size, std::size_t ring_count)
      : size_(static_cast<std::uint32_t>(size)), ring_count_(static_cast<std::uint32_t>(ring_count)) {}
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

  std::size_t size() const { return size_; }
  const Vec2* data() const { return reinterpret_cast<const Vec2*>(this + 1); }
  const Vec2* begin() const { return data(); }
  const Vec2* end() const { return data() + size_; }
  const Vec2& operator[](std::size_t position) const { return data()[position]; }
  const Vec2& front() const { return data()[0]; }

  std::size_t ringCount() const { return ring_count_; }
  const std::uint32_t* ringBegin() const { return reinterpret_cast<const std::uint32_t*>(data() + size_); }
  /// The public numbers of the edges by their positions, and at a closing vertex the last number of its ring.
  const std::uint32_t* numbers() const { return ringBegin() + ring_count_ + 1; }

 private:
  std::uint32_t size_, ring_count_;
};

/// Which winding numbers are inside.
struct Fill {
  FillRule rule = FillRule::EvenOdd;
  bool is_complement = false;  ///< inside is what the rule calls outside

  /// Another one for each fill.
  int number() const { return (rule == FillRule::EvenOdd ? 0 : 1) + (is_complement ? 2 : 0); }
};

/// A ring's vertices, wherever they are.
struct RingView {
  const Vec2* vertices;
  std::size_t size;
};

/// The rings that a polygon is made of: of a vector, or one alone.
class RingsView {
 public:
  explicit RingsView(const std::vector<Ring>& rings) : rings_(rings.data()), size_(rings.size()) {}
  explicit RingsView(const RingView& ring) : one_(ring) {}

  std::size_t size() const { return size_; }
  RingView operator[](std::size_t i) const {
    return rings_ != nullptr ? RingView{rings_[i].data(), rings_[i].size()} : one_;
  }

 private:
  const Ring* rings_ = nullptr;
  std::size_t size_ = 1;
  RingView one_{nullptr, 0};
};

/// What all copies of a polygon share, in one allocation with its path: the edge at position e joins path[e] and
/// path[e + 1]; ring r takes positions [edgeBegin(r), edgeEnd(r)) and the closing vertex after them is no edge.
struct PolygonData {
  /// The last of its users destroys it.
  static PolygonData* make(const RingsView& rings, const Fill& fill);
  /// The polygon of some of its vertices, by their positions, whose region must be the same; with the same S and unit.
  const PolygonData* reducedTo(const std::vector<EdgePosition>& positions) const;
  void hold() const { users.fetch_add(1, std::memory_order_relaxed); }
  void release() const;

  std::size_t ringCount() const { return path.ringCount(); }
  EdgePosition edgeBegin(std::size_t ring) const { return path.ringBegin()[ring]; }
  EdgePosition edgeEnd(std::size_t ring) const { return path.ringBegin()[ring + 1] - 1; }
  /// The ring of a position.
  std::size_t ringOf(EdgePosition position) const;
  /// A ring without its repeats.
  Ring vertices(std::size_t ring) const { return {path.begin() + edgeBegin(ring), path.begin() + edgeEnd(ring)}; }

  /// Between positions in the path and the public numbering, which skips the closing vertices and counts repeats. The
  /// number of an edge that a repeat begins stands for the next edge of its ring that has a length.
  EdgeIndex edgeNumber(EdgePosition position) const {
    if (has_repeats) return path.numbers()[position];
    return position - (ringCount() == 1 ? 0 : static_cast<EdgeIndex>(ringOf(position)));
  }
  EdgePosition edgePosition(EdgeIndex number) const;
  std::size_t edgeCount() const {
    return has_repeats ? path.numbers()[path.size() - 1] + std::size_t{1} : path.size() - ringCount();
  }
  /// The number of a ring's first edge.
  EdgeIndex firstNumber(std::size_t ring) const {
    if (!has_repeats) return edgeBegin(ring) - static_cast<EdgeIndex>(ring);
    return ring == 0 ? 0 : edgeNumber(edgeEnd(ring - 1)) + 1;
  }
  /// The edge that results name for the one at a position: that edge, or, if it has no length, the next one of its ring
  /// that has, which starts at the same point. A ring without any such edge names the given one.
  EdgePosition namedEdge(EdgePosition position) const {
    return path[position] != path[position + 1] ? position : nextWithLength(position);
  }
  /// The public number of that edge; -1 for kNoEdge.
  EdgeIndex edgeName(EdgePosition position) const { return position == kNoEdge ? -1 : edgeNumber(namedEdge(position)); }
  /// Throws std::out_of_range for what is no edge's number.
  EdgePosition checkedEdgePosition(EdgeIndex number) const;

  bool isDegenerate() const { return degenerate_edge != kNoEdge; }
  bool isPoint() const { return is_point; }

  /// False for the largest of polygons: no power of two is above their radius.
  bool fitsUnit() const { return radius <= unit; }

  /// A point of the polygon's frame from S, in units. Rounded by U. Quarters don't overflow, nor does what is between
  /// them in units.
  Vec2 inUnits(const Vec2& p) const {
    return extent < 0x1p1000 ? Vec2((p - origin) * inverse_unit) : Vec2((0.25 * p - 0.25 * origin) * inverse_unit * 4);
  }

  Vec2 origin;    ///< S
  double radius;  ///< at least the distance from S to any vertex
  double reach;   ///< at least the distance from S to any point of the region: the radius, or infinity for a complement
  double extent;  ///< the largest |x| + |y| of a vertex or of S: scales the rounding errors
  /// A power of two, at least the radius (where that is finite and above 2^-1000) and below 2 radii; and 1 / unit.
  double unit, inverse_unit;
  std::uint64_t id;
  // Derived data, and what queries have cost so far without it.
  Derived hierarchy, discs;  ///< boxes around edges; discs in the region
  Derived convexity;         ///< whether it is convex, and its corners
  Derived starts;            ///< the starts of rings that containment tests
  Derived rings;             ///< as they were given; with repeats, from the start
  SkiRental<Stages::Hierarchy> hierarchy_rental;
  SkiRental<Stages::All> discs_rental;
  SkiRental<Stages::Paid> starts_rental;
  mutable std::atomic<std::uint32_t> users{1};
  Fill fill;
  /// Whether a ring of more than three vertices was given with equal ones next to each other. The path has one of them,
  /// and three where a ring has fewer: what repeats costs nothing.
  bool has_repeats;
  bool is_point;  ///< whether it is a degenerate polygon whose edge has no length
  /// The one edge of a degenerate polygon, a segment or a point: what a margin makes a stadium or a
  /// disc of. S is on it but for rounding, and on a point exactly. A complement is never degenerate.
  EdgePosition degenerate_edge;
  alignas(8) Path path;  ///< the last member: its vertices lie behind

 private:
  PolygonData(const RingsView& rings, std::size_t positions, const Fill& fill, bool has_repeats);
  EdgePosition nextWithLength(EdgePosition position) const;
};

/// What a polygon is, for the kernel.
inline const PolygonData& dataOf(const Polygon& polygon) { return *polygon.data_; }

}  // namespace tricover::detail
