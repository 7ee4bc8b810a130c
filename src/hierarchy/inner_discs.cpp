// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inner_discs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "hierarchy/inclusion.h"
#include "hierarchy/simd.h"
#include "numbers/float4.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// A disc that may be in the region.
struct Guess {
  float x, y, depth;
};

typedef float LooseFloat4 __attribute__((vector_size(16), aligned(4), may_alias));
Float4 load4(const float* from) { return *reinterpret_cast<const LooseFloat4*>(from); }
void store4(float* to, Float4 v) { *reinterpret_cast<LooseFloat4*>(to) = v; }

/// How deep points are in a small convex polygon: the least distance from a line.
void measureDepths(const SmallPolygon& convex, DepthProbes& probes) {
  static_assert(kLanes == 8);
  const Float4 x[] = {load4(probes.x), load4(probes.x + 4)}, y[] = {load4(probes.y), load4(probes.y + 4)};
  Float4 depth[] = {Float4{} + 1e30f, Float4{} + 1e30f};
  for (int i = 0; i < convex.count; ++i)
    for (const int k : {0, 1}) {
      const Float4 inside = convex.d[i] - convex.nx[i] * x[k] - convex.ny[i] * y[k];
      depth[k] = inside < depth[k] ? inside : depth[k];
    }
  for (const int k : {0, 1}) store4(probes.depth + 4 * k, depth[k]);
}

/// Places in a box, by its half extents from its centre: so many along it and across.
template <int kCount>
struct Grid {
  constexpr Grid(int along, int across) {
    for (int k = 0; k < kCount; ++k) {
      u[k] = static_cast<float>(2 * (k % along) + 1 - along) / static_cast<float>(along);
      v[k] = static_cast<float>(2 * (k / along) + 1 - across) / static_cast<float>(across);
    }
  }
  float u[kCount] = {}, v[kCount] = {};
};
constexpr Grid<8 * 2> kFewPlaces(8, 2);
constexpr Grid<10 * 4> kPlaces(10, 4);
constexpr int kMostGroups = 10 * 4 / kLanes;

/// Up to kLanes large discs, the first one the largest. A search in floats: what it finds has to be proven.
class DiscSearch {
 public:
  DiscSearch(const PolygonData& polygon, const Hierarchy& hierarchy)
      : convex_(hierarchy.small_convex), root_(hierarchy.root) {
    if (convex_ == nullptr) outline_.emplace(polygon);
    polygon.path.size() < 32 ? lookAround(kFewPlaces) : lookAround(kPlaces);
    climb();
    choose();
  }

  const Guess* begin() const { return chosen_; }
  const Guess* end() const { return chosen_ + count_; }

 private:
  /// From a grid over the box around everything.
  template <int kCount>
  void lookAround(const Grid<kCount>& grid) {
    static_assert(kCount % kLanes == 0);
    const float x = root_.x, ux = root_.along * root_.ux, vx = root_.across * root_.uy;
    const float y = root_.y, uy = root_.along * root_.uy, vy = root_.across * root_.ux;
    for (; group_count_ < kCount / kLanes; ++group_count_) {
      DepthProbes& probes = groups_[group_count_];
      const float *u = grid.u + group_count_ * kLanes, *v = grid.v + group_count_ * kLanes;
      for (int i = 0; i < kLanes; i += 4) {
        store4(probes.x + i, x + load4(u + i) * ux - load4(v + i) * vx);
        store4(probes.y + i, y + load4(u + i) * uy + load4(v + i) * vy);
      }
      measure(probes);
    }
  }

  /// The largest, uphill from near S (but not where symmetry would need the exact stage) or from the best place.
  void climb() {
    constexpr float kWayX[kLanes] = {1, -1, 0, 0, 0.7f, -0.7f, 0.7f, -0.7f};
    constexpr float kWayY[kLanes] = {0, 0, 1, -1, 0.7f, 0.7f, -0.7f, -0.7f};
    const auto tryAround = [&](float x, float y, float step) {
      DepthProbes probes;
      for (int i = 0; i < kLanes; ++i) {
        probes.x[i] = x + step * kWayX[i];
        probes.y[i] = y + step * kWayY[i];
      }
      measure(probes);
    };
    tryAround(0x1.8p-11f, 0x1.2p-12f, 0x1p-4f);
    for (float step = 0.25f; step > 0.02f; step *= best_.depth > 0 ? 0.5f : 0.7f) tryAround(best_.x, best_.y, step);
  }

  /// Each time the largest whose centre no disc holds yet.
  void choose() {
    while (best_.depth > 0 && count_ < kLanes) {
      const Guess held_by = chosen_[count_++] = best_;
      best_ = {0, 0, 0};
      for (int k = 0; k < group_count_; ++k) {
        DepthProbes& probes = groups_[k];
        for (int i = 0; i < kLanes; i += 4) {
          const Float4 dx = load4(probes.x + i) - held_by.x, dy = load4(probes.y + i) - held_by.y;
          const Float4 depth = load4(probes.depth + i);
          store4(probes.depth + i, dx * dx + dy * dy < held_by.depth * held_by.depth ? Float4{} : depth);
        }
        findBest(probes);
      }
    }
  }

  void measure(DepthProbes& probes) {
    convex_ != nullptr ? measureDepths(*convex_, probes) : detail::measureDepths(*outline_, probes);
    findBest(probes);
  }

  void findBest(const DepthProbes& probes) {
    const Float4 four = larger(load4(probes.depth), load4(probes.depth + 4));
    const Float4 two = larger(four, shuffled<2, 3, 0, 1>(four));
    if (!(std::max(two[0], two[1]) > best_.depth)) return;
    const auto k = std::max_element(probes.depth, probes.depth + kLanes) - probes.depth;
    best_ = {probes.x[k], probes.y[k], probes.depth[k]};
  }

  const SmallPolygon* convex_;  ///< asked instead of the outline, if there is one
  std::optional<ThinnedOutline> outline_;
  const Box& root_;
  DepthProbes groups_[kMostGroups];
  Guess best_{0, 0, -1e30f}, chosen_[kLanes];
  int group_count_ = 0, count_ = 0;
};

/// Exactly, as far as a radius less an ulp is the radius. Edges that are farther away by a 2^-10 need no exact number.
[[maybe_unused]] bool isInRegion(const PolygonData& polygon, const Vec2& center, double radius) {
  const double within = std::nextafter(radius, 0), near = radius / polygon.unit * (1 + 0x1p-10);
  const Vec2 local_center = polygon.inUnits(center);
  for (std::size_t r = 0; r < polygon.ringCount(); ++r)
    for (std::size_t e = polygon.edgeBegin(r); e < polygon.edgeEnd(r); ++e) {
      const Vec2 &v = polygon.path[e], &w = polygon.path[e + 1];
      if (squaredDistanceToSegment(local_center, polygon.inUnits(v), polygon.inUnits(w)) > near * near) continue;
      if (withinExact({nullptr, center}, {nullptr, v}, {nullptr, w}, within)) return false;
    }
  return includeInCovering(polygon, IncludedPoint::ofFrame(center)).location == Location::Inside;
}

/// A point in units from S.
Vec2 inFrame(const PolygonData& polygon, const Vec2& p) { return polygon.origin + p * polygon.unit; }

}  // namespace

ThinnedOutline::ThinnedOutline(const PolygonData& polygon) : is_even_odd_(polygon.fill == FillRule::EvenOdd) {
  const std::size_t stride = polygon.path.size() / kSearched + 1;
  const std::size_t most = polygon.path.size() / stride + polygon.ringCount();
  if (most > kFew) many_.resize(most);
  end_ = begin_ = many_.empty() ? few_ : many_.data();
  const auto vertex = [&](std::size_t position) {
    const Vec2 p = polygon.inUnits(polygon.path[position]);
    const Double2 v = load2(p.data());
    return narrowed(absolute(v) < 0x1p-60 ? Double2{} : v);
  };
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t end = polygon.edgeEnd(r);
    Float2 v = vertex(polygon.edgeBegin(r));
    for (std::size_t e = polygon.edgeBegin(r); e < end; e += stride) {
      const Float2 w = vertex(std::min(e + stride, end)), along = w - v, squares = along * along;
      const float square = squares[0] + squares[1];
      const float inverse = square > 1e-20f ? 1 / square : 0, slope = along[1] != 0 ? along[0] / along[1] : 0;
      *end_++ = {v[0], v[1], w[1], along[0], along[1], inverse, slope};
      v = w;
    }
  }
}

double provenRadius(const PolygonData& polygon, const Vec2& center, float depth) {
  if (!polygon.fitsUnit()) return 0;
  const auto isInside = [&] {
    const Vec2 p = inFrame(polygon, center);
    return p.allFinite() && locateInPolygon(polygon, IncludedPoint::ofFrame(p)) == Location::Inside;
  };
  // Taking the centre to the polygon's frame rounds it, in either coordinate, by U of the product and of the sum with
  // S, which may be far off.
  const Place place{center.x(), center.y(), 4 * kUnitRoundoff * (polygon.extent / polygon.unit + 1)};
  if (ThinnedOutline::isWhole(polygon) && depth > kSurelyBeside && std::abs(place.x) + std::abs(place.y) < 4) {
    const double radius = std::max(depth - kDepthError - 2 * place.error, 0.0);
    assert(radius == 0 || isInside());
    return radius;
  }
  // What a thinned outline overlooks makes a disc smaller, rounding perhaps larger.
  const double radius = clearanceAt(hierarchyOf(polygon), place, depth * (1 + 0x1p-10));
  return radius > 0 && std::isfinite(radius * polygon.unit) && isInside() ? radius : 0;
}

InnerDiscs::InnerDiscs(const PolygonData& polygon) : center(polygon.origin) {
  int first = 0;
  for (const Guess& guess : DiscSearch(polygon, topOf(polygon))) {
    const double proven = provenRadius(polygon, Vec2(guess.x, guess.y), guess.depth);
    if (!(proven > 0)) continue;
    const int k = count++;
    x[k] = guess.x;
    y[k] = guess.y;
    radius[k] = static_cast<float>(proven * (1 - 0x1p-22));
    const double away = std::sqrt(dot(Double2{x[k], y[k]}, Double2{x[k], y[k]}));
    reach = std::max(reach, static_cast<float>((away + radius[k]) * (1 + 0x1p-20)));
    if (radius[k] > radius[first]) first = k;
  }
  if (count == 0) return;
  // What the thinned outline overlooked may have turned their order.
  std::swap(x[0], x[first]);
  std::swap(y[0], y[first]);
  std::swap(radius[0], radius[first]);
  center = inFrame(polygon, Vec2(x[0], y[0]));
  largest = radius[0] * polygon.unit;
  assert(isInRegion(polygon, center, largest));
}

const InnerDiscs& innerDiscsOf(const PolygonData& polygon) {
  if (const InnerDiscs* ready = innerDiscsIfBuilt(polygon)) return *ready;
  return *static_cast<const InnerDiscs*>(
      polygon.discs.built([&] { return std::make_unique<const InnerDiscs>(polygon); }));
}

const InnerDiscs* payForDiscs(const PolygonData& polygon) {
  // Of more edges than a thinned outline has nothing is looked at but what the hierarchy finds. Few edges are asked at
  // once, so that discs save a query little.
  constexpr std::size_t kOfEdge = 16, kMostEdges = 80, kOfQuery = 24, kOfFewEdges = 4;
  const bool few = polygon.path.size() - polygon.ringCount() <= SmallPolygon::kMost;
  const bool is_due =
      polygon.discs_rent.isDue(few ? kOfFewEdges : kOfQuery, kOfEdge * std::min(polygon.path.size(), kMostEdges));
  return is_due ? &innerDiscsOf(polygon) : nullptr;
}

}  // namespace tricover::detail
