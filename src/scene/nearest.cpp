// SPDX-License-Identifier: BSD-3-Clause
// The bodies nearest to a polygon.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "distance/options.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "polygon/cache_access.h"
#include "scene/scene_state.h"

namespace tricover {

using detail::PolygonData;
using detail::SceneState;
using detail::Slot;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isNearer(const BodyDistance& p, const BodyDistance& q) {
  return std::pair(p.result.distance, p.body) < std::pair(q.result.distance, q.body);
}

/// A posed polygon whose distances from bodies are asked.
class AskedDistance {
 public:
  AskedDistance(const SceneState& state, const Polygon& polygon, const Pose& pose, double limit,
                const DistanceOptions& options, const BodyFilter& filter)
      : state_(state), polygon_(polygon), pose_(pose), limit_(limit), options_(options), filter_(state.slots(filter)) {
    detail::checkOptions(options);
    detail::requireRigid(pose, "pose");
    bounds_ = detail::boundsOf(polygon.data(), pose, options.margin);
  }

  /// None if the body isn't asked for or is beyond the limit.
  std::optional<BodyDistance> from(Slot slot, double limit) const {
    if (!state_.passes(filter_, slot)) return std::nullopt;
    const auto& other = state_.bodies[slot];
    DistanceOptions sum = options_;
    sum.margin = detail::marginSum(options_.margin, other.options.margin);
    auto result = distanceWithin(polygon_, pose_, other.polygon, other.pose, limit, sum);
    // Another body's distance cuts off what this one's was rounded up by: which one is told shouldn't depend on who
    // comes first.
    if (result && result->distance == limit && 0 < limit && limit < limit_)
      result = distanceWithin(polygon_, pose_, other.polygon, other.pose, limit_, sum);
    if (!result || result->distance == kInfinity) return std::nullopt;
    return BodyDistance{state_.handleOf(slot), *result};
  }

  /// At most the distance of a body that is slim and may lie slanted in its box, by the box around everything of it;
  /// otherwise 0.
  double leastFrom(Slot slot) const {
    const auto& body = state_.bodies[slot];
    const PolygonData& polygon = body.polygon.data();
    const detail::Hierarchy* tree = detail::topIfBuilt(polygon);
    if (tree == nullptr || !(tree->root.along > kSlim * tree->root.across)) return 0;
    if (!disc_) disc_.emplace(polygon_.data(), pose_);
    const double least = disc_->leastFrom(tree->root, polygon, body.pose);
    return std::max(0.0, least - detail::marginSum(options_.margin, body.options.margin));
  }
  static constexpr float kSlim = 3;

  /// Whether a point of the world is no farther away than `reach` and the polygon's own size.
  bool isNear(const Vec2& at, double reach) const {
    const detail::Bounds around =
        bounds_.grown(reach + (bounds_.max_x - bounds_.min_x) + (bounds_.max_y - bounds_.min_y));
    return around.contains({at.x(), at.y(), at.x(), at.y()});
  }

  /// The nearest body; a guess makes the limit smaller.
  std::optional<BodyDistance> nearest(Slot guess = detail::kNoSlot) const {
    std::optional<BodyDistance> best;
    double limit = limit_;
    const auto ask = [&](Slot slot) {
      const BodyHandle body = state_.handleOf(slot);
      if (best && (body == best->body || (limit == 0 && body > best->body))) return limit;  // no nearer
      const auto found = from(slot, limit);
      if (found && (!best || isNearer(*found, *best))) {
        best = found;
        limit = std::min(limit, best->result.distance);
      }
      return limit;
    };
    if (guess != detail::kNoSlot) ask(guess);
    state_.tree.visitNear(
        bounds_, limit, [&](Slot slot) { return leastFrom(slot); }, ask);
    return best;
  }

  /// So many, the nearest first.
  std::vector<BodyDistance> nearestFew(std::size_t count) const {
    std::vector<BodyDistance> best;
    if (count == 0) return best;
    double limit = limit_;
    const auto ask = [&](Slot slot) {
      const auto found = from(slot, limit);
      if (!found || (best.size() == count && !isNearer(*found, best.back()))) return limit;
      if (best.size() == count) best.pop_back();
      best.insert(std::upper_bound(best.begin(), best.end(), *found, isNearer), *found);
      if (best.size() == count) limit = std::min(limit, best.back().result.distance);
      return limit;
    };
    state_.tree.visitNear(
        bounds_, limit, [&](Slot slot) { return leastFrom(slot); }, ask);
    return best;
  }

 private:
  const SceneState& state_;
  const Polygon& polygon_;
  const Pose& pose_;
  const double limit_;
  const DistanceOptions& options_;
  const detail::SlotFilter filter_;
  /// Boxes hold the bodies' margins, this one the query's own: a result is what margins leave of a distance.
  detail::Bounds bounds_;
  mutable std::optional<detail::WorldDisc> disc_;
};

}  // namespace

std::optional<BodyDistance> Scene::nearest(const Polygon& polygon, const Pose& pose, const DistanceOptions& options,
                                           const BodyFilter& filter) const {
  return AskedDistance(impl_->settled(), polygon, pose, kInfinity, options, filter).nearest();
}

std::optional<BodyDistance> Scene::nearest(const Polygon& polygon, const Pose& pose, SceneCache& cache,
                                           const DistanceOptions& options, const BodyFilter& filter) const {
  detail::SceneFact& fact = detail::factsIn(cache);
  const AskedDistance asked(impl_->settled(), polygon, pose, kInfinity, options, filter);
  // After a jump the last one is as good as any other body, and costs a look at it.
  const bool helps =
      fact.nearest_scene == impl_->id && asked.isNear(fact.nearest_point, fact.nearest_reach) && contains(fact.nearest);
  const auto best = asked.nearest(helps ? slotOf(fact.nearest) : detail::kNoSlot);
  fact.nearest_scene = best ? impl_->id : 0;
  if (!best) return best;
  const detail::Bounds box = impl_->tree.boundsOf(slotOf(best->body));
  fact.nearest = best->body;
  fact.nearest_point = best->result.point_b;
  fact.nearest_reach = 2 * best->result.distance + (box.max_x - box.min_x) + (box.max_y - box.min_y);
  return best;
}

std::optional<BodyDistance> Scene::nearestWithin(const Polygon& polygon, const Pose& pose, double limit,
                                                 const DistanceOptions& options, const BodyFilter& filter) const {
  detail::requireNotNegative(limit, "limit");
  return AskedDistance(impl_->settled(), polygon, pose, limit, options, filter).nearest();
}

std::vector<BodyDistance> Scene::nearestFew(const Polygon& polygon, const Pose& pose, std::size_t count, double limit,
                                            const DistanceOptions& options, const BodyFilter& filter) const {
  detail::requireNotNegative(limit, "limit");
  return AskedDistance(impl_->settled(), polygon, pose, limit, options, filter).nearestFew(count);
}

}  // namespace tricover
