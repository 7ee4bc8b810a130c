// SPDX-License-Identifier: BSD-3-Clause
#include "shape/planar_pair.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tricover_fcl {
namespace {

using tricover::DistanceResult;
using tricover::Penetration;
using tricover::Vec2;

Vec2 middle(const Vec2& p, const Vec2& q) { return p / 2 + q / 2; }

/// Where a posed polygon's outline is straight around a point of it, across the normal of a contact: along `line`, a
/// unit vector, and measured from that point. Edges that lean by less than 1e-6 are taken for straight.
struct Face {
  Face(const tricover::Polygon& polygon, const tricover::Pose& pose, const Vec2& point, const Vec2& line) {
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

/// The points of the two grown outlines that part last, the way's length from each other. At its end the polygons are
/// the margins apart, in a direction that isn't the way's where it leads into a corner.
struct OutlinePoints {
  OutlinePoints(const PlanarPair& pair, const Penetration& way) {
    const Vec2 between = way.point_b - way.point_a + way.depth * way.normal;
    const bool is_known = between.allFinite() && !between.isZero(0);
    const Vec2 out = is_known ? Vec2(between.stableNormalized()) : way.normal;
    on_a = way.point_a + pair.margin_a * out;
    on_b = way.point_b - pair.margin_b * out;
  }

  Vec2 on_a, on_b;
};

}  // namespace

std::optional<DistanceResult> PlanarPair::distanceWithin(double limit, tricover::DistanceOptions options) const {
  tricover::PairCache* const kept = cache();
  options.margin = margin;
  return kept != nullptr ? tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, *kept, options)
                         : tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, options);
}

std::optional<Penetration> PlanarPair::penetration() const {
  tricover::PenetrationOptions options;
  options.margin = margin;
  auto found = tricover::penetration(*a, pose_a, *b, pose_b, options);
  if (!found || !std::isfinite(found->depth)) return found;
  const Vec2 line(-found->normal.y(), found->normal.x());
  const Face of_a(*a, pose_a, found->point_a, line), of_b(*b, pose_b, found->point_b, line);
  const double middle = (std::max(of_a.low, of_b.low) + std::min(of_a.high, of_b.high)) / 2;
  found->point_a += middle * line;
  found->point_b += middle * line;
  found->edge_a = of_a.edgeAt(middle, found->edge_a);
  found->edge_b = of_b.edgeAt(middle, found->edge_b);
  return found;
}

std::vector<tricover::Contact> PlanarPair::contacts(std::size_t most) const {
  return tricover::contacts(*a, pose_a, *b, pose_b, {margin, most, tricover::ContactDetail::LocalDepth});
}

bool PlanarPair::overlap(double error) const {
  const double less = margin * (1 - 1e-13) - error;
  if (less > 0) return tricover::collide(*a, pose_a, *b, pose_b, {less});
  if (error > 0) {
    const auto deepest = contacts(1);
    return !deepest.empty() && deepest.front().depth > error;
  }
  const tricover::CollideOptions of_interiors{0, 0, tricover::Touching::Allowed};
  if (tricover::collide(*a, pose_a, *b, pose_b, of_interiors)) return true;
  const auto hasInterior = [&](const tricover::Polygon& polygon) {
    return tricover::collide(polygon, pose_a, polygon, pose_a, of_interiors);
  };
  if (hasInterior(*a) && hasInterior(*b)) return false;
  const auto way = penetration();
  return way && way->depth > 0;
}

std::vector<PlanarContact> contactsOf(const PlanarPair& pair, bool as_one, std::size_t most, const Vec2& touch) {
  std::vector<PlanarContact> shared;
  if (as_one) {
    if (const auto whole = pair.penetration()) {
      const OutlinePoints points(pair, *whole);
      return {{middle(points.on_a, points.on_b), whole->normal, whole->depth, whole->edge_a, whole->edge_b}};
    }
  } else {
    const std::vector<tricover::Contact> parts = pair.contacts(most);
    std::size_t spare = pair.has_faces ? most - parts.size() : 0;
    for (const tricover::Contact& part : parts) {
      const bool has_both = part.count == 2 && spare > 0;
      spare -= has_both ? 1 : 0;
      if (!has_both) shared.push_back({part.point, part.normal, part.depth, part.edge_a, part.edge_b});
      for (std::size_t k = 0; has_both && k < 2; ++k)
        shared.push_back({part.points[k].point, part.normal, part.points[k].depth, part.edge_a, part.edge_b});
    }
  }
  if (shared.empty()) {
    const DistanceResult nearest = tricover::distance(*pair.a, pair.pose_a, *pair.b, pair.pose_b);
    const Vec2 between = nearest.point_b - nearest.point_a;
    shared.push_back({middle(nearest.point_a, nearest.point_b),
                      between.isZero(0) ? touch : Vec2(between.stableNormalized()), 0, nearest.edge_a, nearest.edge_b});
  }
  for (PlanarContact& contact : shared) contact.point += (pair.margin_a - pair.margin_b) / 2 * contact.normal;
  return shared;
}

void moveByMargins(const PlanarPair& pair, DistanceResult& found) {
  const double both = pair.margin_a + pair.margin_b;
  if (both == 0 || !std::isfinite(found.distance)) return;
  const Vec2 between = found.point_b - found.point_a;
  if (found.distance > 0) {
    const Vec2 towards = between.stableNormalized();
    found.point_a += pair.margin_a * towards;
    found.point_b -= pair.margin_b * towards;
  } else {
    if (pair.margin_a > 0) found.point_a += pair.margin_a / both * between;
    found.point_b = found.point_a;
  }
}

DistanceResult overlapOf(const PlanarPair& pair, bool is_signed, bool is_surface, double error, double least,
                         DistanceResult common) {
  if (!is_surface && !pair.overlap(error)) return common;
  if (!is_signed) {
    common.distance = -1;
    return common;
  }
  const auto way = pair.penetration();
  if (!way || !(way->depth > std::max(error, least))) return common;
  const OutlinePoints points(pair, *way);
  return {-way->depth, points.on_a, points.on_b, way->edge_a, way->edge_b};
}

}  // namespace tricover_fcl
