// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/polygon_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

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

}  // namespace

template <typename S>
PolygonShape<S>::PolygonShape(tricover::Polygon polygon, const PolygonOptions& options)
    : polygon_(std::move(polygon)), options_(options), is_flat_(options.z_low == 0 && options.z_high == 0) {
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
fcl::NODE_TYPE PolygonShape<S>::getNodeType() const {
  return fcl::GEOM_TRIANGLE;
}

template <typename S>
void PolygonShape<S>::computeLocalAABB() {}

template class PolygonShape<float>;
template class PolygonShape<double>;

}  // namespace tricover_fcl
