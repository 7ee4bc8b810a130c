// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_chain_shape.h>
#include <box2d/b2_dynamic_tree.h>
#include <box2d/b2_polygon_shape.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "scenes/placed.h"
#include "tricover/polygon.h"

namespace tricover::bench {

/// Convex polygons of at most 8 vertices in a b2BroadPhase, which tells of the pairs whose boxes, grown by the motion,
/// have begun to meet; they are kept, as a b2World's contacts are, while those boxes meet, and b2TestOverlap decides.
class Box2dCrowd {
 public:
  /// One body a pose, with shapes[i % size]. `scale`: Box2D's units for one of ours.
  Box2dCrowd(const std::vector<Polygon>& shapes, const std::vector<Pose>& poses, float scale);

  /// Converts poses, before they are timed.
  std::vector<b2Transform> transforms(const std::vector<Pose>& poses) const;

  void move(std::size_t body, const b2Transform& transform);

  /// Calls visit(i, j), i < j, for the pairs that touch now.
  template <class Visit>
  void forEachTouching(Visit visit) {
    phase_.UpdatePairs(this);
    for (std::size_t k = 0; k < pairs_.size();) {
      const auto [i, j] = pairs_[k];
      if (!phase_.TestOverlap(bodies_[i].proxy, bodies_[j].proxy)) {
        drop(k);
        continue;
      }
      if (b2TestOverlap(bodies_[i].shape, 0, bodies_[j].shape, 0, bodies_[i].transform, bodies_[j].transform)) {
        visit(i, j);
      }
      ++k;
    }
  }

  void AddPair(void* first, void* second);  ///< for b2BroadPhase

 private:
  struct Body {
    const b2PolygonShape* shape;
    b2Transform transform;
    b2Vec2 centre;
    std::int32_t proxy;
    std::vector<std::uint32_t> partners;  ///< those of higher indices
  };

  b2AABB boxOf(const Body& body) const;
  void drop(std::size_t pair);

  float scale_;
  std::vector<b2PolygonShape> shapes_;
  std::vector<Body> bodies_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  b2BroadPhase phase_;
};

/// Rays against a b2DynamicTree: each rectangle a b2PolygonShape, all other rings loops of a b2ChainShape, whose edges
/// are leaves of their own, as in Box2D's fixtures.
class Box2dRays {
 public:
  Box2dRays(const Placement& placement, const std::vector<Ray>& rays);

  /// The fraction of ray i; infinity where it hits nothing.
  double value(std::size_t i);

  float RayCastCallback(const b2RayCastInput& input, std::int32_t proxy);  ///< for b2DynamicTree

 private:
  struct Leaf {
    const b2Shape* shape;
    std::int32_t child;
    b2Transform transform;
  };

  void addLeaves(std::unique_ptr<b2Shape> shape, const Pose& pose);

  std::vector<std::unique_ptr<b2Shape>> shapes_;
  std::deque<Leaf> leaves_;
  b2DynamicTree tree_;
  std::vector<b2RayCastInput> rays_;
  float nearest_ = 0;
};

}  // namespace tricover::bench
