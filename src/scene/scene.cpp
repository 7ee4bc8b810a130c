// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/scene.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "scene/scene_state.h"

namespace tricover {
namespace {

/// No scene has 0.
std::uint64_t nextSceneId() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

Scene::Scene() : impl_(std::make_unique<detail::SceneState>()) { impl_->id = nextSceneId(); }
Scene::~Scene() = default;
Scene::Scene(Scene&& other) : Scene() { impl_.swap(other.impl_); }
Scene& Scene::operator=(Scene&& other) {
  Scene moved(std::move(other));
  impl_.swap(moved.impl_);
  return *this;
}

Scene::Body Scene::add(const Polygon& polygon, const Pose& pose, const BodyOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireRigid(pose, "pose");
  detail::SceneState& impl = *impl_;
  const bool anew = impl.free_bodies.empty();
  const Body body = anew ? static_cast<Body>(impl.bodies.size()) : impl.free_bodies.back();
  if (body >= detail::SceneState::kMostBodies)
    throw std::length_error(detail::refusal("scene", "more than 2^28 bodies"));
  const detail::Bounds bounds = detail::boundsOf(polygon.data(), pose, options.margin);
  // What may throw comes first. Lists have room for every body, so that none does later.
  if (anew) {
    detail::makeRoom(impl.bodies, 1);
    const std::size_t room = impl.bodies.capacity();
    for (auto* list : {&impl.fresh, &impl.due, &impl.free_bodies, &impl.mourned}) list->reserve(room);
  }
  impl.tree.insert(body, bounds);
  // Lists may still hold a removed body of that handle.
  const bool fresh = !anew && impl.bodies[body].fresh, listed = !anew && impl.bodies[body].listed;
  detail::SceneState::BodyState state{polygon, pose,  options, detail::WorldDiscs(polygon.data(), pose), 0, 0, 0, 0, {},
                                      true,    fresh, listed};
  if (anew) {
    impl.bodies.push_back(std::move(state));
  } else {
    impl.bodies[body] = std::move(state);
    impl.free_bodies.pop_back();
  }
  impl.listFresh(body);
  impl.listDue(body);
  ++impl.count;
  ++impl.version;
  return body;
}

void Scene::remove(Body body) {
  detail::SceneState& impl = *impl_;
  detail::SceneState::BodyState& state = impl.at(body);
  detail::makeRoom(impl.lost, state.links.size());
  detail::makeRoom(impl.free_pairs, state.links.size());
  const std::size_t before = impl.lost.size();
  while (!state.links.empty()) impl.unlink(state.links.back().pair);
  impl.tree.remove(body);
  state.used = false;
  // Until collisions() has reported that its pairs ended, the handle isn't given to another body.
  (impl.lost.size() == before ? impl.free_bodies : impl.mourned).push_back(body);
  --impl.count;
  ++impl.version;
}

void Scene::move(Body body, const Pose& pose) {
  impl_->at(body);
  detail::requireRigid(pose, "pose");
  impl_->moveBody(body, pose);
}

std::size_t Scene::size() const { return impl_->count; }
bool Scene::contains(Body body) const { return body < impl_->bodies.size() && impl_->bodies[body].used; }
const Polygon& Scene::polygon(Body body) const { return impl_->at(body).polygon; }
const Pose& Scene::pose(Body body) const { return impl_->at(body).pose; }
const BodyOptions& Scene::options(Body body) const { return impl_->at(body).options; }

const std::vector<BodyPair>& Scene::collisions() {
  impl_->updateCollisions();
  return impl_->collisions;
}
const std::vector<BodyPair>& Scene::began() const { return impl_->began; }
const std::vector<BodyPair>& Scene::ended() const { return impl_->ended; }

}  // namespace tricover
