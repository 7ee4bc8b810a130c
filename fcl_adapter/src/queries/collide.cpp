// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/double2.h"
#include "numbers/rigidity.h"
#include "queries/planar_pair.h"
#include "queries/queries.h"
#include "shape/errors.h"

namespace tricover_fcl {
namespace {

/// Whether two polygons collide, if the discs around both shapes' own origins, which two discs are, tell that plainly,
/// and both poses plainly keep the plane and are rigid: before anything else is made of them. Of the two squares, that
/// of the distance errs by 4U and that of the reach by 9U; the last term is for what underflows.
template <typename S>
std::optional<bool> decidedByDiscs(const PolygonShape<S>& a, const fcl::Transform3<S>& tf1, const PolygonShape<S>& b,
                                   const fcl::Transform3<S>& tf2, double more) {
  using tricover::detail::Double2;
  constexpr double kSquares = 0x1p-48, kUnderflow = 0x1p-1000;
  const auto column = [](const fcl::Transform3<S>& tf, int k) {
    return Double2{static_cast<double>(tf.matrix()(0, k)), static_cast<double>(tf.matrix()(1, k))};
  };
  const auto square = [](double reach) { return reach * reach; };
  const Double2 way = column(tf2, 3) - column(tf1, 3);
  const double apart = tricover::detail::dot(way, way), margin = more + (a.options().margin + b.options().margin),
               reach = static_cast<double>(a.aabb_radius) + static_cast<double>(b.aabb_radius);
  // With a negative margin, too: a point that is e deep in a disc is as much nearer to its centre.
  const bool is_free = apart > square(reach + more) * (1 + kSquares) + kUnderflow && reach < kEverywhere<S>;
  const bool is_hit = margin > 0 && a.isDisc() && b.isDisc() && apart < square(margin) * (1 - kSquares) - kUnderflow;
  if (!is_free && !is_hit) return std::nullopt;
  const auto defectOf = [&](const fcl::Transform3<S>& tf) {
    return tricover::detail::Gram(column(tf, 0), column(tf, 1)).defect();
  };
  const double off = (defectOf(tf1) + defectOf(tf2)) + (tiltOf(tf1) + tiltOf(tf2));
  return off <= kTiltTolerance && std::isfinite(apart) ? std::optional(is_hit) : std::nullopt;
}
static_assert(kTiltTolerance < tricover::kRigidTolerance);

/// The world's box around what the boxes of both share in the plane, at the heights that polygons share or, of another
/// geometry, at those of the polygon.
Eigen::AlignedBox3d sharedBox(const PlanarPair& pair, double more) {
  const Eigen::AlignedBox2d box = grown(boxOf(pair.a), std::max(more, 0.0)).intersection(boxOf(pair.b));
  Slab heights = (pair.other == &pair.a ? pair.b : pair.a).heights.of_shape;
  if (!pair.frame) heights = sharedHeights(pair.a.heights, pair.b.heights);
  if (heights.isAll()) heights = {0, 0};
  Eigen::AlignedBox3d world;
  for (const double x : {box.min().x(), box.max().x()}) {
    for (const double y : {box.min().y(), box.max().y()}) {
      for (const double z : {heights.low, heights.high}) world.extend(pair.inWorld({x, y}, z));
    }
  }
  return world;
}

/// Points and the normal from o1 to o2 in the world, edges -1 for none.
template <typename S>
void addContact(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                const fcl::Vector3<double>& point, const fcl::Vector3<double>& normal, double depth,
                std::ptrdiff_t edge1, std::ptrdiff_t edge2, fcl::CollisionResult<S>& result) {
  fcl::Contact<S> added(&o1, &o2, fcl::Contact<S>::NONE, fcl::Contact<S>::NONE, point.cast<S>(), normal.cast<S>(),
                        static_cast<S>(depth));
  added.b1 = edge1;  // the constructor takes ints
  added.b2 = edge2;
  result.addContact(added);
}

template <typename S>
void addContacts(const PlanarPair& pair, const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                 bool as_one, std::size_t most, fcl::CollisionResult<S>& result) {
  const double z = pair.middle();
  const auto add = [&](const tricover::Vec2& point, const Eigen::Vector3d& normal, double depth, std::ptrdiff_t edge1,
                       std::ptrdiff_t edge2) {
    addContact(o1, o2, pair.inWorld(point, z), pair.frame ? Eigen::Vector3d(pair.frame->linear() * normal) : normal,
               depth, edge1, edge2, result);
  };
  if (pair.shadow && pair.shadow->lift) {
    const bool first = pair.other == &pair.b;
    const Shadow::Lift& lift = *pair.shadow->lift;
    return add((first ? pair.a : pair.b).polygon->coveringOrigin(), (first ? 1 : -1) * lift.normal, lift.depth, -1, -1);
  }
  for (const PlanarContact& contact : contactsOf(pair, as_one, most))
    add(contact.point, {contact.normal.x(), contact.normal.y(), 0}, contact.depth, pair.idOf(pair.a, contact.edge_a),
        pair.idOf(pair.b, contact.edge_b));
}

/// Whether a hit leaves cost sources: if asked for, and neither is free.
template <typename S>
bool wantsCosts(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
                const fcl::CollisionRequest<S>& request) {
  return request.enable_cost && !o1.isFree() && !o2.isFree();
}

/// A cost source in the overlap of the world's boxes: 1 thick where that has no thickness, because it would cost
/// nothing.
template <typename S>
void addCost(const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2, Eigen::AlignedBox3d overlap,
             const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result) {
  if (!(overlap.max().z() > overlap.min().z())) {
    overlap.min().z() -= 0.5;
    overlap.max().z() += 0.5;
  }
  result.addCostSource(
      fcl::CostSource<S>(overlap.min().cast<S>(), overlap.max().cast<S>(), o1.cost_density * o2.cost_density),
      request.num_max_cost_sources);
}

/// Adds what a hit of the pair leaves: contacts if both are occupied, and cost sources.
template <typename S>
void report(const PlanarPair& pair, const fcl::CollisionGeometry<S>& o1, const fcl::CollisionGeometry<S>& o2,
            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result, double margin) {
  const std::size_t before = result.numContacts();
  const std::size_t most =
      o1.isOccupied() && o2.isOccupied() && request.num_max_contacts > before ? request.num_max_contacts - before : 0;
  if (most > 0 && request.enable_contact && pair.apart == 0)
    addContacts(pair, o1, o2, request.num_max_contacts == 1, most, result);
  else if (most > 0)
    addContact<S>(o1, o2, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0, -1, -1, result);
  if (wantsCosts(o1, o2, request) && pair.apart == 0) addCost(o1, o2, sharedBox(pair, margin), request, result);
}

template <typename S>
std::size_t collidePolygons(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result,
                            const tricover::CollideOptions& options) {
  const auto &shape_a = static_cast<const PolygonShape<S>&>(o1), &shape_b = static_cast<const PolygonShape<S>&>(o2);
  const std::size_t before = result.numContacts();
  if (before > 0 && request.isSatisfied(result)) return before;
  const std::optional<bool> plain = decidedByDiscs(shape_a, tf1, shape_b, tf2, options.margin);
  if (plain == false) return before;
  PlanarPair pair;
  placePolygons(pair, shape_a, tf1, shape_b, tf2, options.margin);
  pair.touching = options.touching;
  if (pair.apart > 0 || !(plain || pair.collide(options.tolerance))) return before;
  report(pair, o1, o2, request, result, options.margin);
  return result.numContacts();
}

template <typename S>
[[gnu::noinline]] std::size_t collideOthers(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                                            const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                                            const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result,
                                            const tricover::CollideOptions& options) {
  const bool first = isPolygon(o1), second = isPolygon(o2);
  if (first && second) return collidePolygons(o1, tf1, o2, tf2, request, result, options);
  if (!first && !second) {
    warnAsFcl("collision", o1, o2);
    return 0;
  }
  if (request.isSatisfied(result)) return result.numContacts();
  const MixedGeometries<S> both{o1, tf1, o2, tf2, options.margin};
  PlanarPair pair;
  pair.touching = options.touching;
  const bool is_stadium = placeMixed(pair, "collide", both, !request.enable_contact);
  if (pair.apart > 0 || !pair.collide()) return result.numContacts();
  // Discs and stadiums have boxes, and several contacts, by their outlines, which no complement meets.
  if (is_stadium && !both.polygon().polygon().isComplement() &&
      (wantsCosts(o1, o2, request) || (request.enable_contact && request.num_max_contacts != 1)))
    placeShadow(pair, both, false, !request.enable_contact);
  report(pair, o1, o2, request, result, options.margin);
  return result.numContacts();
}

constexpr tricover::CollideOptions kDefaultOptions;

}  // namespace

template <typename S>
std::size_t collideGeometries(const fcl::CollisionGeometry<S>& o1, const fcl::Transform3<S>& tf1,
                              const fcl::CollisionGeometry<S>& o2, const fcl::Transform3<S>& tf2,
                              const fcl::CollisionRequest<S>& request, fcl::CollisionResult<S>& result,
                              const tricover::CollideOptions* given) {
  const tricover::CollideOptions& options = given != nullptr ? *given : kDefaultOptions;
  // FCL's own call costs 20 ns: a frame around this one would be felt.
  return isPlainlyPolygon(o1) && isPlainlyPolygon(o2) ? collidePolygons(o1, tf1, o2, tf2, request, result, options)
                                                      : collideOthers(o1, tf1, o2, tf2, request, result, options);
}

#define TRICOVER_INSTANTIATE(S)                                                                       \
  template std::size_t collideGeometries(const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                         const fcl::CollisionGeometry<S>&, const fcl::Transform3<S>&, \
                                         const fcl::CollisionRequest<S>&, fcl::CollisionResult<S>&,   \
                                         const tricover::CollideOptions*);
TRICOVER_INSTANTIATE(float)
TRICOVER_INSTANTIATE(double)
#undef TRICOVER_INSTANTIATE

}  // namespace tricover_fcl
