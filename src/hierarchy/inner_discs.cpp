// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inner_discs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "numbers/segment.h"
#include "polygon/covering.h"

namespace tricover::detail {
namespace {

/// Numbers of points that are asked about together (GCC's and Clang's vectors, see Double2), and truths, -1 or 0.
typedef float Floats __attribute__((vector_size(16)));
typedef std::int32_t Truths __attribute__((vector_size(16)));
constexpr int kProbes = 4;

struct Probes {
  Floats x, y;
  Floats depth;  ///< distance to the boundary, negative outside the region
};

/// Edges in floats; of a large polygon those between every `stride`-th vertex only.
class ThinnedOutline {
 public:
  ThinnedOutline(const PolygonData& polygon, const std::vector<Vec2>& local) : fill_(polygon.fill) {
    constexpr std::size_t kSearched = 128;
    const std::size_t stride = local.size() / kSearched + 1;
    edges_.reserve(local.size() / stride + polygon.ringCount());
    for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
      const std::size_t end = polygon.edgeEnd(r);
      for (std::size_t e = polygon.edgeBegin(r); e < end; e += stride) {
        const Vec2 &v = local[e], &w = local[std::min(e + stride, end)], along = w - v;
        const double square = along.squaredNorm();
        const auto narrow = [](double value) { return static_cast<float>(value); };
        edges_.push_back({narrow(v.x()), narrow(v.y()), narrow(w.y()), narrow(along.x()), narrow(along.y()),
                          square > 1e-20 ? narrow(1 / square) : 0});
      }
    }
  }

  void measure(Probes& probes) const {
    const Floats zero{}, one = zero + 1;
    Floats square = zero + 1e30f;
    Truths winding{};
    for (const Edge& e : edges_) {
      const Floats x = probes.x - e.x, y = probes.y - e.y;
      Floats part = (x * e.along_x + y * e.along_y) * e.inverse_square;
      part = part > zero ? part : zero;
      part = part < one ? part : one;
      const Floats dx = x - part * e.along_x, dy = y - part * e.along_y, distance = dx * dx + dy * dy;
      square = distance < square ? distance : square;
      const Floats side = e.along_x * y - e.along_y * x;
      const Truths after_start = y >= zero, after_end = probes.y >= zero + e.end_y;
      winding -= (after_start & ~after_end & (side > zero)) - (~after_start & after_end & (side < zero));
    }
    for (int i = 0; i < kProbes; ++i) {
      const bool inside = fill_ == FillRule::EvenOdd ? winding[i] % 2 != 0 : winding[i] != 0;
      probes.depth[i] = inside ? std::sqrt(square[i]) : -std::sqrt(square[i]);
    }
  }

 private:
  struct Edge {
    float x, y, end_y, along_x, along_y, inverse_square;
  };
  std::vector<Edge> edges_;
  FillRule fill_;
};

/// A disc that may be in the region.
struct Guess {
  float x, y, depth;
};

/// Up to kLanes large discs, the first one the largest. A search in floats: what it finds has to be proven.
class DiscSearch {
 public:
  DiscSearch(const PolygonData& polygon, const std::vector<Vec2>& local, const Box& root)
      : outline_(polygon, local), root_(root), few_(local.size() < 32) {
    climb();
    lookAround();
    choose();
  }

  const Guess* begin() const { return chosen_; }
  const Guess* end() const { return chosen_ + count_; }

 private:
  static constexpr int kMostPlaces = 40;

  /// The largest, uphill from near S (but not where symmetry would need the exact stage).
  void climb() {
    constexpr Floats kWayX{1, -1, 0, 0}, kWayY{0, 0, 1, -1};
    best_ = {0x1.8p-11f, 0x1.2p-12f, -1e30f};
    const auto tryAround = [&](float step) {
      Probes probes{best_.x + step * kWayX, best_.y + step * kWayY, {}};
      outline_.measure(probes);
      for (int i = 0; i < kProbes; ++i) keepBetter({probes.x[i], probes.y[i], probes.depth[i]});
    };
    tryAround(0);
    for (float step = 0.4f; step > 0.02f; step *= best_.depth > 0 ? 0.5f : 0.7f) tryAround(step);
  }

  /// The others, from a grid over the box around everything.
  void lookAround() {
    const int along = few_ ? 6 : 10, across = few_ ? 2 : 4;
    for (int k = 0; k < along * across; k += kProbes) {
      Probes probes;
      for (int i = 0; i < kProbes; ++i) {
        const int row = (k + i) / along, column = (k + i) % along;
        const double u = root_.along * ((2.0 * column + 1) / along - 1);
        const double v = root_.across * ((2.0 * row + 1) / across - 1);
        probes.x[i] = static_cast<float>(root_.x + u * root_.ux - v * root_.uy);
        probes.y[i] = static_cast<float>(root_.y + u * root_.uy + v * root_.ux);
      }
      outline_.measure(probes);
      for (int i = 0; i < kProbes; ++i) {
        const Guess found{probes.x[i], probes.y[i], probes.depth[i]};
        if (found.depth > 0) places_[place_count_++] = found;
        keepBetter(found);
      }
    }
  }
  static_assert(6 * 2 % kProbes == 0 && 10 * 4 % kProbes == 0 && kMostPlaces == 10 * 4);

  /// Each time the largest whose centre no disc holds yet.
  void choose() {
    for (Guess next = best_; next.depth > 0 && count_ < kLanes;) {
      chosen_[count_++] = next;
      const auto held = [&](const Guess& g) {
        const float dx = g.x - next.x, dy = g.y - next.y;
        return dx * dx + dy * dy < next.depth * next.depth;
      };
      place_count_ = static_cast<int>(std::remove_if(places_, places_ + place_count_, held) - places_);
      if (place_count_ == 0) break;
      next = *std::max_element(places_, places_ + place_count_,
                               [](const Guess& p, const Guess& q) { return p.depth < q.depth; });
    }
  }

  void keepBetter(const Guess& guess) {
    if (guess.depth > best_.depth) best_ = guess;
  }

  const ThinnedOutline outline_;
  const Box& root_;
  bool few_;
  Guess best_{}, places_[kMostPlaces], chosen_[kLanes];
  int place_count_ = 0, count_ = 0;
};

/// Exactly, as far as a radius less an ulp is the radius. Edges that are farther away by a 2^-10 need no exact number.
[[maybe_unused]] bool isInRegion(const PolygonData& polygon, const std::vector<Vec2>& local, const Vec2& center,
                                 double radius) {
  const double within = std::nextafter(radius, 0), near = radius / polygon.unit * (1 + 0x1p-10);
  const Vec2 local_center = polygon.inUnits(center);
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      if (squaredDistanceToSegment(local_center, local[e], local[e + 1]) > near * near) continue;
      if (withinExact({nullptr, center}, {nullptr, polygon.path[e]}, {nullptr, polygon.path[e + 1]}, within))
        return false;
    }
  return includeInCovering(polygon, IncludedPoint::ofFrame(center)).location == Location::Inside;
}

}  // namespace

std::vector<double> thinnedDepths(const PolygonData& polygon, const std::vector<Vec2>& local,
                                  const std::vector<Vec2>& points) {
  const ThinnedOutline outline(polygon, local);
  std::vector<double> depths;
  while (depths.size() < points.size()) {
    const std::size_t first = depths.size(), count = std::min<std::size_t>(kProbes, points.size() - first);
    Probes probes{};
    for (std::size_t i = 0; i < count; ++i) {
      probes.x[i] = static_cast<float>(points[first + i].x());
      probes.y[i] = static_cast<float>(points[first + i].y());
    }
    outline.measure(probes);
    for (std::size_t i = 0; i < count; ++i) depths.push_back(probes.depth[i]);
  }
  return depths;
}

double provenRadius(const PolygonData& polygon, const std::vector<Vec2>& local, const Vec2& center) {
  double square = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e)
      square = std::min(square, squaredDistanceToSegment(center, local[e], local[e + 1]));
  // Distances of points below 2 units are computed with less than 32 U of error. Taking the centre back to the
  // polygon's frame rounds it, in either coordinate, by U of the product and of the sum with S, which may be far off.
  constexpr double kRoom = 0x1p-22;
  static_assert(32 * kUnitRoundoff <= kRoom);
  const double radius = std::sqrt(square) - kRoom - 4 * kUnitRoundoff * (polygon.extent / polygon.unit);
  const Vec2 p = polygon.origin + center * polygon.unit;
  if (!(radius > 0) || !std::isfinite(radius * polygon.unit) || !p.allFinite()) return 0;
  return includeInCovering(polygon, IncludedPoint::ofFrame(p)).location == Location::Inside ? radius : 0;
}

void findInnerDiscs(const PolygonData& polygon, const std::vector<Vec2>& local, Hierarchy& hierarchy) {
  InnerDiscs& discs = hierarchy.inner_discs;
  for (int i = 0; i < kLanes; ++i) discs.x[i] = discs.y[i] = 0, discs.radius[i] = -1e15f;
  discs.reach = 0;
  discs.count = 0;
  hierarchy.inner_center = polygon.origin;
  hierarchy.inner_radius = 0;
  int largest = 0;
  for (const Guess& guess : DiscSearch(polygon, local, hierarchy.root)) {
    const int k = discs.count;
    discs.x[k] = guess.x;
    discs.y[k] = guess.y;
    const double radius = provenRadius(polygon, local, Vec2(discs.x[k], discs.y[k]));
    if (!(radius > 0)) continue;
    discs.radius[k] = static_cast<float>(radius * (1 - 0x1p-22));
    discs.reach = std::max(discs.reach, std::hypot(discs.x[k], discs.y[k]) + discs.radius[k]) * (1 + 0x1p-20f);
    if (discs.radius[k] > discs.radius[largest]) largest = k;
    ++discs.count;
  }
  if (discs.count == 0) return;
  // What the thinned outline overlooked may have turned their order.
  std::swap(discs.x[0], discs.x[largest]);
  std::swap(discs.y[0], discs.y[largest]);
  std::swap(discs.radius[0], discs.radius[largest]);
  hierarchy.inner_center = polygon.origin + Vec2(discs.x[0], discs.y[0]) * polygon.unit;
  hierarchy.inner_radius = discs.radius[0] * polygon.unit;
  assert(isInRegion(polygon, local, hierarchy.inner_center, hierarchy.inner_radius));
}

}  // namespace tricover::detail
