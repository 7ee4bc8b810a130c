// SPDX-License-Identifier: BSD-3-Clause
#include "convex_pieces.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <map>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace tricover::bench {
namespace {

/// GEOS's C interface with ownership, and its error texts as exceptions.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) { GEOSContext_setErrorMessageHandler_r(handle_, keepMessage, &message_); }
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  using Geometry = std::shared_ptr<GEOSGeometry>;

  Geometry own(GEOSGeometry* geometry) const {
    if (!geometry) throw std::runtime_error("GEOS: " + message_);
    return Geometry(geometry, [handle = handle_](GEOSGeometry* g) { GEOSGeom_destroy_r(handle, g); });
  }

  GEOSCoordSequence* closedSequence(const Ring& ring) const {
    GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(handle_, static_cast<unsigned>(ring.size() + 1), 2);
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Vec2& v = ring[i % ring.size()];
      GEOSCoordSeq_setXY_r(handle_, sequence, static_cast<unsigned>(i), v.x(), v.y());
    }
    return sequence;
  }

  Ring vertices(const GEOSGeometry* polygon) const {
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(handle_, GEOSGetExteriorRing_r(handle_, polygon));
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(handle_, sequence, &size);
    Ring ring(size - 1);
    for (unsigned i = 0; i + 1 < size; ++i) GEOSCoordSeq_getXY_r(handle_, sequence, i, &ring[i].x(), &ring[i].y());
    return ring;
  }

  double area(const GEOSGeometry* geometry) const {
    double area = 0;
    if (!GEOSArea_r(handle_, geometry, &area)) throw std::runtime_error("GEOS: " + message_);
    return area;
  }

  GEOSContextHandle_t handle() const { return handle_; }

 private:
  static void keepMessage(const char* text, void* message) { *static_cast<std::string*>(message) = text; }

  std::string message_;
  GEOSContextHandle_t handle_;
};

/// The even-odd region: the symmetric difference of the rings.
Geos::Geometry region(const Geos& geos, const Polygon& polygon) {
  const GEOSContextHandle_t handle = geos.handle();
  Geos::Geometry sum;
  for (const Ring& ring : polygon.rings()) {
    GEOSGeometry* shell = GEOSGeom_createLinearRing_r(handle, geos.closedSequence(ring));
    const auto simple = geos.own(GEOSGeom_createPolygon_r(handle, shell, nullptr, 0));
    const auto valid = geos.own(GEOSMakeValid_r(handle, simple.get()));
    sum = sum ? geos.own(GEOSSymDifference_r(handle, sum.get(), valid.get())) : valid;
  }
  return sum;
}

/// Exact in its sign for ordinary coordinates (double-double arithmetic).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  static const Geos geos;
  return GEOSOrientationIndex_r(geos.handle(), a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
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
  const Geos geos;
  const auto whole = region(geos, polygon);
  const auto parts = geos.own(GEOSConstrainedDelaunayTriangulation_r(geos.handle(), whole.get()));
  std::vector<Triangle> triangles;
  for (int i = 0; i < GEOSGetNumGeometries_r(geos.handle(), parts.get()); ++i) {
    const Ring ring = geos.vertices(GEOSGetGeometryN_r(geos.handle(), parts.get(), i));
    Triangle triangle = {ring.at(0), ring.at(1), ring.at(2)};
    if (orientation(triangle[0], triangle[1], triangle[2]) < 0) std::swap(triangle[1], triangle[2]);
    triangles.push_back(triangle);
  }
  const double wanted = geos.area(whole.get());
  if (!(std::abs(geos.area(parts.get()) - wanted) <= 1e-9 * wanted)) {
    throw std::runtime_error("triangulate: the triangles' area is not the region's");
  }
  return triangles;
}

std::vector<Ring> convexPieces(const std::vector<Triangle>& triangles) { return PieceMerger(triangles).pieces(); }

}  // namespace tricover::bench
