// SPDX-License-Identifier: BSD-3-Clause
// Whether a polygon collides, with the facts of a SceneCache.
#include <algorithm>
#include <limits>

#include "pair/facts.h"
#include "pair/kernel_order.h"
#include "polygon/cache_access.h"
#include "polygon/fact_balance.h"
#include "scene/asked.h"

namespace tricover {

using detail::Asked;
using detail::SceneFact;
using detail::SceneState;
using detail::Slot;
using detail::SlotFilter;

namespace {

/// A clearance looks ahead for so many steps: fewer than a PairCache's, because all bodies within are asked.
constexpr double kSteps = 8;
/// What a fact costs: it pays if it answers more.
constexpr int kFactCost = 4 * detail::kQuery;

/// A lower bound of the distance between points of two boxes; never NaN.
double gapBetween(const detail::Bounds& p, const detail::Bounds& q) {
  const double x = std::max({0.0, p.min_x - q.max_x, q.min_x - p.max_x});
  const double y = std::max({0.0, p.min_y - q.max_y, q.min_y - p.max_y});
  return std::max({x, y, detail::normBelow(x, y)}) * (1 - 4 * detail::kUnitRoundoff);
}

struct SceneOutcome {
  Slot met;          ///< kNoSlot: none
  double clearance;  ///< then from all bodies, beyond the margins, at most what was looked ahead
};

/// Asks all bodies that come near within the look ahead.
SceneOutcome findOutcome(const SceneState& state, const detail::PolygonData& data, const Pose& pose, const Asked& asked,
                         const CollideOptions& options, const SlotFilter& filter, double lookahead) {
  SceneOutcome outcome{detail::kNoSlot, lookahead};
  const detail::Bounds& bounds = asked.bounds();
  state.tree.visit(bounds.grown(lookahead), [&](Slot body, const detail::Bounds& box) {
    const auto& other = state.bodies[body];
    if (!state.passes(filter, body)) return true;
    if (const double gap = gapBetween(bounds, box); gap > 0) {
      outcome.clearance = std::min(outcome.clearance, gap);  // less than the truth, and sooner known
      return true;
    }
    const CollideOptions sum = detail::withBody(options, other.options);
    const detail::Outcome fact = detail::inKernelOrder(
        data, pose, other.polygon.data(), other.pose,
        [&](const auto&... operands) {
          return detail::findFact(operands..., sum, {lookahead, true});
        },
        [](const detail::Outcome&) {});
    if (fact.collides) outcome.met = body;
    outcome.clearance = std::min(outcome.clearance, detail::roundedDown<1>(fact.clearance - sum.margin));
    return !fact.collides;
  });
  return outcome;
}

/// Keeps where the polygon is; nothing is known of the bodies.
void begin(SceneFact& cache, const SceneState& state, const detail::PolygonData& data, const Pose& pose,
           const BodyFilter& filter) {
  cache.scene = state.id;
  cache.version = state.version;
  cache.polygon = data.id;
  detail::store(cache.pose, pose);
  cache.clearance = 0;
  cache.mask = filter.categories;
  cache.except = filter.except;
  cache.uses = 0;
}

}  // namespace

bool Scene::collides(const Polygon& polygon, const Pose& pose, SceneCache& caller_cache, const CollideOptions& options,
                     const BodyFilter& filter) const {
  SceneFact& cache = detail::factsIn(caller_cache);
  const double defect = detail::checkAsked(pose, options);
  const SceneState& state = impl_->settled();
  const SlotFilter slots = state.slots(filter);
  const detail::PolygonData& data = polygon.data();
  const bool follows = cache.scene == state.id && cache.polygon == data.id;
  if (cache.balance.resting > 0) {
    // The last one sees where the polygon is, so that the next one knows how far it has come.
    if (--cache.balance.resting == 0) begin(cache, state, data, pose, filter);
    return findMet(state, Asked(state, data, pose, defect, options), slots) != detail::kNoSlot;
  }
  double motion = std::numeric_limits<double>::infinity();
  if (follows) {
    const detail::Change change(data, cache.pose, pose);
    motion = change.any() ? change.displacement() : 0;
    const bool known = cache.version == state.version && (filter.categories & ~cache.mask) == 0 &&
                       (cache.except == kNoBody || cache.except == filter.except);
    if (known && motion < detail::roundedDown<1>(cache.clearance - options.margin)) {
      ++cache.uses;
      return false;
    }
  }
  const double lookahead = kSteps * motion / (cache.uses + 1.0);
  const int saved =
      cache.clearance > 0 ? detail::kQuery * static_cast<int>(std::min(cache.uses, 1000u)) - kFactCost : 0;
  const bool coherent = motion <= detail::kCoherentPart * data.radius;
  // After a jump, or another polygon, more may follow.
  bool worth = isWorthIt(cache.balance, coherent ? saved : saved - kFactCost) && coherent;
  begin(cache, state, data, pose, filter);
  const Asked asked(state, data, pose, defect, options);
  if (const Slot last = slotOf(cache.body); coherent && contains(cache.body) && state.passes(slots, last)) {
    const detail::Bounds box = state.tree.boundsOf(last);
    if (box.meets(asked.bounds())) {
      if (asked.isNear(state.bodies[last], box) && asked.meets(last)) {
        isWorthIt(cache.balance, detail::kQuery);
        return true;
      }
      worth = isWorthIt(cache.balance, -detail::kQuery) && worth;
    }
  }
  if (!worth) {
    const Slot met = findMet(state, asked, slots);
    if (met != detail::kNoSlot) cache.body = state.handleOf(met);
    return met != detail::kNoSlot;
  }
  const SceneOutcome outcome = findOutcome(state, data, pose, asked, options, slots, lookahead);
  if (outcome.met != detail::kNoSlot) {
    cache.body = state.handleOf(outcome.met);
    isWorthIt(cache.balance, -detail::kQuery);
    return true;
  }
  if (!(outcome.clearance > 0)) {
    isWorthIt(cache.balance, -kFactCost);
    return false;
  }
  cache.clearance = detail::roundedDown<1>(options.margin + outcome.clearance);
  return false;
}

}  // namespace tricover
