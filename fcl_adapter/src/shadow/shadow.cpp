// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/shadow.h"

#include <fcl/narrowphase/contact.h>

#include <limits>

#include "tricover/collide.h"

namespace tricover_fcl {
using tricover::Polygon;
using tricover::Pose;

bool Shadow::meets(const Polygon& polygon, double margin) const {
  const Pose here = Pose::Identity();
  return tricover::collide(polygon, here, region_, here, {margin + rounding_});
}

std::optional<tricover::DistanceResult> Shadow::distance(const Polygon& polygon, double limit,
                                                         const tricover::DistanceOptions& options) const {
  // Regions that meet up to rounding are a little apart: a limit below that must not cost them their nearest points.
  const Pose here = Pose::Identity();
  const bool touching = meets(polygon, options.margin);
  auto found = tricover::distanceWithin(polygon, here, region_, here,
                                        touching ? std::numeric_limits<double>::infinity() : limit, options);
  if (touching && found) found->distance = 0;
  return found;
}

int Shadow::partOf(std::ptrdiff_t edge) const {
  auto beyond = static_cast<std::size_t>(edge);
  if (edge >= 0) {
    for (const Part& part : parts_) {
      if (beyond < part.edges) return part.id;
      beyond -= part.edges;
    }
  }
  return fcl::Contact<double>::NONE;
}

template <typename S>
bool castsShadow(const fcl::CollisionGeometry<S>& geometry) {
  return geometry.getNodeType() != fcl::BV_UNKNOWN && geometry.getNodeType() != fcl::GEOM_TRIANGLE;
}

template <typename S>
std::optional<Shadow> makeShadow(const fcl::CollisionGeometry<S>& geometry, const View& view) {
  switch (geometry.getNodeType()) {
    case fcl::GEOM_BOX:
    case fcl::GEOM_CONVEX:
      return makeSolidShadow(geometry, view);
    case fcl::GEOM_PLANE:
    case fcl::GEOM_HALFSPACE:
      return makeHalfspaceShadow(geometry, view);
    case fcl::GEOM_OCTREE:
      return makeOctreeShadow(geometry, view);
    case fcl::GEOM_SPHERE:
    case fcl::GEOM_ELLIPSOID:
    case fcl::GEOM_CAPSULE:
    case fcl::GEOM_CONE:
    case fcl::GEOM_CYLINDER:
      return makeRoundShadow(geometry, view);
    default:
      return makeMeshShadow(geometry, view);
  }
}

#define TRICOVER_INSTANTIATE(S)                                \
  template bool castsShadow(const fcl::CollisionGeometry<S>&); \
  template std::optional<Shadow> makeShadow(const fcl::CollisionGeometry<S>&, const View&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
