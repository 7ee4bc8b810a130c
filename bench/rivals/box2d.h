// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <vector>

#include "tricover/motion.h"
#include "tricover/polygon.h"

namespace tricover::bench {

/// Box2D's units for one of ours. Box2D counts as touching what is closer than its skin, 0.02 of its metres, and it
/// computes in floats; this makes the skin 3e-6 of polygons of 100 units, about what floats resolve.
constexpr float kBox2dScale = 64;

/// Whether it is convex and has at most b2_maxPolygonVertices = 8 vertices.
bool box2dTakes(const Polygon& polygon);

/// In Box2D's units, by default those above.
b2Vec2 box2dVector(const Vec2& v, float scale = kBox2dScale);
b2Transform box2dTransform(const Pose& pose, float scale = kBox2dScale);

/// Throws std::invalid_argument for a polygon that Box2D can't hold as it is.
b2PolygonShape box2dShape(const Polygon& polygon, float scale = kBox2dScale);

/// The base of all of Box2D's calls: convex polygons of at most b2_maxPolygonVertices = 8 vertices.
class Box2dPair {
 public:
  /// Throws as box2dShape() does.
  Box2dPair(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose = Pose::Identity());

  void prepare(const std::vector<Pose>& poses);

 protected:
  template <class Input>
  void setProxies(Input& input) const {
    input.proxyA.Set(&fixed_, 0);
    input.proxyB.Set(&moving_, 0);
  }

  b2PolygonShape fixed_, moving_;
  b2Transform fixed_transform_;
  std::vector<b2Transform> transforms_;
};

/// b2TestOverlap: GJK.
class Box2dOverlap : public Box2dPair {
 public:
  using Box2dPair::Box2dPair;
  bool collide(std::size_t i) { return b2TestOverlap(&fixed_, 0, &moving_, 0, fixed_transform_, transforms_[i]); }
};

/// b2CollidePolygons: separating axes, and the manifold where there is none. Its points have depths, less the skin.
class Box2dManifold : public Box2dPair {
 public:
  using Box2dPair::Box2dPair;
  bool collide(std::size_t i) { return manifold(i).pointCount > 0; }
  /// The greatest depth; infinity where there is no point.
  double value(std::size_t i);

 private:
  b2Manifold manifold(std::size_t i) {
    b2Manifold found;
    b2CollidePolygons(&found, &fixed_, fixed_transform_, &moving_, transforms_[i]);
    return found;
  }
};

/// b2Distance, without the skin: GJK, which can start from its last simplex.
class Box2dDistance : public Box2dPair {
 public:
  Box2dDistance(const Polygon& fixed, const Polygon& moving, bool coherent, const Pose& fixed_pose = Pose::Identity());

  double value(std::size_t i) {
    if (!coherent_) cache_.count = 0;
    input_.transformB = transforms_[i];
    b2DistanceOutput output;
    b2Distance(&output, &cache_, &input_);
    return static_cast<double>(output.distance / kBox2dScale);
  }

 private:
  bool coherent_;
  b2DistanceInput input_;
  b2SimplexCache cache_;
};

/// b2TimeOfImpact. It stops a little before the skins touch, which are 3e-6 of the polygons' size.
class Box2dImpact : public Box2dPair {
 public:
  Box2dImpact(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose = Pose::Identity());

  void prepare(const std::vector<Motion>& motions);
  double value(std::size_t i);  ///< infinity where they don't meet

 private:
  b2TOIInput input_;
  std::vector<b2Sweep> sweeps_;
};

/// b2ShapeCast, of motions that don't turn: GJK along a ray. Like b2TimeOfImpact it stops where the skins touch.
class Box2dCast : public Box2dPair {
 public:
  Box2dCast(const Polygon& fixed, const Polygon& moving);

  void prepare(const std::vector<Motion>& motions);
  double value(std::size_t i);  ///< infinity where they don't meet

 private:
  b2ShapeCastInput input_;
  std::vector<b2Vec2> shifts_;
};

}  // namespace tricover::bench
