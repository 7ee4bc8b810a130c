// SPDX-License-Identifier: BSD-3-Clause
#include "mixed/mixed_contacts.h"

#include <algorithm>
#include <utility>

#include "mixed/stadium_penetration.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"

namespace tricover_fcl {
namespace {

using tricover::Pose;
using tricover::Vec2;

Vec2 middle(const Vec2& p, const Vec2& q) { return p / 2 + q / 2; }

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
std::vector<MixedContact> contactsOf(const MixedPair<S>& pair, const Shadow& shadow, std::size_t most) {
  if (shadow.lift()) return {liftContact(pair, *shadow.lift())};
  const tricover::Polygon& polygon = pair.polygon();
  std::vector<MixedContact> found;
  const auto add = [&](const Vec2& point, const Vec2& normal, double depth, const auto& edges) {
    const PlanarContact contact{point, normal, depth, edges.edge_a, shadow.partOf(edges.edge_b)};
    found.push_back(inOrder(pair.polygon_first, pair.plane, contact));
  };
  if (most == 1) {
    if (const auto whole = shadow.penetration(polygon))
      add(middle(whole->point_a, whole->point_b), whole->normal, whole->depth, *whole);
  } else {
    for (const tricover::Contact& part : shadow.contacts(polygon, most)) add(part.point, part.normal, part.depth, part);
  }
  if (found.empty()) {
    const tricover::DistanceResult nearest = *shadow.distance(polygon, std::numeric_limits<double>::infinity(), {});
    const Vec2 between = nearest.point_b - nearest.point_a;
    const Vec2 normal = between.isZero(0) ? Vec2(Vec2::UnitX()) : Vec2(between.stableNormalized());
    add(middle(nearest.point_a, nearest.point_b), normal, 0, nearest);
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
