// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/shadow.h"

#include <fcl/narrowphase/contact.h>

#include <limits>

#include "shape/planar_pair.h"

namespace tricover_fcl {
namespace {

/// Both in the polygon's frame.
PlanarPair pairAt(const tricover::Polygon& polygon, const tricover::Polygon& region, double margin) {
  PlanarPair pair(polygon, region, 0, 0, margin);
  pair.pose_a = pair.pose_b = tricover::Pose::Identity();
  return pair;
}

}  // namespace

bool Shadow::meets(const tricover::Polygon& polygon, double margin) const {
  if (smooth_) return smooth_->meets(polygon, margin);
  return pairAt(polygon, *region_, margin + rounding_).collide();
}

std::optional<tricover::DistanceResult> Shadow::distance(const tricover::Polygon& polygon, double limit,
                                                         const tricover::DistanceOptions& options) const {
  // Regions that meet up to rounding are a little apart: a limit below that must not cost them their nearest points.
  if (smooth_) return smooth_->distance(polygon, options.margin);
  const bool touching = meets(polygon, options.margin);
  auto found = pairAt(polygon, *region_, options.margin)
                   .distanceWithin(touching ? std::numeric_limits<double>::infinity() : limit, options);
  if (touching && found) found->distance = 0;
  return found;
}

double Shadow::outlineError() const { return smooth_ ? smooth_->outlineError(kOutlineError) : rounding_; }

tricover::Polygon Shadow::outline() const { return smooth_ ? smooth_->outline() : *region_; }

bool Shadow::refine(std::ptrdiff_t edge) { return smooth_ && smooth_->refine(edge, kOutlineError); }

namespace {

using tricover::Polygon;
using tricover::Pose;
using tricover::Vec2;

/// With outlines as fine as kFarOutlineError everywhere.
SmoothShadow roughly(SmoothShadow shadow) {
  while (shadow.refine(-1, Shadow::kFarOutlineError)) {
  }
  return shadow;
}

using Normals = std::vector<Vec2>;

/// Adds the shadow's where its outline, moved by `way`, comes as near to the polygon's as the margin.
void addCrossed(Normals& normals, const SmoothShadow& shadow, const Polygon& polygon, const Vec2& way, double margin) {
  Pose there = Pose::Identity();
  there.translation() = way;
  const auto crossed = tricover::crossings(polygon, Pose::Identity(), shadow.outline(), there, {margin});
  for (const tricover::Crossing& crossing : crossed)
    normals.push_back(shadow.normalNear(crossing.edge_b, crossing.point - way));
}

/// Makes outlines fine there; false if they were.
bool sharpen(SmoothShadow& shadow, const Normals& normals) {
  bool sharpened = false;
  for (const Vec2& normal : normals) sharpened = shadow.sharpen(normal, Shadow::kOutlineError) || sharpened;
  return sharpened;
}

/// The way out of a polygon around the shadow is no shorter than that out of the shadow, which is no shorter than that
/// out of a polygon within. They are made fine where either way's length depends on it: in its direction, and where it
/// touches the polygon at its end, which moving back or aside by a little shows. Where that takes long, as of a disc
/// around a needle's tip, many ways are as short, and they are made fine everywhere.
std::optional<tricover::Penetration> sharpenedWay(SmoothShadow& shadow, const Polygon& polygon, double margin) {
  constexpr int kOneByOne = 16;
  const double error = shadow.outlineError(Shadow::kOutlineError);
  const auto into = [&](const Polygon& region) { return pairAt(polygon, region, margin).penetration(); };
  for (int i = 0;; ++i) {
    const auto around = into(shadow.outline());
    if (!around) return around;
    const auto within = into(shadow.inscribed());
    if (around->depth - (within ? within->depth : 0) <= error) return around;
    Normals normals;
    for (const auto& way : {around, within}) {
      if (!way) continue;
      const Vec2 back = -error * way->normal, aside(-back.y(), back.x());
      for (const Vec2& move : {back, aside, Vec2(-aside)})
        addCrossed(normals, shadow, polygon, way->translation + move, margin);
      normals.push_back(-way->normal);
    }
    const bool sharpened = i < kOneByOne ? sharpen(shadow, normals) : shadow.refine(-1, Shadow::kOutlineError);
    if (!sharpened) return around;
  }
}

}  // namespace

std::optional<tricover::Penetration> Shadow::penetration(const Polygon& polygon, double margin) const {
  if (!smooth_) return pairAt(polygon, *region_, margin).penetration();
  SmoothShadow fine = roughly(*smooth_);
  return sharpenedWay(fine, polygon, margin);
}

/// With an outline that is fine where it crosses the polygon, and where a part's way leads.
std::vector<tricover::Contact> Shadow::contacts(const Polygon& polygon, double margin, std::size_t most) const {
  if (!smooth_) return pairAt(polygon, *region_, margin).contacts(most);
  const auto of = [&](const Polygon& region) { return pairAt(polygon, region, margin).contacts(most); };
  SmoothShadow fine = roughly(*smooth_);
  Normals normals;
  do {
    normals.clear();
    addCrossed(normals, fine, polygon, Vec2::Zero(), 0);
  } while (sharpen(fine, normals));
  const std::vector<tricover::Contact> found = of(fine.outline());
  normals.clear();
  for (const tricover::Contact& part : found) normals.push_back(-part.normal);
  return sharpen(fine, normals) ? of(fine.outline()) : found;
}

bool Shadow::isDeeper(const Polygon& polygon, double margin, double depth) const {
  const auto is = [&](const std::vector<tricover::Contact>& deepest) {
    return !deepest.empty() && deepest.front().depth > depth;
  };
  return is_surface_ || (smooth_ && is(pairAt(polygon, smooth_->inscribed(), margin).contacts(1))) ||
         is(contacts(polygon, margin, 1));
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
