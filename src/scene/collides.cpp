// SPDX-License-Identifier: BSD-3-Clause
// Which bodies a polygon collides with.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "depth/collide.h"
#include "numbers/rigidity.h"
#include "scene/in_parallel.h"
#include "scene/scene_state.h"

namespace tricover {

using detail::Bounds;
using detail::SceneState;
using detail::Slot;

namespace {

/// A posed polygon that is tested against the bodies that pass a filter.
class CollisionQuery {
 public:
  CollisionQuery(const SceneState& state, const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                 const BodyFilter& filter)
      : state_(state), polygon_(detail::dataOf(polygon)), pose_(pose), options_(options), filter_(state.slots(filter)) {
    detail::checkOptions(options);
    defect_ = detail::requireRigid(pose, "pose");
    bounds_ = boundsOf(polygon_, pose, detail::marginOfBox(options.margin));
  }

  /// Calls found(slot) for each body that collides, until it returns false.
  template <typename Found>
  void forEachColliding(const Found& found) const {
    state_.tree.visit(bounds_, [&](Slot slot) {
      const bool is_asked = state_.passes(filter_, slot) && !state_.bodies[slot].clear.holds(bounds_);
      return !(is_asked && outlinesMeet(slot)) || found(slot);
    });
  }

 private:
  bool outlinesMeet(Slot slot) const {
    const auto& body = state_.bodies[slot];
    const detail::PolygonData& other = detail::dataOf(body.polygon);
    const CollideOptions options = detail::withBody(options_, body.options);
    const double defect = defect_ + detail::defectOf(body.pose);
    if (collideChecked(polygon_, pose_, other, body.pose, defect, nullptr, options)) return true;
    if (options.touching == Touching::Collides && options.margin >= 0 && body.clear.learnsOf(other))
      body.clear.learn(other, body.pose, detail::marginOfBox(body.options.margin), state_.tree.boundsOf(slot), bounds_);
    return false;
  }

  const SceneState& state_;
  const detail::PolygonData& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const detail::SlotFilter filter_;
  double defect_;  ///< defectOf() the pose
  Bounds bounds_;  ///< around all points within the query's margin
};

}  // namespace

bool Scene::collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) const {
  return anyColliding(polygon, pose, options, filter).has_value();
}

std::vector<bool> Scene::collides(const Polygon& polygon, const std::vector<Pose>& poses, const CollideOptions& options,
                                  const BodyFilter& filter, const Parallel& parallel) const {
  // Threads can't share a vector of bits.
  const auto answers = detail::answersAt<char>(
      poses, parallel, [&](const Pose& pose) { return collides(polygon, pose, options, filter); });
  return {answers.begin(), answers.end()};
}

std::optional<Scene::Body> Scene::anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                               const BodyFilter& filter) const {
  const SceneState& state = impl_->settled();
  std::optional<BodyHandle> found;
  CollisionQuery(state, polygon, pose, options, filter).forEachColliding([&](Slot slot) {
    found = state.handleOf(slot);
    return false;
  });
  return found;
}

std::vector<Scene::Body> Scene::colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                          const BodyFilter& filter) const {
  std::vector<BodyHandle> found;
  const auto list = [&](Body body) {
    found.push_back(body);
    return true;
  };
  visitColliding(polygon, pose, list, options, filter);
  std::sort(found.begin(), found.end());
  return found;
}

void Scene::visitColliding(const Polygon& polygon, const Pose& pose, const std::function<bool(Body)>& visit,
                           const CollideOptions& options, const BodyFilter& filter) const {
  if (!visit) detail::refuse("visit", "the function is empty");
  const SceneState& state = impl_->settled();
  CollisionQuery(state, polygon, pose, options, filter).forEachColliding([&](Slot slot) {
    return visit(state.handleOf(slot));
  });
}

}  // namespace tricover
