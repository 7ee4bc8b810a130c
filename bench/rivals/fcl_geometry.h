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
using FlatMesh = fcl::BVHModel<fcl::OBBRSSd>;

/// FCL's MPR is wrong for prisms of equal height at equal z, so fixed prisms reach this far up and down and moving ones
/// twice as far. Low ones suit FCL best: a rotated object's box in the broadphase is its bounding sphere's (a thousand
/// units high, the countries' prisms took 400 times as long).
constexpr double kHalfHeight = 0.5;

using support::makePrism;

std::shared_ptr<FlatMesh> makeFlatMesh(const std::vector<Triangle>& triangles);

fcl::Transform3d toTransform(const Pose& pose);
std::vector<fcl::Transform3d> toTransforms(const std::vector<Pose>& poses);

}  // namespace tricover::bench
