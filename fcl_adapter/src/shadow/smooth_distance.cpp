// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/segment.h"
#include "shadow/smooth_shadow.h"
#include "shadow/stadium.h"

namespace tricover_fcl {
namespace {

using tricover::DistanceResult;
using tricover::Polygon;
using tricover::Pose;
using tricover::Vec2;
using tricover::detail::nearestOnSegment;

constexpr int kOneByOne = 40;
constexpr std::size_t kFewVertices = 256;  // asked one by one sooner than a polygon of tangents is made

DistanceResult distanceTo(const Polygon& polygon, const Vec2& point) {
  Pose there = Pose::Identity();
  there.translation() = point;
  return tricover::distance(polygon, Pose::Identity(), Stadium::point(), there);
}

/// A lower bound of the distance from the polygon to all that isn't beyond the line through `point` across `normal`.
/// Differences round by U, products and their sum by 2U, the normal's length by 2U; nothing is known of what overflows.
double distanceBeyond(const Polygon& polygon, const Vec2& point, const Vec2& normal) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double least = kInfinity;
  for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
    const Vec2 way = polygon.edgeStart(e) - point;
    const double ahead = normal.dot(way) - 0x1p-50 * way.lpNorm<1>();
    least = std::min(least, std::isnan(ahead) ? -kInfinity : ahead);
  }
  return least;
}

}  // namespace

/// The distance is between `lower` and nearest.distance.
struct SmoothShadow::Approach {
  double lower;
  DistanceResult nearest;
};

/// Of a point p: its nearest point q in the polygon within C, and the chord that q is on.
SmoothShadow::Nearest SmoothShadow::nearestWithin(const Tangents& tangents, const Vec2& p) {
  Nearest nearest{tangents[0].point, 0};
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const Vec2 on_chord = nearestOnSegment(p, tangents[k].point, tangents[(k + 1) % tangents.size()].point);
    if (k == 0 || (p - on_chord).squaredNorm() < (p - nearest.point).squaredNorm()) nearest = {on_chord, k};
  }
  return nearest;
}

/// Adds the two tangents between which a point p outside of C is nearest to it. The tangent across q p, or, if there is
/// one, that across the chord that q is on, bounds most of what is between the two.
Vec2 SmoothShadow::closeIn(Tangents& tangents, const Vec2& p, double enough) const {
  Tangents near = tangents;
  for (int i = 0;; ++i) {
    const auto [q, chord] = nearestWithin(near, p);
    double lower = 0;
    for (const Tangent& tangent : near) lower = std::max(lower, tangent.normal.dot(p - tangent.point));
    const Tangent &first = near[chord], &second = near[(chord + 1) % near.size()];
    if ((p - q).stableNorm() - lower > finest_ / 4 && i < kOneByOne &&
        (insert(near, tangent((p - q).stableNormalized(), enough)) ||
         insert(near, tangent(chordNormal(cap(first, second)), enough))))
      continue;
    for (const Tangent& tangent : {first, second}) insert(tangents, tangent);
    return q;
  }
}

/// Whether p is certainly to the left of all ways from one tangent's point to the next one's: then these go round it.
bool SmoothShadow::goRound(const Tangents& tangents, const Vec2& p) {
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    const Vec2 way = tangents[(k + 1) % tangents.size()].point - tangents[k].point, to_p = p - tangents[k].point;
    const double left = way.x() * to_p.y(), right = way.y() * to_p.x();
    if (!(left - right > 1e-12 * (std::abs(left) + std::abs(right)))) return false;
  }
  return true;
}

/// The distance to the polygon around C, which tangents make, is a lower bound. Where that is met, the polygon within C
/// is asked. Otherwise the tangent across the way between the two touches C at a point: its distance is an upper bound,
/// and its nearest point has a nearest one in C.
SmoothShadow::Approach SmoothShadow::approach(const Polygon& polygon, double margin, bool only_whether) const {
  const double enough = finest_ / 16;
  const Vec2 side = Vec2::UnitX();
  const Vec2 center = tangent(side, enough).point / 2 + tangent(-side, enough).point / 2;
  Approach found{0, distanceTo(polygon, center)};
  DistanceResult& nearest = found.nearest;
  // A body isn't larger, nor its shadow, but for what two poses stretch it by.
  found.lower = nearest.distance - 2 * body_.reach() * (1 + 4 * tricover::kRigidTolerance) - finest_;
  double slack = 0;
  const auto isDecided = [&] {
    return nearest.distance == 0 || nearest.distance - found.lower <= finest_ + 2 * slack ||
           (only_whether && (nearest.distance <= margin || found.lower > margin));
  };
  const auto improve = [&](const DistanceResult& shown) {
    if (shown.distance < nearest.distance) nearest = {shown.distance, shown.point_a, shown.point_b, shown.edge_a, -1};
  };
  if (isDecided()) return found;

  // Points that round to the same have no way between them: any will do.
  const Vec2 way = nearest.point_a - center, towards = way.isZero(0) ? side : Vec2(way.stableNormalized());
  const Vec2 aside(-towards.y(), towards.x());
  Tangents tangents;
  for (const Vec2& normal : {towards, aside, Vec2(-towards), Vec2(-aside)}) tangents.push_back(tangent(normal, enough));
  if (polygon.vertexCount() <= kFewVertices) {
    const Tangent& facing = tangents.front();
    found.lower = std::max(found.lower, distanceBeyond(polygon, facing.point, towards) - facing.slack - finest_ / 8);
    const Vec2 p = nearest.point_a, q = goRound(tangents, p) ? p : facing.point;
    improve({(p - q).stableNorm(), p, q, nearest.edge_a, -1});
    if (isDecided()) return found;
  }
  for (int i = 0;; ++i) {
    const DistanceResult outer = tricover::distance(polygon, Pose::Identity(), around(tangents), Pose::Identity());
    for (const Tangent& tangent : tangents) slack = std::max(slack, tangent.slack);
    found.lower = std::max(found.lower, outer.distance - 2 * slack - finest_ / 8);
    if (isDecided()) return found;

    const std::size_t before = tangents.size();
    const Vec2& p = outer.point_a;
    if (outer.distance == 0) {
      improve(tricover::distance(polygon, Pose::Identity(), within(tangents), Pose::Identity()));
      if (isDecided()) return found;
    } else {
      const Tangent across = tangent((p - outer.point_b).stableNormalized(), enough);
      insert(tangents, across);
      improve(distanceTo(polygon, across.point));
      if (isDecided()) return found;
    }
    const Vec2 q = closeIn(tangents, p, enough);
    improve({(p - q).stableNorm(), p, q, outer.edge_a, -1});
    if (isDecided()) return found;
    // A polygon that fits around C closely is near it everywhere.
    if ((i >= kOneByOne || tangents.size() == before) && !refineAll(tangents, finest_, enough)) return found;
  }
}

bool SmoothShadow::meets(const Polygon& polygon, double margin) const {
  return !(approach(polygon, margin, true).lower > margin);
}

DistanceResult SmoothShadow::distance(const Polygon& polygon, double margin) const {
  const Approach found = approach(polygon, margin, false);
  DistanceResult nearest = found.nearest;
  nearest.distance =
      found.lower > margin ? std::max(nearest.distance - margin, std::numeric_limits<double>::denorm_min()) : 0;
  return nearest;
}

}  // namespace tricover_fcl
