// SPDX-License-Identifier: BSD-3-Clause
#include "polygons/collide_polygons.h"

#include <optional>
#include <vector>

#include "polygons/disc_pair.h"
#include "polygons/polygon_pair.h"
#include "shape/fcl_results.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"

namespace tricover_fcl {
namespace {

tricover::Vec2 middle(const tricover::Vec2& p, const tricover::Vec2& q) { return p / 2 + q / 2; }

/// In the plane, from the origin of `a` towards that of `b`; along x where the two coincide.
template <typename S>
tricover::Vec2 towards(const PolygonPair<S>& pair) {
  const tricover::Vec2 between = (pair.pose_b.pose * pair.b().origin()) / 2 -
                                 (pair.pose_a.pose * pair.a().origin()) / 2;  // halved, not to overflow
  return between.isZero(0) ? tricover::Vec2::UnitX() : between.stableNormalized();
}

/// What the pair shares, as one or in parts, deepest first; where only margins meet, what is between the nearest
/// points.
template <typename S>
std::vector<PlanarContact> contactsOf(const PolygonPair<S>& pair, bool as_one, std::size_t most) {
  const tricover::Polygon &a = pair.a(), &b = pair.b();
  const tricover::Pose &pose_a = pair.pose_a.pose, &pose_b = pair.pose_b.pose;
  std::vector<PlanarContact> shared;
  if (as_one) {
    if (const auto whole = tricover::penetration(a, pose_a, b, pose_b)) {
      shared.push_back(
          {middle(whole->point_a, whole->point_b), whole->normal, whole->depth, whole->edge_a, whole->edge_b});
    }
  } else {
    for (const tricover::Contact& part : tricover::contacts(a, pose_a, b, pose_b, most)) {
      shared.push_back({part.point, part.normal, part.depth, part.edge_a, part.edge_b});
    }
  }
  if (shared.empty()) {
    const tricover::DistanceResult nearest = tricover::distance(a, pose_a, b, pose_b);
    const tricover::Vec2 between = nearest.point_b - nearest.point_a;
    shared.push_back({middle(nearest.point_a, nearest.point_b),
                      between.isZero(0) ? towards(pair) : between.stableNormalized(), 0, nearest.edge_a,
                      nearest.edge_b});
  }
  return shared;
}

/// The posed polygon's box, its margin added.
template <typename S>
Eigen::AlignedBox3d boxOf(const PolygonShape<S>& shape, const PlanarPose& pose, const SharedHeights& heights) {
  Eigen::AlignedBox2d bounds;
  for (const tricover::Ring& ring : shape.polygon().rings()) {
    for (const tricover::Vec2& vertex : ring) bounds.extend(pose.pose * vertex);
  }
  const double margin = shape.options().margin;
  return {Eigen::Vector3d(bounds.min().x() - margin, bounds.min().y() - margin, heights.low),
          Eigen::Vector3d(bounds.max().x() + margin, bounds.max().y() + margin, heights.high)};
}

}  // namespace

template <typename S>
std::size_t collidePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                            const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                            fcl::CollisionResult<S>& result) {
  if (request.isSatisfied(result)) return result.numContacts();
  const auto &shape_a = static_cast<const PolygonShape<S>&>(o1), &shape_b = static_cast<const PolygonShape<S>&>(o2);
  const Wanted want = wanted(o1, o2, request);
  const double margin = options.margin + (shape_a.options().margin + shape_b.options().margin);
  if (DiscPair<S>::areDiscs(shape_a, shape_b) && options.tolerance == 0 && !want.costs) {
    const std::optional<bool> hit = DiscPair<S>(shape_a, tf1, shape_b, tf2).areWithin(margin);
    if (hit && !(*hit && want.contacts && request.enable_contact)) {
      if (*hit && want.contacts && room(request, result) > 0) addContact(o1, o2, result);
      return result.numContacts();
    }
  }

  const PolygonPair<S> pair(shape_a, tf1, shape_b, tf2);
  if (!want.contacts && !want.costs) return result.numContacts();
  const tricover::CollideOptions with_margins{margin, options.tolerance};
  const auto collide = [&](auto&... cache) {
    return tricover::collide(pair.a(), pair.pose_a.pose, pair.b(), pair.pose_b.pose, cache..., with_margins);
  };
  const bool hit = pair.heightsMeet() && pair.remembering(tf1, tf2, collide);
  if (!hit) return result.numContacts();

  const std::size_t most = want.contacts ? room(request, result) : 0;
  if (most > 0 && !request.enable_contact) {
    addContact(o1, o2, result);
  } else if (most > 0) {
    const Plane plane = planeAt(sharedHeights(pair.heightsA(), pair.heightsB()).middle());
    for (const PlanarContact& contact : contactsOf(pair, request.num_max_contacts == 1, most))
      addContact(o1, o2, plane, contact, result);
  }
  if (want.costs) {
    const SharedHeights heights = sharedHeights(pair.heightsA(), pair.heightsB());
    addCost(o1, o2, boxOf(pair.shape_a, pair.pose_a, heights).intersection(boxOf(pair.shape_b, pair.pose_b, heights)),
            request, result);
  }
  return result.numContacts();
}

#define TRICOVER_INSTANTIATE(S)                                                                          \
  template std::size_t collidePolygons(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,      \
                                       const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&,      \
                                       const fcl::CollisionRequest<S>&, const tricover::CollideOptions&, \
                                       fcl::CollisionResult<S>&);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
