// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/collision_geometry.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "shadow/slab_cut.h"
#include "shadow/smooth_shadow.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl {

/// What of a 3D geometry lies in a polygon's slab, seen along z in the polygon's frame: a planar region that meets the
/// polygon's exactly where the two bodies meet.
class Shadow {
 public:
  /// `parts`: for each ring the part of the geometry that it is the shadow of, and the number of its edges.
  struct Part {
    int id;
    std::size_t edges;
  };
  Shadow(tricover::Polygon region, double rounding, std::vector<Part> parts = {})
      : region_(std::move(region)), rounding_(rounding), parts_(std::move(parts)) {}
  explicit Shadow(SmoothShadow smooth) : smooth_(std::move(smooth)) {}

  /// Whether it is a surface's, which has no inside to be in.
  bool isSurface() const { return is_surface_; }
  void makeSurface() { is_surface_ = true; }

  /// How to part a polygon from a geometry that covers all of its plane: move the geometry along the unit normal (in
  /// space, polygon's frame) by `depth`.
  struct Lift {
    Eigen::Vector3d normal;
    double depth;
  };
  void coverAll(const Lift& lift) { lift_ = lift; }
  const std::optional<Lift>& lift() const { return lift_; }

  /// Whether the polygon and the shadow come as close as `margin`; never false where they do.
  bool meets(const tricover::Polygon& polygon, double margin) const;

  /// Of the polygon (a) and the shadow (b): 0 exactly where meets(polygon, options.margin), otherwise as `options`
  /// allow, and for smooth bodies SmoothShadow::kError of the body's reach above the truth. Where it is above the
  /// limit, it may be nothing.
  std::optional<tricover::DistanceResult> distance(const tricover::Polygon& polygon, double limit,
                                                   const tricover::DistanceOptions& options) const;

  /// The shadow itself, or, of a smooth body, a rough polygon around it.
  tricover::Polygon outline() const;
  /// Makes that finer at one of its edges, to kOutlineError of the body's reach; false if it is so fine.
  bool refine(std::ptrdiff_t edge);
  static constexpr double kOutlineError = 1e-6;
  /// Of the polygon (a), grown by the margin, and the shadow (b). The way is right to kOutlineError of the body's reach
  /// for its direction; of two ways out of a smooth body that differ by less than kFarOutlineError the longer one may
  /// be taken.
  std::optional<tricover::Penetration> penetration(const tricover::Polygon& polygon, double margin) const;
  static constexpr double kFarOutlineError = 1e-3;
  /// One for each part of their overlap, as PlanarPair's, as right.
  std::vector<tricover::Contact> contacts(const tricover::Polygon& polygon, double margin, std::size_t most) const;
  /// Whether one is deeper. Of a surface that is met, all are, if only touched.
  bool isDeeper(const tricover::Polygon& polygon, double margin, double depth) const;

  /// How far the outline and what meets() takes for it may be from the true shadow, a length.
  double outlineError() const;

  /// The triangle of a mesh or the cell of an octree (FCL's query cell id) which an edge of the outline comes from;
  /// otherwise fcl::Contact's NONE.
  int partOf(std::ptrdiff_t edge) const;

 private:
  std::optional<tricover::Polygon> region_;
  double rounding_ = 0;
  std::vector<Part> parts_;
  std::optional<SmoothShadow> smooth_;
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
std::optional<Shadow> makeSmoothShadow(const fcl::CollisionGeometry<S>& shape, const View& view);

}  // namespace tricover_fcl
