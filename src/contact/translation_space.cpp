// SPDX-License-Identifier: BSD-3-Clause
#include "contact/translation_space.h"

#include <algorithm>
#include <cmath>

#include "numbers/double_double.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"

namespace tricover::detail {

TranslationSpace::Vertices TranslationSpace::verticesOf(const PolygonData& polygon, const Pose& pose,
                                                        const Vec2& origin, double inverse_unit) {
  const std::size_t n = polygon.path.size();
  const Eigen::Matrix2d turn = pose.linear();
  Vertices result{std::vector<Vec2>(n), std::vector<Vec2>(n, Vec2::Zero()), std::vector<Vec2>(n, Vec2::Zero()),
                  std::vector<char>(n, 0)};
  const auto inUnits = [&](const Vec2& p, const Vec2& q) { return Vec2(turn * (p * inverse_unit - q * inverse_unit)); };
  for (std::size_t i = 0; i < n; ++i) result.at[i] = origin + inUnits(polygon.path[i], polygon.origin);
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t begin = polygon.edgeBegin(r), end = polygon.edgeEnd(r);
    std::size_t last = end;
    for (std::size_t i = begin; i < end; ++i) {
      if (polygon.path[i] == polygon.path[i + 1]) continue;
      result.is_edge[i] = 1;
      result.outgoing[i] = inUnits(polygon.path[i + 1], polygon.path[i]);
      last = i;
    }
    // A ring that is one point is one edge without a length.
    if (last == end) result.is_edge[begin] = 1;
    for (std::size_t i = begin; i < end && last != end; ++i) {
      if (!result.is_edge[i]) continue;
      result.incoming[i] = result.outgoing[last];
      last = i;
    }
  }
  return result;
}

// In units of U, r_a and r_b the radii, c the way between the origins; reach is their sum:
//   a vertex of a     p - q 1, products 1, sum 1                           3 r_a in either coordinate
//   one of b          the same, the sum with c 1, c itself 1               4 r_b + 2 c
//   a segment's end   their difference 1                                   4 r_a + 5 r_b + 3 c
// which is sqrt2 5 reach in any direction; the margin is part of it, too. at() rounds a translation to the spacing of
// doubles at t_b - t_a + t, of which no component is larger than reach and shift: two sums there and two differences
// back, 4.
constexpr double kVertexError = 16 * kUnitRoundoff, kShiftError = 4 * kUnitRoundoff;
static_assert(kVertexError >= kUnitRows * kRoot2 * errorOf(5) + errorOf(4));

TranslationSpace::TranslationSpace(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b,
                                   double margin)
    : polygon_a_(a),
      polygon_b_(b),
      pose_a_(pose_a),
      pose_b_(pose_b),
      unit_(std::max(a.unit, b.unit)),
      inverse_unit_(std::min(a.inverse_unit, b.inverse_unit)),
      margin_(margin / unit_),
      quarter_origin_(pose_a.linear() * (a.origin / 4) + pose_a.translation() / 4) {
  // How far discs overlap steers a search of this plane: so they are there, whatever has been paid for.
  for (const PolygonData* polygon : {&a, &b})
    if (!polygon->isDegenerate()) innerDiscsOf(*polygon);
  const auto& ra = pose_a.matrix();
  const auto& rb = pose_b.matrix();
  for (int row = 0; row < 2; ++row) {
    const DoubleDouble shift = twoSum(rb(row, 2), -ra(row, 2));
    shift_[row] = shift.high;
    shift_rest_[row] = shift.low;
    const auto inUnits = [&](const Eigen::Matrix3d& m, const Vec2& s) {
      return twoProduct(m(row, 0), s.x() * inverse_unit_) + twoProduct(m(row, 1), s.y() * inverse_unit_);
    };
    const DoubleDouble scaled{shift.high * inverse_unit_, shift.low * inverse_unit_};
    between_[row] = (inUnits(rb, b.origin) - inUnits(ra, a.origin) + scaled).high;
  }
  pose_a_.translation().setZero();
  const double radii = (a.radius * inverse_unit_ + b.radius * inverse_unit_) * (1 + kLargestDefect);
  noise_ = kVertexError * (radii + between_.norm() + margin_) + kShiftError * (shift_.lpNorm<1>() * inverse_unit_) +
           0x1p-1073 * inverse_unit_;
  if (!isFinite()) return;
  a_ = verticesOf(a, pose_a, Vec2::Zero(), inverse_unit_);
  b_ = verticesOf(b, pose_b, between_, inverse_unit_);
}

DiscSums TranslationSpace::discSums() const {
  const auto posed = [&](const PolygonData& polygon, const Pose& pose, const Vec2& origin) {
    const double scale = polygon.unit * inverse_unit_;
    std::vector<Disc> discs = discCoverOf(polygon);
    for (Disc& disc : discs)
      disc = {origin + pose.linear() * (disc.center * scale), disc.radius * scale * (1 - kLargestDefect)};
    return discs;
  };
  // A centre is no less precise than a vertex, and so is t; the fourth is for the roundings where they are compared.
  return DiscSums(posed(polygon_a_, pose_a_, Vec2::Zero()), posed(polygon_b_, pose_b_, between_), margin_ - 4 * noise_,
                  polygon_a_.path.size() + polygon_b_.path.size());
}

PosedPair TranslationSpace::at(Vec2& t) {
  const Vec2 translation = shift_ + (shift_rest_ + t * unit_);
  t = ((translation - shift_) - shift_rest_) * inverse_unit_;
  pose_b_.translation() = translation;
  return PosedPair(polygon_a_, pose_a_, polygon_b_, pose_b_);
}

/// False only if the edges at the vertex certainly leave to both sides of the other's line. A direction's coordinates
/// err by a difference, a product and a sum, their cross product by these of both, a product and a difference: 8U.
bool TranslationSpace::mayBound(const Vertices& polygon, std::size_t i, const Vec2& edge) {
  const Vec2 &in = polygon.incoming[i], &out = polygon.outgoing[i];
  static_assert(kVertexError >= kUnitRows * errorOf(3 + 3 + 2));
  const double bound = kVertexError * edge.lpNorm<1>(), from = cross(edge, in), to = cross(edge, out);
  const bool passes = (from > bound * in.lpNorm<1>() && to > bound * out.lpNorm<1>()) ||
                      (-from > bound * in.lpNorm<1>() && -to > bound * out.lpNorm<1>());
  return !passes;
}

bool TranslationSpace::isNear(const Vec2& t, double radius, const Segment& segment) {
  return squaredDistanceToSegment(t, segment.v, segment.w) <= radius * radius;
}

}  // namespace tricover::detail
