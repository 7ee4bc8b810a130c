// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "shadow/slab_cut.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"

namespace tricover_fcl {

/// A round body's outline is a polygon around its part in the slab, larger by at most this share of that part's radius.
constexpr double kRoundError = 1e-4;

/// The part of a 3D geometry in a polygon's slab, seen along z in the polygon's frame: a planar region that meets the
/// polygon exactly where the two bodies meet.
class Shadow {
 public:
  /// `parts`: for each ring the part of the geometry that it is the shadow of, and the number of its edges.
  struct Part {
    int id;
    std::size_t edges;
  };
  /// The true shadow lies in the region grown by `rounding`. `heights` are those that the slab and the geometry share.
  Shadow(tricover::Polygon region, double rounding, const Slab& heights, std::vector<Part> parts = {})
      : region_(std::move(region)), rounding_(rounding), heights_(heights), parts_(std::move(parts)) {}

  const tricover::Polygon& region() const { return region_; }
  double rounding() const { return rounding_; }
  const Slab& heights() const { return heights_; }

  /// How far the region and what meets() takes for it may be from the true shadow, a length.
  double outlineError() const { return rounding_ + excess_; }
  /// The region is larger than the true shadow, by at most that.
  void addExcess(double excess) { excess_ = excess; }
  /// Whether the region stands for a round body: its edges are none of the body's.
  bool isRound() const { return excess_ > 0; }

  /// Whether it is a surface's, which has no inside to be in.
  bool isSurface() const { return is_surface_; }
  void makeSurface() { is_surface_ = true; }

  /// How to separate a polygon from a geometry that covers all of its plane: move the geometry along the unit normal
  /// (in space, polygon's frame) by `depth`.
  struct Lift {
    Eigen::Vector3d normal;
    double depth;
  };
  void coverAll(const Lift& lift) { lift_ = lift; }
  const std::optional<Lift>& lift() const { return lift_; }

  /// Whether the polygon and the shadow come as close as `margin`; never false where they do.
  bool meets(const tricover::Polygon& polygon, double margin) const;

  /// Returns the distance of the polygon (a) and the region (b): 0 exactly where meets(polygon, options.margin),
  /// otherwise as `options` allow. Where it is above the limit, it may be nothing.
  std::optional<tricover::DistanceResult> distance(const tricover::Polygon& polygon, double limit,
                                                   const tricover::DistanceOptions& options) const;

  /// The triangle of a mesh or the cell of an octree (FCL's query cell id) which an edge of the region comes from;
  /// otherwise fcl::Contact's NONE.
  int partOf(std::ptrdiff_t edge) const;

 private:
  tricover::Polygon region_;
  double rounding_, excess_ = 0;
  Slab heights_;
  std::vector<Part> parts_;
  std::optional<Lift> lift_;
  bool is_surface_ = false;
};

/// What a shadow is needed for. Of unbounded or many-parted geometries, only as much is made.
struct View {
  Eigen::Affine3d to_polygon;  ///< from the geometry's frame to the polygon's
  Slab slab;
  Eigen::AlignedBox2d around;  ///< holds the polygon
  bool only_there;             ///< parts that don't reach into `around` may be left out
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

}  // namespace tricover_fcl
