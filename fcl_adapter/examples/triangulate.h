// SPDX-License-Identifier: BSD-3-Clause
// What a flat mesh needs in a polygon's place.
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <tricover/polygon.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

namespace mesh {

using Triangle = std::array<tricover::Vec2, 3>;

/// Twice the area of (u, v, w), positive if they run counter-clockwise; exact for small integers.
inline double area2(const tricover::Vec2& u, const tricover::Vec2& v, const tricover::Vec2& w) {
  return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
}

inline double area2(const tricover::Ring& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += area2(ring[0], ring[i], ring[i + 1]);
  return sum;
}

/// Whether the segments cross at an inner point of both.
inline bool cross(const tricover::Vec2& p, const tricover::Vec2& q, const tricover::Vec2& u, const tricover::Vec2& v) {
  return area2(p, q, u) * area2(p, q, v) < 0 && area2(u, v, p) * area2(u, v, q) < 0;
}

/// The outline and a hole in it as one ring, joined along the first diagonal that crosses neither.
inline tricover::Ring joined(const tricover::Ring& outline, const tricover::Ring& hole) {
  const auto crosses = [](const tricover::Ring& ring, const tricover::Vec2& p, const tricover::Vec2& q) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (cross(p, q, ring[i], ring[(i + 1) % ring.size()])) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (std::size_t k = 0; k < hole.size(); ++k) {
      if (crosses(outline, outline[i], hole[k]) || crosses(hole, outline[i], hole[k])) continue;
      const auto from = hole.begin() + static_cast<std::ptrdiff_t>(k);
      tricover::Ring ring(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      ring.insert(ring.end(), from, hole.end());
      ring.insert(ring.end(), hole.begin(), from + 1);
      ring.insert(ring.end(), outline.begin() + static_cast<std::ptrdiff_t>(i), outline.end());
      return ring;
    }
  }
  throw std::invalid_argument("triangulate: the hole can't be seen from the outline");
}

/// Ear clipping. Cuts the triangles of a ring off until none is left: O(n^3), once a shape.
inline void clipEars(tricover::Ring ring, std::vector<Triangle>& triangles) {
  while (ring.size() >= 3) {
    const std::size_t n = ring.size();
    const auto isEar = [&](std::size_t i) {
      const tricover::Vec2 &u = ring[(i + n - 1) % n], &v = ring[i], &w = ring[(i + 1) % n];
      if (area2(u, v, w) <= 0) return false;
      return std::none_of(ring.begin(), ring.end(), [&](const tricover::Vec2& p) {
        return p != u && p != v && p != w && area2(u, v, p) >= 0 && area2(v, w, p) >= 0 && area2(w, u, p) >= 0;
      });
    };
    std::size_t ear = 0;
    while (ear < n && !isEar(ear)) ++ear;
    if (ear == n) throw std::invalid_argument("triangulate: the rings cross");
    triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
}

/// The even-odd region of nested rings: every even ring is an outline, the one after it (if any) the hole in it.
inline std::vector<Triangle> triangulate(const tricover::Polygon& polygon) {
  std::vector<Triangle> triangles;
  double wanted = 0, got = 0;
  std::vector<tricover::Ring> rings = polygon.rings();
  for (std::size_t i = 0; i < rings.size(); i += 2) {
    if (area2(rings[i]) < 0) std::reverse(rings[i].begin(), rings[i].end());
    wanted += area2(rings[i]);
    if (i + 1 == rings.size()) {
      clipEars(rings[i], triangles);
      break;
    }
    if (area2(rings[i + 1]) > 0) std::reverse(rings[i + 1].begin(), rings[i + 1].end());
    wanted += area2(rings[i + 1]);
    clipEars(joined(rings[i], rings[i + 1]), triangles);
  }
  for (const Triangle& t : triangles) got += area2(t[0], t[1], t[2]);
  if (got != wanted) throw std::logic_error("triangulate: the triangles' area is not the region's");
  return triangles;
}

/// A flat mesh of FCL's.
inline std::shared_ptr<fcl::CollisionGeometryd> meshOf(const tricover::Polygon& polygon) {
  auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  mesh->beginModel();
  for (const Triangle& t : triangulate(polygon))
    mesh->addTriangle({t[0].x(), t[0].y(), 0}, {t[1].x(), t[1].y(), 0}, {t[2].x(), t[2].y(), 0});
  mesh->endModel();
  return mesh;
}

}  // namespace mesh
