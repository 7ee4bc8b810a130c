// SPDX-License-Identifier: BSD-3-Clause
// Which bodies a polygon collides with.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "overlay/interiors.h"
#include "pair/discs.h"
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
      : state_(state), polygon_(polygon), pose_(pose), options_(options), filter_(state.slots(filter)) {
    detail::requireFiniteMargin(options.margin, "margin");
    detail::requireFiniteNotNegative(options.tolerance, "tolerance");
    detail::requireTouching(options.touching);
    detail::requireRigid(pose, "pose");
    bounds_ = boundsOf(polygon.data(), pose, detail::marginOfBox(options.margin));
  }

  /// Returns a body that collides. Discs come first: two inner discs that meet save the tests of all outlines, which
  /// wait.
  std::optional<BodyHandle> anyColliding() const {
    std::array<Slot, kMostWaiting> waiting;
    std::size_t count = 0;
    std::optional<BodyHandle> found;
    visitNear([&](Slot slot, bool discs_meet) {
      if (discs_meet || (count == kMostWaiting && outlinesMeet(slot)))
        found = state_.handleOf(slot);
      else if (count < kMostWaiting)
        waiting[count++] = slot;
      return !found;
    });
    for (std::size_t i = 0; i < count && !found; ++i)
      if (outlinesMeet(waiting[i])) found = state_.handleOf(waiting[i]);
    return found;
  }

  std::vector<BodyHandle> colliding() const {
    std::vector<BodyHandle> found;
    visitNear([&](Slot slot, bool discs_meet) {
      if (discs_meet || outlinesMeet(slot)) found.push_back(state_.handleOf(slot));
      return true;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  /// More bodies than these don't wait.
  static constexpr std::size_t kMostWaiting = 8;

  /// Calls visit(slot, discs_meet) for the bodies whose boxes meet the query's box, until it returns false.
  /// `discs_meet`: the inner discs prove that the body collides.
  template <typename Visit>
  void visitNear(const Visit& visit) const {
    state_.tree.visit(bounds_, [&](Slot slot) {
      const auto& body = state_.bodies[slot];
      if (!state_.passes(filter_, slot) || body.clear.holds(bounds_)) return true;
      const CollideOptions options = detail::withBody(options_, body.options);
      const detail::PolygonData& other = body.polygon.data();
      const detail::PosedPair pair(polygon_.data(), pose_, other, body.pose);
      // The discs of points and segments have no interior. A depth is asked of outlines alone.
      const bool may_touch = options.margin >= 0 && (!detail::asksForInteriors(options) ||
                                                     !(polygon_.data().isDegenerate() || other.isDegenerate()));
      return visit(slot, depthOfDiscs(pair, options.margin) >= 0 && may_touch);
    });
  }

  /// Tests what discs don't decide.
  bool outlinesMeet(Slot slot) const {
    const auto& body = state_.bodies[slot];
    const CollideOptions options = detail::withBody(options_, body.options);
    if (collide(polygon_, pose_, body.polygon, body.pose, options)) return true;
    if (options.touching == Touching::Collides && options.margin >= 0)
      body.clear.learn(body.polygon.data(), body.pose, detail::marginOfBox(body.options.margin),
                       state_.tree.boundsOf(slot), bounds_);
    return false;
  }

  const SceneState& state_;
  const Polygon& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const detail::SlotFilter filter_;
  Bounds bounds_;  ///< around all points within the query's margin
};

}  // namespace

bool Scene::collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) const {
  return anyColliding(polygon, pose, options, filter).has_value();
}

std::vector<bool> Scene::collides(const Polygon& polygon, const std::vector<Pose>& poses, const CollideOptions& options,
                                  const BodyFilter& filter, const Parallel& parallel) const {
  for (std::size_t i = 0; i < poses.size(); ++i) detail::requireRigid(poses[i], "poses", i);
  std::vector<char> answers(poses.size());  // threads can't share a vector of bits
  detail::inParallelTasks(parallel, poses.size(),
                          [&](std::size_t i) { answers[i] = collides(polygon, poses[i], options, filter); });
  return {answers.begin(), answers.end()};
}

std::optional<Scene::Body> Scene::anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                               const BodyFilter& filter) const {
  return CollisionQuery(impl_->settled(), polygon, pose, options, filter).anyColliding();
}

std::vector<Scene::Body> Scene::colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                          const BodyFilter& filter) const {
  return CollisionQuery(impl_->settled(), polygon, pose, options, filter).colliding();
}

}  // namespace tricover
