// SPDX-License-Identifier: BSD-3-Clause
#include "pair/certificate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "numbers/rigidity.h"
#include "pair/posed_pair.h"

namespace tricover::detail {
namespace {

Pose restore(const double (&kept)[6]) {
  Pose pose = Pose::Identity();
  pose.linear() << kept[0], kept[2], kept[1], kept[3];
  pose.translation() << kept[4], kept[5];
  return pose;
}

/// What is left, at the least, of the certificate's clearance after the motion of the two against each other, seen in
/// the first one's frame: for pairs that travel together.
double clearanceLeft(const Certificate& cache, const PolygonData& first, const Pose& first_pose,
                     const PolygonData& second, const Pose& second_pose, double defect_now) {
  const Pose first_then = restore(cache.first_pose), second_then = restore(cache.second_pose);
  const double defect_then = defectOf(first_then, second_then);
  const UnitMap now = PosedPair(first, first_pose, second, second_pose).inUnits(defect_now),
                then = PosedPair(first, first_then, second, second_then).inUnits(defect_then);
  const Double2 way = Double2{now.tx - then.tx, now.ty - then.ty} * first.unit;
  const Displacement change(second, Double2{now.r00 - then.r00, now.r10 - then.r10},
                            Double2{now.r01 - then.r01, now.r11 - then.r11}, way);
  const double motion = change.length() + (now.error + then.error) * first.unit;
  // Two differences and their product, the product with the clearance, the difference; the motion's own sum rounds
  // twice.
  constexpr int kRoundings = 3 + 2 + 2;
  return roundedDown<kRoundings>((1 - defect_then) * (1 - defect_now)) * cache.clearance - motion;
}

}  // namespace

double displacement(const PolygonData& polygon, const double (&kept)[6], const Pose& pose) {
  return sameAs(kept, pose) ? 0 : Displacement(polygon, kept, pose).length();
}

void store(double (&kept)[6], const Pose& pose) {
  Eigen::Map<Eigen::Matrix<double, 2, 3>>{kept} = pose.matrix().topRows<2>();
}

Recollection recallMoved(Certificate& cache, const PolygonData& first, const Pose& first_pose,
                         const PolygonData& second, const Pose& second_pose, double defect, double margin) {
  const double first_motion = displacement(first, cache.first_pose, first_pose),
               second_motion = displacement(second, cache.second_pose, second_pose);
  // Rounds twice: the difference and the sum of two motions.
  const double needed = cache.overlapping ? 0 : margin, room = roundedDown<2>(cache.clearance - needed);
  const double motion = first_motion + second_motion;
  if (motion < room || (room > 0 && first_motion != 0 && second_motion != 0 &&
                        clearanceLeft(cache, first, first_pose, second, second_pose, defect) > needed)) {
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

bool beginRenewal(Certificate& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                  const Pose& second_pose, const Recollection& recollection) {
  claim(cache, first, second);
  const bool may_pay = cache.isWorthRenewing(recollection.known, recollection.coherent);
  if (!may_pay) rememberPoses(cache, first, first_pose, second, second_pose);
  return may_pay;
}

}  // namespace tricover::detail
