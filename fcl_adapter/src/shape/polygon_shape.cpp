// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/polygon_shape.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "shape/convex_hull.h"
#include "shape/errors.h"
#include "shape/heights.h"
#include "shape/planar_pose.h"
#include "tricover/pose.h"

namespace tricover_fcl {
namespace {

/// The least S that isn't below.
template <typename S>
S notBelow(double value) {
  const S rounded = static_cast<S>(value);
  if (static_cast<double>(rounded) >= value) return rounded;
  return std::nextafter(rounded, std::numeric_limits<S>::infinity());
}

/// An S above what `value` was rounded from by one operation: by an ulp or two.
template <typename S>
S roundUp(double value) {
  return notBelow<S>(value + std::abs(value) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
}

/// Of all vertices.
struct Extremes {
  explicit Extremes(const tricover::Polygon& polygon) : low(polygon.edgeStart(0)), high(low) {
    const tricover::EdgeIndex count = polygon.edgeCount();
    double square = 0;
    for (tricover::EdgeIndex e = 0; e < count; ++e) {
      const tricover::Vec2 vertex = polygon.edgeStart(e);
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
      square = std::max(square, vertex.squaredNorm());
    }
    if (square > 0x1p-900 && square < 0x1p900) {
      reach = std::sqrt(square);
      return;
    }
    for (tricover::EdgeIndex e = 0; e < count; ++e) {
      const tricover::Vec2 vertex = polygon.edgeStart(e);
      reach = std::max(reach, std::hypot(vertex.x(), vertex.y()));
    }
  }

  tricover::Vec2 low, high;
  double reach = 0;  ///< the largest distance from the origin, up to rounding; infinity, a box too wide, on overflow
};

void check(bool valid, const char* field, const char* rule) {
  if (!valid) refuse(field, std::string("it must be ") + rule);
}

}  // namespace

namespace detail {

struct HullPlace::Hull {
  tricover::Ring corners;
  mutable std::atomic<std::size_t> users{1};
};

HullPlace& HullPlace::operator=(const HullPlace& other) {
  release(found_.exchange(other.shared(), std::memory_order_acq_rel));
  return *this;
}

const HullPlace::Hull* HullPlace::shared() const {
  const Hull* hull = found_.load(std::memory_order_acquire);
  if (hull != nullptr) hull->users.fetch_add(1, std::memory_order_relaxed);
  return hull;
}

void HullPlace::releaseOne(const Hull* hull) {
  if (hull->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete hull;
}

/// Of threads that find them at once the first one's stay.
const tricover::Ring& HullPlace::cornersOf(const tricover::Polygon& polygon) const {
  if (const Hull* hull = found_.load(std::memory_order_acquire)) return hull->corners;
  const tricover::EdgeIndex count = polygon.edgeCount();
  std::vector<tricover::Vec2> vertices;
  vertices.reserve(static_cast<std::size_t>(count));
  for (tricover::EdgeIndex e = 0; e < count; ++e) vertices.push_back(polygon.edgeStart(e));
  auto hull = std::make_unique<Hull>();
  hull->corners = convexHull(vertices);
  const Hull* first = nullptr;
  const bool is_first = found_.compare_exchange_strong(first, hull.get(), std::memory_order_acq_rel);
  return (is_first ? hull.release() : first)->corners;
}

}  // namespace detail

template <typename S>
PolygonShape<S>::PolygonShape(const tricover::Polygon& polygon, const PolygonOptions& options, detail::FilledTables<S>)
    : polygon_(polygon), options_(options), is_flat_(options.z_low == 0 && options.z_high == 0) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (options.z_low != -infinity || options.z_high != infinity) {
    check(std::isfinite(options.z_low), "z_low", "finite");
    check(std::isfinite(options.z_high) && options.z_high >= options.z_low, "z_high", "finite and not below z_low");
  }
  check(std::isfinite(options.margin), "margin", "finite");

  const Extremes of_polygon(polygon);
  const auto& [low, high, reach] = of_polygon;
  is_disc_ = polygon.vertexCount() == 3 && low.isZero(0) && high.isZero(0);

  // CollisionObject::computeAABB leaves out a rotation within dummy_precision of the identity, entry by entry: a vertex
  // may be off by that times |x| + |y| <= sqrt(2) reach, within the plane; heights are taken without it.
  const double pad = 2 * static_cast<double>(Eigen::NumTraits<S>::dummy_precision()) * reach;
  const double margin = std::max(options.margin, 0.0) * (1 + 0x1p-50);  // pays for rounding where two margins are added
  const double grown = pad + margin;
  // |R|_2 <= 1 + 1.5 kRigidTolerance if no entry of R^T R - I exceeds it; the rest pays for rounding.
  constexpr double stretch = 1 + 2 * tricover::kRigidTolerance;
  const double planar = reach * stretch + margin;
  const double z_low = isAtAllHeights() ? -planar : options.z_low, z_high = isAtAllHeights() ? planar : options.z_high;
  this->aabb_local.min_ = {-roundUp<S>(grown - low.x()), -roundUp<S>(grown - low.y()), -roundUp<S>(pad - z_low)};
  this->aabb_local.max_ = {roundUp<S>(high.x() + grown), roundUp<S>(high.y() + grown), roundUp<S>(z_high + pad)};
  this->aabb_center.setZero();
  this->aabb_radius =
      roundUp<S>(std::hypot(planar, isAtAllHeights() ? 0 : stretch * std::max(std::abs(z_low), std::abs(z_high))));
  if (!polygon.isComplement()) return;
  this->aabb_radius = kEverywhere<S>;
  this->aabb_local.min_.template head<2>().setConstant(-kEverywhere<S>);
  this->aabb_local.max_.template head<2>().setConstant(kEverywhere<S>);
}

template <typename S>
fcl::AABB<S> PolygonShape<S>::boxAt(const fcl::Transform3<S>& pose) const {
  if (polygon_.isComplement())
    return {fcl::Vector3<S>::Constant(-kEverywhere<S>), fcl::Vector3<S>::Constant(kEverywhere<S>)};
  const tricover::Ring& corners = hull_.cornersOf(polygon_);
  // Along all axes at once; the fourth is nothing.
  const Eigen::Matrix4d m = pose.matrix().template cast<double>();
  const Eigen::Array4d x = m.col(0), y = m.col(1), z = m.col(2), t = m.col(3);
  Eigen::Array4d low = Eigen::Array4d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const tricover::Vec2& corner : corners) {
    const Eigen::Array4d at = x * corner.x() + y * corner.y();
    low = low.min(at);
    high = high.max(at);
  }
  const double reach = static_cast<double>(this->aabb_radius);
  const double z_low = isAtAllHeights() ? -reach : options_.z_low, z_high = isAtAllHeights() ? reach : options_.z_high;
  Eigen::Array4d below = (z * z_low).min(z * z_high), above = (z * z_low).max(z * z_high);
  // Pairs of polygons leave out a tilt within the tolerance, other pairs don't: the box is around both readings. A
  // level shape's margin is a length of the world's plane, another one's of its own.
  Eigen::Array4d margin = (x * x + y * y).sqrt();
  if (keepsPlane(pose)) {
    low[2] = std::min(low[2], 0.0);
    high[2] = std::max(high[2], 0.0);
    const Eigen::Array4d upright(0, 0, std::copysign(1, z[2]), 0);
    below = below.min(upright * z_low).min(upright * z_high);
    above = above.max(upright * z_low).max(upright * z_high);
    margin[0] = std::max(margin[0], 1.0);
    margin[1] = std::max(margin[1], 1.0);
  }
  // (1 + 2^-49) pays for rounding here and where two margins are added. With U = 2^-53
  // and all of the shape within `reach`: the hull errs by 2^-50 of its size, 16 U reach; products and sums in the plane
  // by 5 U reach; the product with z by 2 U reach; four more sums by U (3 reach + |t|) each. In all less than
  // 2^-47 reach + 2^-48 |t|, and of products that underflow 2^-1075 each.
  const Eigen::Array4d pad =
      margin * (std::max(options_.margin, 0.0) * (1 + 0x1p-49)) + 0x1p-47 * reach + 0x1p-48 * t.abs() + 0x1p-1072;
  fcl::AABB<S> box;
  for (int axis = 0; axis < 3; ++axis) {
    const bool known = std::isfinite(pad[axis]) && low[axis] <= high[axis];
    const double down = pad[axis] - (low[axis] + below[axis] + t[axis]),
                 up = high[axis] + above[axis] + t[axis] + pad[axis];
    box.min_[axis] = known ? -notBelow<S>(down) : -std::numeric_limits<S>::infinity();
    box.max_[axis] = known ? notBelow<S>(up) : std::numeric_limits<S>::infinity();
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
