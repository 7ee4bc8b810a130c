// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover_fcl::test {

using tricover::support::mirrored;
using tricover::support::nudged;
using tricover::support::Random;
using tricover::support::randomPose;
using tricover::support::rectangle;
using tricover::support::regular;
using tricover::support::scaledCount;
using tricover::support::star;

template <typename S>
using Shape = std::shared_ptr<PolygonShape<S>>;

template <typename S = double>
Shape<S> shapeOf(const tricover::Polygon& polygon) {
  return std::make_shared<PolygonShape<S>>(polygon);
}

inline Shape<double> rectangular(double x_low, double y_low, double x_high, double y_high) {
  return shapeOf(tricover::Polygon({rectangle(x_low, y_low, x_high, y_high)}));
}

/// The planar pose in space, at height z.
template <typename S = double>
fcl::Transform3<S> lifted(const tricover::Pose& pose, double z = 0) {
  fcl::Transform3<S> transform = fcl::Transform3<S>::Identity();
  transform.matrix().template topLeftCorner<2, 2>() = pose.linear().cast<S>();
  transform.translation() << static_cast<S>(pose.translation().x()), static_cast<S>(pose.translation().y()),
      static_cast<S>(z);
  return transform;
}

/// Turned about z, and moved.
template <typename S = double>
fcl::Transform3<S> lifted(double angle, double x, double y, double z = 0) {
  return lifted<S>(tricover::support::turnedAndMoved(angle, x, y), z);
}

/// What FCL's transform does in the plane, exactly. Not inline: where GCC 12 sees double turned into float and back,
/// its vectoriser leaves out the rounding.
template <typename S>
tricover::Pose flat(const fcl::Transform3<S>& transform);

/// Not convex, half of them with a hole.
inline tricover::Polygon randomPolygon(tricover::support::Random& random, double size) {
  std::vector<tricover::Ring> rings = {tricover::support::star(random, random.integer(5, 16), 0.4 * size, size)};
  if (random.coin()) rings.push_back(tricover::support::star(random, 7, 0.1 * size, 0.3 * size));
  return tricover::Polygon(rings);
}

/// In the polygon's own frame.
template <typename S>
void expectOnEdge(const PolygonShape<S>& shape, std::intptr_t edge, const tricover::Vec2& point) {
  ASSERT_GE(edge, 0);
  const tricover::Vec2 start = shape.polygon().edgeStart(edge), end = shape.polygon().edgeEnd(edge);
  EXPECT_NEAR((point - start).norm() + (end - point).norm(), (end - start).norm(), 1e-12);
}

/// What `query` throws, or an empty string.
template <typename Exception, typename Query>
std::string thrownBy(const Query& query) {
  try {
    query();
  } catch (const Exception& exception) {
    return exception.what();
  }
  return {};
}

}  // namespace tricover_fcl::test
