// SPDX-License-Identifier: BSD-3-Clause
#include "pair/certificate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "hierarchy/placement.h"
#include "numbers/rigidity.h"

namespace tricover::detail {
namespace {

Pose restore(const double (&kept)[6]) {
  Pose pose = Pose::Identity();
  pose.linear() << kept[0], kept[2], kept[1], kept[3];
  pose.translation() << kept[4], kept[5];
  return pose;
}

/// How far a map's change, p -> D p + d, takes any point of a polygon's bounding disc at most: |D| r + |D S + d|, the
/// norm of D by the eigenvalues of D^T D, which are at most the larger squared column and their product. D by its
/// columns; `way` is D S + d. What underflows in the squares is put back. Rounding, in units of U:
///   D, d               differences of doubles                                                   1
///   D S + d            in either coordinate: D, product, two sums 4 |D| |S|_1; d 1 |d|, the last sum 1 of itself; with
///                      |d| <= |D| |S|_1 + |D S + d|, and sqrt2 of it in any direction           7.1 |D| |S|_1, 2.9
///   squares of D       entries 2, product 1, sum 1, of either term; two more sums               10
///   squares of the way 2.9 twice, product 1, two sums 2                                         8.8
///   the result         root of a square 5 + 1, r 1, product 1, sum 1                            9
/// r is taken larger by 7.1 |S|_1.
double displacement(const PolygonData& polygon, Double2 d0, Double2 d1, Double2 way) {
  constexpr double kWayError = 8 * kUnitRoundoff;
  constexpr int kRoundings = 9;
  static_assert(kWayError >= kRoot2 * errorOf(5));
  const double radius = polygon.radius + kWayError * (std::abs(polygon.origin.x()) + std::abs(polygon.origin.y()));
  const Double2 x{d0[0], d1[0]}, y{d0[1], d1[1]}, norms = x * x + y * y, product = d0 * d1;
  const double square_of_turn = std::max(norms[0], norms[1]) + std::abs(product[0] + product[1]) + 0x1p-1000;
  const double square_of_way = dot(way, way) + 0x1p-1000;
  return roundedUp<kRoundings>(std::sqrt(square_of_turn) * radius + std::sqrt(square_of_way));
}

/// What is left, at the least, of the certificate's clearance after the motion of the two against each other, seen in
/// the first one's frame: for pairs that travel together.
double clearanceLeft(const Certificate& cache, const PolygonData& first, const Pose& first_pose,
                     const PolygonData& second, const Pose& second_pose) {
  const Pose first_then = restore(cache.first_pose), second_then = restore(cache.second_pose);
  const double defect_now = defectOf(first_pose, second_pose), defect_then = defectOf(first_then, second_then);
  const UnitMap now = PosedPair(first, first_pose, second, second_pose).inUnits(defect_now).map,
                then = PosedPair(first, first_then, second, second_then).inUnits(defect_then).map;
  const Double2 way = Double2{now.tx - then.tx, now.ty - then.ty} * first.unit;
  const double change = displacement(second, Double2{now.r00 - then.r00, now.r10 - then.r10},
                                     Double2{now.r01 - then.r01, now.r11 - then.r11}, way);
  const double motion = change + (now.error + then.error) * first.unit;
  // Two differences and their product, the product with the clearance, the difference; the motion's own sum rounds
  // twice.
  constexpr int kRoundings = 3 + 2 + 2;
  return roundedDown<kRoundings>((1 - defect_then) * (1 - defect_now)) * cache.clearance - motion;
}

}  // namespace

double displacement(const PolygonData& polygon, const double (&kept)[6], const Pose& pose) {
  if (sameAs(kept, pose)) return 0;
  const double* m = pose.data();
  const Double2 d0 = load2(m) - load2(kept), d1 = load2(m + 3) - load2(kept + 2),
                shift = load2(m + 6) - load2(kept + 4);
  return displacement(polygon, d0, d1, d0 * polygon.origin.x() + d1 * polygon.origin.y() + shift);
}

void store(double (&kept)[6], const Pose& pose) {
  for (const int column : {0, 1, 2}) store2(kept + 2 * column, load2(pose.data() + 3 * column));
}

Recollection recall(Certificate& cache, const PolygonData& a, const Pose& pose_a, const PolygonData& b,
                    const Pose& pose_b, double margin) {
  const bool direct = cache.first_id == a.id && cache.second_id == b.id;
  if (!direct && !(cache.first_id == b.id && cache.second_id == a.id)) {
    requireRigid(pose_a, pose_b);
    return {};
  }
  const PolygonData &first = direct ? a : b, &second = direct ? b : a;
  const Pose &first_pose = direct ? pose_a : pose_b, &second_pose = direct ? pose_b : pose_a;
  const double first_motion = displacement(first, cache.first_pose, first_pose),
               second_motion = displacement(second, cache.second_pose, second_pose);
  if (first_motion != 0) requireRigid(first_pose, direct ? "pose_a" : "pose_b");
  if (second_motion != 0) requireRigid(second_pose, direct ? "pose_b" : "pose_a");
  // Rounds twice: the difference and the sum of two motions.
  assert(cache.clearance >= 0);
  const double needed = cache.overlapping ? 0 : margin, room = roundedDown<2>(cache.clearance - needed);
  const double motion = first_motion + second_motion;
  if (motion < room || (room > 0 && first_motion != 0 && second_motion != 0 &&
                        clearanceLeft(cache, first, first_pose, second, second_pose) > needed)) {
    ++cache.uses;
    return {true, cache.overlapping, true, true, 0};
  }
  const double radius = std::min(first.radius, second.radius);
  return {false, false, true, motion <= kCoherentPart * radius, cache.lookahead(motion, radius)};
}

void claim(Certificate& cache, const PolygonData& first, const PolygonData& second) {
  if (cache.first_id == first.id && cache.second_id == second.id) return;
  cache = Certificate();
  cache.first_id = first.id;
  cache.second_id = second.id;
}

void remember(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
              const Pose& second_pose, bool overlapping, double clearance) {
  rememberPoses(cache, first, first_pose, second, second_pose);
  cache.clearance = clearance > 0 ? clearance : 0;
  cache.overlapping = overlapping;
  cache.was_sought = true;
}

void rememberPoses(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                   const Pose& second_pose) {
  claim(cache, first, second);
  store(cache.first_pose, first_pose);
  store(cache.second_pose, second_pose);
  cache.clearance = 0;
  cache.overlapping = cache.was_sought = false;
  cache.uses = 0;
}

}  // namespace tricover::detail
