// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/scene.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "pair/interiors.h"
#include "scene/scene_state.h"

namespace tricover {
namespace {

/// No scene has 0.
std::uint64_t nextSceneId() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

void checkBody(const Pose& pose, const BodyOptions& options) {
  detail::requireFiniteNotNegative(options.margin, "margin");
  detail::requireTouching(options.touching);
  detail::requireRigid(pose, "pose");
}

}  // namespace

Scene::Scene() : impl_(std::make_unique<detail::SceneState>()) { impl_->id = nextSceneId(); }
Scene::~Scene() = default;
Scene::Scene(const Scene& other) : impl_(std::make_unique<detail::SceneState>(other.impl_->settled())) {
  impl_->id = nextSceneId();
  impl_->makeRoomFor(0);
}
Scene& Scene::operator=(const Scene& other) { return *this = Scene(other); }
Scene::Scene(Scene&& other) : Scene() { impl_.swap(other.impl_); }
Scene& Scene::operator=(Scene&& other) {
  Scene moved(std::move(other));
  impl_.swap(moved.impl_);
  return *this;
}

Scene::Body Scene::add(const Polygon& polygon, const Pose& pose, const BodyOptions& options) {
  checkBody(pose, options);
  impl_->makeRoomFor(1);
  return impl_->put(polygon, pose, options);
}

std::vector<Scene::Body> Scene::add(const std::vector<BodyPlacement>& bodies) {
  for (const BodyPlacement& body : bodies) checkBody(body.pose, body.options);
  impl_->makeRoomFor(bodies.size());
  std::vector<Body> handles;
  handles.reserve(bodies.size());
  for (const BodyPlacement& body : bodies) handles.push_back(impl_->put(body.polygon, body.pose, body.options));
  return handles;
}

void Scene::remove(Body body) {
  detail::SceneState& impl = *impl_;
  detail::SceneState::BodyState& state = impl.at(body);
  detail::makeRoom(impl.lost, state.links.size());
  detail::makeRoom(impl.free_pairs, state.links.size());
  detail::makeRoom(impl.unreported, 1);
  detail::makeRoom(impl.free_bodies, impl.unreported.size() + 1);
  const std::size_t before = impl.lost.size();
  while (!state.links.empty()) impl.unlink(state.links.back().pair);
  if (impl.tree.holds(body)) impl.tree.remove(body);
  state.used = false;
  // Until collisions() has reported that its pairs ended, the handle isn't given to another body.
  (impl.lost.size() == before ? impl.free_bodies : impl.unreported).push_back(body);
  --impl.count;
  ++impl.version;
}

void Scene::move(Body body, const Pose& pose) {
  impl_->at(body);
  detail::requireRigid(pose, "pose");
  impl_->moveBody(body, pose, impl_->stepTo(body, pose));
}

void Scene::move(const std::vector<BodyPose>& poses, const Parallel& parallel) { impl_->moveBodies(poses, parallel); }

std::size_t Scene::size() const { return impl_->count; }
std::vector<Scene::Body> Scene::bodies() const {
  std::vector<Body> all;
  all.reserve(size());
  for (Body body = 0; body < impl_->bodies.size(); ++body)
    if (contains(body)) all.push_back(body);
  return all;
}
bool Scene::contains(Body body) const { return body < impl_->bodies.size() && impl_->bodies[body].used; }
const Polygon& Scene::polygon(Body body) const { return impl_->at(body).polygon; }
const Pose& Scene::pose(Body body) const { return impl_->at(body).pose; }
const BodyOptions& Scene::options(Body body) const { return impl_->at(body).options; }

const std::vector<BodyPair>& Scene::collisions(const Parallel& parallel) {
  impl_->updateCollisions(parallel);
  return impl_->collisions;
}
const std::vector<BodyPair>& Scene::began() const { return impl_->began; }
const std::vector<BodyPair>& Scene::ended() const { return impl_->ended; }

}  // namespace tricover
