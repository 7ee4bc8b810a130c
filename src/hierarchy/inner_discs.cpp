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

/// How deep points are in a small convex polygon, for what is deeper than kOfLines: no more than that too much. The
/// depth is the least distance from a line, d - n p, of which floats, whose points are within 1 of S (others are far
/// outside) round away 8 2^-24 at most; and vertices, which are rounded by U from S, turn the line of an edge of 2^-30
/// or more by 2^-22 at most. The rest is there so that the hierarchy, which knows less, can confirm it.
constexpr float kOfLines = 0x1p-15f;

void measureDepths(const SmallPolygon& convex, DepthProbes& probes) {
  static_assert(kLanes == 8);
  typedef float Loose __attribute__((vector_size(16), aligned(4), may_alias));
  const auto load = [](const float* from) -> Float4 { return *reinterpret_cast<const Loose*>(from); };
  const Float4 x[] = {load(probes.x), load(probes.x + 4)}, y[] = {load(probes.y), load(probes.y + 4)};
  Float4 depth[] = {Float4{} + 1e30f, Float4{} + 1e30f};
  for (int i = 0; i < convex.count; ++i)
    for (const int k : {0, 1}) {
      const Float4 inside = convex.d[i] - convex.nx[i] * x[k] - convex.ny[i] * y[k];
      depth[k] = inside < depth[k] ? inside : depth[k];
    }
  for (const int k : {0, 1}) *reinterpret_cast<Loose*>(probes.depth + 4 * k) = depth[k];
}

/// Up to kLanes large discs, the first one the largest. A search in floats: what it finds has to be proven.
class DiscSearch {
 public:
  DiscSearch(const PolygonData& polygon, const Hierarchy& hierarchy)
      : convex_(hierarchy.small_convex), root_(hierarchy.root), few_(polygon.path.size() < 32) {
    if (convex_ == nullptr) outline_.emplace(polygon);
    lookAround();
    climb();
    choose();
  }

  const Guess* begin() const { return chosen_; }
  const Guess* end() const { return chosen_ + count_; }

 private:
  static constexpr int kMostPlaces = 40;

  /// From a grid over the box around everything.
  void lookAround() {
    const int along = few_ ? 8 : 10, across = few_ ? 2 : 4;
    const float part_u = root_.along / static_cast<float>(along), part_v = root_.across / static_cast<float>(across);
    float u = part_u - root_.along, v = part_v - root_.across;
    for (int k = 0; k < along * across; k += kLanes) {
      DepthProbes probes;
      for (int i = 0; i < kLanes; ++i) {
        probes.x[i] = root_.x + u * root_.ux - v * root_.uy;
        probes.y[i] = root_.y + u * root_.uy + v * root_.ux;
        u += 2 * part_u;
        if (u < root_.along) continue;
        u = part_u - root_.along;
        v += 2 * part_v;
      }
      measure(probes, [&](const Guess& found) {
        if (found.depth > 0) places_[place_count_++] = found;
      });
    }
  }
  static_assert(8 * 2 % kLanes == 0 && 10 * 4 % kLanes == 0 && kMostPlaces == 10 * 4);

  /// The largest, uphill from near S (but not where symmetry would need the exact stage) or from the best place.
  void climb() {
    constexpr float kWay[kLanes][2] = {{1, 0},       {-1, 0},       {0, 1},        {0, -1},
                                       {0.7f, 0.7f}, {-0.7f, 0.7f}, {0.7f, -0.7f}, {-0.7f, -0.7f}};
    const auto tryAround = [&](const Guess& from, float step) {
      DepthProbes probes;
      for (int i = 0; i < kLanes; ++i)
        probes.x[i] = from.x + step * kWay[i][0], probes.y[i] = from.y + step * kWay[i][1];
      measure(probes, [](const Guess&) {});
    };
    tryAround({0x1.8p-11f, 0x1.2p-12f, 0}, 0x1p-4f);
    for (float step = 0.25f; step > 0.02f; step *= best_.depth > 0 ? 0.5f : 0.7f) tryAround(best_, step);
  }

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

  template <typename Show>
  void measure(DepthProbes& probes, Show show) {
    convex_ != nullptr ? measureDepths(*convex_, probes) : detail::measureDepths(*outline_, probes);
    for (int i = 0; i < kLanes; ++i) {
      const Guess found{probes.x[i], probes.y[i], probes.depth[i]};
      show(found);
      if (found.depth > best_.depth) best_ = found;
    }
  }

  const SmallPolygon* convex_;  ///< asked instead of the outline, if there is one
  std::optional<ThinnedOutline> outline_;
  const Box& root_;
  bool few_;
  Guess best_{0, 0, -1e30f}, places_[kMostPlaces], chosen_[kLanes];
  int place_count_ = 0, count_ = 0;
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

/// The radius, in units, of a disc of which `clearance(place)` is known not to meet an edge; 0 if there is none.
template <typename Clearance>
double clearRadius(const PolygonData& polygon, const Vec2& center, Clearance clearance) {
  if (!polygon.fitsUnit() || !inFrame(polygon, center).allFinite()) return 0;
  // Taking the centre to the polygon's frame rounds it, in either coordinate, by U of the product and of the sum with
  // S, which may be far off.
  const Place place{center.x(), center.y(), 4 * kUnitRoundoff * (polygon.extent / polygon.unit + 1)};
  const double radius = clearance(place);
  return radius > 0 && std::isfinite(radius * polygon.unit) ? radius : 0;
}

/// At most `most`.
double clearRadius(const PolygonData& polygon, const Vec2& center, double most) {
  return clearRadius(polygon, center,
                     [&](const Place& place) { return clearanceAt(hierarchyOf(polygon), place, most); });
}

/// Of a small convex polygon, as deep in which as lines tell.
double clearOfLines(const PolygonData& polygon, const Vec2& center, float depth) {
  return clearRadius(polygon, center, [&](const Place& place) { return depth - kOfLines - 2 * place.error; });
}

bool isInside(const PolygonData& polygon, const Vec2& center) {
  return locateInPolygon(polygon, IncludedPoint::ofFrame(inFrame(polygon, center))) == Location::Inside;
}

}  // namespace

ThinnedOutline::ThinnedOutline(const PolygonData& polygon) : fill(polygon.fill) {
  const std::size_t stride = polygon.path.size() / kSearched + 1;
  edges.reserve(polygon.path.size() / stride + polygon.ringCount());
  const auto narrow = [](double value) { return std::abs(value) < 0x1p-60 ? 0 : static_cast<float>(value); };
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t end = polygon.edgeEnd(r);
    Vec2 v = polygon.inUnits(polygon.path[polygon.edgeBegin(r)]);
    for (std::size_t e = polygon.edgeBegin(r); e < end; e += stride) {
      const Vec2 w = polygon.inUnits(polygon.path[std::min(e + stride, end)]), along = w - v;
      const double square = along.squaredNorm();
      edges.push_back({narrow(v.x()), narrow(v.y()), narrow(w.x()), narrow(w.y()), static_cast<float>(along.x()),
                       static_cast<float>(along.y()), square > 1e-20 ? static_cast<float>(1 / square) : 0});
      v = w;
    }
  }
}

double provenRadius(const PolygonData& polygon, const Vec2& center, double most) {
  const double radius = clearRadius(polygon, center, most);
  return radius > 0 && isInside(polygon, center) ? radius : 0;
}

InnerDiscs::InnerDiscs(const PolygonData& polygon) : center(polygon.origin) {
  int first = 0;
  const Hierarchy& hierarchy = hierarchyOf(polygon);
  const bool is_convex = hierarchy.small_convex != nullptr;
  for (const Guess& guess : DiscSearch(polygon, hierarchy)) {
    // What the thinned outline overlooks makes a disc smaller, rounding perhaps larger.
    const Vec2 at(guess.x, guess.y);
    const double proven =
        is_convex ? clearOfLines(polygon, at, guess.depth) : clearRadius(polygon, at, guess.depth * (1 + 0x1p-10));
    if (!(proven > 0)) continue;
    // No edge parts two discs that meet: if the one is in the region, so is the other.
    bool is_inside = is_convex || (ThinnedOutline::isWhole(polygon) && proven >= kSurelyBeside);
    assert(!is_inside || isInside(polygon, at));
    for (int i = 0; i < count && !is_inside; ++i) {
      const double sum = (radius[i] + proven) * (1 - 0x1p-20);
      is_inside = (at - Vec2(x[i], y[i])).squaredNorm() < sum * sum;
    }
    if (!is_inside && !isInside(polygon, at)) continue;
    const int k = count++;
    x[k] = guess.x;
    y[k] = guess.y;
    radius[k] = static_cast<float>(proven * (1 - 0x1p-22));
    reach = std::max(reach, std::hypot(x[k], y[k]) + radius[k]) * (1 + 0x1p-20f);
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
