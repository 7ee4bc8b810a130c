// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "shape/crossing.h"
#include "shape/fcl_results.h"
#include "shape/pair_cache_table.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl {

/// Two polygons under their poses in one plane, each grown by a length: what two geometries come down to, and what the
/// kernel is asked.
struct PlanarPair {
  const tricover::Polygon *a, *b;
  tricover::Pose pose_a, pose_b;
  double margin_a = 0, margin_b = 0;
  double margin = 0;  ///< of both, and what else was asked for
  /// As pairCache() has them; null where no facts are kept.
  const void *place_a = nullptr, *place_b = nullptr;

  bool collide(double tolerance = 0) const {
    tricover::PairCache* const facts = cache();
    return facts != nullptr ? tricover::collide(*a, pose_a, *b, pose_b, *facts, {margin, tolerance})
                            : tricover::collide(*a, pose_a, *b, pose_b, {margin, tolerance});
  }
  std::optional<tricover::DistanceResult> distanceWithin(double limit, tricover::DistanceOptions options) const {
    tricover::PairCache* const facts = cache();
    options.margin = margin;
    return facts != nullptr ? tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, *facts, options)
                            : tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, options);
  }

  /// What contactsOf() and overlapOf() ask.
  std::optional<tricover::Penetration> penetration() const {
    tricover::PenetrationOptions options;
    options.margin = margin;
    return tricover::penetration(*a, pose_a, *b, pose_b, options);
  }
  std::vector<tricover::Contact> contacts(std::size_t most) const {
    return tricover::contacts(*a, pose_a, *b, pose_b, {margin, most});
  }
  tricover::DistanceResult nearest() const { return tricover::distance(*a, pose_a, *b, pose_b); }
  bool areWithin(double length) const { return tricover::collide(*a, pose_a, *b, pose_b, {length, 0}); }
  /// Edges that cross and rings that lie inside without meeting an edge go on overlapping when moved a little. Contacts
  /// are needed of the others only, which mostly touch.
  bool areDeeper(double depth, const tricover::DistanceResult& common) const {
    if (common.edge_a < 0 || common.edge_b < 0) return true;
    if (crossDeeply(*a, pose_a, common.edge_a, *b, pose_b, common.edge_b, 0)) return true;
    const auto deepest = contacts(1);
    return !deepest.empty() && deepest.front().depth > depth;
  }

 private:
  tricover::PairCache* cache() const { return place_a != nullptr ? pairCache(*a, place_a, *b, place_b) : nullptr; }
};

inline tricover::Vec2 middle(const tricover::Vec2& p, const tricover::Vec2& q) { return p / 2 + q / 2; }

/// The points of the two grown outlines that part last, the way's length from each other. At its end the polygons are
/// the margins apart, in a direction that isn't the way's where it leads into a corner.
struct OutlinePoints {
  template <typename Pair>
  OutlinePoints(const Pair& pair, const tricover::Penetration& way) {
    const tricover::Vec2 between = way.point_b - way.point_a + way.depth * way.normal;
    const bool is_known = between.allFinite() && !between.isZero(0);
    const tricover::Vec2 out = is_known ? tricover::Vec2(between.stableNormalized()) : way.normal;
    on_a = way.point_a + pair.margin_a * out;
    on_b = way.point_b - pair.margin_b * out;
  }

  tricover::Vec2 on_a, on_b;
};

/// What a pair shares, as one or in parts, deepest first, in the middle between the two grown outlines. What a
/// tolerance or rounding takes for a hit is between the nearest points, along `touch` if that is nothing.
template <typename Pair>
std::vector<PlanarContact> contactsOf(const Pair& pair, bool as_one, std::size_t most, const tricover::Vec2& touch) {
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
    const tricover::DistanceResult nearest = pair.nearest();
    const tricover::Vec2 between = nearest.point_b - nearest.point_a;
    shared.push_back({middle(nearest.point_a, nearest.point_b),
                      between.isZero(0) ? touch : tricover::Vec2(between.stableNormalized()), 0, nearest.edge_a,
                      nearest.edge_b});
  }
  for (PlanarContact& contact : shared) contact.point += (pair.margin_a - pair.margin_b) / 2 * contact.normal;
  return shared;
}

/// Nearest points of the polygons become those of the grown ones: each goes towards the other by its own margin. Where
/// the margins meet, both become one point that is within either.
template <typename Pair>
void moveByMargins(const Pair& pair, tricover::DistanceResult& found) {
  const double both = pair.margin_a + pair.margin_b;
  if (both == 0 || !std::isfinite(found.distance)) return;
  const tricover::Vec2 between = found.point_b - found.point_a;
  if (found.distance > 0) {
    const tricover::Vec2 towards = between.stableNormalized();
    found.point_a += pair.margin_a * towards;
    found.point_b -= pair.margin_b * towards;
  } else {
    if (pair.margin_a > 0) found.point_a += pair.margin_a / both * between;
    found.point_b = found.point_a;
  }
}

/// What FCL is told of a pair that shares a point: 0 where it only touches, up to the error of a distance or `touch`;
/// otherwise -1 or, if signed, minus the depth, with the points of the two surfaces that part last.
template <typename Pair>
tricover::DistanceResult overlapOf(const Pair& pair, bool is_signed, double touch, tricover::DistanceResult common) {
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
