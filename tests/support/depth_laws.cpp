// SPDX-License-Identifier: BSD-3-Clause
#include "depth_laws.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "contact_laws.h"
#include "exact_covers.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/covers.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"
#include "tricover/signed_distance.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const Pose kHere = Pose::Identity();

double length(const Vec2& v) { return v.stableNorm(); }

std::string valued(const std::string& what, double found, double other) {
  return what + ": " + hex(found) + ", " + hex(other);
}

bool isNear(const Vec2& p, const Polygon& polygon, const Pose& pose, double error) {
  return exact::within(exact::distanceSquared(polygon, pose, Polygon::point(p), kHere), mpq_class(error));
}

bool isOnEdge(const Vec2& p, const Polygon& polygon, const Pose& pose, EdgeIndex edge, double error) {
  if (edge < 0 || edge >= polygon.edgeCount()) return false;
  return isNear(p, Polygon::segment(polygon.edgeStart(edge), polygon.edgeEnd(edge)), pose, error);
}

/// With the area on one side at least, or not at all.
bool hasArea(const Polygon& polygon) { return exact::interiorsMeet(polygon, kHere, polygon, kHere); }

/// Exact, and null where doubles don't hold its border.
std::optional<Polygon> complementOf(const Polygon& polygon) {
  if (!hasArea(polygon)) return std::nullopt;
  try {
    return polygon.complement();
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::string wrongPoints(const Case& c, const Depth& d, double error) {
  if (!(std::abs(d.normal.norm() - 1) <= 1e-12)) return "the normal is no unit vector";
  if (!(length(d.point_a - d.point_b - d.depth * d.normal) <= error)) return "the points aren't the depth apart";
  if (!isNear(d.point_a, c.a, c.pose_a, error)) return "point_a isn't in a";
  if (!isNear(d.point_b, c.b, c.pose_b, error)) return "point_b isn't in b";
  const bool is_inner_a = d.is_point_of_a && d.edge_a == -1, is_inner_b = !d.is_point_of_a && d.edge_b == -1;
  if (!is_inner_a && !isOnEdge(d.point_a, c.a, c.pose_a, d.edge_a, error)) return "point_a isn't on edge_a";
  if (!is_inner_b && !isOnEdge(d.point_b, c.b, c.pose_b, d.edge_b, error)) return "point_b isn't on edge_b";
  const exact::Bracket truth = d.is_point_of_a ? exact::depthIn(Polygon::point(d.point_a), kHere, c.b, c.pose_b)
                                               : exact::depthIn(Polygon::point(d.point_b), kHere, c.a, c.pose_a);
  return std::abs(truth.low - d.depth) <= error ? ""
                                                : valued("the deepest point's own depth", d.depth, double(truth.low));
}

bool isNone(const Depth& d) {
  return d.point_a == Vec2(0, 0) && d.point_b == Vec2(0, 0) && d.edge_a == -1 && d.edge_b == -1;
}

bool isSwapped(const Depth& p, const Depth& q) {
  return p.depth == q.depth && p.upper_bound == q.upper_bound && p.normal == -q.normal && p.point_a == q.point_b &&
         p.point_b == q.point_a && p.edge_a == q.edge_b && p.edge_b == q.edge_a &&
         (p.is_point_of_a != q.is_point_of_a || isNone(p));
}

}  // namespace

double depthPrecision(const Case& c) { return rounding(c); }

Case pushedTogether(Random& random, Case c) {
  if (random.coin()) return c;
  const Vec2 way = c.pose_a * c.a.coveringOrigin() - c.pose_b * c.b.coveringOrigin();
  const double apart = length(way), smaller = std::min(c.a.radius(), c.b.radius());
  if (!(apart > 0) || !std::isfinite(apart)) return c;
  const double left = random.oneIn(4) ? 0 : std::min({smaller, apart, 1e300}) * random.unit();
  const Vec2 by = way * ((apart - left) / apart);
  if ((c.pose_b.translation() + by).allFinite()) c.pose_b.translation() += by;
  return c;
}

std::string wrongDepth(const Case& c, const Depth& found) {
  if (!(found.depth >= 0 && found.upper_bound >= found.depth)) return "depth or upper_bound";
  const bool is_infinite = c.a.isComplement() && c.b.isComplement();
  if (is_infinite != (found.depth == kInfinity)) return "infinite or not";
  if ((found.depth > 0) != exact::reachInto(c.a, c.pose_a, c.b, c.pose_b)) return valued("0 or not", found.depth, 0);
  if (!isOneTwice(c) && !isSwapped(found, depth(c.b, c.pose_b, c.a, c.pose_a))) return "swapped, the depth differs";
  if (found.depth == 0 || is_infinite) return isNone(found) ? "" : "points or edges where there are none";
  const double error = depthPrecision(c);
  if (!(found.upper_bound - found.depth <= error)) return valued("a budget ended", found.depth, found.upper_bound);
  // Interiors that meet by less than rounding.
  if (found.depth <= error && isNone(found)) return "";
  return wrongPoints(c, found, 2 * error);
}

std::string wrongLargest(const Case& c, double found, const exact::Bracket& truth) {
  if (std::isinf(found) || std::isinf(truth.low))
    return std::isinf(found) == std::isinf(truth.low) ? "" : "infinite or not";
  const double error = depthPrecision(c);
  if (found < truth.low - error) return valued("less than the oracle's", found, double(truth.low));
  return found > truth.high + error ? valued("more than the oracle's", found, double(truth.high)) : "";
}

std::string wrongBesideOthers(Random& random, const Case& c, const Depth& found) {
  if (std::isinf(found.depth)) return "";
  const double error = 2 * depthPrecision(c);
  if (!c.a.isComplement() && !c.b.isComplement()) {
    const auto way = penetration(c.a, c.pose_a, c.b, c.pose_b);
    // Proven to part them; penetration's depth is less precise.
    const double most = way ? std::max(way->depth, length(way->translation)) : 0;
    if (!(found.depth <= most + error)) return valued("deeper than a translation that parts them", found.depth, most);
  }
  Case moved = c;
  const double size = std::min({c.a.radius(), c.b.radius(), 1e300});
  moved.pose_b.translation() += size * std::pow(10, random.real(-12, 0)) * direction(random.real(0, 6.3));
  const double by = length(moved.pose_b.translation() - c.pose_b.translation());
  if (std::isfinite(by)) {
    const double other = depth(moved.a, moved.pose_a, moved.b, moved.pose_b).depth;
    if (!(std::abs(other - found.depth) <= by + error))
      return valued("changes by more than b moves", found.depth, other);
  }
  const auto outside_a = complementOf(c.a), outside_b = complementOf(c.b);
  if (!outside_a || !outside_b) return "";
  const double either = std::max(excess(c.a, c.pose_a, *outside_b, c.pose_b).distance,
                                 excess(c.b, c.pose_b, *outside_a, c.pose_a).distance);
  return std::abs(either - found.depth) <= error ? "" : valued("another excess from complements", found.depth, either);
}

std::string wrongExcess(const Case& c, const Excess& found) {
  if (!(found.distance >= 0 && found.upper_bound >= found.distance)) return "distance or upper_bound";
  const bool is_infinite = c.a.isComplement() && !c.b.isComplement();
  if (is_infinite != (found.distance == kInfinity)) return "infinite or not";
  const bool is_covered = exact::covers({{c.b, c.pose_b, {}}}, c.a, c.pose_a, 0);
  if ((found.distance == 0) != is_covered) return valued("0 or not", found.distance, 0);
  if (found.distance == 0 || is_infinite)
    return found.point == Vec2(0, 0) && found.nearest == Vec2(0, 0) && found.edge == -1 && found.nearest_edge == -1
               ? ""
               : "points or edges where there are none";
  const double precision = depthPrecision(c), error = 2 * precision;
  if (!(found.upper_bound - found.distance <= precision))
    return valued("a budget ended", found.distance, found.upper_bound);
  // Not covered by less than rounding.
  if (found.distance <= precision && found.edge == -1 && found.nearest_edge == -1) return "";
  if (!(std::abs(length(found.point - found.nearest) - found.distance) <= error))
    return "points that aren't that far apart";
  if (!isNear(found.point, c.a, c.pose_a, error)) return "the point isn't in the part";
  if (!isNear(found.nearest, c.b, c.pose_b, error)) return "the nearest point isn't in the area";
  if (found.edge != -1 && !isOnEdge(found.point, c.a, c.pose_a, found.edge, error)) return "edge";
  if (!isOnEdge(found.nearest, c.b, c.pose_b, found.nearest_edge, error)) return "nearest_edge";
  const exact::Bracket own = exact::excess(Polygon::point(found.point), kHere, c.b, c.pose_b);
  return std::abs(own.low - found.distance) <= error
             ? ""
             : valued("the point's own distance", found.distance, double(own.low));
}

std::string wrongBesideOthers(Random& random, const Case& c, const Excess& found) {
  const double back = excess(c.b, c.pose_b, c.a, c.pose_a).distance,
               either = hausdorffDistance(c.a, c.pose_a, c.b, c.pose_b);
  if (either != std::max(found.distance, back)) return valued("the Hausdorff distance", either, back);
  if (either != hausdorffDistance(c.b, c.pose_b, c.a, c.pose_a)) return "the Hausdorff distance of swapped operands";
  if (std::isinf(found.distance)) return "";
  const double error = 2 * depthPrecision(c);
  const EdgeIndex edge = anyEdge(random, c.a);
  const double of_edge =
      excess(Polygon::segment(c.a.edgeStart(edge), c.a.edgeEnd(edge)), c.pose_a, c.b, c.pose_b).distance;
  if (!(of_edge <= found.distance + error)) return valued("less than an edge's", found.distance, of_edge);
  // a, b, and a elsewhere.
  Case moved = c;
  moved.pose_a.translation() += std::min(c.b.radius(), 1e300) * random.unit() * direction(random.real(0, 6.3));
  if (!moved.pose_a.translation().allFinite()) return "";
  const double first = excess(moved.a, moved.pose_a, c.a, c.pose_a).distance,
               whole = excess(moved.a, moved.pose_a, c.b, c.pose_b).distance;
  return whole <= first + found.distance + 2 * error ? "" : valued("no triangle inequality", whole, first);
}

std::string wrongCoversButFor(const Case& c, const Excess& found) {
  const double e = found.upper_bound;
  for (const double most : {5e-324, 1e-300, e * (1 - 1e-9), nudged(e, -1), e, nudged(e, 1), e * (1 + 1e-9), 2 * e}) {
    if (!(most > 0) || !std::isfinite(most)) continue;
    if (covers(c.b, c.pose_b, c.a, c.pose_a, {-most}) != (e <= most)) return valued("covers but for", e, most);
  }
  return "";
}

std::string wrongMargins(Random& random, const Case& c) {
  const double s = signedDistance(c.a, c.pose_a, c.b, c.pose_b).distance, size = std::min(c.a.radius(), c.b.radius());
  const Depth deep = depth(c.a, c.pose_a, c.b, c.pose_b);
  if (deep.depth > 0 ? s != -deep.upper_bound : !(s >= 0)) return valued("signedDistance beside depth", s, deep.depth);
  std::vector<double> margins{
      0, -5e-324, 5e-324, -1e-300, 1e-300, -1e-9 * size, -size, size, -1e300, size * random.real(-1, 1)};
  if (s < 0)
    for (const int steps : {-2, -1, 0, 1, 2}) margins.push_back(nudged(s, steps));
  for (const double factor : {1 - 1e-9, 1 + 1e-9, 0.5, 2.0}) margins.push_back(s * factor);
  std::sort(margins.begin(), margins.end());
  bool closed_before = false, open_before = false;
  for (const double m : margins) {
    // A distance is rounded, and collide() exact with a margin from 0 on.
    if (!std::isfinite(m) || (s > 0 && m == s)) continue;
    const bool closed = collide(c.a, c.pose_a, c.b, c.pose_b, {m}),
               open = collide(c.a, c.pose_a, c.b, c.pose_b, {m, 0, Touching::Allowed});
    if (closed != (s <= m)) return valued("collide beside signedDistance", s, m);
    if (open != (s < m)) return valued("collide, touching allowed, beside signedDistance", s, m);
    if (closed < closed_before || open < open_before) return valued("not monotone in the margin", s, m);
    closed_before = closed, open_before = open;
    if (closed != collide(c.b, c.pose_b, c.a, c.pose_a, {m})) return valued("collide, swapped", s, m);
    PairCache cache;
    for (int i = 0; i < 3; ++i)
      if (closed != collide(c.a, c.pose_a, c.b, c.pose_b, cache, {m})) return valued("collide with a cache", s, m);
    if (m < 0) continue;  // refused there
    DistanceOptions options;
    options.margin = m;
    if (closed != (signedDistance(c.a, c.pose_a, c.b, c.pose_b, options).distance <= 0))
      return valued("signedDistance with a margin", s, m);
  }
  return "";
}

}  // namespace tricover::support
