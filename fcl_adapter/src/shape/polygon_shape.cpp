// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/polygon_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "shape/convex_hull.h"
#include "shape/errors.h"
#include "tricover/pose.h"
#include "tricover_fcl/registration.h"

namespace tricover_fcl {
namespace {

/// An S above what `value` was rounded from by one operation.
template <typename S>
S roundUp(double value) {
  const double bound = std::nextafter(value, std::numeric_limits<double>::infinity());
  const S rounded = static_cast<S>(bound);
  if (static_cast<double>(rounded) >= bound) return rounded;
  return std::nextafter(rounded, std::numeric_limits<S>::infinity());
}

void check(bool valid, const char* field, const char* rule) {
  if (!valid) refuse(field, std::string("it must be ") + rule);
}

/// Of numbers.
struct Range {
  double low, high;

  void extend(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace

/// All that boxes depend on.
template <typename S>
struct PolygonShape<S>::Hull {
  std::once_flag once;
  tricover::Ring corners;
};

template <typename S>
PolygonShape<S>::PolygonShape(tricover::Polygon polygon, const PolygonOptions& options)
    : polygon_(std::move(polygon)),
      options_(options),
      is_flat_(options.z_low == 0 && options.z_high == 0),
      hull_(std::make_shared<Hull>()) {
  detail::fillTables();
  const double infinity = std::numeric_limits<double>::infinity();
  if (options.z_low != -infinity || options.z_high != infinity) {
    check(std::isfinite(options.z_low), "z_low", "finite");
    check(std::isfinite(options.z_high) && options.z_high >= options.z_low, "z_high", "finite and not below z_low");
  }
  check(std::isfinite(options.margin) && options.margin >= 0, "margin", "finite and not negative");

  tricover::Vec2 low(infinity, infinity), high(-infinity, -infinity);
  double reach = 0;
  for (const tricover::Ring& ring : polygon_.rings()) {
    for (const tricover::Vec2& vertex : ring) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
      reach = std::max(reach, std::hypot(vertex.x(), vertex.y()));  // infinity where it overflows: a box too wide
    }
  }

  // CollisionObject::computeAABB leaves out a rotation within dummy_precision of the identity, entry by entry: a vertex
  // may be off by that times |x| + |y| <= sqrt(2) reach, within the plane; heights are taken without it.
  const double pad = 2 * static_cast<double>(Eigen::NumTraits<S>::dummy_precision()) * reach;
  const double margin = options.margin * (1 + 0x1p-50);  // pays for rounding where two margins are added
  const double grown = pad + margin;
  // |R|_2 <= 1 + kRigidTolerance if no entry of R^T R - I exceeds it; the rest pays for hypot's rounding.
  const double planar = reach * (1 + 2 * tricover::kRigidTolerance) + margin;
  const double z_low = isAtAllHeights() ? -planar : options.z_low, z_high = isAtAllHeights() ? planar : options.z_high;
  this->aabb_local.min_ = {-roundUp<S>(grown - low.x()), -roundUp<S>(grown - low.y()), -roundUp<S>(pad - z_low)};
  this->aabb_local.max_ = {roundUp<S>(high.x() + grown), roundUp<S>(high.y() + grown), roundUp<S>(z_high + pad)};
  this->aabb_center.setZero();
  this->aabb_radius =
      roundUp<S>(std::hypot(planar, isAtAllHeights() ? 0 : std::max(std::abs(z_low), std::abs(z_high))));
}

template <typename S>
fcl::AABB<S> PolygonShape<S>::boxAt(const fcl::Transform3<S>& pose) const {
  std::call_once(hull_->once, [&] {
    std::vector<tricover::Vec2> vertices;
    for (const tricover::Ring& ring : polygon_.rings()) vertices.insert(vertices.end(), ring.begin(), ring.end());
    hull_->corners = convexHull(vertices);
  });
  const auto at = [&](int row, int column) { return static_cast<double>(pose.matrix()(row, column)); };
  const double reach = static_cast<double>(this->aabb_radius);
  const double z_low = isAtAllHeights() ? -reach : options_.z_low, z_high = isAtAllHeights() ? reach : options_.z_high;
  // Pairs of polygons leave out a tilt within the tolerance, other pairs don't: the box is around both readings.
  const bool level = std::abs(std::abs(at(2, 2)) - 1) <= tricover::kRigidTolerance;

  fcl::AABB<S> box;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = at(axis, 0), y = at(axis, 1), z = at(axis, 2), t = at(axis, 3);
    Range plane{0, 0};
    if (axis < 2 || x != 0 || y != 0) {
      if (axis < 2 || !level)
        plane = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (const tricover::Vec2& corner : hull_->corners) plane.extend(x * corner.x() + y * corner.y());
    }
    Range heights{z * z_low, z * z_low};
    heights.extend(z * z_high);
    if (level) {
      const double upright = axis < 2 ? 0 : std::copysign(1, z);
      heights.extend(upright * z_low);
      heights.extend(upright * z_high);
    }
    // Of a level shape it is a length of the world's plane, otherwise of its own, whose part along the axis counts. The
    // rest pays for a pose that stretches and for rounding where two margins are added.
    const double margin = options_.margin * (1 + 2 * tricover::kRigidTolerance) *
                          (level && axis < 2 ? 1 : std::min(1.0, std::hypot(x, y)));
    // With U = 2^-53 and all of the shape within `reach`: the hull errs by 2^-50 of its size, 16 U reach; products and
    // sums in the plane by 5 U reach; the product with z by 2 U reach; three more sums by U (3 reach + |t|) each. In
    // all less than 2^-47 reach + 2^-48 |t|, and of products that underflow 2^-1075 each.
    const double pad = margin + 0x1p-47 * reach + 0x1p-48 * std::abs(t) + 0x1p-1072;
    const double below = (plane.low + heights.low) + t, above = (plane.high + heights.high) + t;
    const bool known = std::isfinite(pad);
    box.min_[axis] = known ? -roundUp<S>(pad - below) : -std::numeric_limits<S>::infinity();
    box.max_[axis] = known ? roundUp<S>(above + pad) : std::numeric_limits<S>::infinity();
  }
  return box;
}

template <typename S>
fcl::NODE_TYPE PolygonShape<S>::getNodeType() const {
  return fcl::GEOM_TRIANGLE;
}

template <typename S>
void PolygonShape<S>::computeLocalAABB() {}

template class PolygonShape<float>;
template class PolygonShape<double>;

}  // namespace tricover_fcl
