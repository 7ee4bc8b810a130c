// SPDX-License-Identifier: BSD-3-Clause
#include "shape/planar_pair.h"

#include <cmath>

namespace tricover_fcl {
namespace {

using tricover::DistanceResult;
using tricover::Penetration;
using tricover::Vec2;

Vec2 middle(const Vec2& p, const Vec2& q) { return p / 2 + q / 2; }

/// Whether the two edges cross, and go on to do so when either is moved a little, for certain: the ends of each are on
/// both sides of the other's line. Rounding counts as touching.
bool crossDeeply(const PlanarPair& pair, tricover::EdgeIndex edge_a, tricover::EdgeIndex edge_b) {
  const Vec2 start_a = pair.a->edgeStart(edge_a), end_a = pair.a->edgeEnd(edge_a), start_b = pair.b->edgeStart(edge_b),
             end_b = pair.b->edgeEnd(edge_b);
  // A posed vertex errs by less than 4 roundings of what it is added from, which this size bounds.
  const double size = 3 * (start_a.lpNorm<1>() + end_a.lpNorm<1>() + start_b.lpNorm<1>() + end_b.lpNorm<1>()) +
                      pair.pose_a.translation().lpNorm<1>() + pair.pose_b.translation().lpNorm<1>();
  const double error = 0x1p-48 * size;
  const Vec2 p = pair.pose_a * start_a, q = pair.pose_a * end_a, r = pair.pose_b * start_b, s = pair.pose_b * end_b;
  const auto separates = [error](const Vec2& from, const Vec2& to, const Vec2& left, const Vec2& right) {
    const Vec2 along = to - from;
    const auto above = [&](const Vec2& end) {
      return along.x() * (end.y() - from.y()) - along.y() * (end.x() - from.x());
    };
    const double least =
        4 * error * (along.lpNorm<1>() + (left - from).lpNorm<1>() + (right - from).lpNorm<1>()) + 1e-300;  // underflow
    return (above(left) > least && above(right) < -least) || (above(left) < -least && above(right) > least);
  };
  return separates(p, q, r, s) && separates(r, s, p, q);
}

/// The points of the two grown outlines that part last, the way's length from each other. At its end the polygons are
/// the margins apart, in a direction that isn't the way's where it leads into a corner.
struct OutlinePoints {
  OutlinePoints(const RegionPair& pair, const Penetration& way) {
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
  tricover::PairCache* const facts = cache();
  options.margin = margin;
  return facts != nullptr ? tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, *facts, options)
                          : tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, options);
}

std::optional<Penetration> PlanarPair::penetration() const {
  tricover::PenetrationOptions options;
  options.margin = margin;
  return tricover::penetration(*a, pose_a, *b, pose_b, options);
}

std::vector<tricover::Contact> PlanarPair::contacts(std::size_t most) const {
  return tricover::contacts(*a, pose_a, *b, pose_b, {margin, most, tricover::ContactDetail::LocalDepth});
}

DistanceResult PlanarPair::nearest() const { return tricover::distance(*a, pose_a, *b, pose_b); }

bool PlanarPair::areWithin(double length) const { return tricover::collide(*a, pose_a, *b, pose_b, {length, 0}); }

/// Edges that cross and rings that lie inside without meeting an edge go on overlapping when moved a little. Contacts
/// are needed of the others only, which mostly touch.
bool PlanarPair::areDeeper(double depth, const DistanceResult& common) const {
  if (common.edge_a < 0 || common.edge_b < 0 || crossDeeply(*this, common.edge_a, common.edge_b)) return true;
  const auto deepest = contacts(1);
  return !deepest.empty() && deepest.front().depth > depth;
}

std::vector<PlanarContact> contactsOf(const RegionPair& pair, bool as_one, std::size_t most, const Vec2& touch) {
  std::vector<PlanarContact> shared;
  if (as_one) {
    if (const auto whole = pair.penetration()) {
      const OutlinePoints points(pair, *whole);
      return {{middle(points.on_a, points.on_b), whole->normal, whole->depth, whole->edge_a, whole->edge_b}};
    }
  } else {
    for (const tricover::Contact& part : pair.contacts(most))
      shared.push_back({part.point, part.normal, part.depth, part.edge_a, part.edge_b});
  }
  if (shared.empty()) {
    const DistanceResult nearest = pair.nearest();
    const Vec2 between = nearest.point_b - nearest.point_a;
    shared.push_back({middle(nearest.point_a, nearest.point_b),
                      between.isZero(0) ? touch : Vec2(between.stableNormalized()), 0, nearest.edge_a, nearest.edge_b});
  }
  for (PlanarContact& contact : shared) contact.point += (pair.margin_a - pair.margin_b) / 2 * contact.normal;
  return shared;
}

void moveByMargins(const RegionPair& pair, DistanceResult& found) {
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

DistanceResult overlapOf(const RegionPair& pair, bool is_signed, double touch, DistanceResult common) {
  const double less = pair.margin * (1 - 1e-13) - touch;
  if (less > 0 && !pair.areWithin(less)) return common;
  if (is_signed) {
    const auto way = pair.penetration();
    if (!way || !(way->depth > touch)) return common;
    const OutlinePoints points(pair, *way);
    return {-way->depth, points.on_a, points.on_b, way->edge_a, way->edge_b};
  }
  if (less > 0 || pair.areDeeper(touch, common)) common.distance = -1;
  return common;
}

}  // namespace tricover_fcl
