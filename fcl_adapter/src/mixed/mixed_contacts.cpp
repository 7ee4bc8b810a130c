// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/mixed_contacts.h"

#include <utility>

namespace tricover_fcl {
namespace {

using tricover::Vec2;

/// From polygon to geometry, turned where the row's order is the other one.
MixedContact inOrder(bool polygon_first, const Plane& plane, PlanarContact contact) {
  if (!polygon_first) {
    contact.normal *= -1;
    std::swap(contact.edge1, contact.edge2);
  }
  return {contact, plane};
}

/// Of a geometry that covers the whole plane: below the polygon's origin, along the geometry's normal.
template <typename S>
MixedContact liftContact(const MixedPair<S>& pair, const Shadow::Lift& lift) {
  const Vec2& origin = pair.polygon().origin();
  Plane along = pair.plane * fcl::Translation3<double>(origin.x(), origin.y(), 0);
  along.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), lift.normal));
  return inOrder(pair.polygon_first, along, {Vec2::Zero(), Vec2::UnitX(), lift.depth, -1, -1});
}

}  // namespace

template <typename S>
std::vector<MixedContact> contactsOf(const MixedPair<S>& pair, const Shadow& shadow, double margin, std::size_t most) {
  if (shadow.lift()) return {liftContact(pair, *shadow.lift())};
  const ShadowPair planar{pair.polygon(), shadow, pair.shape.options().margin, margin};
  std::vector<MixedContact> found;
  for (PlanarContact& contact : tricover_fcl::contactsOf(planar, most == 1, most, Vec2::UnitX())) {
    contact.edge2 = shadow.partOf(contact.edge2);
    found.push_back(inOrder(pair.polygon_first, pair.plane, contact));
  }
  return found;
}

template <typename S>
MixedContact contactOf(const StadiumPair<S>& pair) {
  PlanarContact contact = tricover_fcl::contactsOf(pair, true, 1, Vec2::UnitX()).front();
  contact.edge2 = -1;
  return inOrder(pair.polygon_first, pair.plane(), contact);
}

template std::vector<MixedContact> contactsOf(const MixedPair<float>&, const Shadow&, double, std::size_t);
template std::vector<MixedContact> contactsOf(const MixedPair<double>&, const Shadow&, double, std::size_t);
template MixedContact contactOf(const StadiumPair<float>&);
template MixedContact contactOf(const StadiumPair<double>&);

}  // namespace tricover_fcl
