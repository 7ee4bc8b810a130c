// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "shape/fcl_results.h"
#include "shape/pair_cache_table.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl {

/// Two polygons under their poses in one plane: what two geometries come down to, and what the kernel is asked. Lengths
/// that they are grown by are the options' margins.
struct PlanarPair {
  const tricover::Polygon *a, *b;
  tricover::Pose pose_a, pose_b;
  /// As pairCache() has them; null where no facts are kept.
  const void *place_a = nullptr, *place_b = nullptr;

  bool collide(const tricover::CollideOptions& options) const {
    tricover::PairCache* const facts = cache();
    return facts != nullptr ? tricover::collide(*a, pose_a, *b, pose_b, *facts, options)
                            : tricover::collide(*a, pose_a, *b, pose_b, options);
  }
  std::optional<tricover::DistanceResult> distanceWithin(double limit, const tricover::DistanceOptions& options) const {
    tricover::PairCache* const facts = cache();
    return facts != nullptr ? tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, *facts, options)
                            : tricover::distanceWithin(*a, pose_a, *b, pose_b, limit, options);
  }
  tricover::DistanceResult distance() const { return tricover::distance(*a, pose_a, *b, pose_b); }
  std::optional<tricover::Penetration> penetration() const { return tricover::penetration(*a, pose_a, *b, pose_b); }
  std::vector<tricover::Contact> contacts(std::size_t most) const {
    return tricover::contacts(*a, pose_a, *b, pose_b, {0, most});
  }

 private:
  tricover::PairCache* cache() const { return place_a != nullptr ? pairCache(*a, place_a, *b, place_b) : nullptr; }
};

inline tricover::Vec2 middle(const tricover::Vec2& p, const tricover::Vec2& q) { return p / 2 + q / 2; }

/// What a pair shares, as one or in parts, deepest first. Where only margins meet, it is what is between the nearest
/// points, along `touch` if that is nothing. `Pair` has penetration(), contacts() and distance().
template <typename Pair>
std::vector<PlanarContact> contactsOf(const Pair& pair, bool as_one, std::size_t most, const tricover::Vec2& touch) {
  std::vector<PlanarContact> shared;
  if (as_one) {
    if (const auto whole = pair.penetration())
      shared.push_back(
          {middle(whole->point_a, whole->point_b), whole->normal, whole->depth, whole->edge_a, whole->edge_b});
  } else {
    for (const tricover::Contact& part : pair.contacts(most))
      shared.push_back({part.point, part.normal, part.depth, part.edge_a, part.edge_b});
  }
  if (shared.empty()) {
    const tricover::DistanceResult nearest = pair.distance();
    const tricover::Vec2 between = nearest.point_b - nearest.point_a;
    shared.push_back({middle(nearest.point_a, nearest.point_b),
                      between.isZero(0) ? touch : tricover::Vec2(between.stableNormalized()), 0, nearest.edge_a,
                      nearest.edge_b});
  }
  return shared;
}

}  // namespace tricover_fcl
