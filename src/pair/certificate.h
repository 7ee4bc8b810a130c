// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "numbers/rounding.h"
#include "pair/outcome.h"
#include "polygon/cache_contents.h"
#include "polygon/polygon_data.h"
#include "tricover/collide_options.h"

namespace tricover::detail {

/// What a cache's certificate says of a query.
struct Recollection {
  bool certain;  ///< `collides` is the answer
  bool collides;
  bool known;  ///< the cache is this pair's
  /// Whether the next certificate is likely to be of use: the polygons have not jumped since.
  bool coherent;
  double lookahead;  ///< the clearance, beyond the margin, that would pay for a good many steps like the last ones
};

inline bool sameAs(const double (&kept)[6], const Pose& pose) {
  const double* m = pose.data();
  const Double2 difference = absolute(load2(m) - load2(kept)) + absolute(load2(m + 3) - load2(kept + 2)) +
                             absolute(load2(m + 6) - load2(kept + 4));
  return difference[0] + difference[1] == 0;
}

/// Keeps a pose with a certificate.
void store(double (&kept)[6], const Pose& pose);

/// How far a map's change, p -> D p + d, takes any point of a polygon's bounding disc at most: |D| r + |D S + d|, the
/// norm of D by the eigenvalues of D^T D, which are at most the larger squared column and their product. D by its
/// columns; `way` is D S + d. What underflows in the squares is put back. Rounding, in units of U:
///   D, d               differences of doubles                                                   1
///   D S + d            in either coordinate: D, product, two sums 4 |D| |S|_1; d 1 |d|, the last sum 1 of itself; with
///                      |d| <= |D| |S|_1 + |D S + d|, and sqrt2 of it in any direction           7.1 |D| |S|_1, 2.9
///   squares of D       entries 2, product 1, sum 1, of either term; two more sums               10
///   squares of the way 2.9 twice, product 1, two sums 2                                         8.8
///   length()           root of a square 5 + 1, r 1, product 1, sum 1                            9
///   isBelow()          a square 10, square of r 2 + 1, product 1, sum 1; the length's square 1  16
/// r is taken larger by 7.1 |S|_1.
struct Displacement {
  Displacement(const PolygonData& polygon, Double2 d0, Double2 d1, Double2 way)
      : radius(polygon.radius + kWayError * (std::abs(polygon.origin.x()) + std::abs(polygon.origin.y()))) {
    const Double2 x{d0[0], d1[0]}, y{d0[1], d1[1]}, norms = x * x + y * y, product = d0 * d1;
    square_of_turn = std::max(norms[0], norms[1]) + std::abs(product[0] + product[1]) + 0x1p-1000;
    square_of_way = dot(way, way) + 0x1p-1000;
  }
  /// From a kept pose to another one.
  Displacement(const PolygonData& polygon, const double (&kept)[6], const Pose& pose)
      : Displacement(polygon, kept, pose, load2(pose.data()) - load2(kept), load2(pose.data() + 3) - load2(kept + 2)) {}

  double length() const {
    return roundedUp<kLengthRoundings>(std::sqrt(square_of_turn) * radius + std::sqrt(square_of_way));
  }
  /// Whether it is certainly below `length`, without a root: (x + y)^2 <= 2 (x^2 + y^2).
  bool isBelow(double length) const {
    return squarable(length) &&
           roundedUp<kSquareRoundings>(2 * (square_of_turn * (radius * radius) + square_of_way)) < length * length;
  }

  double radius, square_of_turn, square_of_way;

 private:
  Displacement(const PolygonData& polygon, const double (&kept)[6], const Pose& pose, Double2 d0, Double2 d1)
      : Displacement(polygon, d0, d1,
                     d0 * polygon.origin.x() + d1 * polygon.origin.y() + (load2(pose.data() + 6) - load2(kept + 4))) {}

  static constexpr double kWayError = 8 * kUnitRoundoff;
  static constexpr int kLengthRoundings = 9, kSquareRoundings = 16;
  static_assert(kWayError >= kRoot2 * errorOf(5));
};

/// The same in the world; 0 for the kept pose.
double displacement(const PolygonData& polygon, const double (&kept)[6], const Pose& pose);

/// Tells what recall() can't at a glance.
Recollection recallMoved(Certificate& cache, const PolygonData& first, const Pose& first_pose,
                         const PolygonData& second, const Pose& second_pose, double defect, double margin);

/// What a certificate says of checked poses, whose defect is given.
inline Recollection recall(Certificate& cache, const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                           const Pose& pose_b, double defect, double margin) {
  const bool direct = cache.first_id == a.id && cache.second_id == b.id;
  if (!direct && !(cache.first_id == b.id && cache.second_id == a.id)) return {};
  const PolygonData &first = direct ? a : b, &second = direct ? b : a;
  const Pose &first_pose = direct ? pose_a : pose_b, &second_pose = direct ? pose_b : pose_a;
  assert(cache.clearance >= 0);
  const bool first_moved = !sameAs(cache.first_pose, first_pose),
             second_moved = !sameAs(cache.second_pose, second_pose);
  // As a rule one of them stands still.
  const double room = roundedDown<1>(cache.clearance - (cache.overlapping ? 0 : margin));
  const bool certain = first_moved ? !second_moved && Displacement(first, cache.first_pose, first_pose).isBelow(room)
                                   : Displacement(second, cache.second_pose, second_pose).isBelow(room);
  if (!certain) return recallMoved(cache, first, first_pose, second, second_pose, defect, margin);
  ++cache.uses;
  return {true, cache.overlapping, true, true, 0};
}

/// Makes the cache one of these two polygons; empties it if it was another pair's.
void claim(Certificate& cache, const PolygonData& first, const PolygonData& second);

/// Keeps a new certificate of these poses.
void remember(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
              const Pose& second_pose, bool overlapping, double clearance);
/// Keeps the poses alone: the next query then knows how far the polygons have moved.
void rememberPoses(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                   const Pose& second_pose);

/// Makes the cache this pair's. Returns whether a new certificate may pay; if it may not, the poses are kept.
bool beginRenewal(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                  const Pose& second_pose, const Recollection& recollection);

/// Counts a query during a back-off. The last one keeps its poses.
inline void countDown(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                      const Pose& second_pose) {
  if (--cache.back_off.left == 0) rememberPoses(cache, first, first_pose, second, second_pose);
}

/// The aims of a search for a certificate.
struct CertificateWish {
  double lookahead;                                 ///< the clearance, beyond the margin, that is of use
  bool wants_clearance;                             ///< false: a clearance would be of no use
  EdgePosition edge_a = kNoEdge, edge_b = kNoEdge;  ///< tried first, unless kNoEdge
};

/// Finds what a Certificate says of these poses: an Outcome whose clearance is a world length, 0 of a hit by the
/// margin or the tolerance alone. Operands in the kernel's order, all arguments checked.
Outcome findCertificate(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                        double defect, const CollideOptions& options, const CertificateWish& wish);

/// After recall(): keeps a new certificate if one may be of use, and returns its answer.
std::optional<bool> renewCertificate(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                     double defect, Certificate& cache, const Recollection& recollection,
                                     const CollideOptions& options);

}  // namespace tricover::detail
