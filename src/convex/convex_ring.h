// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "hierarchy/hierarchy.h"
#include "numbers/double2.h"
#include "polygon/convexity.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// Vertices, or edges, in a row around a ring, which may go on with its first one.
struct RingRange {
  std::uint32_t first = 0, count = 0;
};

/// A view of a convex ring all of whose vertices are corners: at least three, none straight. They are a polygon's own,
/// or copies of its corners, or mapped into another frame. Edge k leads from vertex k to the next one, and the vertex
/// after the last one is a copy of the first.
///
/// Along a convex ring the height n . p rises to its greatest value and falls to its least one, once each.
class ConvexRing {
 public:
  /// size + 1 vertices; turn: 1 if they run counter-clockwise, -1 if clockwise.
  ConvexRing(const Vec2* vertices, std::size_t size, int turn)
      : vertices_(vertices), size_(static_cast<std::uint32_t>(size)), turn_(turn) {}

  std::uint32_t size() const { return size_; }
  int turn() const { return turn_; }

  std::uint32_t next(std::uint32_t k) const { return k + 1 == size_ ? 0 : k + 1; }
  std::uint32_t previous(std::uint32_t k) const { return (k == 0 ? size_ : k) - 1; }
  /// The same for k + steps, steps <= size().
  std::uint32_t after(std::uint32_t k, std::uint32_t steps) const {
    return k + steps < size_ ? k + steps : k + steps - size_;
  }

  Double2 vertex(std::uint32_t k) const { return load2(vertices_[k].data()); }
  Double2 way(std::uint32_t from, std::uint32_t to) const { return vertex(to) - vertex(from); }
  /// Needs no next().
  Double2 edge(std::uint32_t k) const { return load2(vertices_[k + 1].data()) - load2(vertices_[k].data()); }

  /// The support vertex along n, as plain doubles see it, in O(log n) steps. From a vertex that rises the highest one
  /// is ahead, before any that rises no more or is lower; from one that falls it is before any that falls and is
  /// higher.
  std::uint32_t supportVertex(Double2 n) const {
    const auto rises = [&](std::uint32_t k) { return dot(n, edge(k)) > 0; };
    std::uint32_t low = 0, high = size_;
    bool low_rises = rises(0);
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      const bool middle_rises = rises(middle), is_higher = dot(n, way(low, middle)) > 0;
      if (low_rises ? !(middle_rises && is_higher) : !middle_rises && is_higher) {
        high = middle;
      } else {
        low = middle;
        low_rises = middle_rises;
      }
    }
    return !low_rises ? low : high == size_ ? 0 : high;
  }

  /// The edge at the support vertex along n that leads down from it by less: from it, or to it.
  std::uint32_t flatterEdge(Double2 n, std::uint32_t support) const {
    const std::uint32_t before = previous(support);
    return dot(n, edge(support)) >= -dot(n, edge(before)) ? support : before;
  }

  /// All vertices that may be the support vertex: those between an edge that certainly leads ahead and one that
  /// certainly leads back, as its climb(edge) tells. The walk begins at range.first, so that it is short from one that
  /// was near the support vertex before. False if there are no such edges.
  template <typename Climb, typename LeadsAhead, typename LeadsBack>
  [[gnu::always_inline]] bool supportVertex(Climb climb, LeadsAhead leadsAhead, LeadsBack leadsBack,
                                            RingRange& range) const {
    std::uint32_t v = range.first, steps = 0;
    auto up = climb(v);
    for (; leadsAhead(up); up = climb(v = next(v)))
      if (steps++ == size_) return false;
    if (steps == 0)  // what leads to v is yet to be found
      for (auto to = climb(previous(v)); !leadsAhead(to); to = climb(previous(v))) {
        if (steps++ == size_) return false;
        up = to;
        v = previous(v);
      }
    range = {v, 1};
    for (; !leadsBack(up); up = climb(v = next(v)))
      if (range.count++ == size_) return false;
    return true;
  }

  /// The same along n, a climb of up to `doubt` being in doubt.
  bool supportVertex(Double2 n, double doubt, RingRange& range) const {
    return supportVertex([&](std::uint32_t k) { return dot(n, edge(k)); }, [&](double up) { return up > doubt; },
                         [&](double up) { return up < -doubt; }, range);
  }

 private:
  const Vec2* vertices_;
  std::uint32_t size_;
  int turn_;
};

/// A polygon that is cornersOf() itself.
inline ConvexRing convexRing(const PolygonData& polygon) {
  return {polygon.path.data(), polygon.path.size() - 1, convexityOf(polygon).direction};
}

}  // namespace tricover::detail
