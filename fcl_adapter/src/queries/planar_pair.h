// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "shape/is_polygon.h"
#include "shape/pair_cache_table.h"
#include "shape/planar_pose.h"
#include "shape/plane.h"
#include "shape/region.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover_fcl {

/// Two geometries as regions of one plane, in the query's order. The kernel answers.
struct PlanarPair {
  PlanarPair() = default;
  PlanarPair(const PlanarPair&) = delete;  // a region's polygon may be the shadow's
  PlanarPair& operator=(const PlanarPair&) = delete;

  /// Whether the two come as close as the margin; never false where the true ones do. Where touching is allowed,
  /// what touches up to the rounding may be either.
  bool collide(double tolerance = 0) const {
    tricover::PairCache* const kept = cache();
    const bool may_touch = touching == tricover::Touching::Allowed;
    const tricover::CollideOptions options{may_touch ? margin : margin + rounding, tolerance, touching};
    return kept != nullptr ? tricover::collide(*a.polygon, a.pose, *b.polygon, b.pose, *kept, options)
                           : tricover::collide(*a.polygon, a.pose, *b.polygon, b.pose, options);
  }
  /// Returns the distance of the two: 0 exactly where they collide, otherwise as `options` allow. A distance above the
  /// limit may be left out.
  std::optional<tricover::DistanceResult> distanceWithin(double limit, tricover::DistanceOptions options) const;

  /// The middle of the heights that both share.
  double middle() const { return sharedHeights(a.heights, b.heights).middle(); }
  Eigen::Vector3d inWorld(const tricover::Vec2& p, double z) const {
    const Eigen::Vector3d point(p.x(), p.y(), z);
    return frame ? Eigen::Vector3d(*frame * point) : point;
  }
  Region& of(bool first) { return first ? a : b; }
  /// The number that FCL is told for a region's edge: a polygon's own, a shadow's part, -1 for none.
  std::ptrdiff_t idOf(const Region& region, std::ptrdiff_t edge) const {
    return &region != other ? edge : shadow ? shadow->partOf(edge) : -1;
  }

  Region a, b;
  double margin;        ///< of both, and of the query
  double rounding = 0;  ///< the true shadow lies in its region inflated by so much
  tricover::Touching touching = tricover::Touching::Collides;
  double apart = 0;  ///< how far their heights are; infinite where the other one doesn't reach the polygon's
  const Region* other = nullptr;  ///< the one that isn't a polygon's
  std::optional<Shadow> shadow;   ///< where `other` comes from; a stadium's holds its segment alone, a disc has none
  /// Maps the plane's coordinates and heights to the world; none where they are the world's.
  std::optional<Plane> frame;
  /// As pairCache() has them; null where no certificates are kept.
  const void *place_a = nullptr, *place_b = nullptr;

 private:
  tricover::PairCache* cache() const {
    return place_a != nullptr ? pairCache(a.polygon->id(), place_a, b.polygon->id(), place_b) : nullptr;
  }
};

/// The arguments of a row about a polygon and a geometry of FCL's own.
template <typename S>
struct MixedGeometries {
  const fcl::CollisionGeometry<S>& o1;
  const fcl::Transform3<S>& tf1;
  const fcl::CollisionGeometry<S>& o2;
  const fcl::Transform3<S>& tf2;
  double more = 0;  ///< a length added to the margin
  bool polygon_first = isPolygon(o1);

  const PolygonShape<S>& polygon() const { return static_cast<const PolygonShape<S>&>(polygon_first ? o1 : o2); }
  const fcl::CollisionGeometry<S>& other() const { return polygon_first ? o2 : o1; }
  const fcl::Transform3<S>& ofPolygon() const { return polygon_first ? tf1 : tf2; }
  const fcl::Transform3<S>& ofOther() const { return polygon_first ? tf2 : tf1; }
};

/// Places a polygon and a disc or a stadium in the polygon's plane: a point or a segment with a margin, its radius. The
/// kernel then answers exactly, without an outline. The plane is the world's if `may_be_level` and the polygon's axis
/// is along z, otherwise that of the polygon's frame. False, of other geometries.
template <typename S>
bool placeStadium(PlanarPair& pair, const MixedGeometries<S>& both, bool may_be_level);

/// Places a polygon and the other one's shadow in the polygon's frame: between the polygon's heights, or all of it. The
/// polygon may have any pose in space. Parts that aren't near the polygon may be left out; what is unbounded is made as
/// far as `around` from it. False if there is no shadow.
template <typename S>
bool placeShadow(PlanarPair& pair, const MixedGeometries<S>& both, bool at_all_heights, bool only_near,
                 double around = 0);

/// Throws std::logic_error, naming the operation, if the other geometry isn't one that FCL knows, and
/// std::invalid_argument for a pose that isn't rigid, or not finite.
template <typename S>
void requireMixed(const char* operation, const MixedGeometries<S>& both);

/// The one or the other, in the plane that suits best. Returns whether it is a stadium.
template <typename S>
bool placeMixed(PlanarPair& pair, const char* operation, const MixedGeometries<S>& both, bool only_near);

/// Two polygons in the world's plane. `more` is a length added to the margins.
template <typename S>
void placePolygons(PlanarPair& pair, const PolygonShape<S>& shape_a, const fcl::Transform3<S>& tf1,
                   const PolygonShape<S>& shape_b, const fcl::Transform3<S>& tf2, double more) {
  const auto place = [](Region& region, const PolygonShape<S>& shape, const fcl::Transform3<S>& pose) {
    region.polygon = &shape.polygon();
    region.margin = shape.options().margin;
    region.heights = heightsOf(shape.options(), pose);
    setPlanarPart(region.pose, pose);
  };
  requirePlanar(tf1, tf2);
  place(pair.a, shape_a, tf1);
  place(pair.b, shape_b, tf2);
  pair.margin = more + (pair.a.margin + pair.b.margin);
  pair.apart = gap(pair.a.heights, pair.b.heights);
  if (pair.apart > 0) {  // as the kernel, which isn't called then
    tricover::checkPose(pair.a.pose, "pose_a");
    tricover::checkPose(pair.b.pose, "pose_b");
  }
  // A disc beside few edges is sooner tested than a certificate is found.
  if ((shape_a.isDisc() && hasFewEdges(*pair.b.polygon)) || (shape_b.isDisc() && hasFewEdges(*pair.a.polygon))) return;
  pair.place_a = &tf1;
  pair.place_b = &tf2;
}

/// A point that o1 and o2 share, in the plane.
struct PlanarContact {
  tricover::Vec2 point;
  tricover::Vec2 normal;  ///< from o1 to o2
  double depth;
  tricover::EdgeIndex edge_a, edge_b;  ///< -1: none
};

/// Returns the overlap of a pair, as one or by components, deepest first, in the middle between the two grown outlines.
/// Where more than the components are wanted, flat ones have both of their ends.
/// As one, its depth is the shortest translation that separates the two. What a tolerance or rounding takes for a hit
/// is between the nearest points, along the line between the origins if these are the same.
std::vector<PlanarContact> contactsOf(const PlanarPair& pair, bool as_one, std::size_t most);

/// Nearest points of the regions become those of the grown ones: each goes towards the other by its own margin. Where
/// the margins meet, both become one point that is within either.
void moveByMargins(const PlanarPair& pair, tricover::DistanceResult& found);

/// Returns the distance that FCL is told of a pair that shares a point: 0 where it only touches, up to the regions'
/// error and that of a distance; otherwise -1 or, if signed, minus the depth, with the points of the two surfaces that
/// separate last. A depth below `least` is none. Surfaces overlap wherever they meet.
tricover::DistanceResult overlapOf(const PlanarPair& pair, bool is_signed, double least,
                                   tricover::DistanceResult common);

}  // namespace tricover_fcl
