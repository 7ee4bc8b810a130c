// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inner_discs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "hierarchy/inclusion.h"
#include "hierarchy/simd.h"

namespace tricover::detail {
namespace {

/// A point in units from S.
Vec2 inFrame(const PolygonData& polygon, const Vec2& p) { return polygon.origin + p * polygon.unit; }

/// A disc that may be in the region.
struct Guess {
  float x, y, depth;
};

/// Looks for deep places in floats: what it finds has to be proven.
class DepthSearch {
 public:
  explicit DepthSearch(const PolygonData& polygon) : outline_(polygon) {}

  /// On a grid over a box, a little aside from where symmetry would need exact predicates.
  void lookAround(const Box& box, int along, int across) {
    const auto share = [](int k, int count) {
      return static_cast<float>(2 * k + 1 - count) / static_cast<float>(count);
    };
    inside_.reserve(static_cast<std::size_t>(along * across + 8 * kLanes));
    for (int first = 0; first < along * across; first += kLanes) {
      DepthProbes probes;
      for (int i = 0; i < kLanes; ++i) {
        const float u = box.along * (share((first + i) % along, along) + 0x1.8p-11f);
        const float v = box.across * (share((first + i) / along, across) + 0x1.2p-12f);
        probes.x[i] = box.x + u * box.ux - v * box.uy;
        probes.y[i] = box.y + u * box.uy + v * box.ux;
      }
      measure(probes);
    }
  }

  /// Uphill from the deepest place.
  void climb() {
    constexpr float kWayX[kLanes] = {1, -1, 0, 0, 0.7f, -0.7f, 0.7f, -0.7f};
    constexpr float kWayY[kLanes] = {0, 0, 1, -1, 0.7f, 0.7f, -0.7f, -0.7f};
    for (float step = 0.25f; step > 0.005f; step *= best_.depth > 0 ? 0.5f : 0.7f) {
      DepthProbes probes;
      for (int i = 0; i < kLanes; ++i) {
        probes.x[i] = best_.x + step * kWayX[i];
        probes.y[i] = best_.y + step * kWayY[i];
      }
      measure(probes);
    }
  }

  const Guess& deepest() const { return best_; }
  /// Leaves out what is within `radius` of a guess. Returns the deepest of the others, or depth 0 if there is none.
  Guess deepestBeyond(const Guess& around, float radius) {
    Guess best{0, 0, 0};
    for (Guess& guess : inside_) {
      const float dx = guess.x - around.x, dy = guess.y - around.y;
      if (dx * dx + dy * dy <= radius * radius) guess.depth = 0;
      if (guess.depth > best.depth) best = guess;
    }
    return best;
  }

 private:
  void measure(DepthProbes& probes) {
    measureDepths(outline_, probes);
    for (int i = 0; i < kLanes; ++i) {
      const float depth = probes.depth[i];
      if (depth > 0) inside_.push_back({probes.x[i], probes.y[i], depth});
      if (depth > best_.depth) best_ = {probes.x[i], probes.y[i], depth};
    }
  }

  ThinnedOutline outline_;
  std::vector<Guess> inside_;
  Guess best_{0, 0, -1e30f};
};

}  // namespace

ThinnedOutline::ThinnedOutline(const PolygonData& polygon) : is_even_odd(polygon.fill.rule == FillRule::EvenOdd) {
  const auto stride = static_cast<EdgePosition>(polygon.path.size() / kSearched + 1);
  edges.reserve(polygon.path.size() / stride + polygon.ringCount());
  struct Vertex {
    float x, y;
  };
  const auto vertex = [&](EdgePosition position) {
    const auto coordinate = [](double value) { return std::abs(value) < 0x1p-60 ? 0 : static_cast<float>(value); };
    const Vec2 p = polygon.inUnits(polygon.path[position]);
    return Vertex{coordinate(p.x()), coordinate(p.y())};
  };
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const EdgePosition end = polygon.edgeEnd(r);
    Vertex v = vertex(polygon.edgeBegin(r));
    for (EdgePosition e = polygon.edgeBegin(r); e < end; e += stride) {
      const Vertex w = vertex(std::min(e + stride, end));
      const float dx = w.x - v.x, dy = w.y - v.y, square = dx * dx + dy * dy;
      edges.push_back({v.x, v.y, w.y, dx, dy, square > 1e-20f ? 1 / square : 0, dy != 0 ? dx / dy : 0});
      v = w;
    }
  }
}

double provenRadius(const PolygonData& polygon, const Vec2& center, float depth) {
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

/// Around the deepest places of a grid over the root box and the deepest near those, deepest first. No centre is in a
/// disc before it.
InnerDiscs::InnerDiscs(const PolygonData& polygon) : center(polygon.origin) {
  if (!polygon.fitsUnit() || polygon.fill.is_complement) return;
  // At most 16 edges are tested at once: little but the largest disc is worth its cost.
  const bool few = topOf(polygon).small != nullptr;
  DepthSearch search(polygon);
  search.lookAround(topOf(polygon).root, 8, few ? 2 : 5);
  search.climb();
  int first = 0;
  for (Guess guess = search.deepest(); guess.depth > 0 && count < (few ? 2 : kLanes);) {
    const Vec2 at(guess.x, guess.y);
    const double proven = provenRadius(polygon, at, guess.depth);
    guess = search.deepestBeyond(guess, static_cast<float>(proven));
    if (!(proven > 0)) continue;
    const int k = count++;
    x[k] = static_cast<float>(at.x());
    y[k] = static_cast<float>(at.y());
    radius[k] = static_cast<float>(proven * (1 - 0x1p-22));
    reach = std::max(reach, static_cast<float>((at.norm() + radius[k]) * (1 + 0x1p-20)));
    if (radius[k] > radius[first]) first = k;
  }
  if (count == 0) return;
  // The thinned outline may have overlooked something, and the first isn't the largest.
  std::swap(x[0], x[first]);
  std::swap(y[0], y[first]);
  std::swap(radius[0], radius[first]);
  center = inFrame(polygon, Vec2(x[0], y[0]));
  largest = radius[0] * polygon.unit;
}

const InnerDiscs& innerDiscsOf(const PolygonData& polygon) { return polygon.discs.made<InnerDiscs>(polygon); }

const InnerDiscs* payForDiscs(const PolygonData& polygon) {
  // A thinned outline bounds the price. At most 16 edges are tested at once, and discs save such a query little.
  constexpr std::size_t kOfEdge = 16, kMostEdges = 80, kOfQuery = 24, kOfFewEdges = 4;
  const bool few = polygon.path.size() - polygon.ringCount() <= SmallPolygon::kMost;
  const bool is_due =
      polygon.discs_rental.isDue(few ? kOfFewEdges : kOfQuery, kOfEdge * std::min(polygon.path.size(), kMostEdges));
  return is_due ? &innerDiscsOf(polygon) : nullptr;
}

}  // namespace tricover::detail
