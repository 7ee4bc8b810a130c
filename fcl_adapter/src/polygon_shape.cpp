// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/polygon_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tricover/pose.h"

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

}  // namespace

template <typename S>
PolygonShape<S>::PolygonShape(tricover::Polygon polygon) : polygon_(std::move(polygon)) {
  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x, high_y = -low_x, reach = 0;
  for (const tricover::Ring& ring : polygon_.rings()) {
    for (const tricover::Vec2& vertex : ring) {
      low_x = std::min(low_x, vertex.x());
      low_y = std::min(low_y, vertex.y());
      high_x = std::max(high_x, vertex.x());
      high_y = std::max(high_y, vertex.y());
      reach = std::max(reach, std::hypot(vertex.x(), vertex.y()));  // infinity where it overflows: a box too wide
    }
  }

  // CollisionObject::computeAABB leaves out a rotation within dummy_precision of the identity, entry by entry: a vertex
  // may be off by that times |x| + |y| <= sqrt(2) reach.
  const double pad = 2 * static_cast<double>(Eigen::NumTraits<S>::dummy_precision()) * reach;
  this->aabb_local.min_ = {-roundUp<S>(pad - low_x), -roundUp<S>(pad - low_y), -roundUp<S>(pad)};
  this->aabb_local.max_ = {roundUp<S>(high_x + pad), roundUp<S>(high_y + pad), roundUp<S>(pad)};

  this->aabb_center.setZero();
  // |R|_2 <= 1 + kRigidTolerance if no entry of R^T R - I exceeds it; the rest pays for hypot's rounding.
  this->aabb_radius = roundUp<S>(reach * (1 + 2 * tricover::kRigidTolerance));
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
