// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "queries/planar_pair.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"

namespace tricover_fcl {
namespace {

using tricover::DistanceResult;
using tricover::Penetration;
using tricover::Vec2;

Vec2 middle(const Vec2& p, const Vec2& q) { return p / 2 + q / 2; }

/// Where a posed polygon's outline is straight around a point of it, across the normal of a contact: along `line`, a
/// unit vector, and measured from that point. Edges that lean by less than 1e-6 are taken for straight.
struct Face {
  Face(const Region& region, const Vec2& point, const Vec2& line) {
    const tricover::Polygon& polygon = *region.polygon;
    const tricover::Pose& pose = region.pose;
    constexpr double kLean = 1e-6;
    const double rounding = 0x1p-46 * (point.lpNorm<1>() + pose.translation().lpNorm<1>());
    const auto isOnLine = [&](const Vec2& p) {
      return std::abs(line.x() * p.y() - line.y() * p.x()) <= kLean * std::abs(line.dot(p)) + rounding;
    };
    for (tricover::EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
      const Vec2 from = pose * polygon.edgeStart(e) - point, to = pose * polygon.edgeEnd(e) - point;
      if (!isOnLine(from) || !isOnLine(to)) continue;
      const double v = line.dot(from), w = line.dot(to);
      edges.push_back({std::min(v, w), std::max(v, w), e});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& i, const Edge& j) { return i.low < j.low; });
    for (std::size_t i = 0; i < edges.size();) {  // those that follow each other
      double from = edges[i].low, to = edges[i].high;
      for (++i; i < edges.size() && edges[i].low <= to + rounding; ++i) to = std::max(to, edges[i].high);
      if (!(from <= rounding && to >= -rounding)) continue;
      low = std::min(low, from);
      high = std::max(high, to);
    }
  }

  /// The edge at a place of the face, `known` if that is there.
  tricover::EdgeIndex edgeAt(double place, tricover::EdgeIndex known) const {
    tricover::EdgeIndex found = -1;
    for (const Edge& edge : edges) {
      if (!(edge.low <= place && place <= edge.high)) continue;
      if (edge.edge == known) return known;
      if (found < 0) found = edge.edge;
    }
    return found < 0 ? known : found;
  }

  struct Edge {
    double low, high;
    tricover::EdgeIndex edge;
  };
  std::vector<Edge> edges;
  double low = 0, high = 0;
};

/// In the middle of the two outlines' faces where these lie upon each other at the end of the translation.
std::optional<Penetration> penetrationOf(const PlanarPair& pair) {
  tricover::PenetrationOptions options;
  options.margin = pair.margin;
  auto found = tricover::penetration(*pair.a.polygon, pair.a.pose, *pair.b.polygon, pair.b.pose, options);
  if (!found || !std::isfinite(found->depth)) return found;
  const Vec2 line(-found->normal.y(), found->normal.x());
  const Face of_a(pair.a, found->point_a, line), of_b(pair.b, found->point_b, line);
  const double middle = (std::max(of_a.low, of_b.low) + std::min(of_a.high, of_b.high)) / 2;
  found->point_a += middle * line;
  found->point_b += middle * line;
  found->edge_a = of_a.edgeAt(middle, found->edge_a);
  found->edge_b = of_b.edgeAt(middle, found->edge_b);
  return found;
}

/// Each component with a depth and a normal of its own: what a step of a simulation needs. An overlap that a negative
/// margin allows is none, and is no part of a depth.
std::vector<tricover::Contact> componentsOf(const PlanarPair& pair, std::size_t most) {
  auto found =
      tricover::contacts(*pair.a.polygon, pair.a.pose, *pair.b.polygon, pair.b.pose,
                         {std::max(pair.margin, 0.0), most, tricover::ContactDetail::LocalDepth, pair.touching});
  if (pair.margin >= 0) return found;
  while (found.size() > 1 && found.back().depth < -pair.margin) found.pop_back();  // the deepest are first
  for (tricover::Contact& contact : found) {
    contact.depth = std::max(contact.depth + pair.margin, 0.0);
    for (tricover::ContactPoint& point : contact.points) point.depth = std::max(point.depth + pair.margin, 0.0);
  }
  return found;
}

bool isUnbounded(const PlanarPair& pair) { return pair.a.polygon->isComplement() || pair.b.polygon->isComplement(); }

/// Whether regions that share a point overlap by more than `error`, or, grown by a margin, by 1e-13 of that. Exact
/// where error and margin are 0: whether interiors meet or, of a region without one, whether its depth isn't 0.
bool overlap(const PlanarPair& pair, double error) {
  const tricover::Polygon &a = *pair.a.polygon, &b = *pair.b.polygon;
  const double less = pair.margin * (1 - 1e-13) - error;
  if (less > 0) return tricover::collide(a, pair.a.pose, b, pair.b.pose, {less});
  if (error > 0 || isUnbounded(pair)) {
    const auto deepest = componentsOf(pair, 1);
    return !deepest.empty() && deepest.front().depth > error;
  }
  const tricover::CollideOptions of_interiors{0, 0, tricover::Touching::Allowed};
  if (tricover::collide(a, pair.a.pose, b, pair.b.pose, of_interiors)) return true;
  const auto hasInterior = [&](const tricover::Polygon& polygon) {
    return tricover::collide(polygon, pair.a.pose, polygon, pair.a.pose, of_interiors);
  };
  if (hasInterior(a) && hasInterior(b)) return false;
  const auto way = penetrationOf(pair);
  return way && way->depth > 0;
}

/// The points of the two grown outlines that part last, the translation's length from each other. At its end the
/// polygons are the margins apart, in a direction that isn't the translation's where it leads into a corner.
struct OutlinePoints {
  OutlinePoints(const PlanarPair& pair, const Penetration& way) {
    const Vec2 between = way.point_b - way.point_a + way.depth * way.normal;
    const bool is_known = between.allFinite() && !between.isZero(0);
    const Vec2 out = is_known ? Vec2(between.stableNormalized()) : way.normal;
    on_a = way.point_a + pair.a.margin * out;
    on_b = way.point_b - pair.b.margin * out;
  }

  Vec2 on_a, on_b;
};

/// From the origin of `a` towards that of `b`; along x where the two coincide.
Vec2 towards(const PlanarPair& pair) {
  const auto half = [](const Region& region) { return Vec2((region.pose * region.polygon->coveringOrigin()) / 2); };
  const Vec2 between = half(pair.b) - half(pair.a);  // halved, not to overflow
  return between.isZero(0) ? Vec2::UnitX() : between.stableNormalized();
}

/// Adds what FCL is told of a component: its own point and depth or, as `spare` allows, both ends of two faces that lie
/// upon each other, the first with the component's depth. Where the component is deeper elsewhere, that comes first.
void addComponent(const tricover::Contact& part, std::size_t& spare, std::vector<PlanarContact>& shared) {
  const auto add = [&](const Vec2& point, double depth) {
    shared.push_back({point, part.normal, depth, part.edge_a, part.edge_b});
  };
  const bool has_ends = part.count == 2 && spare > 0;
  const double rounding = 1e-9 * part.depth + 0x1p-44 * part.point.lpNorm<1>();
  const bool is_deepest = has_ends && part.points[0].depth >= part.depth - rounding;
  add(is_deepest ? part.points[0].point : part.point, part.depth);
  for (std::size_t k = is_deepest ? 1 : 0; has_ends && k < 2 && spare > 0; ++k, --spare)
    add(part.points[k].point, part.points[k].depth);
}

}  // namespace

std::optional<DistanceResult> PlanarPair::distanceWithin(double limit, tricover::DistanceOptions options) const {
  tricover::PairCache* const kept = cache();
  options.margin = margin;
  // Regions that meet up to rounding are a little apart: a limit below that must not cost them their nearest points.
  const bool is_touch = rounding > 0 && collide();
  if (is_touch) limit = std::numeric_limits<double>::infinity();
  auto found = kept != nullptr ? tricover::distanceWithin(*a.polygon, a.pose, *b.polygon, b.pose, limit, *kept, options)
                               : tricover::distanceWithin(*a.polygon, a.pose, *b.polygon, b.pose, limit, options);
  if (is_touch && found) found->distance = 0;
  return found;
}

std::vector<PlanarContact> contactsOf(const PlanarPair& pair, bool as_one, std::size_t most) {
  std::vector<PlanarContact> shared;
  if (as_one && pair.margin >= 0 && !isUnbounded(pair)) {
    if (const auto whole = penetrationOf(pair)) {
      const OutlinePoints points(pair, *whole);
      return {{middle(points.on_a, points.on_b), whole->normal, whole->depth, whole->edge_a, whole->edge_b}};
    }
  } else {
    const std::vector<tricover::Contact> parts = componentsOf(pair, most);
    std::size_t spare = !(pair.shadow && pair.shadow->excess > 0) ? most - parts.size() : 0;
    for (const tricover::Contact& part : parts) addComponent(part, spare, shared);
    std::stable_sort(shared.begin(), shared.end(),
                     [](const PlanarContact& i, const PlanarContact& j) { return i.depth > j.depth; });
  }
  if (shared.empty()) {
    const DistanceResult nearest = tricover::distance(*pair.a.polygon, pair.a.pose, *pair.b.polygon, pair.b.pose);
    const Vec2 between = nearest.point_b - nearest.point_a;
    shared.push_back({middle(nearest.point_a, nearest.point_b),
                      between.isZero(0) ? towards(pair) : Vec2(between.stableNormalized()), 0, nearest.edge_a,
                      nearest.edge_b});
  }
  for (PlanarContact& contact : shared) contact.point += (pair.a.margin - pair.b.margin) / 2 * contact.normal;
  return shared;
}

void moveByMargins(const PlanarPair& pair, DistanceResult& found) {
  const double of_a = pair.a.margin, of_b = pair.b.margin;
  if ((of_a == 0 && of_b == 0) || !std::isfinite(found.distance)) return;
  const Vec2 between = found.point_b - found.point_a;
  if (found.distance > 0) {
    const Vec2 out = between.stableNormalized();
    found.point_a += of_a * out;
    found.point_b -= of_b * out;
  } else {
    const double apart = between.stableNorm();
    const double share = std::min(std::max(of_a / (of_a + of_b), 1 - of_b / apart), of_a / apart);
    if (apart > 0) found.point_a += share * between;
    found.point_b = found.point_a;
  }
}

DistanceResult overlapOf(const PlanarPair& pair, bool is_signed, double least, DistanceResult common) {
  const double error = pair.shadow ? pair.shadow->outlineError() : 0;
  if (!(pair.shadow && pair.shadow->is_surface) && !overlap(pair, error)) return common;
  if (!is_signed) {
    common.distance = -1;
    return common;
  }
  const auto way = penetrationOf(pair);
  if (!way || !(way->depth > std::max(error, least))) return common;
  const OutlinePoints points(pair, *way);
  return {-way->depth, points.on_a, points.on_b, way->edge_a, way->edge_b};
}

}  // namespace tricover_fcl
