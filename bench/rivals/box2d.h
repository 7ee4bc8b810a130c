// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <vector>

#include "tricover/polygon.h"

namespace tricover::bench {

/// Box2D's units for one of ours. Box2D counts as touching what is closer than its skin, 0.02 of its metres, and it
/// computes in floats; this makes the skin 3e-6 of polygons of 100 units, about what floats resolve.
constexpr float kBox2dScale = 64;

/// What both of Box2D's calls need: convex polygons of at most b2_maxPolygonVertices = 8 vertices.
class Box2dPair {
 public:
  /// Throws std::invalid_argument for a polygon that Box2D can't hold as it is.
  Box2dPair(const Polygon& fixed, const Polygon& moving);

  void prepare(const std::vector<Pose>& poses);

 protected:
  b2PolygonShape fixed_, moving_;
  b2Transform identity_;
  std::vector<b2Transform> transforms_;
};

/// b2TestOverlap: GJK.
class Box2dOverlap : public Box2dPair {
 public:
  using Box2dPair::Box2dPair;
  bool collide(std::size_t i) { return b2TestOverlap(&fixed_, 0, &moving_, 0, identity_, transforms_[i]); }
};

/// b2CollidePolygons: separating axes, and the manifold where there is none.
class Box2dManifold : public Box2dPair {
 public:
  using Box2dPair::Box2dPair;
  bool collide(std::size_t i) {
    b2Manifold manifold;
    b2CollidePolygons(&manifold, &fixed_, identity_, &moving_, transforms_[i]);
    return manifold.pointCount > 0;
  }
};

}  // namespace tricover::bench
