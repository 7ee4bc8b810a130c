// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "shadow/smooth_shadow.h"

namespace tricover_fcl {
namespace {

using tricover::DistanceResult;
using tricover::Polygon;
using tricover::Pose;

DistanceResult distanceBelow(double limit, const Polygon& a, const Polygon& b) {
  tricover::DistanceOptions options;
  options.limit = limit;
  return tricover::distance(a, Pose::Identity(), b, Pose::Identity(), options);
}

}  // namespace

DistanceResult SmoothShadow::distance(const Polygon& polygon) const {
  DistanceResult best = distanceBelow(std::numeric_limits<double>::infinity(), polygon, inscribed());
  for (std::size_t i = 0; i < tangents_.size(); ++i) {
    improve(best, polygon, cap(tangents_[i], tangents_[(i + 1) % tangents_.size()]), 0);
  }
  return best;
}

void SmoothShadow::improve(DistanceResult& best, const Polygon& polygon, const Cap& cap, int depth) const {
  if (cap.height <= finest_ || cap.width <= finest_ || depth == kDeepest) return;
  const double of_interest = best.distance - finest_;
  if (!(of_interest > 0) ||
      distanceBelow(of_interest, polygon, triangle(cap.first.point, cap.tip, cap.second.point)).distance >= of_interest)
    return;
  const Tangent middle = tangent(chordNormal(cap));
  const DistanceResult inner =
      distanceBelow(best.distance, polygon, triangle(cap.first.point, middle.point, cap.second.point));
  if (inner.distance < best.distance) best = inner;
  improve(best, polygon, this->cap(cap.first, middle), depth + 1);
  improve(best, polygon, this->cap(middle, cap.second), depth + 1);
}

}  // namespace tricover_fcl
