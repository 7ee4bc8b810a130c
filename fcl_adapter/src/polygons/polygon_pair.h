// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "shape/heights.h"
#include "shape/planar_pair.h"
#include "shape/planar_pose.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Two polygons as a row gets them: `a` is its first geometry.
template <typename S>
struct PolygonPair final : PlanarPair {
  const PolygonShape<S>&shape_a, &shape_b;
  const fcl::Transform3<S>&tf_a, &tf_b;

  /// `more` is a length added to the margins.
  PolygonPair(const PolygonShape<S>& a_, const fcl::Transform3<S>& tf1, const PolygonShape<S>& b_,
              const fcl::Transform3<S>& tf2, double more = 0)
      : PlanarPair(a_.polygon(), b_.polygon(), a_.options().margin, b_.options().margin,
                   more + (a_.options().margin + b_.options().margin)),
        shape_a(a_),
        shape_b(b_),
        tf_a(tf1),
        tf_b(tf2) {
    requirePlanar(tf1, tf2);
    setPlanarPart(pose_a, tf1);
    setPlanarPart(pose_b, tf2);
    if ((shape_a.isDisc() && hasFewEdges(*b)) || (shape_b.isDisc() && hasFewEdges(*a))) return;
    place_a = &tf1;
    place_b = &tf2;
  }

  Heights heightsOfA() const { return heightsOf(shape_a.options(), tf_a); }
  Heights heightsOfB() const { return heightsOf(shape_b.options(), tf_b); }

  /// Exact, touching counts. Checks the poses if they don't, as the kernel, which then isn't asked, would.
  bool heightsMeet() const {
    const bool meet = shape_a.isFlat() && shape_b.isFlat() ? tf_a.matrix()(2, 3) == tf_b.matrix()(2, 3)
                                                           : share(heightsOfA(), heightsOfB());
    if (!meet) {
      tricover::checkPose(pose_a, "pose_a");
      tricover::checkPose(pose_b, "pose_b");
    }
    return meet;
  }
};

/// Whether the two collide, if the discs around both shapes' own origins, which two discs are, tell that plainly, and
/// both poses plainly keep the plane and are rigid: before anything else is made of them. Of the two squares, the way's
/// errs by 4U and the reach's by 9U; the last term is for what underflows.
template <typename S>
std::optional<bool> decidedByDiscs(const PolygonShape<S>& a, const fcl::Transform3<S>& tf1, const PolygonShape<S>& b,
                                   const fcl::Transform3<S>& tf2, double more) {
  using tricover::detail::Double2;
  constexpr double kSquares = 0x1p-48, kUnderflow = 0x1p-1000;
  const auto column = [](const fcl::Transform3<S>& tf, int k) {
    return Double2{static_cast<double>(tf.matrix()(0, k)), static_cast<double>(tf.matrix()(1, k))};
  };
  const auto square = [](double reach) { return reach * reach; };
  const Double2 way = column(tf2, 3) - column(tf1, 3);
  const double apart = tricover::detail::dot(way, way), margin = more + (a.options().margin + b.options().margin),
               reach = static_cast<double>(a.aabb_radius) + static_cast<double>(b.aabb_radius);
  const bool is_free = apart > square(reach + more) * (1 + kSquares) + kUnderflow;
  const bool is_hit = a.isDisc() && b.isDisc() && apart < square(margin) * (1 - kSquares) - kUnderflow;
  if (!is_free && !is_hit) return std::nullopt;
  const auto defectOf = [&](const fcl::Transform3<S>& tf) {
    return tricover::detail::Gram(column(tf, 0), column(tf, 1)).defect();
  };
  const double off = (defectOf(tf1) + defectOf(tf2)) + (tiltOf(tf1) + tiltOf(tf2));
  return off <= kTiltTolerance && std::isfinite(apart) ? std::optional(is_hit) : std::nullopt;
}
static_assert(kTiltTolerance < tricover::kRigidTolerance);

}  // namespace tricover_fcl
