// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/shape/shape_base.h>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// A tricover polygon as an FCL geometry: a flat shape in the plane z = 0 of its own frame, the polygon's coordinates
/// being its local x and y. Needs registerNarrowphase() once. Its coordinates stay doubles for S = float, too; a float
/// pose converts exactly, so both scalars get the same exact answers.
///
/// The boxes that the broadphase sees are fixed at construction and hold every posed point whatever the pose:
/// - aabb_center is the local origin, not the box's centre. Then a rotated object's box is its translation -+
///   aabb_radius, rounded once, and rounding can't part two boxes that meet, however far away. Author polygons around
///   their own origin: the farther off they are, the wider their box becomes once they are rotated.
/// - aabb_radius is the largest vertex distance from there, widened by the rigidity that poses may miss.
/// - aabb_local is padded by what FCL drops when it takes a tiny rotation for the identity.
template <typename S>
class PolygonShape final : public fcl::ShapeBase<S> {
 public:
  explicit PolygonShape(tricover::Polygon polygon);

  const tricover::Polygon& polygon() const { return polygon_; }

  /// FCL has no free node type; this one is empty in all of its tables, also for its own TriangleP.
  fcl::NODE_TYPE getNodeType() const override;

  /// Does nothing: CollisionObject's constructor calls it on a geometry that other threads may be using.
  void computeLocalAABB() override;

 private:
  tricover::Polygon polygon_;
};

using PolygonShapef = PolygonShape<float>;
using PolygonShaped = PolygonShape<double>;

extern template class PolygonShape<float>;
extern template class PolygonShape<double>;

}  // namespace tricover_fcl
