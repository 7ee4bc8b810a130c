// SPDX-License-Identifier: BSD-3-Clause
#include <fcl/geometry/shape/ellipsoid.h>

#include <algorithm>
#include <cmath>
#include <typeinfo>
#include <utility>
#include <vector>

#include "shadow/shadow.h"
#include "shadow/stadium.h"
#include "shape/errors.h"

namespace tricover_fcl {
namespace {

using tricover::Ring;
using tricover::Vec2;

/// The convex hull of two ellipsoids, axis-parallel and centred at -+half_height on the z axis: sphere, ellipsoid,
/// capsule, cone and cylinder are all of this kind.
struct RoundBody {
  double half_height;
  Eigen::Vector3d bottom, top;  ///< radii; 0 for a point or a flat disc

  /// A point of the body that is farthest in `direction`.
  Eigen::Vector3d support(const Eigen::Vector3d& direction) const;

  /// Radius of a ball around the origin that holds the body.
  double reach() const { return half_height + bottom.cwiseMax(top).maxCoeff(); }
};

Eigen::Vector3d RoundBody::support(const Eigen::Vector3d& direction) const {
  const auto ofEllipsoid = [&](double z, const Eigen::Vector3d& radii) {
    const Eigen::Vector3d scaled = radii.cwiseProduct(direction);
    const double square = scaled.squaredNorm();
    const double norm = square > 1e-290 && square < 1e290 ? std::sqrt(square) : scaled.stableNorm();
    Eigen::Vector3d point = norm > 0 ? radii.cwiseProduct(scaled / norm).eval() : Eigen::Vector3d::Zero().eval();
    point.z() += z;
    return point;
  };
  if (bottom == top) return ofEllipsoid(direction.z() > 0 ? half_height : -half_height, top);
  const Eigen::Vector3d low = ofEllipsoid(-half_height, bottom), high = ofEllipsoid(half_height, top);
  return direction.dot(high) > direction.dot(low) ? high : low;
}

/// The part of a round body in the slab, seen along z, is a convex region C. The outline is made of tangents of C. What
/// it holds beyond C lies in the caps: a cap is the triangle between two tangents and the chord of their points.
class RoundOutline {
 public:
  /// `to_polygon` maps the body's frame to the polygon's; `rounding` bounds the error of a point it maps.
  RoundOutline(const RoundBody& body, const Eigen::Affine3d& to_polygon, const Slab& slab, double rounding)
      : body_(body), to_polygon_(to_polygon), slab_(slab), rounding_(rounding) {
    constexpr int kFirstTangents = 16;
    for (int i = 0; i < kFirstTangents; ++i) {
      const double angle = 2 * M_PI * i / kFirstTangents;
      tangents_.push_back(tangent({std::cos(angle), std::sin(angle)}));
    }
    Eigen::AlignedBox2d box;
    for (const Tangent& tangent : tangents_) box.extend(tangent.point);
    highest_ = std::max(kRoundError / 2 * box.sizes().stableNorm(), 4 * rounding);
    while (halveCaps()) {
    }
  }

  Ring ring() const {
    Ring ring;
    for (std::size_t i = 0; i < tangents_.size(); ++i) ring.push_back(capAfter(i).tip);
    return ring;
  }
  /// The polygon lies in C grown by that length: caps are no higher.
  double excess() const { return highest_; }
  /// C lies in the polygon grown by that length.
  double slack() const {
    double slack = rounding_;
    for (const Tangent& tangent : tangents_) slack = std::max(slack, tangent.slack);
    return slack;
  }

 private:
  /// C lies within `height` + `slack` along the normal; `point` is one of C, at most `slack` short of that.
  struct Tangent {
    Vec2 normal, point;
    double slack;
  };
  struct Cap {
    Vec2 tip, chord_normal;
    double width, height;
  };

  Eigen::Vector3d support(const Eigen::Vector3d& direction) const {
    return to_polygon_ * body_.support(to_polygon_.linear().transpose() * direction);
  }
  Tangent tangent(const Vec2& normal) const;
  Cap capAfter(std::size_t first) const;
  /// Adds a tangent along the chord of each cap that is too high; false if there is none.
  bool halveCaps();

  RoundBody body_;
  Eigen::Affine3d to_polygon_;
  Slab slab_;
  double rounding_, highest_;      ///< a cap's height at most
  std::vector<Tangent> tangents_;  ///< all around, counter-clockwise, none 180 degrees from the next
};

/// C's reach along the normal n is the largest n . p over the body's points p with a height in the slab. By Lagrange's
/// duality it is the smallest over all slopes s / c (c > 0, c^2 + s^2 = 1) of
///   max over the body's p of (c n . p - s p.z) / c + (s / c) z,  z the slab's side on which s presses,
/// and any slope's value is at least that: tangents hold C whatever the search comes to. The value is convex in the
/// slope and falls while the maximum's point is beyond z: the search is for the slope whose point is at z, by regula
/// falsi (Illinois), every third step a bisection, because a body's flat parts make the point jump. The point in the
/// slab is where the connection of the last two points passes z. A value errs by what the points do, over c.
RoundOutline::Tangent RoundOutline::tangent(const Vec2& normal) const {
  const Eigen::Vector3d middle = support({normal.x(), normal.y(), 0});
  if (middle.z() >= slab_.low && middle.z() <= slab_.high) return {normal, middle.head<2>(), 2 * rounding_};

  constexpr int kMostRefinements = 150;  // a third of them bisections: as many as a double has bits
  const double side = middle.z() > slab_.high ? 1 : -1, z = side > 0 ? slab_.high : slab_.low;
  struct End {
    Vec2 slope;  // (c, s)
    Eigen::Vector3d point;
    double weight;
  };
  const auto end = [&](const Vec2& slope, const Eigen::Vector3d& point) {
    return End{slope, point, std::abs(point.z() - z)};
  };
  End beyond = end({1, 0}, middle), within = end({0, side}, support({0, 0, -side}));
  const auto touched = [&]() -> Vec2 {
    const double height = beyond.point.z() - within.point.z();
    return within.point.head<2>() +
           std::clamp((z - within.point.z()) / height, 0.0, 1.0) * (beyond.point - within.point).head<2>();
  };
  double reach = normal.dot(middle.head<2>()) + rounding_;
  bool was_beyond = true;
  for (int i = 0; i < kMostRefinements; ++i) {
    const bool bisect = i % 3 == 2 || !(beyond.weight > 0 && within.weight > 0);
    const double share = bisect ? 0.5 : beyond.weight / (beyond.weight + within.weight);
    const Vec2 slope = ((1 - share) * beyond.slope + share * within.slope).normalized();
    if (slope == beyond.slope || slope == within.slope) break;
    const Eigen::Vector3d p = support({slope.x() * normal.x(), slope.x() * normal.y(), -slope.y()});
    const double value = normal.dot(p.head<2>()) + slope.y() * (z - p.z()) / slope.x();
    reach = std::min(reach, value + 2 * rounding_ / slope.x());
    const bool is_beyond = side * (p.z() - z) > 0;
    (is_beyond ? beyond : within) = end(slope, p);
    if (is_beyond == was_beyond) (is_beyond ? within : beyond).weight /= 2;
    was_beyond = is_beyond;
    if (reach - normal.dot(touched()) <= 8 * rounding_) break;
  }
  const Vec2 point = touched();
  return {normal, point, std::max(reach - normal.dot(point), 0.0) + rounding_};
}

RoundOutline::Cap RoundOutline::capAfter(std::size_t i) const {
  const Tangent &first = tangents_[i], &second = tangents_[(i + 1) % tangents_.size()];
  const Vec2 chord = second.point - first.point, forth = chord.stableNormalized();
  Cap cap{first.point, {forth.y(), -forth.x()}, chord.stableNorm(), 0};
  if (cap.width == 0) return cap;
  // Along the first tangent to the second one. The angle at the tip is obtuse, so the tip is no farther than the chord
  // is wide, which also holds back what rounding does to nearly parallel tangents.
  const Vec2 along(-first.normal.y(), first.normal.x());
  const double way = std::clamp(second.normal.dot(chord) / second.normal.dot(along), 0.0, cap.width);
  cap.tip += way * along;
  cap.height = std::max(cap.chord_normal.dot(cap.tip - first.point), 0.0);
  return cap;
}

bool RoundOutline::halveCaps() {
  std::vector<Tangent> finer;
  for (std::size_t i = 0; i < tangents_.size(); ++i) {
    finer.push_back(tangents_[i]);
    const Cap cap = capAfter(i);
    if (cap.width > 4 * rounding_ && cap.height > highest_) finer.push_back(tangent(cap.chord_normal));
  }
  const bool found = finer.size() > tangents_.size();
  tangents_ = std::move(finer);
  return found;
}

template <typename S>
RoundBody bodyOf(const fcl::CollisionGeometry<S>& shape) {
  const fcl::NODE_TYPE type = shape.getNodeType();
  if (type == fcl::GEOM_ELLIPSOID) {
    const Eigen::Vector3d radii = static_cast<const fcl::Ellipsoid<S>&>(shape).radii.template cast<double>();
    if (!radii.allFinite()) refuse(className(typeid(shape)), "a radius is not finite");
    return {0, radii, radii};
  }
  const auto [radius, half_height] = roundSizeOf(shape);
  const bool is_flat = type == fcl::GEOM_CONE || type == fcl::GEOM_CYLINDER;
  const Eigen::Vector3d bottom(radius, radius, is_flat ? 0 : radius);
  return {half_height, bottom, type == fcl::GEOM_CONE ? Eigen::Vector3d(0, 0, 0) : bottom};
}

}  // namespace

template <typename S>
std::optional<Shadow> makeRoundShadow(const fcl::CollisionGeometry<S>& shape, const View& view) {
  const RoundBody body = bodyOf(shape);
  const double rounding = mappingError(view.to_polygon, body.reach());
  const Slab slab = grown(view.slab, rounding);
  const Eigen::Vector3d up = view.to_polygon.linear().row(2).transpose();
  const Slab heights{(view.to_polygon * body.support(-up)).z(), (view.to_polygon * body.support(up)).z()};
  if (heights.low > slab.high || heights.high < slab.low) return std::nullopt;
  const RoundOutline outline(body, view.to_polygon, slab, rounding);
  Shadow shadow = shadowOf(outlineOf(outline.ring()), outline.slack(), heights, view);
  shadow.excess = outline.excess();
  return shadow;
}

template std::optional<Shadow> makeRoundShadow(const fcl::CollisionGeometry<float>&, const View&);
template std::optional<Shadow> makeRoundShadow(const fcl::CollisionGeometry<double>&, const View&);

}  // namespace tricover_fcl
