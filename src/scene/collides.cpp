// SPDX-License-Identifier: BSD-3-Clause
// Which bodies a polygon collides with.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/discs.h"
#include "pair/interiors.h"
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
    detail::requireFiniteNotNegative(options.margin, "margin");
    detail::requireFiniteNotNegative(options.tolerance, "tolerance");
    detail::requireTouching(options.touching);
    detail::requireRigid(pose, "pose");
    discs_ = detail::WorldDiscs(polygon.data(), pose);
    bounds_ = boundsOf(polygon.data(), pose, options.margin);
  }

  /// Returns a body that collides. Inner discs come first: two that meet save the tests of all outlines, which wait. Of
  /// these the body whose box shares the largest area with the query's box is the likeliest to collide.
  std::optional<BodyHandle> anyColliding() const {
    std::array<Waiting, kMostWaiting> waiting;
    std::size_t count = 0;
    std::optional<BodyHandle> found;
    visitNear([&](Slot slot, const Bounds& box) {
      const BodyState& body = state_.bodies[slot];
      if (innerDiscsMeet(body) || (count == kMostWaiting && outlinesMeet(body, box)))
        found = state_.handleOf(slot);
      else if (count < kMostWaiting)
        waiting[count++] = {slot, sharedArea(box)};
      return !found;
    });
    if (found || count == 0) return found;
    const auto end = waiting.begin() + static_cast<std::ptrdiff_t>(count);
    const auto isLess = [](const Waiting& p, const Waiting& q) { return p.shared_area < q.shared_area; };
    std::iter_swap(waiting.begin(), std::max_element(waiting.begin(), end, isLess));
    for (std::size_t i = 0; i < count; ++i) {
      const Slot slot = waiting[i].slot;
      if (outlinesMeet(state_.bodies[slot], state_.tree.boundsOf(slot))) return state_.handleOf(slot);
    }
    return found;
  }

  std::vector<BodyHandle> colliding() const {
    std::vector<BodyHandle> found;
    visitNear([&](Slot slot, const Bounds& box) {
      const BodyState& body = state_.bodies[slot];
      if (innerDiscsMeet(body) || outlinesMeet(body, box)) found.push_back(state_.handleOf(slot));
      return true;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  using BodyState = SceneState::BodyState;

  struct Waiting {
    Slot slot;
    double shared_area;
  };
  /// More bodies than these don't wait.
  static constexpr std::size_t kMostWaiting = 8;

  /// Calls visit(slot, box) for the bodies whose boxes meet the query's box, until it returns false.
  template <typename Visit>
  void visitNear(const Visit& visit) const {
    state_.tree.visit(bounds_, [&](Slot slot, const Bounds& box) {
      const bool is_near = state_.passes(filter_, slot) && !state_.bodies[slot].clear.holds(bounds_);
      return !is_near || visit(slot, box);
    });
  }

  double sharedArea(const Bounds& box) const {
    return (std::min(box.max_x, bounds_.max_x) - std::max(box.min_x, bounds_.min_x)) *
           (std::min(box.max_y, bounds_.max_y) - std::max(box.min_y, bounds_.min_y));
  }

  bool innerDiscsMeet(const BodyState& body) const {
    const CollideOptions options = detail::withBody(options_, body.options);
    const detail::WorldDiscs discs = body.discs.of(body.polygon.data(), body.pose);
    // The inner discs of points and segments have no interior.
    const bool are_open = discs_.inner_radius > 0 && discs.inner_radius > 0;
    return discs_.innerMeet(discs, options.margin) && (are_open || !detail::asksForInteriors(options));
  }

  /// Tests what inner discs don't decide.
  bool outlinesMeet(const BodyState& body, const Bounds& box) const {
    const CollideOptions options = detail::withBody(options_, body.options);
    const detail::WorldDiscs discs = body.discs.of(body.polygon.data(), body.pose);
    if (discs_.areApart(discs, options.margin)) return false;
    if (collide(polygon_, pose_, body.polygon, body.pose, options)) return true;
    if (options.touching == Touching::Collides)
      body.clear.learn(body.polygon.data(), body.pose, body.options.margin, box, bounds_);
    return false;
  }

  const SceneState& state_;
  const Polygon& polygon_;
  const Pose& pose_;
  const CollideOptions& options_;
  const detail::SlotFilter filter_;
  detail::WorldDiscs discs_;
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
