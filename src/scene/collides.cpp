// SPDX-License-Identifier: BSD-3-Clause
// Which bodies a polygon collides with.
#include <algorithm>
#include <optional>
#include <vector>

#include "scene/asked.h"

namespace tricover {
namespace detail {

BodyHandle findMet(const SceneState& state, const Asked& asked, const BodyFilter& filter) {
  // All discs first: one that is met spares all that is near. What is near waits in order. Where bodies are many, the
  // polygon's own box leaves more of them out than its disc's.
  constexpr int kMost = 16, kSparse = 2;
  struct Waiting {
    double rank;
    BodyHandle body;
  } near[kMost];
  int count = 0;
  BodyHandle met = kNoBody;
  int seen = 0;
  state.tree.visit(asked.surroundings(), [&](BodyHandle body) {
    if (++seen > kSparse && !state.tree.boundsOf(body).meets(asked.bounds())) return true;
    const auto& other = state.bodies[body];
    if (!state.passes(filter, body)) return true;
    const Asked::Glance glance = asked.glance(other);
    if (glance.answer == Asked::Glance::Apart) return true;
    if (glance.answer == Asked::Glance::Meets ||
        (count == kMost && asked.meetsClose(other, state.tree.boundsOf(body)))) {
      met = body;
      return false;
    }
    if (count == kMost) return true;
    int place = count++;
    for (; place > 0 && glance.rank < near[place - 1].rank; --place) near[place] = near[place - 1];
    near[place] = {glance.rank, body};
    return true;
  });
  if (met != kNoBody || count == 0) return met;
  const Waiting* first = std::find_if(near, near + count, [&](const Waiting& some) {
    return asked.meetsClose(state.bodies[some.body], state.tree.boundsOf(some.body));
  });
  return first == near + count ? kNoBody : first->body;
}

}  // namespace detail

using detail::Asked;
using detail::SceneState;

bool Scene::collides(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                     const BodyFilter& filter) const {
  detail::checkAsked(pose, options);
  return findMet(impl_->settled(), Asked(polygon.data(), pose, options), filter) != kNoBody;
}

std::optional<Scene::Body> Scene::anyColliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                               const BodyFilter& filter) const {
  detail::checkAsked(pose, options);
  const Body met = findMet(impl_->settled(), Asked(polygon.data(), pose, options), filter);
  return met != kNoBody ? std::optional<Body>(met) : std::nullopt;
}

std::vector<Scene::Body> Scene::colliding(const Polygon& polygon, const Pose& pose, const CollideOptions& options,
                                          const BodyFilter& filter) const {
  detail::checkAsked(pose, options);
  const SceneState& state = impl_->settled();
  const Asked asked(polygon.data(), pose, options);
  std::vector<Body> found;
  state.tree.visit(asked.surroundings(), [&](Body body) {
    if (state.passes(filter, body) && asked.meets(state.bodies[body], state.tree.boundsOf(body))) found.push_back(body);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace tricover
