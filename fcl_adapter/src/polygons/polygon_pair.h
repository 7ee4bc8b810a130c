// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>

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
    requirePlanar(tf1, "pose_a");
    requirePlanar(tf2, "pose_b");
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

  /// Whether the two collide, if the discs around both shapes' own origins, which two discs are, tell that plainly:
  /// before facts are looked up and the kernel is asked. Of the two squares, the way's errs by 4U and the reach's by
  /// 9U; the last term is for what underflows.
  std::optional<bool> collidePlainly() const {
    constexpr double kSquares = 0x1p-48, kTiny = 0x1p-1000;
    const tricover::Vec2 way = pose_b.translation() - pose_a.translation();
    const auto square = [](double reach) { return reach * reach; };
    const double apart = way.squaredNorm(),
                 reach = static_cast<double>(shape_a.aabb_radius) + static_cast<double>(shape_b.aabb_radius);
    const bool is_free = apart > square(reach + (margin - (margin_a + margin_b))) * (1 + kSquares) + kTiny;
    const bool is_hit = shape_a.isDisc() && shape_b.isDisc() && apart < square(margin) * (1 - kSquares) - kTiny;
    if ((is_free || is_hit) && areRigid()) return is_hit;
    return std::nullopt;
  }

  /// Most poses that the kernel doesn't refuse.
  bool areRigid() const { return tricover::detail::isPlainlyRigid(pose_a) && tricover::detail::isPlainlyRigid(pose_b); }
};

}  // namespace tricover_fcl
