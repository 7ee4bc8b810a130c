// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygons/pair_cache_table.h"
#include "shape/heights.h"
#include "shape/planar_pose.h"
#include "tricover_fcl/polygon_shape.h"

namespace tricover_fcl {

/// Two polygons as a row gets them: `a` is its first geometry.
template <typename S>
struct PolygonPair {
  const PolygonShape<S>&shape_a, &shape_b;
  PlanarPose pose_a, pose_b;

  PolygonPair(const PolygonShape<S>& a, const fcl::Transform3<S>& tf1, const PolygonShape<S>& b,
              const fcl::Transform3<S>& tf2)
      : shape_a(a), shape_b(b), pose_a(planarPose(tf1, "pose_a")), pose_b(planarPose(tf2, "pose_b")) {}

  const tricover::Polygon& a() const { return shape_a.polygon(); }
  const tricover::Polygon& b() const { return shape_b.polygon(); }

  /// Exact, touching counts. Checks the poses if they don't, as the kernel, which then isn't asked, would.
  bool heightsMeet() const {
    const bool meet = shape_a.isFlat() && shape_b.isFlat() ? pose_a.z == pose_b.z : share(heightsA(), heightsB());
    if (!meet) {
      tricover::checkPose(pose_a.pose, "pose_a");
      tricover::checkPose(pose_b.pose, "pose_b");
    }
    return meet;
  }

  /// Calls ask() with the pair's cache, or without one where there is none any more, or a disc is beside few edges.
  template <typename Ask>
  auto remembering(const fcl::Transform3<S>& tf1, const fcl::Transform3<S>& tf2, const Ask& ask) const {
    if ((shape_a.isDisc() && hasFewEdges(b())) || (shape_b.isDisc() && hasFewEdges(a()))) return ask();
    tricover::PairCache* const cache = pairCache(a(), &tf1, b(), &tf2);
    return cache != nullptr ? ask(*cache) : ask();
  }

  Heights heightsA() const { return heightsOf(shape_a.options(), pose_a); }
  Heights heightsB() const { return heightsOf(shape_b.options(), pose_b); }
};

}  // namespace tricover_fcl
