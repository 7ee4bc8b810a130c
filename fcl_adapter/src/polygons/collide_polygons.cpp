// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include "polygons/polygon_pair.h"
#include "polygons/polygons.h"
#include "shape/bounds.h"
#include "shape/fcl_results.h"

namespace tricover_fcl {
namespace {

/// In the plane, from the origin of `a` towards that of `b`; along x where the two coincide.
tricover::Vec2 towards(const PlanarPair& pair) {
  const tricover::Vec2 between =
      (pair.pose_b * pair.b->origin()) / 2 - (pair.pose_a * pair.a->origin()) / 2;  // halved, not to overflow
  return between.isZero(0) ? tricover::Vec2::UnitX() : between.stableNormalized();
}

/// The posed polygon's box, its margin added.
template <typename S>
Eigen::AlignedBox3d boxOf(const PolygonShape<S>& shape, const tricover::Pose& pose, const SharedHeights& heights) {
  const Eigen::AlignedBox2d bounds = boundsOf(shape.polygon(), pose);
  const double margin = shape.options().margin;
  return {Eigen::Vector3d(bounds.min().x() - margin, bounds.min().y() - margin, heights.low),
          Eigen::Vector3d(bounds.max().x() + margin, bounds.max().y() + margin, heights.high)};
}

}  // namespace

template <typename S>
std::size_t collidePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result, double margin,
                            double tolerance) {
  const std::size_t before = result.numContacts();
  if (before > 0 && request.isSatisfied(result)) return before;
  const auto &shape_a = static_cast<const PolygonShape<S>&>(o1), &shape_b = static_cast<const PolygonShape<S>&>(o2);
  const std::optional<bool> plain = decidedByDiscs(shape_a, tf1, shape_b, tf2, margin);
  if (plain == false) return before;
  const PolygonPair<S> pair(shape_a, tf1, shape_b, tf2, margin);
  if (!(pair.heightsMeet() && (plain || pair.collide(tolerance)))) return before;

  const Wanted want = wanted(o1, o2, request);
  const std::size_t most = want.contacts ? room(request, result) : 0;
  if (most > 0 && !request.enable_contact) {
    addContact(o1, o2, result);
  } else if (most > 0) {
    const Plane plane = planeAt(sharedHeights(pair.heightsOfA(), pair.heightsOfB()).middle());
    for (const PlanarContact& contact : contactsOf(pair, request.num_max_contacts == 1, most, towards(pair)))
      addContact(o1, o2, plane, contact, result);
  }
  if (want.costs) {
    const SharedHeights heights = sharedHeights(pair.heightsOfA(), pair.heightsOfB());
    addCost(o1, o2, boxOf(pair.shape_a, pair.pose_a, heights).intersection(boxOf(pair.shape_b, pair.pose_b, heights)),
            request, result);
  }
  return result.numContacts();
}

#define TRICOVER_INSTANTIATE(S)                                                                     \
  template std::size_t collidePolygons(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                       const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                       const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&, double, double);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
