// SPDX-License-Identifier: BSD-3-Clause
#include "box2d_scene.h"

#include <algorithm>
#include <limits>

#include "box2d.h"

namespace tricover::bench {
namespace {

void* asUserData(std::uint32_t body) { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(body)); }
std::uint32_t bodyOf(void* user_data) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(user_data));
}

/// Rays are long and Box2D's floats few: one of its units is one of ours.
constexpr float kRayScale = 1;

std::unique_ptr<b2Shape> loopOf(const Ring& ring) {
  std::vector<b2Vec2> vertices;
  for (const Vec2& v : ring) {
    const b2Vec2 vertex = box2dVector(v, kRayScale);
    // It refuses vertices as close as its slop.
    if (vertices.empty() || b2Distance(vertices.back(), vertex) > 2 * b2_linearSlop) vertices.push_back(vertex);
  }
  if (b2Distance(vertices.back(), vertices.front()) <= 2 * b2_linearSlop) vertices.pop_back();
  auto chain = std::make_unique<b2ChainShape>();
  chain->CreateLoop(vertices.data(), static_cast<int>(vertices.size()));
  return chain;
}

}  // namespace

Box2dCrowd::Box2dCrowd(const std::vector<Polygon>& shapes, const std::vector<Pose>& poses, float scale)
    : scale_(scale) {
  for (const Polygon& shape : shapes) shapes_.push_back(box2dShape(shape, scale));
  bodies_.reserve(poses.size());
  for (const b2Transform& transform : transforms(poses)) {
    const auto i = static_cast<std::uint32_t>(bodies_.size());
    bodies_.push_back({&shapes_[i % shapes_.size()], transform, transform.p, 0, {}});
    const b2AABB box = boxOf(bodies_[i]);
    bodies_[i].centre = box.GetCenter();
    bodies_[i].proxy = phase_.CreateProxy(box, asUserData(i));
  }
}

std::vector<b2Transform> Box2dCrowd::transforms(const std::vector<Pose>& poses) const {
  std::vector<b2Transform> transforms;
  for (const Pose& pose : poses) transforms.push_back(box2dTransform(pose, scale_));
  return transforms;
}

b2AABB Box2dCrowd::boxOf(const Body& body) const {
  b2AABB box;
  body.shape->ComputeAABB(&box, body.transform, 0);
  return box;
}

void Box2dCrowd::move(std::size_t i, const b2Transform& transform) {
  Body& body = bodies_[i];
  body.transform = transform;
  const b2AABB box = boxOf(body);
  const b2Vec2 centre = box.GetCenter();
  phase_.MoveProxy(body.proxy, box, centre - body.centre);
  body.centre = centre;
}

void Box2dCrowd::AddPair(void* first, void* second) {
  const std::uint32_t i = std::min(bodyOf(first), bodyOf(second)), j = std::max(bodyOf(first), bodyOf(second));
  std::vector<std::uint32_t>& partners = bodies_[i].partners;
  if (std::find(partners.begin(), partners.end(), j) != partners.end()) return;
  partners.push_back(j);
  pairs_.emplace_back(i, j);
}

void Box2dCrowd::drop(std::size_t pair) {
  const auto [i, j] = pairs_[pair];
  std::vector<std::uint32_t>& partners = bodies_[i].partners;
  *std::find(partners.begin(), partners.end(), j) = partners.back();
  partners.pop_back();
  pairs_[pair] = pairs_.back();
  pairs_.pop_back();
}

Box2dRays::Box2dRays(const Placement& placement, const std::vector<Ray>& rays) {
  for (const auto& [polygon, pose] : placement) {
    if (polygon.vertexCount() == 4) {
      addLeaves(std::make_unique<b2PolygonShape>(box2dShape(polygon, kRayScale)), pose);
      continue;
    }
    for (const Ring& ring : polygon.rings()) addLeaves(loopOf(ring), pose);
  }
  for (const auto& [from, to] : rays) {
    rays_.push_back({box2dVector(from, kRayScale), box2dVector(to, kRayScale), 1});
  }
}

void Box2dRays::addLeaves(std::unique_ptr<b2Shape> shape, const Pose& pose) {
  const b2Transform transform = box2dTransform(pose, kRayScale);
  for (std::int32_t child = 0; child < shape->GetChildCount(); ++child) {
    leaves_.push_back({shape.get(), child, transform});
    b2AABB box;
    shape->ComputeAABB(&box, transform, child);
    tree_.CreateProxy(box, &leaves_.back());
  }
  shapes_.push_back(std::move(shape));
}

float Box2dRays::RayCastCallback(const b2RayCastInput& input, std::int32_t proxy) {
  const Leaf& leaf = *static_cast<const Leaf*>(tree_.GetUserData(proxy));
  b2RayCastOutput output;
  if (!leaf.shape->RayCast(&output, input, leaf.transform, leaf.child)) return -1;
  nearest_ = std::min(nearest_, output.fraction);
  return output.fraction;
}

double Box2dRays::value(std::size_t i) {
  nearest_ = std::numeric_limits<float>::infinity();
  tree_.RayCast(this, rays_[i]);
  return static_cast<double>(nearest_);
}

}  // namespace tricover::bench
