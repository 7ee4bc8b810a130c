// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/geometry/shape/shape_base.h>

#include <atomic>
#include <limits>

#include "tricover/export.h"
#include "tricover/polygon.h"
#include "tricover_fcl/registration.h"

namespace tricover_fcl {

/// Describes a shape besides its polygon. Lengths of the shape's own frame; doubles for S = float, too.
struct PolygonOptions {
  /// Safety distance in the plane: two shapes collide if and only if their heights overlap and their polygons come as
  /// close as the sum of their margins (rounded to a double) or closer. Distances, depths and contacts are those of the
  /// polygons grown by their margins. A negative sum -e is an overlap that is allowed, in collisions and continuous
  /// collisions: shapes collide if some point of either is e deep in the other, as CollideOptions::margin says. A
  /// distance with a negative sum is an error.
  double margin = 0;
  /// The shape is a prism: the polygon at every local z from z_low to z_high, both included. Flat by default. A pose
  /// that turns the shape upside down turns the interval, too.
  double z_low = 0;
  double z_high = 0;  ///< see z_low

  /// The options of a shape at all heights, for scenes in which z means nothing: z_low and z_high are -infinity and
  /// infinity.
  /// Flat shapes collide only at exactly the same z; shapes at all heights ignore z. FCL's managers can't hold infinite
  /// boxes, so their box of such a shape is as high and as deep as it is wide: keep z values close there.
  ///
  /// \snippet fcl.cpp shape
  static PolygonOptions atAllHeights(double margin = 0) {
    return {margin, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
};

namespace detail {

/// Where the corners of a polygon's convex hull are kept, which boxes depend on: found at the first call, by whichever
/// threads come first. Copies that are made later share them.
class TRICOVER_EXPORT HullPlace {
 public:
  HullPlace() = default;
  HullPlace(const HullPlace& other) : found_(other.shared()) {}
  HullPlace& operator=(const HullPlace& other);
  ~HullPlace() { release(found_.load(std::memory_order_acquire)); }

  const tricover::Ring& cornersOf(const tricover::Polygon& polygon) const;

 private:
  struct Hull;
  const Hull* shared() const;
  static void release(const Hull* hull) {
    if (hull != nullptr) releaseOne(hull);
  }
  static void releaseOne(const Hull* hull);

  mutable std::atomic<const Hull*> found_{nullptr};
};

}  // namespace detail

/// A tricover polygon as an FCL geometry: a flat shape in the plane z = 0 of its own frame, the polygon's coordinates
/// being its local x and y, or a prism over it. The first one makes FCL know the class, as registerNarrowphase() does,
/// which also checks that FCL's functions reach it. Its coordinates stay doubles for S = float, too; a float pose
/// converts exactly, so both scalars get the same exact answers.
///
/// The boxes that the broadphase sees are fixed at construction and hold every posed point, and what its margin adds,
/// whatever the pose:
/// - aabb_center is the local origin, not the box's centre. Then a rotated object's box is its translation -+
///   aabb_radius, rounded once, and rounding can't part two boxes that meet, however far away. Author polygons around
///   their own origin: the farther off they are, the wider their box becomes once they are rotated. boxAt(), which a
///   PolygonObject has for its box, doesn't mind either.
/// - aabb_radius is the largest vertex distance from there, widened by the rigidity that poses may miss.
/// - aabb_local is padded by what FCL drops when it takes a tiny rotation for the identity.
///
/// The shape of a complement (tricover::Polygon::complement()) has no end: its boxes reach as far as FCL's managers can
/// bear, 1e153 or, for float, 2e18. It is asked beside other polygons, spheres, cylinders and capsules; beside other
/// geometries it is refused. Its contacts are those of the components, also where one is asked for, and a signed
/// distance of what overlaps it is refused.
///
/// Volume and moments stay FCL's default, 0: a flat shape has none.
///
/// \snippet fcl.cpp shape
template <typename S>
class TRICOVER_EXPORT PolygonShape final : public fcl::ShapeBase<S> {
 public:
  /// Makes a shape from a polygon and its options.
  ///
  /// The last argument is there for its default, which the caller's own code evaluates. The default sees FCL as the
  /// caller does; and FCL's tables for float, which are large, are linked only into programs that make shapes for
  /// float.
  /// \throws std::invalid_argument for an interval that isn't finite (except that of atAllHeights()) or runs downwards,
  /// and for a margin that is not finite
  /// \throws std::logic_error if the caller was compiled with another FCL than tricover, or with another alignment of
  /// Eigen's types (-march=native): nothing would work safely
  explicit PolygonShape(const tricover::Polygon& polygon, const PolygonOptions& options = {},
                        detail::FilledTables<S> tables = detail::filledTables<S>(FclLayout{}));

  PolygonShape(const PolygonShape&) = default;             ///< Moving copies, too: no shape is ever without its data.
  PolygonShape& operator=(const PolygonShape&) = default;  ///< Copies, too.

  const tricover::Polygon& polygon() const { return polygon_; }  ///< as it was given
  const PolygonOptions& options() const { return options_; }     ///< as they were given
  /// Whether the shape lies in its own plane z = 0.
  bool isFlat() const { return is_flat_; }
  /// Whether its polygon is tricover::Polygon::point() at the local origin, so that with a margin the shape is a disc
  /// there.
  bool isDisc() const { return is_disc_; }
  /// Whether it is at all heights.
  bool isAtAllHeights() const { return options_.z_high == std::numeric_limits<double>::infinity(); }

  /// The box around the shape under a pose, as small as it can be but for rounding, which is outwards: it holds every
  /// posed point and what the margin adds, wherever the polygon lies from its origin. At all heights it is as high and
  /// as deep as aabb_radius. Costs a nanosecond or two for each corner of the polygon's convex hull, which the first
  /// call finds.
  ///
  /// \snippet fcl.cpp shape
  fcl::AABB<S> boxAt(const fcl::Transform3<S>& pose) const;

  /// FCL has no free node type; this one is empty in all of its tables, also for its own TriangleP.
  fcl::NODE_TYPE getNodeType() const override;

  /// Does nothing: CollisionObject's constructor calls it on a geometry that other threads may be using.
  void computeLocalAABB() override;

 private:
  tricover::Polygon polygon_;
  PolygonOptions options_;
  bool is_flat_, is_disc_;
  detail::HullPlace hull_;
};

using PolygonShapef = PolygonShape<float>;   ///< For FCL's float types.
using PolygonShaped = PolygonShape<double>;  ///< For FCL's double types.

extern template class PolygonShape<float>;
extern template class PolygonShape<double>;

}  // namespace tricover_fcl
