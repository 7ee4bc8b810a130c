// SPDX-License-Identifier: BSD-3-Clause
#include "collide_polygons.h"

#include "pair_cache_table.h"
#include "planar_pose.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"

namespace tricover_fcl {
namespace {

bool polygonsMeet(const tricover::Polygon& a, const PlanarPose& pose_a, const tricover::Polygon& b,
                  const PlanarPose& pose_b, tricover::PairCache& cache) {
  if (pose_a.z == pose_b.z) return tricover::collide(a, pose_a.pose, b, pose_b.pose, cache);
  tricover::checkPose(pose_a.pose, "pose_a");
  tricover::checkPose(pose_b.pose, "pose_b");
  return false;
}

template <typename S>
fcl::Contact<S> makeContact(const PolygonShape<S>& o1, const PolygonShape<S>& o2, double z,
                            const tricover::Contact& common) {
  fcl::Contact<S> contact(&o1, &o2, fcl::Contact<S>::NONE, fcl::Contact<S>::NONE,
                          fcl::Vector3<double>(common.point.x(), common.point.y(), z).template cast<S>(),
                          fcl::Vector3<double>(common.normal.x(), common.normal.y(), 0).template cast<S>(),
                          static_cast<S>(common.depth));
  contact.b1 = common.edge_a;  // the constructor takes ints
  contact.b2 = common.edge_b;
  return contact;
}

/// The overlap of the boxes, 1 thick because flat boxes would cost nothing.
template <typename S>
fcl::CostSource<S> makeCost(const PolygonShape<S>& o1, const PlanarPose& pose_a, const PolygonShape<S>& o2,
                            const PlanarPose& pose_b) {
  const auto box = [](const PolygonShape<S>& shape, const PlanarPose& pose) {
    Eigen::AlignedBox2d bounds;
    for (const tricover::Ring& ring : shape.polygon().rings()) {
      for (const tricover::Vec2& vertex : ring) bounds.extend(pose.pose * vertex);
    }
    return bounds;
  };
  const Eigen::AlignedBox2d overlap = box(o1, pose_a).intersection(box(o2, pose_b));
  const fcl::Vector3<double> low(overlap.min().x(), overlap.min().y(), pose_a.z - 0.5);
  const fcl::Vector3<double> high(overlap.max().x(), overlap.max().y(), pose_a.z + 0.5);
  return fcl::CostSource<S>(low.template cast<S>(), high.template cast<S>(), o1.cost_density * o2.cost_density);
}

}  // namespace

template <typename S>
std::size_t collidePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if (request.isSatisfied(result)) return result.numContacts();
  const auto& shape_a = static_cast<const PolygonShape<S>&>(o1);
  const auto& shape_b = static_cast<const PolygonShape<S>&>(o2);
  const tricover::Polygon& a = shape_a.polygon();
  const tricover::Polygon& b = shape_b.polygon();
  const PlanarPose pose_a = planarPose(tf1, "pose_a");
  const PlanarPose pose_b = planarPose(tf2, "pose_b");

  const bool occupied = o1.isOccupied() && o2.isOccupied();
  const bool costs = request.enable_cost && !o1.isFree() && !o2.isFree();
  if (!occupied && !costs) return result.numContacts();
  if (!polygonsMeet(a, pose_a, b, pose_b, pairCache(a, &tf1, b, &tf2))) return result.numContacts();

  if (occupied && result.numContacts() < request.num_max_contacts) {
    if (request.enable_contact) {
      const auto deepest = tricover::contacts(a, pose_a.pose, b, pose_b.pose, 1);
      result.addContact(makeContact(shape_a, shape_b, pose_a.z, deepest.front()));
    } else {
      // Zeros, because FCL's shorter constructor leaves these fields uninitialised.
      result.addContact(fcl::Contact<S>(&o1, &o2, fcl::Contact<S>::NONE, fcl::Contact<S>::NONE, fcl::Vector3<S>::Zero(),
                                        fcl::Vector3<S>::Zero(), S(0)));
    }
  }
  if (costs) result.addCostSource(makeCost(shape_a, pose_a, shape_b, pose_b), request.num_max_cost_sources);
  return result.numContacts();
}

template std::size_t collidePolygons(const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                     const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                     const fcl::CollisionRequest<float>&, fcl::CollisionResult<float>&);
template std::size_t collidePolygons(const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                     const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                     const fcl::CollisionRequest<double>&, fcl::CollisionResult<double>&);

}  // namespace tricover_fcl
