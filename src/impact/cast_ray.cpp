// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "impact/impact_options.h"
#include "impact/impact_solvers.h"
#include "impact/moving_pair.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "overlay/plain_ray.h"
#include "pair/posed_pair.h"
#include "polygon/edge_position.h"
#include "tricover/polygon.h"
#include "tricover/ray.h"

namespace tricover {
namespace {

/// With a margin: the impacts of a point that moves along the ray. All lengths are divided by a power of two if the
/// ray's length, or twice that, is not finite.
class RoundRay {
 public:
  RoundRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to, double margin)
      : scale_((to - from).lpNorm<Eigen::Infinity>() < 0x1p1020 ? 1 : 0x1p-4),
        polygon_(scale_ == 1 ? polygon : polygon.scaled(scale_)),
        still_(Motion::still(pose)),
        from_(scale_ * from),
        to_(scale_ * to),
        margin_(scale_ * margin) {
    still_.start.translation() *= scale_;
  }

  std::optional<RayHit> first() const { return first(from_, to_); }

  /// Each interval is in a part of the ray that may be met. The ray is cast forwards and backwards in the part and a
  /// little around it, which finds begin and end as precisely as any hit.
  std::vector<RayInterval> all() const {
    std::vector<RayInterval> intervals;
    std::optional<RayHit> begin = first();
    if (!begin) return intervals;
    const std::vector<Part> parts = partsInReach();
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto [low, high] = parts[k];
      const double room = 0.5 * (high - low);
      const double before = std::max(low - room, 0.5 * (low + (k > 0 ? parts[k - 1].end : 0)));
      const double beyond = std::min(high + room, 0.5 * (high + (k + 1 < parts.size() ? parts[k + 1].begin : 1)));
      const Vec2 at = placeAt(before), apart = placeAt(beyond);
      if (!intervals.empty() && (begin = first(at, apart)))
        begin->fraction = detail::timeWithin(before, beyond - before, begin->fraction);
      if (!begin || begin->fraction > beyond) continue;
      auto end = first(apart, at);
      if (!end) end = RayHit{0, begin->point, -begin->normal, begin->edge};
      end->fraction = std::max(begin->fraction, beyond - end->fraction * (beyond - before));
      intervals.push_back({*begin, *end});
    }
    return intervals;
  }

 private:
  /// Fractions of the ray.
  struct Part {
    double begin, end;
    bool operator<(const Part& other) const { return begin < other.begin; }
  };

  Vec2 placeAt(double fraction) const { return fraction < 1 ? Vec2(from_ + fraction * (to_ - from_)) : to_; }

  /// Returns parts of the ray, in order and apart. What is between them certainly isn't met, by twice as much as
  /// timeOfImpact() errs by.
  std::vector<Part> partsInReach() const {
    const Polygon start = Polygon::point(from_);
    const Motion motion = Motion::translation(Pose::Identity(), to_ - from_);
    const detail::MovingPair pair(detail::dataOf(polygon_), still_, detail::dataOf(start), motion, margin_);
    const double reach = pair.margin + 8 * pair.error;
    const Vec2 origin = pair.b.base, way = pair.b.path.first;
    const detail::Places places = pair.a.places(0, 0);
    std::vector<Part> parts;
    for (const RayInterval& inside : detail::castPlainRayAll(detail::dataOf(polygon_), still_.start, from_, to_))
      parts.push_back({inside.begin.fraction, inside.end.fraction});
    const auto add = [&](detail::EdgePosition edge) {
      const detail::MovingEdge ends = pair.a.ends(places, 0, edge);
      const Part part = partWithin(ends.from() - origin, ends.to() - origin, way, reach);
      if (!(part.begin > part.end)) parts.push_back(part);
      return true;
    };
    const detail::PosedPair posed(detail::dataOf(polygon_), still_.start, detail::dataOf(start), motion.start);
    const detail::ApproxPoint v = seenFromA(posed, from_).approx, w = seenFromA(posed, to_).approx;
    const double room = reach * pair.length * pair.expansion * (1 + detail::kLargestDefect) + 1.5 * (v.error + w.error);
    detail::forEachEdgeNear(detail::dataOf(polygon_), detail::dataOf(polygon_).inUnits({v.x, v.y}),
                            detail::dataOf(polygon_).inUnits({w.x, w.y}), room * detail::dataOf(polygon_).inverse_unit,
                            add);
    std::sort(parts.begin(), parts.end());
    std::size_t last = 0;
    for (const Part& part : parts) {
      if (part.begin > parts[last].end) parts[++last] = part;
      parts[last].end = std::max(parts[last].end, part.end);
    }
    parts.resize(std::min(parts.size(), last + 1));
    return parts;
  }

  /// Returns the part of a ray from 0 that is in reach of the edge from v to w: in a disc around either end, or beside
  /// the edge. All of it where doubles don't tell, none (begin > end) where it isn't in reach.
  static Part partWithin(const Vec2& v, const Vec2& w, const Vec2& way, double reach) {
    const double square = way.squaredNorm(), length = std::sqrt(square);
    if (!(square > 0x1p-900 && v.lpNorm<1>() + w.lpNorm<1>() + reach < 0x1p400)) return {0, 1};
    Part part{1, 0};
    const auto add = [&](double begin, double end) {
      begin = std::max(begin, 0.0), end = std::min(end, 1.0);
      if (begin <= end) part = {std::min(part.begin, begin), std::max(part.end, end)};
    };
    for (const Vec2& center : {v, w}) {
      const double middle = way.dot(center) / square, beside = std::abs(detail::cross(way, center)) / length;
      const double half = std::sqrt(std::max(reach - beside, 0.0)) * std::sqrt(reach + beside) / length;
      if (!(beside > reach)) add(middle - half, middle + half);
    }
    const Vec2 along = (w - v).stableNormalized();
    if (v == w) return part;
    double begin = 0, end = 1;
    const auto clip = [&](double at, double rate, double low, double high) {
      const double p = (low - at) / rate, q = (high - at) / rate;
      begin = std::max(begin, std::min(p, q)), end = std::min(end, std::max(p, q));
    };
    clip(-along.dot(v), along.dot(way), 0, along.dot(w - v));
    clip(-detail::cross(along, v), detail::cross(along, way), -reach, reach);
    add(begin, end);
    return part;
  }

  std::optional<RayHit> first(const Vec2& from, const Vec2& to) const {
    const auto impact = detail::impactOf(Polygon::point(from), Motion::translation(Pose::Identity(), to - from),
                                         polygon_, still_, {margin_, 0});
    if (!impact) return std::nullopt;
    return RayHit{impact->time, (from + impact->time * (to - from)) / scale_, -impact->normal,
                  impact->time > 0 ? impact->edge_b : -1};
  }

  double scale_;
  Polygon polygon_;
  Motion still_;
  Vec2 from_, to_;
  double margin_;
};

void checkRay(const Pose& pose, const Vec2& from, const Vec2& to, const RayOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireRigid(pose, "pose");
  detail::requireFiniteRay(from, to);
}

}  // namespace

std::optional<RayHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                              const RayOptions& options) {
  checkRay(pose, from, to, options);
  if (options.margin > 0) return RoundRay(polygon, pose, from, to, options.margin).first();
  return detail::castPlainRay(detail::dataOf(polygon), pose, from, to, 1);
}

std::vector<RayInterval> castRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                    const RayOptions& options) {
  checkRay(pose, from, to, options);
  if (!(options.margin > 0)) return detail::castPlainRayAll(detail::dataOf(polygon), pose, from, to);
  return RoundRay(polygon, pose, from, to, options.margin).all();
}

}  // namespace tricover
