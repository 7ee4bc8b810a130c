// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/shadow.h"

#include <fcl/narrowphase/contact.h>

#include <limits>

#include "tricover/collide.h"

namespace tricover_fcl {

bool Shadow::meets(const tricover::Polygon& polygon, double margin) const {
  if (smooth_) return smooth_->meets(polygon, margin);
  tricover::CollideOptions options;
  options.margin = margin + rounding_;
  return tricover::collide(polygon, tricover::Pose::Identity(), *region_, tricover::Pose::Identity(), options);
}

tricover::DistanceResult Shadow::distance(const tricover::Polygon& polygon,
                                          const tricover::DistanceOptions& options) const {
  // Regions that meet up to rounding are a little apart: a limit below that must not cost them their nearest points.
  if (smooth_) return smooth_->distance(polygon, options.margin);
  const bool touching = meets(polygon, options.margin);
  tricover::DistanceOptions within = options;
  if (touching) within.limit = std::numeric_limits<double>::infinity();
  tricover::DistanceResult found =
      tricover::distance(polygon, tricover::Pose::Identity(), *region_, tricover::Pose::Identity(), within);
  if (touching) found.distance = 0;
  return found;
}

double Shadow::outlineError() const { return smooth_ ? smooth_->outlineError(kOutlineError) : rounding_; }

tricover::Polygon Shadow::outline() const { return smooth_ ? smooth_->outline() : *region_; }

bool Shadow::refine(std::ptrdiff_t edge) { return smooth_ && smooth_->refine(edge, kOutlineError); }

tricover::Polygon Shadow::outlineIn(const tricover::Polygon& polygon) const {
  return smooth_ ? smooth_->outline({kOutlineError, &polygon, kFarOutlineError}) : *region_;
}

std::optional<tricover::Penetration> Shadow::penetration(const tricover::Polygon& polygon) const {
  const auto into = [&](const tricover::Polygon& region) {
    return tricover::penetration(polygon, tricover::Pose::Identity(), region, tricover::Pose::Identity());
  };
  auto found = into(outlineIn(polygon));
  if (!smooth_) return found;
  // The outline is coarse where the polygon is far inside: made to touch the body in the way's direction, it gives that
  // way its right length. A better way may show then, but a way's length errs by the square of its direction's error.
  SmoothShadow sharpened = *smooth_;
  for (int round = 0; round < 4 && found; ++round) {
    const double depth = found->depth;
    sharpened.addTangent(-found->direction);
    found = into(sharpened.outline({kOutlineError, &polygon, kFarOutlineError}));
    if (!found || depth - found->depth <= outlineError()) break;
  }
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
      return makeSmoothShadow(geometry, view);
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
