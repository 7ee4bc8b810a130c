// SPDX-License-Identifier: BSD-3-Clause
#include "convex_pieces.h"

#include <geos/algorithm/Orientation.h>
#include <geos/triangulate/polygon/ConstrainedDelaunayTriangulator.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "geos.h"

namespace tricover::bench {
namespace {

/// Exact in its sign for ordinary coordinates (double-double arithmetic).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  using geos::geom::Coordinate;
  return geos::algorithm::Orientation::index(Coordinate(a.x(), a.y()), Coordinate(b.x(), b.y()),
                                             Coordinate(c.x(), c.y()));
}

class PieceMerger {
 public:
  explicit PieceMerger(const std::vector<Triangle>& triangles) : parent_(triangles.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const Triangle& triangle : triangles) {
      std::vector<int> loop;
      for (const Vec2& v : triangle) loop.push_back(intern(v));
      for (int i = 0; i < 3; ++i) owner_[{loop[i], loop[(i + 1) % 3]}] = loops_.size();
      loops_.push_back(std::move(loop));
    }
    for (const auto& [edge, piece] : owner_) {
      const auto twin = owner_.find({edge.second, edge.first});
      if (edge.first < edge.second && twin != owner_.end())
        tryMerge(edge.first, edge.second, root(piece), root(twin->second));
    }
  }

  std::vector<Ring> pieces() const {
    std::vector<Ring> result;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (parent_[i] != i) continue;
      Ring ring;
      for (const int v : loops_[i]) ring.push_back(points_[static_cast<std::size_t>(v)]);
      result.push_back(std::move(ring));
    }
    return result;
  }

 private:
  int intern(const Vec2& v) {
    const auto [place, is_new] = index_.try_emplace({v.x(), v.y()}, static_cast<int>(points_.size()));
    if (is_new) points_.push_back(v);
    return place->second;
  }

  std::size_t root(std::size_t piece) {
    while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }

  bool convexAt(int before, int at, int after) const {
    const auto point = [&](int v) -> const Vec2& { return points_[static_cast<std::size_t>(v)]; };
    return orientation(point(before), point(at), point(after)) >= 0;
  }

  /// The diagonal runs from u to v in `left` and from v to u in `right`.
  void tryMerge(int u, int v, std::size_t left, std::size_t right) {
    if (left == right) return;
    std::vector<int>&p = loops_[left], &q = loops_[right];
    std::rotate(p.begin(), std::find(p.begin(), p.end(), v), p.end());  // v ... u
    std::rotate(q.begin(), std::find(q.begin(), q.end(), u), q.end());  // u ... v
    if (!convexAt(p[p.size() - 2], u, q[1]) || !convexAt(q[q.size() - 2], v, p[1])) return;
    p.insert(p.end(), q.begin() + 1, q.end() - 1);
    q.clear();
    parent_[right] = left;
  }

  std::map<std::pair<double, double>, int> index_;
  std::vector<Vec2> points_;
  std::vector<std::vector<int>> loops_;
  std::map<std::pair<int, int>, std::size_t> owner_;
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<Triangle> triangulate(const Polygon& polygon) {
  const auto region = geosRegion(polygon);
  const auto parts = geos::triangulate::polygon::ConstrainedDelaunayTriangulator::triangulate(region.get());
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < parts->getNumGeometries(); ++i) {
    const Ring ring = ringsOfPart(*parts, i)[0];
    Triangle triangle = {ring.at(0), ring.at(1), ring.at(2)};
    if (orientation(triangle[0], triangle[1], triangle[2]) < 0) std::swap(triangle[1], triangle[2]);
    triangles.push_back(triangle);
  }
  const double wanted = region->getArea();
  if (!(std::abs(parts->getArea() - wanted) <= 1e-9 * wanted)) {
    throw std::runtime_error("triangulate: the triangles' area is not the region's");
  }
  return triangles;
}

std::vector<Ring> convexPieces(const std::vector<Triangle>& triangles) { return PieceMerger(triangles).pieces(); }

}  // namespace tricover::bench
