// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "numbers/segment.h"
#include "polygon/polygon_data.h"

namespace tricover::detail {

/// So many points need no memory but the stack's.
template <std::size_t kFew>
class PointList {
 public:
  explicit PointList(std::size_t most) {
    if (most <= kFew) return;
    many_.resize(most);
    points_ = many_.data();
  }
  PointList(const PointList&) = delete;
  PointList& operator=(const PointList&) = delete;

  void add(const Vec2& p) { points_[size_++] = p; }
  std::size_t size() const { return size_; }
  const Vec2& operator[](std::size_t k) const { return points_[k]; }
  Vec2* data() { return points_; }

 private:
  std::array<Vec2, kFew> few_;
  std::vector<Vec2> many_;
  Vec2* points_ = few_.data();
  std::size_t size_ = 0;
};

/// The vertices of a convex polygon without straight ones in a frame (FrameOfA or WorldFrame), counter-clockwise. Edge
/// k leads from vertex k to the next. Either kept, or mapped anew for each use, where few are used.
template <typename Frame, bool kept>
class ConvexRing {
 public:
  /// turn: 1 if the ring runs counter-clockwise in the frame, -1 if clockwise.
  ConvexRing(const Frame& frame, const PolygonData& polygon, bool of_a, int turn)
      : frame_(frame),
        path_(polygon.path.data()),
        n_(polygon.path.size() - 1),
        of_a_(of_a),
        forward_(turn > 0),
        points_(kept ? 2 * n_ + 1 : 0) {
    if (!kept) return;
    of_a_ ? mapAll([&](const Vec2& p) -> Vec2 { return frame.fromA(p); })
          : mapAll([&](const Vec2& p) -> Vec2 { return frame.fromB(p); });
  }

  std::size_t size() const { return n_; }
  Vec2 vertex(std::size_t k) const { return kept ? points_[k] : mapped(k); }
  Vec2 end(std::size_t k) const { return vertex(k + 1); }
  Vec2 edge(std::size_t k) const { return kept ? points_[n_ + 1 + k] : Vec2(mapped(k + 1) - mapped(k)); }
  std::size_t after(std::size_t k) const { return k + 1 < n_ ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : n_ - 1; }

  /// Of edge k in the path, and back.
  std::size_t position(std::size_t k) const { return forward_ ? k : n_ - 1 - k; }
  /// The edge that leads away from vertex k in the path, and the one that leads there.
  std::size_t leaving(std::size_t k) const { return forward_ ? k : before(k); }
  std::size_t arriving(std::size_t k) const { return forward_ ? before(k) : k; }

  /// How far p is to the left of edge k, times the edge's length.
  double leftOf(std::size_t k, const Vec2& p) const { return cross(edge(k), p - vertex(k)); }

  /// Whether p is inside for certain, areas of up to `doubtful` being in doubt. O(log n).
  bool holds(const Vec2& p, double doubtful) const {
    const Vec2 corner = vertex(0);
    const Vec2 way = p - corner;
    // Between the ways from a corner to vertices `low` and `high`.
    std::size_t low = 1, high = n_ - 1;
    if (!(cross(edge(0), way) > doubtful && cross(vertex(high) - corner, way) < -doubtful)) return false;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      const double turn = cross(vertex(middle) - corner, way);
      if (!(turn > doubtful || turn < -doubtful)) break;
      (turn > 0 ? low : high) = middle;
    }
    for (std::size_t k = low; k < high; ++k)
      if (!(leftOf(k, p) > doubtful)) return false;
    return true;
  }

 private:
  template <typename Map>
  void mapAll(Map map) {
    const std::size_t n = n_;
    const Vec2* from = forward_ ? path_ : path_ + n;
    const std::ptrdiff_t step = forward_ ? 1 : -1;
    Vec2 *const vertices = points_.data(), *const edges = vertices + n + 1;
    Vec2 last = map(*from);
    vertices[0] = last;
    for (std::size_t k = 0; k < n; ++k) {
      from += step;
      const Vec2 next = map(*from);
      vertices[k + 1] = next;
      edges[k] = next - last;
      last = next;
    }
  }

  /// The path ends where it begins.
  Vec2 mapped(std::size_t k) const {
    const Vec2& p = path_[forward_ ? k : n_ - k];
    return of_a_ ? Vec2(frame_.fromA(p)) : frame_.fromB(p);
  }

  const Frame& frame_;
  const Vec2* path_;
  std::size_t n_;
  bool of_a_, forward_;
  PointList<33> points_;  ///< vertices, the first once more, and edges
};

}  // namespace tricover::detail
