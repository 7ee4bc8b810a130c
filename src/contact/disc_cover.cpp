// SPDX-License-Identifier: BSD-3-Clause
#include "contact/disc_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "hierarchy/inner_discs.h"

namespace tricover::detail {
namespace {

std::vector<Disc> coverByDiscs(const PolygonData& polygon) {
  constexpr int kGrid = 20;
  static_assert(kGrid * kGrid % kLanes == 0);
  constexpr std::size_t kMost = 64;
  Vec2 low = polygon.inUnits(polygon.path[0]), high = low;
  for (const Vec2& p : polygon.path) {
    const Vec2 at = polygon.inUnits(p);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  std::vector<Vec2> centers;
  for (int row = 0; row < kGrid; ++row)
    for (int column = 0; column < kGrid; ++column)
      centers.emplace_back(low + Vec2((column + 0.5) / kGrid, (row + 0.5) / kGrid).cwiseProduct(high - low));
  const ThinnedOutline outline(polygon);
  std::vector<Disc> grid;
  for (std::size_t k = 0; k < centers.size(); k += kLanes) {
    DepthProbes probes;
    for (std::size_t i = 0; i < kLanes; ++i) {
      probes.x[i] = static_cast<float>(centers[k + i].x());
      probes.y[i] = static_cast<float>(centers[k + i].y());
    }
    measureDepths(outline, probes);
    for (std::size_t i = 0; i < kLanes; ++i)
      if (probes.depth[i] > 0) grid.push_back({Vec2(probes.x[i], probes.y[i]), probes.depth[i]});
  }
  std::sort(grid.begin(), grid.end(), [](const Disc& c, const Disc& d) { return c.radius > d.radius; });
  std::vector<Disc> discs;
  for (const Disc& disc : grid) {
    if (discs.size() == kMost) break;
    const auto held = [&](const Disc& d) { return (d.center - disc.center).norm() < 0.5 * d.radius; };
    if (std::any_of(discs.begin(), discs.end(), held)) continue;
    const double radius = provenRadius(polygon, disc.center, static_cast<float>(disc.radius));
    if (radius > 0) discs.push_back({disc.center, radius});
  }
  return discs;
}

struct DiscCover : Derived::Thing {
  explicit DiscCover(const PolygonData& polygon) : discs(coverByDiscs(polygon)) {}
  const std::vector<Disc> discs;
};

}  // namespace

const std::vector<Disc>& discCoverOf(const PolygonData& polygon) {
  const Derived::Thing* cover =
      innerDiscsOf(polygon).cover.built([&] { return std::make_unique<const DiscCover>(polygon); });
  return static_cast<const DiscCover*>(cover)->discs;
}

std::vector<Disc> largestDiscsOf(const PolygonData& polygon) {
  std::vector<Disc> discs;
  if (polygon.isDegenerate()) return discs;
  const InnerDiscs& inner = innerDiscsOf(polygon);
  for (int k = 0; k < inner.count; ++k) discs.push_back({Vec2(inner.x[k], inner.y[k]), inner.radius[k]});
  return discs;
}

DiscSums::DiscSums(const std::vector<Disc>& a, const std::vector<Disc>& b, double grown, std::size_t most) {
  // Small ones of both hold less than either with a large one.
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size() && (i + 1) * (j + 1) <= most; ++j)
      add(a[i].center.x() - b[j].center.x(), a[i].center.y() - b[j].center.y(), a[i].radius + b[j].radius + grown);
}

void DiscSums::add(double x, double y, double radius) {
  x_.push_back(x);
  y_.push_back(y);
  radius_.push_back(radius);
  largest_ = std::max(largest_, radius);
}

bool DiscSums::hold(const Vec2& t, double radius) const {
  if (largest_ <= radius) return false;
  std::int64_t holding = 0;  // as wide as a double, so that it is counted in lanes
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double dx = x_[k] - t.x(), dy = y_[k] - t.y(), room = radius_[k] - radius;
    holding += dx * dx + dy * dy < room * std::abs(room);
  }
  return holding > 0;
}

bool DiscSums::holdSegment(const Vec2& v, const Vec2& w) const {
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const auto holds = [&](const Vec2& p) {
      const double dx = x_[k] - p.x(), dy = y_[k] - p.y();
      return dx * dx + dy * dy < radius_[k] * std::abs(radius_[k]);
    };
    if (holds(v) && holds(w)) return true;
  }
  return false;
}

DiscSums DiscSums::near(const Vec2& t, double radius) const {
  DiscSums result;
  result.x_.reserve(x_.size());
  result.y_.reserve(x_.size());
  result.radius_.reserve(x_.size());
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const double dx = x_[k] - t.x(), dy = y_[k] - t.y(), within = radius_[k] + 0.5 * radius;
    if (dx * dx + dy * dy < within * std::abs(within)) result.add(x_[k], y_[k], radius_[k]);
  }
  return result;
}

}  // namespace tricover::detail
