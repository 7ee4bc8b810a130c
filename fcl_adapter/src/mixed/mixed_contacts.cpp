// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/mixed_contacts.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mixed/stadium_penetration.h"

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

/// As contactsOf() asks.
struct ShadowPair {
  std::optional<tricover::Penetration> penetration() const { return shadow.penetration(polygon); }
  std::vector<tricover::Contact> contacts(std::size_t most) const { return shadow.contacts(polygon, most); }
  tricover::DistanceResult distance() const {
    return *shadow.distance(polygon, std::numeric_limits<double>::infinity(), {});
  }

  const tricover::Polygon& polygon;
  const Shadow& shadow;
};

}  // namespace

template <typename S>
std::vector<MixedContact> contactsOf(const MixedPair<S>& pair, const Shadow& shadow, std::size_t most) {
  if (shadow.lift()) return {liftContact(pair, *shadow.lift())};
  const ShadowPair planar{pair.polygon(), shadow};
  std::vector<MixedContact> found;
  for (PlanarContact& contact : tricover_fcl::contactsOf(planar, most == 1, most, Vec2::UnitX())) {
    contact.edge2 = shadow.partOf(contact.edge2);
    found.push_back(inOrder(pair.polygon_first, pair.plane, contact));
  }
  return found;
}

template <typename S>
std::optional<MixedContact> contactOf(const StadiumPair<S>& pair) {
  const auto way = penetrationOf(pair);
  if (!way) return std::nullopt;
  return inOrder(pair.polygon_first, pair.plane(),
                 {middle(way->point_a, way->point_b()), way->normal, std::max(way->depth, 0.0), way->edge_a, -1});
}

template std::vector<MixedContact> contactsOf(const MixedPair<float>&, const Shadow&, std::size_t);
template std::vector<MixedContact> contactsOf(const MixedPair<double>&, const Shadow&, std::size_t);
template std::optional<MixedContact> contactOf(const StadiumPair<float>&);
template std::optional<MixedContact> contactOf(const StadiumPair<double>&);

}  // namespace tricover_fcl
