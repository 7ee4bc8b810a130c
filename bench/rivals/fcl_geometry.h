// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>

#include <memory>
#include <vector>

#include "convex_pieces.h"
#include "prism.h"

/// The rivals' shapes and frames.
namespace tricover::bench {

using Prism = fcl::Convex<double>;

/// FCL's MPR is wrong for prisms of equal height at equal z, so fixed prisms reach this far up and down and moving ones
/// twice as far. Low ones suit FCL best: a rotated object's box in the broadphase is its bounding sphere's (a thousand
/// units high, the countries' prisms took 400 times as long).
constexpr double kHalfHeight = 0.5;

using support::makePrism;

template <class Volume = fcl::OBBRSSd>
std::shared_ptr<fcl::BVHModel<Volume>> makeFlatMesh(const std::vector<Triangle>& triangles) {
  auto mesh = std::make_shared<fcl::BVHModel<Volume>>();
  mesh->beginModel();
  for (const Triangle& t : triangles) {
    mesh->addTriangle({t[0].x(), t[0].y(), 0}, {t[1].x(), t[1].y(), 0}, {t[2].x(), t[2].y(), 0});
  }
  mesh->endModel();
  mesh->computeLocalAABB();
  return mesh;
}

fcl::Transform3d toTransform(const Pose& pose);
std::vector<fcl::Transform3d> toTransforms(const std::vector<Pose>& poses);

}  // namespace tricover::bench
