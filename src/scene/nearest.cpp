// SPDX-License-Identifier: BSD-3-Clause
// The bodies nearest to a polygon.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "distance/distance_query.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "scene/in_parallel.h"
#include "scene/scene_state.h"

namespace tricover {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isNearer(const BodyDistance& p, const BodyDistance& q) {
  return std::pair(p.result.distance, p.body) < std::pair(q.result.distance, q.body);
}

}  // namespace

/// The tree proposes bodies by the distances of their boxes.
std::vector<BodyDistance> Scene::nearestK(const Polygon& polygon, const Pose& pose, std::size_t most, double limit,
                                          const DistanceOptions& options, const BodyFilter& filter) const {
  detail::requireNotNegative(limit, "limit");
  const detail::SceneState& state = impl_->settled();
  const detail::SlotFilter slots = state.slots(filter);
  detail::checkOptions(options);
  detail::requireRigid(pose, "pose");
  std::vector<BodyDistance> best;
  if (most == 0) return best;
  double reach = limit;
  // Boxes hold the bodies' margins, this one holds the query's: a result is what margins leave of a distance.
  const detail::Bounds bounds = boundsOf(detail::dataOf(polygon), pose, options.margin);
  state.tree.visitNear(bounds, limit, [&](detail::Slot slot) {
    const bool is_full = best.size() == most;
    if (!state.passes(slots, slot)) return reach;
    if (is_full && reach == 0 && state.handleOf(slot) > best.back().body) return reach;
    const auto& body = state.bodies[slot];
    DistanceOptions sum = options;
    sum.margin = detail::marginOfBox(detail::marginSum(options.margin, body.options.margin));
    auto result = distanceWithin(polygon, pose, body.polygon, body.pose, reach, sum);
    // Another body's distance cuts off what this distance was rounded up by. The result must not depend on the order
    // in which bodies are visited.
    if (result && result->distance == reach && 0 < reach && reach < limit)
      result = distanceWithin(polygon, pose, body.polygon, body.pose, limit, sum);
    if (!result || result->distance == kInfinity) return reach;
    const BodyDistance found{state.handleOf(slot), *result};
    if (is_full && !isNearer(found, best.back())) return reach;
    if (is_full) best.pop_back();
    best.insert(std::upper_bound(best.begin(), best.end(), found, isNearer), found);
    if (best.size() == most) reach = std::min(reach, best.back().result.distance);
    return reach;
  });
  return best;
}

std::optional<BodyDistance> Scene::nearest(const Polygon& polygon, const Pose& pose, const DistanceOptions& options,
                                           const BodyFilter& filter) const {
  return nearestWithin(polygon, pose, kInfinity, options, filter);
}

std::vector<std::optional<BodyDistance>> Scene::nearest(const Polygon& polygon, const std::vector<Pose>& poses,
                                                        const DistanceOptions& options, const BodyFilter& filter,
                                                        const Parallel& parallel) const {
  return detail::answersAt<std::optional<BodyDistance>>(
      poses, parallel, [&](const Pose& pose) { return nearest(polygon, pose, options, filter); });
}

std::optional<BodyDistance> Scene::nearestWithin(const Polygon& polygon, const Pose& pose, double limit,
                                                 const DistanceOptions& options, const BodyFilter& filter) const {
  const std::vector<BodyDistance> best = nearestK(polygon, pose, 1, limit, options, filter);
  return best.empty() ? std::nullopt : std::optional(best.front());
}

}  // namespace tricover
