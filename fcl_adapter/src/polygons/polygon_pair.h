// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shape/heights.h"
#include "shape/planar_pair.h"
#include "shape/planar_pose.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Two polygons as a row gets them: `a` is its first geometry.
template <typename S>
struct PolygonPair : PlanarPair {
  const PolygonShape<S>&shape_a, &shape_b;
  const Heights heights_a, heights_b;

  /// `more` is a length added to the margins.
  PolygonPair(const PolygonShape<S>& a_, const fcl::Transform3<S>& tf1, const PolygonShape<S>& b_,
              const fcl::Transform3<S>& tf2, double more = 0)
      : PlanarPair{&a_.polygon(), &b_.polygon(), {}, {}, a_.options().margin, b_.options().margin},
        shape_a(a_),
        shape_b(b_),
        heights_a(heightsOf(a_.options(), tf1)),
        heights_b(heightsOf(b_.options(), tf2)) {
    margin = more + (margin_a + margin_b);
    requirePlanar(tf1, "pose_a");
    requirePlanar(tf2, "pose_b");
    setPlanarPart(pose_a, tf1);
    setPlanarPart(pose_b, tf2);
    if ((shape_a.isDisc() && hasFewEdges(*b)) || (shape_b.isDisc() && hasFewEdges(*a))) return;
    place_a = &tf1;
    place_b = &tf2;
  }

  /// Exact, touching counts. Checks the poses if they don't, as the kernel, which then isn't asked, would.
  bool heightsMeet() const {
    const bool meet = shape_a.isFlat() && shape_b.isFlat() ? heights_a.low.of_pose == heights_b.low.of_pose
                                                           : share(heights_a, heights_b);
    if (!meet) {
      tricover::checkPose(pose_a, "pose_a");
      tricover::checkPose(pose_b, "pose_b");
    }
    return meet;
  }
};

}  // namespace tricover_fcl
