// SPDX-License-Identifier: BSD-3-Clause
#include "pair/facts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "pair/posed_pair.h"

namespace tricover::detail {
namespace {

Pose restore(const double (&fact)[6]) {
  Pose pose = Pose::Identity();
  pose.linear() << fact[0], fact[2], fact[1], fact[3];
  pose.translation() << fact[4], fact[5];
  return pose;
}

}  // namespace

void store(double (&fact)[6], const Pose& pose) {
  const auto& m = pose.matrix();
  const double values[6] = {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 2), m(1, 2)};
  std::copy(values, values + 6, fact);
}

Remainder remainderOfRelativeMotion(const double (&first_fact)[6], const double (&second_fact)[6],
                                    const PolygonData& first, const Pose& first_pose, const PolygonData& second,
                                    const Pose& second_pose) {
  const Pose first_then = restore(first_fact), second_then = restore(second_fact);
  const PosedPair now(first, first_pose, second, second_pose), then(first, first_then, second, second_then);
  const Change change(second, load2(&now.m00) - load2(&then.m00), load2(&now.m01) - load2(&then.m01),
                      load2(&now.tx) - load2(&then.tx));
  // Either map is off by sqrt2 error in any direction.
  const double motion = change.displacement() + 1.5 * (now.error + then.error);
  constexpr int kProducts = 3;  // two differences and their product
  return {roundedDown<kProducts + Remainder::kRoundings>((1 - then.scale_defect) * (1 - now.scale_defect)), motion};
}

Recollection recallMoved(CollisionFact& cache, const PolygonData& first, const Pose& first_pose,
                         const PolygonData& second, const Pose& second_pose, double margin) {
  // Rounds twice: the difference and the sum of two motions.
  const double needed = cache.overlapping ? 0 : margin, room = roundedDown<2>(cache.clearance - needed);
  const Change first_change(first, cache.first_pose, first_pose), second_change(second, cache.second_pose, second_pose);
  const double motion =
      (first_change.any() ? first_change.displacement() : 0) + (second_change.any() ? second_change.displacement() : 0);
  if (motion < room ||
      (room > 0 && first_change.any() && second_change.any() &&
       remainderOfRelativeMotion(cache.first_pose, cache.second_pose, first, first_pose, second, second_pose)
               .of(cache.clearance) > needed)) {
    ++cache.uses;
    return {true, cache.overlapping, true, 0};
  }
  const double ahead = kStepsAhead * motion / (cache.uses + 1.0);
  const double most = kCoherentPart * std::min(first.radius, second.radius);
  // Nor does it pay to look for much more than there was, as in a narrow gap.
  return {false, false, motion <= most, ahead <= most ? std::min(ahead, 2.0 * cache.looked_ahead) : 0};
}

void claim(CollisionFact& cache, const PolygonData& first, const PolygonData& second) {
  if (cache.first_id == first.id && cache.second_id == second.id) return;
  cache = CollisionFact();
  cache.first_id = first.id;
  cache.second_id = second.id;
}

bool isWorthRenewing(CollisionFact& cache, bool coherent) {
  constexpr int kSaved = kQuery - 1;  // by a fact that answers
  const int uses = static_cast<int>(std::min<std::uint32_t>(cache.uses, kMostSaved));
  return isWorthIt(cache.balance, kSaved * uses - cache.cost - (coherent ? 0 : kQuery));
}

void remember(CollisionFact& cache, const PolygonData& first, const Pose& first_pose, const PolygonData& second,
              const Pose& second_pose, bool overlapping, double clearance) {
  claim(cache, first, second);
  store(cache.first_pose, first_pose);
  store(cache.second_pose, second_pose);
  cache.clearance = clearance > 0 ? clearance : 0;
  cache.overlapping = overlapping;
  cache.cost = 0;
  cache.uses = 0;
  assert(cache.first_id == first.id && cache.second_id == second.id && cache.clearance >= 0);
}

}  // namespace tricover::detail
