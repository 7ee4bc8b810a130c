// SPDX-License-Identifier: BSD-3-Clause
#include "box2d.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tricover::bench {

b2Vec2 box2dVector(const Vec2& v, float scale) {
  return {scale * static_cast<float>(v.x()), scale * static_cast<float>(v.y())};
}

static double angleOf(const Pose& pose) { return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)); }

b2Transform box2dTransform(const Pose& pose, float scale) {
  return {box2dVector(pose.translation(), scale), b2Rot(static_cast<float>(angleOf(pose)))};
}

b2PolygonShape box2dShape(const Polygon& polygon, float scale) {
  const Ring& ring = polygon.rings()[0];
  if (polygon.rings().size() > 1 || ring.size() > b2_maxPolygonVertices) {
    throw std::invalid_argument("polygon: Box2D takes one ring of at most 8 vertices");
  }
  b2Vec2 vertices[b2_maxPolygonVertices];
  for (std::size_t i = 0; i < ring.size(); ++i) vertices[i] = box2dVector(ring[i], scale);
  b2PolygonShape shape;
  shape.Set(vertices, static_cast<int>(ring.size()));
  // It takes the convex hull, and joins vertices that are close.
  if (shape.m_count != static_cast<int>(ring.size())) {
    throw std::invalid_argument("polygon: Box2D's hull has other vertices");
  }
  return shape;
}

bool box2dTakes(const Polygon& polygon) {
  return polygon.rings().size() == 1 && polygon.vertexCount() <= b2_maxPolygonVertices && polygon.isConvex();
}

Box2dPair::Box2dPair(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose)
    : fixed_(box2dShape(fixed)), moving_(box2dShape(moving)), fixed_transform_(box2dTransform(fixed_pose)) {}

void Box2dPair::prepare(const std::vector<Pose>& poses) {
  transforms_.clear();
  for (const Pose& pose : poses) transforms_.push_back(box2dTransform(pose));
}

double Box2dManifold::value(std::size_t i) {
  const b2Manifold found = manifold(i);
  if (found.pointCount == 0) return std::numeric_limits<double>::infinity();
  b2WorldManifold points;
  points.Initialize(&found, fixed_transform_, 0, transforms_[i], 0);
  float depth = 0;
  for (int k = 0; k < found.pointCount; ++k) depth = std::max(depth, -points.separations[k]);
  return static_cast<double>(depth / kBox2dScale);
}

Box2dDistance::Box2dDistance(const Polygon& fixed, const Polygon& moving, bool coherent, const Pose& fixed_pose)
    : Box2dPair(fixed, moving, fixed_pose), coherent_(coherent) {
  setProxies(input_);
  input_.transformA = fixed_transform_;
  input_.useRadii = false;
  cache_.count = 0;
}

Box2dImpact::Box2dImpact(const Polygon& fixed, const Polygon& moving, const Pose& fixed_pose)
    : Box2dPair(fixed, moving, fixed_pose) {
  setProxies(input_);
  input_.sweepA = {};
  input_.sweepA.c0 = input_.sweepA.c = fixed_transform_.p;
  input_.sweepA.a0 = input_.sweepA.a = fixed_transform_.q.GetAngle();
  input_.tMax = 1;
}

void Box2dImpact::prepare(const std::vector<Motion>& motions) {
  sweeps_.clear();
  for (const Motion& motion : motions) {
    const Vec2 from = motion.start * motion.pivot;
    const double angle = angleOf(motion.start);
    b2Sweep sweep{};
    sweep.localCenter = box2dVector(motion.pivot);
    sweep.c0 = box2dVector(from);
    sweep.c = box2dVector(from + motion.shift);
    sweep.a0 = static_cast<float>(angle);
    sweep.a = static_cast<float>(angle + motion.angle);
    sweeps_.push_back(sweep);
  }
}

double Box2dImpact::value(std::size_t i) {
  input_.sweepB = sweeps_[i];
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input_);
  return output.state == b2TOIOutput::e_separated ? std::numeric_limits<double>::infinity()
                                                  : static_cast<double>(output.t);
}

Box2dCast::Box2dCast(const Polygon& fixed, const Polygon& moving) : Box2dPair(fixed, moving) {
  setProxies(input_);
  input_.transformA = fixed_transform_;
}

void Box2dCast::prepare(const std::vector<Motion>& motions) {
  transforms_.clear();
  shifts_.clear();
  for (const Motion& motion : motions) {
    transforms_.push_back(box2dTransform(motion.start));
    shifts_.push_back(box2dVector(motion.shift));
  }
}

double Box2dCast::value(std::size_t i) {
  input_.transformB = transforms_[i];
  input_.translationB = shifts_[i];
  b2ShapeCastOutput output;
  return b2ShapeCast(&output, &input_) ? static_cast<double>(output.lambda) : std::numeric_limits<double>::infinity();
}

}  // namespace tricover::bench
