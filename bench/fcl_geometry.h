// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>

#include <memory>
#include <vector>

#include "convex_pieces.h"

/// The rivals' shapes and frames.
namespace tricover::bench {

using Prism = fcl::Convex<double>;
using FlatMesh = fcl::BVHModel<fcl::OBBRSSd>;

/// FCL's MPR is wrong for prisms of equal height at equal z and gave no error for unequal ones that are taller than the
/// depths in the plane, so fixed prisms reach this far up and down, and moving ones twice as far.
constexpr double kHalfHeight = 1000;

std::shared_ptr<Prism> makePrism(const Ring& convex_ring, double half_height);

std::shared_ptr<FlatMesh> makeFlatMesh(const std::vector<Triangle>& triangles);

fcl::Transform3d toTransform(const Pose& pose);
std::vector<fcl::Transform3d> toTransforms(const std::vector<Pose>& poses);

}  // namespace tricover::bench
