// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "families.h"
#include "random.h"
#include "refusal.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover_fcl::test {

using tricover::Polygon;
using tricover::Pose;
using tricover::Ring;
using tricover::Vec2;
using tricover::support::Case;
using tricover::support::families;
using tricover::support::Family;
using tricover::support::mirrored;
using tricover::support::nudged;
using tricover::support::Random;
using tricover::support::randomPose;
using tricover::support::rectangle;
using tricover::support::regular;
using tricover::support::reproduction;
using tricover::support::scaledCount;
using tricover::support::star;
using tricover::support::turnedAndMoved;

using Body = fcl::CollisionGeometryd;
using Transform = fcl::Transform3d;
using Vec3 = fcl::Vector3d;

template <typename S>
using Shape = std::shared_ptr<PolygonShape<S>>;

inline const Transform kHere = Transform::Identity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
constexpr fcl::GJKSolverType kSolvers[] = {fcl::GST_LIBCCD, fcl::GST_INDEP};

template <typename S = double>
Shape<S> shapeOf(const Polygon& polygon, const PolygonOptions& options = {}) {
  return std::make_shared<PolygonShape<S>>(polygon, options);
}

template <typename S = double>
Shape<S> withMargin(const Polygon& polygon, double margin) {
  return shapeOf<S>(polygon, {margin, 0, 0});
}

template <typename S = double>
Shape<S> rectangular(double x_low, double y_low, double x_high, double y_high, const PolygonOptions& options = {}) {
  return shapeOf<S>(Polygon({rectangle(x_low, y_low, x_high, y_high)}), options);
}

/// The planar pose in space, at height z.
template <typename S = double>
fcl::Transform3<S> lifted(const Pose& pose, double z = 0) {
  fcl::Transform3<S> transform = fcl::Transform3<S>::Identity();
  transform.matrix().template topLeftCorner<2, 2>() = pose.linear().cast<S>();
  transform.translation() << static_cast<S>(pose.translation().x()), static_cast<S>(pose.translation().y()),
      static_cast<S>(z);
  return transform;
}

/// Turned about z, and moved.
template <typename S = double>
fcl::Transform3<S> lifted(double angle, double x, double y, double z = 0) {
  return lifted<S>(turnedAndMoved(angle, x, y), z);
}

/// What FCL's transform does in the plane, exactly. Not inline: where GCC 12 sees double turned into float and back,
/// its vectoriser leaves out the rounding.
template <typename S>
Pose flat(const fcl::Transform3<S>& transform);

/// Not convex, half of them with a hole.
inline Polygon randomPolygon(Random& random, double size) {
  std::vector<Ring> rings = {star(random, random.integer(5, 16), 0.4 * size, size)};
  if (random.coin()) rings.push_back(star(random, 7, 0.1 * size, 0.3 * size));
  return Polygon(rings);
}

/// In the polygon's own frame.
template <typename S>
void expectOnEdge(const PolygonShape<S>& shape, std::intptr_t edge, const Vec2& point) {
  ASSERT_GE(edge, 0);
  const Vec2 start = shape.polygon().edgeStart(edge), end = shape.polygon().edgeEnd(edge);
  EXPECT_NEAR((point - start).norm() + (end - point).norm(), (end - start).norm(), 1e-12);
}

/// What `query` throws, or an empty string.
template <typename Exception = std::invalid_argument, typename Query>
std::string thrownBy(const Query& query) {
  return tricover::support::refusal<Exception>(query);
}

/// `query` throws, with all of these words in its text.
template <typename Exception = std::invalid_argument, typename Query>
void expectRefused(std::initializer_list<std::string> words, const Query& query) {
  const std::string text = thrownBy<Exception>(query);
  EXPECT_NE(text, "");
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << ": " << text;
}

}  // namespace tricover_fcl::test
