// SPDX-License-Identifier: BSD-3-Clause
#include "box2d.h"

#include <cmath>
#include <stdexcept>

namespace tricover::bench {
namespace {

b2Vec2 scaled(const Vec2& v) {
  return {kBox2dScale * static_cast<float>(v.x()), kBox2dScale * static_cast<float>(v.y())};
}

b2PolygonShape box2dShape(const Polygon& polygon) {
  const Ring& ring = polygon.rings()[0];
  if (polygon.rings().size() > 1 || ring.size() > b2_maxPolygonVertices) {
    throw std::invalid_argument("polygon: Box2D takes one ring of at most 8 vertices");
  }
  b2Vec2 vertices[b2_maxPolygonVertices];
  for (std::size_t i = 0; i < ring.size(); ++i) vertices[i] = scaled(ring[i]);
  b2PolygonShape shape;
  shape.Set(vertices, static_cast<int>(ring.size()));
  // It takes the convex hull, and joins vertices that are close.
  if (shape.m_count != static_cast<int>(ring.size())) {
    throw std::invalid_argument("polygon: Box2D's hull has other vertices");
  }
  return shape;
}

}  // namespace

Box2dPair::Box2dPair(const Polygon& fixed, const Polygon& moving)
    : fixed_(box2dShape(fixed)), moving_(box2dShape(moving)) {
  identity_.SetIdentity();
}

void Box2dPair::prepare(const std::vector<Pose>& poses) {
  transforms_.clear();
  for (const Pose& pose : poses) {
    const double angle = std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
    transforms_.emplace_back(scaled(pose.translation()), b2Rot(static_cast<float>(angle)));
  }
}

}  // namespace tricover::bench
