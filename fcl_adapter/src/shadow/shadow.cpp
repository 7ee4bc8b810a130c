// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/shadow.h"

#include <utility>

#include "shape/convex_hull.h"

namespace tricover_fcl {

Shadow shadowOf(tricover::Polygon outline, double rounding, const Slab& heights, const View& view) {
  Shadow shadow;
  shadow.made = std::move(outline);
  shadow.heights = {0, heights.sharedWith(view.slab)};
  shadow.rounding = rounding;
  return shadow;
}

void PartShadows::add(int id, const SlabCut& cut) {
  std::vector<tricover::Vec2> corners = cut.corners();
  for (std::size_t i = 0; view_.joins_parts && i < cut.corners().size(); ++i) {
    for (const double x : {-rounding_, rounding_})
      for (const double y : {-rounding_, rounding_}) corners.push_back(cut.corners()[i] + tricover::Vec2(x, y));
  }
  rings_.push_back(convexHull(corners));
  heights_ = united(heights_, cut.heights());
  parts_.push_back({id, rings_.back().size()});
}

std::optional<Shadow> PartShadows::all() {
  if (rings_.empty()) return std::nullopt;
  tricover::Polygon outline(std::move(rings_), tricover::FillRule::NonZero);
  Shadow shadow = shadowOf(std::move(outline), rounding_, heights_, view_);
  shadow.parts = std::move(parts_);
  return shadow;
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
