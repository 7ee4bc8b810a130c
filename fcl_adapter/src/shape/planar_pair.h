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

/// Two regions in one plane, each grown by a length: what two geometries come down to. What FCL is told of those that
/// overlap is made of the five answers below.
struct RegionPair {
  RegionPair(double of_a, double of_b, double of_both) : margin_a(of_a), margin_b(of_b), margin(of_both) {}

  virtual std::optional<tricover::Penetration> penetration() const = 0;
  /// Each part with a depth and a normal of its own: what a step of a simulation needs.
  virtual std::vector<tricover::Contact> contacts(std::size_t most) const = 0;
  /// Of the regions without their margins, as all that follows.
  virtual tricover::DistanceResult nearest() const = 0;
  virtual bool areWithin(double length) const = 0;
  /// Of regions that share the nearest points `common`: whether they overlap by more than `depth`.
  virtual bool areDeeper(double depth, const tricover::DistanceResult& common) const = 0;

  double margin_a, margin_b;
  double margin;  ///< of both, and what else was asked for

 protected:
  ~RegionPair() = default;
};

/// Two polygons under their poses: what the kernel is asked.
struct PlanarPair : RegionPair {
  PlanarPair(const tricover::Polygon& a_, const tricover::Polygon& b_, double of_a, double of_b, double of_both)
      : RegionPair(of_a, of_b, of_both), a(&a_), b(&b_) {}

  bool collide(double tolerance = 0) const {
    tricover::PairCache* const facts = cache();
    return facts != nullptr ? tricover::collide(*a, pose_a, *b, pose_b, *facts, {margin, tolerance})
                            : tricover::collide(*a, pose_a, *b, pose_b, {margin, tolerance});
  }
  std::optional<tricover::DistanceResult> distanceWithin(double limit, tricover::DistanceOptions options) const;

  std::optional<tricover::Penetration> penetration() const override;
  std::vector<tricover::Contact> contacts(std::size_t most) const override;
  tricover::DistanceResult nearest() const override;
  bool areWithin(double length) const override;
  bool areDeeper(double depth, const tricover::DistanceResult& common) const override;

  const tricover::Polygon *a, *b;
  tricover::Pose pose_a, pose_b;
  /// As pairCache() has them; null where no facts are kept.
  const void *place_a = nullptr, *place_b = nullptr;

 private:
  tricover::PairCache* cache() const { return place_a != nullptr ? pairCache(*a, place_a, *b, place_b) : nullptr; }
};

/// What a pair shares, as one or in parts, deepest first, in the middle between the two grown outlines. As one, its
/// depth is the shortest way that parts the two. What a tolerance or rounding takes for a hit is between the nearest
/// points, along `touch` if that is nothing.
std::vector<PlanarContact> contactsOf(const RegionPair& pair, bool as_one, std::size_t most,
                                      const tricover::Vec2& touch);

/// Nearest points of the regions become those of the grown ones: each goes towards the other by its own margin. Where
/// the margins meet, both become one point that is within either.
void moveByMargins(const RegionPair& pair, tricover::DistanceResult& found);

/// What FCL is told of a pair that shares a point: 0 where it only touches, up to the error of a distance or `touch`;
/// otherwise -1 or, if signed, minus the depth, with the points of the two surfaces that part last.
tricover::DistanceResult overlapOf(const RegionPair& pair, bool is_signed, double touch,
                                   tricover::DistanceResult common);

}  // namespace tricover_fcl
