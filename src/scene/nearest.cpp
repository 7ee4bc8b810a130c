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
#include "scene/scene_state.h"

namespace tricover {

using detail::SceneState;
using detail::Slot;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isNearer(const BodyDistance& p, const BodyDistance& q) {
  return std::pair(p.result.distance, p.body) < std::pair(q.result.distance, q.body);
}

/// A posed polygon whose distances from the bodies that pass a filter are computed, up to a limit.
class NearestQuery {
 public:
  NearestQuery(const SceneState& state, const Polygon& polygon, const Pose& pose, double limit,
               const DistanceOptions& options, const BodyFilter& filter)
      : state_(state), polygon_(polygon), pose_(pose), limit_(limit), options_(options), filter_(state.slots(filter)) {
    detail::checkOptions(options);
    detail::requireRigid(pose, "pose");
  }

  /// Returns the `count` nearest bodies, the nearest first. The tree proposes bodies by the distances of their boxes.
  std::vector<BodyDistance> nearest(std::size_t count) const {
    std::vector<BodyDistance> best;
    if (count == 0) return best;
    double limit = limit_;
    // Boxes hold the bodies' margins, this one holds the query's: a result is what margins leave of a distance.
    const detail::Bounds bounds = boundsOf(polygon_.data(), pose_, options_.margin);
    state_.tree.visitNear(bounds, limit, [&](Slot slot) {
      const bool is_full = best.size() == count;
      if (is_full && limit == 0 && state_.handleOf(slot) > best.back().body) return limit;
      const auto found = distanceFrom(slot, limit);
      if (!found || (is_full && !isNearer(*found, best.back()))) return limit;
      if (is_full) best.pop_back();
      best.insert(std::upper_bound(best.begin(), best.end(), *found, isNearer), *found);
      if (best.size() == count) limit = std::min(limit, best.back().result.distance);
      return limit;
    });
    return best;
  }

  std::optional<BodyDistance> nearest() const {
    const auto best = nearest(1);
    return best.empty() ? std::nullopt : std::optional(best.front());
  }

 private:
  /// Returns nothing if the body doesn't pass the filter or is beyond the limit.
  std::optional<BodyDistance> distanceFrom(Slot slot, double limit) const {
    if (!state_.passes(filter_, slot)) return std::nullopt;
    const auto& body = state_.bodies[slot];
    DistanceOptions sum = options_;
    sum.margin = detail::marginSum(options_.margin, body.options.margin);
    auto result = distanceWithin(polygon_, pose_, body.polygon, body.pose, limit, sum);
    // Another body's distance cuts off what this distance was rounded up by. The result must not depend on the order
    // in which bodies are visited.
    if (result && result->distance == limit && 0 < limit && limit < limit_)
      result = distanceWithin(polygon_, pose_, body.polygon, body.pose, limit_, sum);
    if (!result || result->distance == kInfinity) return std::nullopt;
    return BodyDistance{state_.handleOf(slot), *result};
  }

  const SceneState& state_;
  const Polygon& polygon_;
  const Pose& pose_;
  const double limit_;
  const DistanceOptions& options_;
  const detail::SlotFilter filter_;
};

}  // namespace

std::optional<BodyDistance> Scene::nearest(const Polygon& polygon, const Pose& pose, const DistanceOptions& options,
                                           const BodyFilter& filter) const {
  return NearestQuery(impl_->settled(), polygon, pose, kInfinity, options, filter).nearest();
}

std::optional<BodyDistance> Scene::nearestWithin(const Polygon& polygon, const Pose& pose, double limit,
                                                 const DistanceOptions& options, const BodyFilter& filter) const {
  detail::requireNotNegative(limit, "limit");
  return NearestQuery(impl_->settled(), polygon, pose, limit, options, filter).nearest();
}

std::vector<BodyDistance> Scene::nearestK(const Polygon& polygon, const Pose& pose, std::size_t count, double limit,
                                          const DistanceOptions& options, const BodyFilter& filter) const {
  detail::requireNotNegative(limit, "limit");
  return NearestQuery(impl_->settled(), polygon, pose, limit, options, filter).nearest(count);
}

}  // namespace tricover
