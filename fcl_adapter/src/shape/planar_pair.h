// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "shape/fcl_results.h"
#include "shape/pair_cache_table.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl {

/// Two polygons under their poses, each grown by a margin: what two geometries come down to. The kernel answers.
struct PlanarPair {
  PlanarPair(const tricover::Polygon& a_, const tricover::Polygon& b_, double of_a, double of_b, double of_both)
      : a(&a_), b(&b_), margin_a(of_a), margin_b(of_b), margin(of_both) {}

  bool collide(double tolerance = 0) const {
    tricover::PairCache* const kept = cache();
    return kept != nullptr ? tricover::collide(*a, pose_a, *b, pose_b, *kept, {margin, tolerance})
                           : tricover::collide(*a, pose_a, *b, pose_b, {margin, tolerance});
  }
  std::optional<tricover::DistanceResult> distanceWithin(double limit, tricover::DistanceOptions options) const;

  /// In the middle of the two outlines' faces where these lie upon each other at the end of the translation.
  std::optional<tricover::Penetration> penetration() const;
  /// Each component with a depth and a normal of its own: what a step of a simulation needs.
  std::vector<tricover::Contact> contacts(std::size_t most) const;
  /// Whether regions that share a point overlap by more than `error`, or, grown by a margin, by 1e-13 of that. Exact
  /// where error and margin are 0: whether interiors meet or, of a region without one, whether its depth isn't 0.
  bool overlap(double error) const;

  const tricover::Polygon *a, *b;
  double margin_a, margin_b;
  double margin;  ///< of both, and of the query
  tricover::Pose pose_a, pose_b;
  bool has_faces = true;  ///< their edges are; those of a round body's outline are none to rest on
  /// As pairCache() has them; null where no certificates are kept.
  const void *place_a = nullptr, *place_b = nullptr;

 private:
  tricover::PairCache* cache() const { return place_a != nullptr ? pairCache(*a, place_a, *b, place_b) : nullptr; }
};

/// Returns the overlap of a pair, as one or by components, deepest first, in the middle between the two grown outlines.
/// Where more than the components are wanted, flat ones have both of their ends.
/// As one, its depth is the shortest way that parts the two. What a tolerance or rounding takes for a hit is between
/// the nearest points, along `touch` if that is nothing.
std::vector<PlanarContact> contactsOf(const PlanarPair& pair, bool as_one, std::size_t most,
                                      const tricover::Vec2& touch);

/// Nearest points of the regions become those of the grown ones: each goes towards the other by its own margin. Where
/// the margins meet, both become one point that is within either.
void moveByMargins(const PlanarPair& pair, tricover::DistanceResult& found);

/// Returns the distance that FCL is told of a pair that shares a point: 0 where it only touches, up to `error` and that
/// of a distance; otherwise -1 or, if signed, minus the depth, with the points of the two surfaces that separate last.
/// A depth below `least` is none. Surfaces overlap wherever they meet.
tricover::DistanceResult overlapOf(const PlanarPair& pair, bool is_signed, bool is_surface, double error, double least,
                                   tricover::DistanceResult common);

}  // namespace tricover_fcl
