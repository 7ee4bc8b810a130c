// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "mixed/mixed.h"
#include "mixed/mixed_pair.h"
#include "mixed/stadium_pair.h"
#include "shape/bounds.h"
#include "shape/fcl_results.h"
#include "shape/is_polygon.h"

namespace tricover_fcl {
namespace {

using tricover::Vec2;

/// The world's box around what the boxes of polygon and shadow share in the polygon's frame.
template <typename S>
Eigen::AlignedBox3d overlap(const MixedPair<S>& pair, const Shadow& shadow) {
  const Eigen::AlignedBox2d box = boundsOf(shadow.region()).intersection(pair.view.around);
  const double half_height = pair.view.slab.halfHeight();
  const Plane middle = pair.planeOf(pair.view.slab.middle());
  Eigen::AlignedBox3d world;
  for (const double x : {box.min().x(), box.max().x()}) {
    for (const double y : {box.min().y(), box.max().y()}) {
      for (const double z : {-half_height, half_height}) world.extend(middle * Eigen::Vector3d(x, y, z));
    }
  }
  return world;
}

/// Adds a contact from the polygon to the geometry, swapped where the row's order is the other one.
template <typename S>
void addInOrder(bool polygon_first, const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                const Plane& plane, PlanarContact contact, fcl::CollisionResult<S>& result) {
  if (!polygon_first) {
    contact.normal *= -1;
    std::swap(contact.edge1, contact.edge2);
  }
  addContact(o1, o2, plane, contact, result);
}

/// Where x is along the normal of a geometry that covers the polygon's whole plane, below the polygon's origin.
template <typename S>
Plane liftPlane(const MixedPair<S>& pair, const Plane& plane, const Shadow::Lift& lift) {
  const Vec2& origin = pair.polygon().origin();
  Plane along = plane * fcl::Translation3<double>(origin.x(), origin.y(), 0);
  along.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), lift.normal));
  return along;
}

}  // namespace

template <typename S>
std::size_t collideMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                         const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                         const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result, double margin) {
  if (request.isSatisfied(result)) return result.numContacts();
  const Wanted of_hit = wanted(o1, o2, request);
  const bool polygon_first = isPolygon(o1);
  const std::size_t most = of_hit.contacts ? room(request, result) : 0;
  const auto addAll = [&](const PlanarPair& pair, const Plane& plane, const auto& part_of) {
    for (PlanarContact& contact : contactsOf(pair, request.num_max_contacts == 1, most, Vec2::UnitX())) {
      contact.edge2 = part_of(contact.edge2);
      addInOrder(polygon_first, o1, o2, plane, contact, result);
    }
  };

  const StadiumPair<S> round(polygon_first, o1, tf1, o2, tf2, margin);
  const bool is_round = round.found != StadiumCase::None;
  if (is_round) {
    if (!of_hit.contacts && !of_hit.costs) round.requireRigidPoses();
    if ((!of_hit.contacts && !of_hit.costs) || round.found == StadiumCase::OutOfSlab || !round.collide())
      return result.numContacts();
    if (!of_hit.costs && !request.enable_contact) {
      if (most > 0) addContact(o1, o2, result);
      return result.numContacts();
    }
    if (!of_hit.costs && request.num_max_contacts == 1) {
      addAll(round, round.plane(), [](std::ptrdiff_t) { return -1; });
      return result.numContacts();
    }
  }

  MixedPair<S> pair = mixedPair("collide", o1, tf1, o2, tf2);
  margin += pair.shape.options().margin;
  if (!of_hit.contacts && !of_hit.costs) return result.numContacts();

  pair.view.only_there = !request.enable_contact;  // the way out of a mesh depends on all of it
  pair.view.around.min().array() -= margin;
  pair.view.around.max().array() += margin;
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);
  if (!is_round && !(shadow && shadow->meets(pair.polygon(), margin))) return result.numContacts();

  const Plane plane = pair.planeOf(shadow ? shadow->heights().middle() : 0);
  if (most > 0 && (!request.enable_contact || !shadow)) {
    addContact(o1, o2, result);
  } else if (most > 0 && shadow->lift()) {
    const Shadow::Lift& lift = *shadow->lift();
    addInOrder(polygon_first, o1, o2, liftPlane(pair, plane, lift), {Vec2::Zero(), Vec2::UnitX(), lift.depth, -1, -1},
               result);
  } else if (most > 0) {
    addAll(pairOf(pair.polygon(), *shadow, pair.shape.options().margin, margin), plane,
           [&](std::ptrdiff_t edge) { return shadow->partOf(edge); });
  }
  if (of_hit.costs && shadow) addCost(o1, o2, overlap(pair, *shadow), request, result);
  return result.numContacts();
}

template std::size_t collideMixed(const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                  const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                  const fcl::CollisionRequest<float>&, fcl::CollisionResult<float>&, double);
template std::size_t collideMixed(const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                  const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                  const fcl::CollisionRequest<double>&, fcl::CollisionResult<double>&, double);

}  // namespace tricover_fcl
