// SPDX-License-Identifier: BSD-3-Clause
#include "distance/distance_facts.h"

#include <algorithm>
#include <limits>

#include "distance/small_distance.h"
#include "pair/containment.h"
#include "pair/facts.h"

namespace tricover::detail {
namespace {

/// DistanceFacts::answered: facts pay if they answer two queries, or more of small rings, whose search takes little, in
/// steps of at most that part of the radius. Those that didn't look ahead aren't judged.
constexpr std::uint8_t kPaying = 2, kPayingOfRings = 8, kUnjudged = 255;
constexpr double kCoherentPartOfRings = kCoherentPart / 16;
bool knowsFacts(const DistanceFacts& cache) { return cache.count > 0 || cache.apart[0] > 0; }

void storePoses(DistanceFacts& cache, const DistancePair& pair) {
  store(cache.first_pose, pair.pose_a);
  store(cache.second_pose, pair.pose_b);
  cache.uses = 0;
}

Remainder remainderOf(const DistanceFacts& cache, const DistancePair& pair, bool& both_moved) {
  const bool a_moved = !sameAs(cache.first_pose, pair.pose_a), b_moved = !sameAs(cache.second_pose, pair.pose_b);
  both_moved = a_moved && b_moved;
  const double motion = (a_moved ? Change(pair.a, cache.first_pose, pair.pose_a).displacement() : 0) +
                        (b_moved ? Change(pair.b, cache.second_pose, pair.pose_b).displacement() : 0);
  return {roundedDown<Remainder::kRoundings>(1), motion};
}

/// How many of the pairs that the fact lists had to be shown for the least distance, or a meeting, to be among them
/// after a motion; -1 if it isn't certain to be.
int showListed(const DistanceFacts& cache, const Remainder& remainder, DistanceSearch& search) {
  const bool apart = remainder.of(cache.apart[0]) > 0;
  for (int k = 0; k <= cache.count; ++k) {
    if (EdgeDistances::below(remainder.of(cache.apart[k])) > search.worth()) return k;
    if (k == cache.count) break;
    if (apart)
      search.showNear(cache.first_edge[k], cache.second_edge[k]);
    else if (!search.show(cache.first_edge[k], cache.second_edge[k]))
      return k;
  }
  return -1;
}

/// How far the next facts should look ahead, after this motion was too much for these; 0: not at all.
double lookaheadAfter(DistanceFacts& cache, const DistancePair& pair, double motion) {
  const bool are_rings = areSmall(pair.a, pair.b);
  const double most = are_rings ? kCoherentPartOfRings * (cache.uses + 1.0) : kCoherentPart;
  const bool jumped = !(motion <= most * pair.b.radius);
  const bool are_paid = !jumped && cache.answered >= (are_rings ? kPayingOfRings : kPaying);
  if (jumped || cache.answered != kUnjudged) isWorthIt(cache.balance, are_paid ? kMostSaved : -kMostSaved - 1);
  if (jumped || cache.balance.resting > 0) return 0;
  return std::min(kStepsAhead * motion / (cache.uses + 1.0), pair.b.radius);
}

std::optional<Outcome> recallFacts(const DistancePair& pair, DistanceFacts& cache, DistanceSearch& search) {
  bool both_moved;
  Remainder remainder = remainderOf(cache, pair, both_moved);
  search.lookAhead(std::numeric_limits<double>::infinity());
  int shown = showListed(cache, remainder, search);
  if (shown < 0 && both_moved) {
    remainder =
        remainderOfRelativeMotion(cache.first_pose, cache.second_pose, pair.a, pair.pose_a, pair.b, pair.pose_b);
    shown = showListed(cache, remainder, search);
  }
  if (shown < 0) {
    search.lookAhead(lookaheadAfter(cache, pair, remainder.motion));
    return std::nullopt;
  }
  ++cache.uses;
  if (cache.answered < kPayingOfRings) ++cache.answered;
  Outcome outcome;
  if (!search.meets() && !(remainder.of(cache.apart[0]) > 0))
    outcome = findContainment(PosedPair(pair.a, pair.pose_a, pair.b, pair.pose_b));
  if (!outcome.collides && search.refresh(cache, remainder, shown)) storePoses(cache, pair);
  return outcome;
}

}  // namespace

std::optional<Outcome> recallNearest(const DistancePair& pair, DistanceFacts& cache, DistanceSearch& search) {
  if (knowsFacts(cache)) return recallFacts(pair, cache, search);
  if (cache.balance.resting == 0) return std::nullopt;
  --cache.balance.resting;
  const bool meets = cache.hint == kNearEdges && !search.show(cache.first_edge[0], cache.second_edge[0]);
  return meets ? std::optional(Outcome()) : std::nullopt;
}

void storeNearest(const DistancePair& pair, DistanceFacts& cache, const DistanceSearch& search,
                  const Outcome& outcome) {
  if (outcome.collides && !search.meets()) {
    storeHint(cache, kNoHint, 0, 0);
  } else if (cache.balance.resting > 0) {
    const ShownPair& upper = search.upperPair();
    const bool is_hint = search.hasUpper() && !areSmall(pair.a, pair.b);  // all of whose edges are asked anyway
    storeHint(cache, is_hint ? kNearEdges : kNoHint, upper.i, upper.j);
  } else {
    storePoses(cache, pair);
    cache.hint = kNoHint;
    cache.answered = search.looksAhead() ? 0 : kUnjudged;
    search.keep(cache);
  }
}

}  // namespace tricover::detail
