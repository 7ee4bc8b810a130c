// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/collide_mixed.h"

#include "mixed/mixed_contacts.h"
#include "mixed/stadium_pair.h"
#include "shape/bounds.h"

namespace tricover_fcl {
namespace {

/// The world's box around what the boxes of polygon and shadow share in the polygon's frame.
template <typename S>
Eigen::AlignedBox3d overlap(const MixedPair<S>& pair, const Shadow& shadow) {
  const Eigen::AlignedBox2d box = boundsOf(shadow.outline()).intersection(pair.view.around);
  const double half_height = pair.view.slab.halfHeight();
  Eigen::AlignedBox3d world;
  for (const double x : {box.min().x(), box.max().x()}) {
    for (const double y : {box.min().y(), box.max().y()}) {
      for (const double z : {-half_height, half_height}) {
        world.extend(pair.plane * Eigen::Vector3d(x, y, z));
      }
    }
  }
  return world;
}

}  // namespace

template <typename S>
std::size_t collideMixed(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                         const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                         const fcl::CollisionRequest<S>& request, const tricover::CollideOptions& options,
                         fcl::CollisionResult<S>& result) {
  if (request.isSatisfied(result)) return result.numContacts();
  const Wanted of_hit = wanted(o1, o2, request);
  const StadiumPair<S> round(o1, tf1, o2, tf2, options.margin);
  const bool is_round = round.found != StadiumCase::None;
  if (is_round) {
    if (!(of_hit.contacts || of_hit.costs) || round.found == StadiumCase::OutOfSlab || !round.collide())
      return result.numContacts();
    if (!request.enable_contact && !of_hit.costs) {
      if (room(request, result) > 0) addContact(o1, o2, result);
      return result.numContacts();
    }
    if (!of_hit.costs && room(request, result) == 1) {
      const MixedContact found = contactOf(round);
      addContact(o1, o2, found.plane, found.contact, result);
      return result.numContacts();
    }
  }

  MixedPair<S> pair = mixedPair("collide", o1, tf1, o2, tf2);
  const double margin = options.margin + pair.shape.options().margin;
  if (!of_hit.contacts && !of_hit.costs) return result.numContacts();

  pair.view.only_there = !request.enable_contact;  // the way out of a mesh depends on all of it
  pair.view.around.min().array() -= margin;
  pair.view.around.max().array() += margin;
  const std::optional<Shadow> shadow = makeShadow(pair.other, pair.view);
  if (!is_round && !(shadow && shadow->meets(pair.polygon(), margin))) return result.numContacts();

  const std::size_t most = of_hit.contacts ? room(request, result) : 0;
  if (most > 0 && (!request.enable_contact || !shadow)) {
    addContact(o1, o2, result);
  } else if (most > 0) {
    for (const MixedContact& found : contactsOf(pair, *shadow, margin, most)) {
      addContact(o1, o2, found.plane, found.contact, result);
    }
  }
  if (of_hit.costs && shadow) addCost(o1, o2, overlap(pair, *shadow), request, result);
  return result.numContacts();
}

template std::size_t collideMixed(const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                  const fcl::CollisionGeometry<float>&, const fcl::Transform3<float>&,
                                  const fcl::CollisionRequest<float>&, const tricover::CollideOptions&,
                                  fcl::CollisionResult<float>&);
template std::size_t collideMixed(const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                  const fcl::CollisionGeometry<double>&, const fcl::Transform3<double>&,
                                  const fcl::CollisionRequest<double>&, const tricover::CollideOptions&,
                                  fcl::CollisionResult<double>&);

}  // namespace tricover_fcl
