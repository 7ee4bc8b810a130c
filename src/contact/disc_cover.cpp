// SPDX-License-Identifier: BSD-3-Clause
#include "contact/disc_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

namespace tricover::detail {
namespace {

struct DiscCover : Derived::Thing {
  explicit DiscCover(const PolygonData& polygon) : discs(discsOnGrid(polygon, 20, 20, 64, 0.5)) {}
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
