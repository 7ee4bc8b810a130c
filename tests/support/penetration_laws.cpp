// SPDX-License-Identifier: BSD-3-Clause
#include "penetration_laws.h"

#include <algorithm>
#include <cmath>

#include "contact_laws.h"
#include "exact_penetration.h"
#include "exact_reference.h"
#include "reference.h"
#include "reproduction.h"
#include "shapes.h"

namespace tricover::support {
namespace {

double length(const Vec2& v) { return std::hypot(v.x(), v.y()); }

/// What a translation's sum with a pose's is off by.
double spacing(const Case& c) {
  return 0x1p-43 * (c.pose_a.translation().lpNorm<1>() + c.pose_b.translation().lpNorm<1>());
}

bool areWithinAfter(const Case& c, const Vec2& way, double margin) {
  const Case after{c.a, c.pose_a, c.b, moved(c.pose_b, way)};
  const Reference reference(after);
  return margin > 0 ? reference.within(margin) : reference.collide();
}

/// A quarter of what the translation is longer by wouldn't do, as between edges that are nearly parallel; or not a
/// little aside, as in the tip of a slit, where rounding decides.
bool needsAll(const Case& c, const Penetration& p) {
  const Vec2 limit = p.depth * p.normal, quarter = limit + (p.translation - limit) / 4;
  const Vec2 across = Vec2(-quarter.y(), quarter.x()).stableNormalized();
  for (const double aside : {0.0, precisionOf(c), -precisionOf(c)}) {
    const Vec2 way = quarter + aside * across;
    const Case of_a{c.a, moved(c.pose_a, -way), c.b, c.pose_b};
    if (areWithinAfter(c, way, 0) || Reference(of_a).collide()) return true;
  }
  return false;
}

/// Where they part last, without a margin.
std::string wrongEdges(const Case& c, const Penetration& p, double error) {
  if (p.optimal && !(length(p.point_a - p.point_b - p.depth * p.normal) <= error)) return "points don't meet";
  const auto isOn = [&](const Vec2& point, const Polygon& polygon, const Pose& pose, EdgeIndex edge) {
    if (edge < 0 || edge >= polygon.edgeCount()) return false;
    const Vec2 v = pose * polygon.edgeStart(edge), w = pose * polygon.edgeEnd(edge);
    return exact::distanceBelow(exact::distanceSquared(point, v, w)) <= error;
  };
  if (!isOn(p.point_a, c.a, c.pose_a, p.edge_a)) return "point_a isn't on edge_a";
  return isOn(p.point_b, c.b, c.pose_b, p.edge_b) ? "" : "point_b isn't on edge_b";
}

/// How far apart they end, with a margin.
std::string wrongEnd(const Case& c, const Penetration& p, double margin, double error) {
  const double apart = static_cast<double>(Reference(c).distance().low);
  if (!(p.depth >= margin - apart - error)) return "less than what is left of the margin";
  const Vec2 between = p.point_a - p.point_b - p.depth * p.normal;
  const bool are_apart = std::abs(length(between) - margin) <= 1e-3 * margin + 64 * error;
  return p.optimal && margin > 1e3 * error && !are_apart ? "the points aren't the margin apart" : "";
}

}  // namespace

double precisionOf(const Case& c, double margin) {
  const double between = length(c.pose_b.translation() - c.pose_a.translation());
  return 1e-12 * std::min(c.a.radius(), c.b.radius()) + 0x1p-43 * (c.a.radius() + c.b.radius() + margin + between) +
         0x1p-1060;
}

std::string wrongPenetration(Random& random, const Case& c, double margin, const std::optional<Penetration>& found,
                             int directions) {
  const Reference reference(c);
  if (found.has_value() != (margin > 0 ? reference.within(margin) : reference.collide()))
    return "a penetration, or none";
  if (!found) return "";
  const Penetration& p = *found;
  const double tiny = precisionOf(c, margin), error = tiny + spacing(c);
  // Where rounding the coordinates loses a polygon's size, or lengths overflow.
  if (std::isinf(p.depth))
    return margin > 0 || std::min(c.a.radius(), c.b.radius()) < rounding(c) || !(rounding(c) < 1e285) ? "" : "no depth";
  if (!(p.depth >= 0 && p.lower_bound >= 0 && p.lower_bound <= p.depth)) return "depth or lower_bound";
  if (!(std::abs(p.normal.norm() - 1) <= 1e-12)) return "normal is no unit vector";
  if (p.optimal && !(p.depth - p.lower_bound <= tiny)) return "not optimal";
  if (margin == 0) {
    if (!p.optimal && p.depth - p.lower_bound <= tiny / 8) return "optimal, but said not to be";
    if (!(length(p.translation) <= p.depth + 2 * error) && !needsAll(c, p)) return "translation is too long";
  }
  if (areWithinAfter(c, p.translation, margin)) return "translation doesn't part them";
  for (int i = 0; i < directions; ++i) {
    const double way = (i % 2 == 0 ? 0.999 : random.unit()) * p.lower_bound - error;
    if (way > 0 && !areWithinAfter(c, way * direction(random.real(0, 6.3)), margin)) return "a shorter one parts them";
  }
  return margin == 0 ? wrongEdges(c, p, error) : wrongEnd(c, p, margin, error);
}

std::string wrongConvexDepth(const Case& c, double depth) {
  // Of the depth, or of 1e-14 of the coordinates, which rounding(c) is an upper bound of.
  const auto isRight = [&, least = rounding(c)](long double low, long double high) {
    const long double error = 1e-14L * std::max(low, static_cast<long double>(least));
    return depth <= low + error && depth >= high - error;
  };
  const Reference::Bounds bounds = convexDepth(c);
  if (isRight(bounds.low, bounds.high)) return "";
  const double truth = exact::distanceBelow(exact::convexPenetrationSquared(c.a, c.pose_a, c.b, c.pose_b));
  return isRight(truth, truth) ? "" : "depth, which is " + hex(truth);
}

std::string wrongSwapped(const Case& c, const Penetration& p) {
  const auto q = penetration(c.b, c.pose_b, c.a, c.pose_a);
  const bool same = q && q->depth == p.depth && q->normal == -p.normal && q->translation == -p.translation &&
                    q->edge_a == p.edge_b && q->edge_b == p.edge_a && q->point_a == p.point_b &&
                    q->lower_bound == p.lower_bound && q->optimal == p.optimal;
  return same || isOneTwice(c) ? "" : "swapped, the result differs";
}

}  // namespace tricover::support
