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
  Vertices result{std::vector<Vec2>(n),      std::vector<Vec2>(n, Vec2::Zero()), std::vector<Vec2>(n, Vec2::Zero()),
                  std::vector<double>(n, 0), std::vector<double>(n, 0),          std::vector<char>(n, 0)};
  const auto inUnits = [&](const Vec2& p, const Vec2& q) { return Vec2(turn * (p * inverse_unit - q * inverse_unit)); };
  for (std::size_t i = 0; i < n; ++i) result.at[i] = origin + inUnits(polygon.path[i], polygon.origin);
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t begin = polygon.edgeBegin(r), end = polygon.edgeEnd(r);
    std::size_t last = end;
    for (std::size_t i = begin; i < end; ++i) {
      if (polygon.path[i] == polygon.path[i + 1]) continue;
      result.is_edge[i] = 1;
      result.outgoing[i] = inUnits(polygon.path[i + 1], polygon.path[i]);
      result.out_of[i] = result.outgoing[i].lpNorm<1>();
      last = i;
    }
    // A ring that is one point is one edge without a length.
    if (last == end) result.is_edge[begin] = 1;
    for (std::size_t i = begin; i < end && last != end; ++i) {
      if (!result.is_edge[i]) continue;
      result.incoming[i] = result.outgoing[last];
      result.into[i] = result.out_of[last];
      last = i;
    }
  }
  return result;
}

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
                  (polygon_a_.path.size() + polygon_b_.path.size()) / 2);
}

PosedPair TranslationSpace::at(Vec2& t) {
  const Vec2 translation = shift_ + (shift_rest_ + t * unit_);
  t = ((translation - shift_) - shift_rest_) * inverse_unit_;
  pose_b_.translation() = translation;
  return PosedPair(polygon_a_, pose_a_, polygon_b_, pose_b_);
}

TranslationSpace::MeetingEdges TranslationSpace::meetingOf(std::size_t i, std::size_t j) const {
  const Vec2 &of_a = a_.outgoing[i], of_b = -b_.outgoing[j];
  Vec2 up_a = Vec2(-of_a.y(), of_a.x()).stableNormalized(), up_b = Vec2(of_b.y(), -of_b.x()).stableNormalized();
  if (up_a.dot(of_b) < 0) {
    up_a = -up_a;
    up_b = -up_b;
  }
  return {
      a_.at[i] - b_.at[j],          up_a, up_b, up_a.dot(of_b), std::abs(up_b.dot(of_a)), static_cast<std::uint32_t>(i),
      static_cast<std::uint32_t>(j)};
}

}  // namespace tricover::detail
