// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <memory_resource>
#include <vector>

#include "contact/boundary_point.h"
#include "contact/crossings.h"
#include "numbers/union_find.h"

namespace tricover::detail {

/// Where a node is on a ring.
struct Stop {
  EdgePosition edge;
  Span span;
  std::size_t node;
  /// By how much the other's winding number changes here; none if it may do anything, as where edges touch.
  Winding change;
  bool joined;  ///< the arc from here to the next stop is in the other region
};

/// One polygon's boundary, as the nodes divide it.
struct Side {
  struct RingStops {
    std::size_t begin = 0, end = 0;  ///< in `stops`
    std::ptrdiff_t node = -1;        ///< of a ring that lies in the other region as a whole; otherwise -1
  };

  Side(const PolygonData& polygon_, std::pmr::memory_resource* memory) : polygon(polygon_), stops(memory) {}

  bool isInside(int winding) const { return detail::isInside(polygon.fill, winding); }

  const PolygonData& polygon;
  std::pmr::vector<Stop> stops;  ///< by edge, then where they begin
  RingStops* rings = nullptr;
};

/// Off the middle, where symmetric shapes have other edges, too.
inline double somewhere(const Span& span) { return span.low + 0.4142 * (span.high - span.low); }

/// Vertices of a ring that lie in the other region, from one to another, all around.
struct Arc {
  int side;
  EdgePosition from, to;
  std::size_t node;
};

/// A crossing, or a vertex of an arc.
struct NodePoint {
  std::size_t node;
  int side;        ///< kCrossing, or whose vertex it is
  std::size_t at;  ///< its index, or the vertex's position
  static constexpr int kCrossing = -1;
};

/// The boundary of the overlap as arcs of either polygon that lie in the other one, joined where they meet.
class OverlapArcs {
 protected:
  OverlapArcs(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings)
      : pair_(pair),
        swapped_(pair.back()),
        frame_(frame),
        crossings_(crossings),
        sides_{{pair.a, &memory_}, {pair.b, &memory_}} {}

  using Ends = WorldFrame::Ends;

  /// Along all rings; a polygon's own crossings join its arcs only if asked to.
  void join(bool with_own_crossings);

  Vec2 vertex(int side, EdgePosition v) const { return frame_.from(side, sides_[side].polygon.path[v]); }
  Ends ends(int side, EdgePosition e) const { return frame_.edgeEnds(side, e); }
  bool holds(int side, const Vec2& p) const { return detail::holds(pair_, frame_, side, p); }

  /// Of a repeated vertex the last one stands for all.
  template <typename Visit>
  void forEachVertex(const Arc& arc, Visit visit) const {
    const PolygonData& polygon = sides_[arc.side].polygon;
    const Vec2* const path = &polygon.path[0];
    const std::size_t ring = polygon.ringOf(arc.from);
    const EdgePosition begin = polygon.edgeBegin(ring), end = polygon.edgeEnd(ring);
    for (EdgePosition v = arc.from;; v = v + 1 < end ? v + 1 : begin) {
      if (path[v] != path[v + 1] || beginsPoint(polygon, v)) visit(v);
      if (v == arc.to) break;
    }
  }

  const PosedPair &pair_, swapped_;
  const WorldFrame& frame_;
  const std::vector<EdgeCrossing>& crossings_;
  alignas(std::max_align_t) std::byte few_[2048];  ///< as much as a few crossings take
  std::pmr::monotonic_buffer_resource memory_{few_, sizeof few_};
  Side sides_[2];
  std::pmr::vector<Side::RingStops> rings_{&memory_};  ///< a's, then b's
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  struct Node {
    bool is_present;  ///< it is in the overlap, which a polygon's own crossing needn't be
    bool is_inner;    ///< the overlap has an inside there
    std::size_t component = kNone;
  };
  UnionFind sets_;  ///< of nodes
  std::pmr::vector<Node> nodes_{&memory_};
  std::pmr::vector<Arc> arcs_{&memory_};

 private:
  /// Where one side's vertex is in the other's region.
  Inclusion includeVertex(int side, EdgePosition v) const { return includeVertexOfB(side == 0 ? swapped_ : pair_, v); }
  std::size_t addNode(bool present);
  void addOwnCrossings(int side);
  void addRepeatedVertices(int side);
  void addOwnCrossing(int side, EdgePosition e, EdgePosition f);
  void joinAlongRings(int side);
  void joinWhole(int side, std::size_t r);
  void joinArcs(int side, std::size_t begin, std::size_t end);
  bool joinedOnEdge(int side, const Stop& stop, const Stop& next, double reach, const Winding& winding);
  bool joinedRoundVertices(int side, const Stop& stop, const Stop& next, Winding& winding);
};

}  // namespace tricover::detail
