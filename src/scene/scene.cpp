// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/scene.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "overlay/interiors.h"
#include "scene/in_parallel.h"
#include "scene/scene_state.h"

namespace tricover {
namespace {

void check(const BodyOptions& options) {
  detail::requireFiniteMargin(options.margin, "margin");
  detail::requireTouching(options.touching);
}

}  // namespace

Scene::Scene() : impl_(std::make_unique<detail::SceneState>()) {}
Scene::~Scene() = default;
Scene::Scene(const Scene& other) : impl_(std::make_unique<detail::SceneState>(other.impl_->settled())) {
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
  check(options);
  detail::requireRigid(pose, "pose");
  impl_->makeRoomFor(1);
  return impl_->handleOf(impl_->put(polygon, pose, options));
}

std::vector<Scene::Body> Scene::add(const std::vector<BodyPlacement>& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyPlacement& body = bodies[i];
    const auto name = [&](const char* field) { return "bodies[" + std::to_string(i) + "]." + field; };
    if (!std::isfinite(body.options.margin))
      detail::requireFiniteMargin(body.options.margin, name("options.margin").c_str());
    check(body.options);
    if (!detail::isPlainlyRigid(body.pose)) detail::requireRigid(body.pose, name("pose").c_str());
  }
  impl_->makeRoomFor(bodies.size());
  std::vector<Body> handles;
  handles.reserve(bodies.size());
  for (const BodyPlacement& body : bodies)
    handles.push_back(impl_->handleOf(impl_->put(body.polygon, body.pose, body.options)));
  return handles;
}

void Scene::remove(Body body) {
  detail::SceneState& impl = *impl_;
  const detail::Slot slot = impl.slot(body);
  detail::SceneState::BodyState& state = impl.bodies[slot];
  detail::makeRoom(impl.lost, state.links.size());
  detail::makeRoom(impl.free_pairs, state.links.size());
  detail::makeRoom(impl.unreported, 1);
  detail::makeRoom(impl.free_bodies, impl.unreported.size() + 1);
  const std::size_t before = impl.lost.size();
  while (!state.links.empty()) impl.unlink(state.links.back().pair);
  auto pair = impl.ignored.lower_bound({slot, 0});
  while (pair != impl.ignored.end() && (*pair)[0] == slot) {
    impl.ignored.erase({(*pair)[1], slot});
    pair = impl.ignored.erase(pair);
  }
  if (impl.tree.holds(slot)) impl.tree.remove(slot);
  // Until collisions() has reported that its pairs ended, the slot isn't given to another body; nor ever again after as
  // many bodies as handles count.
  if (++impl.tenancies[slot].changes != 0)
    (impl.lost.size() == before ? impl.free_bodies : impl.unreported).push_back(slot);
  --impl.count;
}

void Scene::move(Body body, const Pose& pose) {
  const detail::Slot slot = impl_->slot(body);
  detail::requireRigid(pose, "pose");
  impl_->moveBody(slot, pose);
}

void Scene::move(const std::vector<BodyPose>& poses, const Parallel& parallel) { impl_->moveBodies(poses, parallel); }

std::size_t Scene::size() const { return impl_->count; }
std::vector<Scene::Body> Scene::bodies() const {
  std::vector<Body> all;
  all.reserve(size());
  for (detail::Slot slot = 0; slot < impl_->bodies.size(); ++slot)
    if (impl_->isUsed(slot)) all.push_back(impl_->handleOf(slot));
  std::sort(all.begin(), all.end());
  return all;
}
bool Scene::contains(Body body) const { return impl_->has(body); }
const Polygon& Scene::polygon(Body body) const { return impl_->bodies[impl_->slot(body)].polygon; }
const Pose& Scene::pose(Body body) const { return impl_->bodies[impl_->slot(body)].pose; }
const BodyOptions& Scene::options(Body body) const { return impl_->bodies[impl_->slot(body)].options; }

void Scene::setOptions(Body body, const BodyOptions& options) {
  const detail::Slot slot = impl_->slot(body);
  check(options);
  impl_->setOptions(slot, options);
}

void Scene::setIgnored(Body a, Body b, bool ignored) {
  const detail::Slot first = impl_->slot(a), second = impl_->slot(b);
  if (first == second) detail::refuse("b", "it is a, and a body doesn't meet itself", "name two bodies");
  impl_->setIgnored(first, second, ignored);
}
bool Scene::isIgnored(Body a, Body b) const { return impl_->ignores(impl_->slot(a), impl_->slot(b)); }

const std::vector<BodyPair>& Scene::collisions(const Parallel& parallel) {
  impl_->updateCollisions(parallel);
  return impl_->collisions;
}
const std::vector<BodyPair>& Scene::began() const { return impl_->began; }
const std::vector<BodyPair>& Scene::ended() const { return impl_->ended; }

}  // namespace tricover
