// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/inner_discs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "numbers/segment.h"
#include "polygon/covering.h"

namespace tricover::detail {
namespace {

/// Distance to the boundary, negative outside the region; over every `stride`-th vertex only.
double depth(const PolygonData& polygon, const std::vector<Vec2>& local, const Vec2& p, std::size_t stride) {
  double square = std::numeric_limits<double>::infinity();
  int winding = 0;
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t end = polygon.edgeEnd(r);
    for (std::size_t e = polygon.edgeBegin(r); e < end; e += stride) {
      const Vec2 &v = local[e], &w = local[std::min(e + stride, end)];
      square = std::min(square, squaredDistanceToSegment(p, v, w));
      if ((v.y() <= p.y()) == (w.y() <= p.y())) continue;
      const double side = (w.x() - v.x()) * (p.y() - v.y()) - (w.y() - v.y()) * (p.x() - v.x());
      if (w.y() > v.y() ? side > 0 : side < 0) winding += w.y() > v.y() ? 1 : -1;
    }
  }
  const bool inside = polygon.fill == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
  return inside ? std::sqrt(square) : -std::sqrt(square);
}

/// A disc that may be in the region.
struct Guess {
  Vec2 center;
  double depth;
};

/// Up to kLanes large discs, the first one the largest. A search on a thinned outline, in rounded numbers: what it
/// finds has to be proven.
std::vector<Guess> search(const PolygonData& polygon, const std::vector<Vec2>& local, const Box& root) {
  constexpr std::size_t kSearched = 128;
  const std::size_t stride = local.size() / kSearched + 1;
  const auto guess = [&](const Vec2& p) { return Guess{p, depth(polygon, local, p, stride)}; };

  // The largest, uphill from near S (but not where symmetry would need the exact stage).
  Guess best = guess(Vec2(0x1.8p-11, 0x1.2p-12));
  for (double step = 0.4; step > 0.02; step *= best.depth > 0 ? 0.5 : 0.7) {
    const Vec2 from = best.center;
    for (const Vec2& way : {Vec2(step, 0), Vec2(-step, 0), Vec2(0, step), Vec2(0, -step)}) {
      const Guess other = guess(from + way);
      if (other.depth > best.depth) best = other;
    }
  }
  // The others, from a grid over the box around everything: each time the largest whose centre no disc holds yet.
  const int along = local.size() < 32 ? 6 : 10, across = local.size() < 32 ? 2 : 4;
  std::vector<Guess> grid;
  for (int i = 0; i < along * across; ++i) {
    const int row = i / along, column = i % along;
    const double u = root.along * ((2.0 * column + 1) / along - 1);
    const double v = root.across * ((2.0 * row + 1) / across - 1);
    const Guess found = guess({root.x + u * root.ux - v * root.uy, root.y + u * root.uy + v * root.ux});
    if (found.depth > 0) grid.push_back(found);
    if (found.depth > best.depth) best = found;
  }
  std::vector<Guess> chosen;
  for (Guess next = best; next.depth > 0 && chosen.size() < kLanes;) {
    chosen.push_back(next);
    const auto held = [&](const Guess& g) { return (g.center - next.center).norm() < next.depth; };
    grid.erase(std::remove_if(grid.begin(), grid.end(), held), grid.end());
    const auto largest =
        std::max_element(grid.begin(), grid.end(), [](const Guess& p, const Guess& q) { return p.depth < q.depth; });
    if (largest == grid.end()) break;
    next = *largest;
  }
  return chosen;
}

/// The radius, in units, of a disc around `center` (also in units) that lies in the region; 0 if that can't be shown.
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

void findInnerDiscs(const PolygonData& polygon, const std::vector<Vec2>& local, Hierarchy& hierarchy) {
  InnerDiscs& discs = hierarchy.inner_discs;
  for (int i = 0; i < kLanes; ++i) discs.x[i] = discs.y[i] = 0, discs.radius[i] = -1e15f;
  discs.reach = 0;
  discs.count = 0;
  hierarchy.inner_center = polygon.origin;
  hierarchy.inner_radius = 0;
  int largest = 0;
  for (const Guess& guess : search(polygon, local, hierarchy.root)) {
    const int k = discs.count;
    discs.x[k] = static_cast<float>(guess.center.x());
    discs.y[k] = static_cast<float>(guess.center.y());
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
