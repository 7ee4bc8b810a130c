// SPDX-License-Identifier: BSD-3-Clause
// The same by fcl::collide of two geometries and their transforms, as planners hand them over.
#include <fcl/narrowphase/collision.h>

#include "first_methods.h"
#include "rivals/fcl_geometry.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

std::size_t hitsOf(const fcl::CollisionGeometryd& fixed, const fcl::CollisionGeometryd& moving,
                   const FirstAsked& asked) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < asked.queries; ++i) {
    fcl::CollisionResultd result;
    hits += fcl::collide<double>(&fixed, fcl::Transform3d::Identity(), &moving, toTransform(asked.poses[i]),
                                 fcl::CollisionRequestd(), result);
  }
  return hits;
}

std::size_t askShapes(const FirstAsked& asked) {
  const tricover_fcl::PolygonShaped fixed(Polygon(asked.fixed.data(), asked.fixed.size())),
      moving(Polygon(asked.moving.data(), asked.moving.size()));
  return hitsOf(fixed, moving, asked);
}

/// All of a cell's rings are seen from their frame's origin as a whole.
std::shared_ptr<fcl::CollisionGeometryd> fan(const Ring& ring) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++)
    triangles.push_back({Vec2::Zero(), ring[last], ring[i]});
  return makeFlatMesh(triangles);
}

std::size_t askBvh(const FirstAsked& asked) { return hitsOf(*fan(asked.fixed), *fan(asked.moving), asked); }

std::size_t askConvex(const FirstAsked& asked) {
  return hitsOf(*makePrism(asked.fixed, kHalfHeight), *makePrism(asked.moving, 2 * kHalfHeight), asked);
}

}  // namespace

const char* const kFirstReport = "first_fcl";

const std::vector<FirstMethod>& firstMethods() {
  static const std::vector<FirstMethod> methods = {{"tricover in FCL", FirstMethod::Ours, askShapes},
                                                   {"FCL BVH", FirstMethod::Library, askBvh},
                                                   {"FCL Convex", FirstMethod::Convex, askConvex}};
  return methods;
}

}  // namespace tricover::bench
