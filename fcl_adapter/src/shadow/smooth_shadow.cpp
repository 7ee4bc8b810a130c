// SPDX-License-Identifier: BSD-3-Clause
#include "shadow/smooth_shadow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tricover_fcl {
namespace {

using tricover::Polygon;
using tricover::Ring;
using tricover::Vec2;

constexpr int kFirstTangents = 16;
constexpr int kMostRefinements = 150;  // a third of them bisections: as many as a double has bits
Vec2 leftOf(const Vec2& v) { return {-v.y(), v.x()}; }

bool turnsLeft(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x() > 0; }

}  // namespace

Eigen::Vector3d SmoothBody::support(const Eigen::Vector3d& direction) const {
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

Vec2 SmoothShadow::chordNormal(const Cap& cap) {
  return -leftOf((cap.second.point - cap.first.point).stableNormalized());
}

SmoothShadow::SmoothShadow(const SmoothBody& body, const Eigen::Affine3d& to_polygon, const Slab& slab, double rounding)
    : body_(body),
      to_polygon_(to_polygon),
      slab_(slab),
      rounding_(rounding),
      finest_(std::max(kError * body.reach() / 4, 4 * rounding)) {}

SmoothShadow::Tangents SmoothShadow::tangents() const {
  if (!tangents_.empty()) return tangents_;
  Tangents found;
  for (int i = 0; i < kFirstTangents; ++i) {
    const double angle = 2 * M_PI * i / kFirstTangents;
    found.push_back(tangent({std::cos(angle), std::sin(angle)}));
  }
  return found;
}

Vec2 SmoothShadow::normalNear(std::ptrdiff_t edge, const Vec2& point) const {
  // From the tip of one cap to that of the next; and along a cap C's normal turns about evenly.
  const Tangents all = tangents();
  const auto at = [&](std::size_t i) -> const Tangent& { return all[i % all.size()]; };
  auto first = static_cast<std::size_t>(edge);
  if (leftOf(at(first + 1).normal).dot(point - at(first + 1).point) > 0) ++first;
  const Vec2 chord = at(first + 1).point - at(first).point;
  const double square = chord.squaredNorm();
  const double part = square > 0 ? std::clamp(chord.dot(point - at(first).point) / square, 0.0, 1.0) : 0.5;
  return ((1 - part) * at(first).normal + part * at(first + 1).normal).stableNormalized();
}

bool SmoothShadow::sharpen(const Vec2& normal, double error) {
  constexpr double kSameNormal = -1e-9;
  tangents_ = tangents();
  bool sharpened = false;
  for (std::size_t i = 0; i < tangents_.size();) {
    const Tangent &first = tangents_[i], &second = tangents_[(i + 1) % tangents_.size()];
    const bool holds = normal.dot(first.normal) > 0 && leftOf(first.normal).dot(normal) >= kSameNormal &&
                       leftOf(normal).dot(second.normal) >= kSameNormal;
    const Cap coarse = cap(first, second);
    if (holds && !isFine(coarse, error) && insert(tangents_, tangent(chordNormal(coarse)))) {
      sharpened = true;
    } else {
      ++i;
    }
  }
  return sharpened;
}

/// C's reach along the normal n is the largest n . p over the body's points p with a height in the slab. By Lagrange's
/// duality it is the smallest over all slopes s / c (c > 0, c^2 + s^2 = 1) of
///   max over the body's p of (c n . p - s p.z) / c + (s / c) z,  z the slab's side on which s presses,
/// and any slope's value is at least that: tangents hold C whatever the search comes to. The value is convex in the
/// slope and falls while the maximum's point is beyond z: the search is for the slope whose point is at z, by regula
/// falsi (Illinois), every third step a bisection, because a body's flat parts make the point jump. The point in the
/// slab is where the connection of the last two points passes z. A value errs by what the points do, over c.
SmoothShadow::Tangent SmoothShadow::tangent(const Vec2& normal, double enough) const {
  const Eigen::Vector3d middle = support({normal.x(), normal.y(), 0});
  if (middle.z() >= slab_.low && middle.z() <= slab_.high) return {normal, middle.head<2>(), 2 * rounding_};

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
    if (reach - normal.dot(touched()) <= std::max(8 * rounding_, enough)) break;
  }
  const Vec2 point = touched();
  return {normal, point, std::max(reach - normal.dot(point), 0.0) + rounding_};
}

SmoothShadow::Cap SmoothShadow::cap(const Tangent& first, const Tangent& second) const {
  Cap cap{first, second, first.point, 0, 0};
  const Vec2 chord = second.point - first.point;
  cap.width = chord.stableNorm();
  if (cap.width == 0) return cap;
  // Along the first tangent to the second one. The angle at the tip is obtuse, so the tip is no farther than the chord
  // is wide, which also holds back what rounding does to nearly parallel tangents.
  const Vec2 along = leftOf(first.normal);
  const double way = std::clamp(second.normal.dot(chord) / second.normal.dot(along), 0.0, cap.width);
  cap.tip = first.point + way * along;
  cap.height = std::max(chordNormal(cap).dot(cap.tip - first.point), 0.0);
  return cap;
}

Polygon SmoothShadow::around(const Tangents& tangents) const {
  Ring ring;
  for (std::size_t i = 0; i < tangents.size(); ++i)
    ring.push_back(cap(tangents[i], tangents[(i + 1) % tangents.size()]).tip);
  return Polygon(ring.data(), ring.size(), tricover::FillRule::NonZero);
}

Polygon SmoothShadow::within(const Tangents& tangents) {
  Ring ring;
  for (const Tangent& tangent : tangents) ring.push_back(tangent.point);
  return Polygon(ring.data(), ring.size(), tricover::FillRule::NonZero);
}

Polygon SmoothShadow::inscribed() const { return within(tangents()); }

bool SmoothShadow::insert(Tangents& tangents, const Tangent& tangent) {
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const Vec2 &before = tangents[i].normal, &after = tangents[(i + 1) % tangents.size()].normal;
    if (turnsLeft(before, tangent.normal) && turnsLeft(tangent.normal, after)) {
      tangents.insert(tangents.begin() + static_cast<std::ptrdiff_t>(i) + 1, tangent);
      return true;
    }
  }
  return false;
}

bool SmoothShadow::refineAll(Tangents& tangents, double height, double enough) const {
  Tangents refined;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    refined.push_back(tangents[i]);
    const Cap coarse = cap(tangents[i], tangents[(i + 1) % tangents.size()]);
    if (coarse.width > finest_ && coarse.height > height) refined.push_back(tangent(chordNormal(coarse), enough));
  }
  if (refined.size() == tangents.size()) return false;
  tangents = std::move(refined);
  return true;
}

bool SmoothShadow::refine(std::ptrdiff_t edge, double error) {
  tangents_ = tangents();
  if (edge < 0) return refineAll(tangents_, outlineError(error));
  bool refined = false;
  // From the tip of one cap to that of the next.
  const auto at = [&](std::size_t i) -> const Tangent& { return tangents_[i % tangents_.size()]; };
  const auto first = static_cast<std::size_t>(edge);
  const Cap caps[] = {cap(at(first), at(first + 1)), cap(at(first + 1), at(first + 2))};
  for (const Cap& coarse : caps) {
    if (!isFine(coarse, error)) refined = insert(tangents_, tangent(chordNormal(coarse))) || refined;
  }
  return refined;
}

}  // namespace tricover_fcl
