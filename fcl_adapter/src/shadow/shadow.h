// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "shadow/slab_cut.h"
#include "shape/region.h"

/// A shadow is the part of a 3D geometry in a polygon's slab, seen along z in the polygon's frame: a planar region that
/// meets the polygon exactly where the two bodies meet.
namespace tricover_fcl {

/// A round body's outline is a polygon around its part in the slab, larger by at most this share of that part's radius.
constexpr double kRoundError = 1e-4;

/// What a shadow is needed for. Of unbounded or many-parted geometries, only as much is made.
struct View {
  Eigen::Affine3d to_polygon;  ///< from the geometry's frame to the polygon's
  Slab slab;
  Eigen::AlignedBox2d around;  ///< holds the polygon
  bool only_there;             ///< parts that don't reach into `around` may be left out
  bool joins_parts;            ///< depths count, which a gap that rounding leaves between neighbours would change
};

/// Nothing if the geometry doesn't reach the slab (or not within the view). For node types that castsShadow() knows.
template <typename S>
std::optional<Shadow> makeShadow(const fcl::CollisionGeometry<S>& geometry, const View& view);

template <typename S>
bool castsShadow(const fcl::CollisionGeometry<S>& geometry);

/// The kinds that makeShadow() tells apart.
template <typename S>
std::optional<Shadow> makeSolidShadow(const fcl::CollisionGeometry<S>& box_or_convex, const View& view);
template <typename S>
std::optional<Shadow> makeHalfspaceShadow(const fcl::CollisionGeometry<S>& plane_or_halfspace, const View& view);
template <typename S>
std::optional<Shadow> makeMeshShadow(const fcl::CollisionGeometry<S>& mesh, const View& view);
template <typename S>
std::optional<Shadow> makeOctreeShadow(const fcl::CollisionGeometry<S>& octree, const View& view);
template <typename S>
std::optional<Shadow> makeRoundShadow(const fcl::CollisionGeometry<S>& shape, const View& view);

/// A shadow whose outline is a convex ring.
inline tricover::Polygon outlineOf(const tricover::Ring& ring) {
  return tricover::Polygon(ring.data(), ring.size(), tricover::FillRule::NonZero);
}

/// A shadow in the polygon's frame. Of the geometry's heights those are kept that the slab shares.
Shadow shadowOf(tricover::Polygon outline, double rounding, const Slab& heights, const View& view);

/// Gathers the shadows of a mesh's triangles or an octree's cells.
class PartShadows {
 public:
  PartShadows(const View& view, double rounding)
      : slab(grown(view.slab, rounding)), view_(view), rounding_(rounding), around_(grown(view.around, 2 * rounding)) {}

  bool isWanted(const Eigen::AlignedBox2d& box) const { return !view_.only_there || around_.intersects(box); }
  void add(int id, const SlabCut& cut);
  std::optional<Shadow> all();

  const Slab slab;  ///< of the parts that count

 private:
  const View& view_;
  double rounding_;
  Eigen::AlignedBox2d around_;
  Slab heights_ = kNoHeights;
  std::vector<tricover::Ring> rings_;
  std::vector<Shadow::Part> parts_;
};

}  // namespace tricover_fcl
