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

/// What floats take a point's distance from an edge of a small polygon, or from its line, for too much at most, of
/// points with |x| + |y| < 4 in units from S:
///   n p - d, and what is past the edge's ends, are off by 2^-24 times
///     4 + 4 + 4  the products' factors and themselves, |n| being 1
///     1 + 1      d, or the middle and the half
///     5 + 5 + 6  sums and differences
///   an edge of 2^-30 or more is turned by less than 2^-21 by its vertices, rounded by U from S, over 5 at most
/// Together below 2^-18, in any direction and with the root below 2^-17.
constexpr double kFewEdgesError = 0x1p-17;

typedef float LooseFloat4 __attribute__((vector_size(16), aligned(4), may_alias));
Float4 load4(const float* from) { return *reinterpret_cast<const LooseFloat4*>(from); }

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
  for (const int k : {0, 1}) *reinterpret_cast<LooseFloat4*>(probes.depth + 4 * k) = depth[k];
}

/// A lower bound of the distance from the edges.
double clearanceOfFew(const SmallPolygon& small, const Place& place) {
  if (!(std::abs(place.x) + std::abs(place.y) < 4)) return 0;
  const auto x = static_cast<float>(place.x), y = static_cast<float>(place.y);
  Float4 square = Float4{} + 1e30f;
  for (int i = 0; i < small.lanes; i += 4) {
    const Float4 nx = load4(small.nx + i), ny = load4(small.ny + i);
    const Float4 beyond = nx * x + ny * y - load4(small.d + i);
    const Float4 past = larger(absolute(nx * y - ny * x - load4(small.middle + i)) - load4(small.half + i), Float4{});
    const Float4 here = beyond * beyond + past * past;
    square = here < square ? here : square;
  }
  const float least = std::min(std::min(square[0], square[1]), std::min(square[2], square[3]));
  return std::sqrt(least) - kFewEdgesError - 2 * place.error;
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

/// The radius, in units, of a disc that no edge meets, at most `most`; 0 if that can't be shown.
double clearRadius(const PolygonData& polygon, const Vec2& center, double most) {
  if (!polygon.fitsUnit() || !inFrame(polygon, center).allFinite()) return 0;
  // Taking the centre to the polygon's frame rounds it, in either coordinate, by U of the product and of the sum with
  // S, which may be far off.
  const Place place{center.x(), center.y(), 4 * kUnitRoundoff * (polygon.extent / polygon.unit + 1)};
  const SmallPolygon* small = topOf(polygon).small.get();
  const double radius =
      small == nullptr ? clearanceAt(hierarchyOf(polygon), place, most) : std::min(clearanceOfFew(*small, place), most);
  return radius > 0 && std::isfinite(radius * polygon.unit) ? radius : 0;
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
    float x = narrow(v.x()), y = narrow(v.y());
    for (std::size_t e = polygon.edgeBegin(r); e < end; e += stride) {
      const Vec2 w = polygon.inUnits(polygon.path[std::min(e + stride, end)]), along = w - v;
      const double square = along.squaredNorm();
      const float end_x = narrow(w.x()), end_y = narrow(w.y());
      edges.push_back({x, y, end_y, end_x - x, end_y - y, static_cast<float>(along.x()), static_cast<float>(along.y()),
                       square > 1e-20 ? static_cast<float>(1 / square) : 0});
      v = w;
      x = end_x, y = end_y;
    }
  }
}

double provenRadius(const PolygonData& polygon, const Vec2& center, double most) {
  const double radius = clearRadius(polygon, center, most);
  return radius > 0 && isInside(polygon, center) ? radius : 0;
}

InnerDiscs::InnerDiscs(const PolygonData& polygon) : center(polygon.origin) {
  int first = 0;
  const Hierarchy& hierarchy = topOf(polygon);
  const bool is_convex = hierarchy.small_convex != nullptr;
  for (const Guess& guess : DiscSearch(polygon, hierarchy)) {
    // What the thinned outline overlooks makes a disc smaller, rounding perhaps larger.
    const Vec2 at(guess.x, guess.y);
    const double proven = clearRadius(polygon, at, guess.depth * (1 + 0x1p-10));
    if (!(proven > 0)) continue;
    // No edge parts two discs that meet: if the one is in the region, so is the other. And a convex region is what is
    // beyond no line.
    bool is_inside =
        is_convex ? guess.depth > kFewEdgesError : ThinnedOutline::isWhole(polygon) && proven >= kSurelyBeside;
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
