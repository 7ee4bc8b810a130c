// SPDX-License-Identifier: BSD-3-Clause
#include "contact/translation_space.h"

#include <algorithm>
#include <cmath>

#include "numbers/double_double.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"

namespace tricover::detail {

TranslationSpace::Vertices TranslationSpace::verticesOf(const PolygonData& polygon, const Pose& pose,
                                                        const Vec2& origin) const {
  Vertices result;
  result.reserve(polygon.path.size());
  for (std::size_t r = 0; r < polygon.ringCount(); ++r) {
    const std::size_t begin = polygon.edgeBegin(r), end = polygon.edgeEnd(r);
    const auto isEdge = [&](std::size_t i) { return polygon.path[i] != polygon.path[i + 1]; };
    const auto edge = [&](std::size_t i) { return inUnits(pose, polygon.path[i + 1], polygon.path[i]); };
    std::size_t last = end;
    while (last > begin && !isEdge(last - 1)) --last;
    Vec2 incoming = last > begin ? edge(last - 1) : Vec2(Vec2::Zero());
    for (std::size_t i = begin; i <= end; ++i) {
      Vertex vertex{origin + inUnits(pose, polygon.path[i], polygon.origin), Vec2::Zero(), Vec2::Zero(), false};
      if (i < end && isEdge(i)) {
        vertex.incoming = incoming;
        incoming = vertex.outgoing = edge(i);
        vertex.is_edge = true;
      }
      result.push_back(vertex);
    }
    // A ring that is one point is one edge without a length.
    if (last == begin) result[begin].is_edge = true;
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
}

void TranslationSpace::prepareSearch() {
  // How far discs overlap steers a search of this plane: so they are there, whatever has been paid for.
  for (const PolygonData* polygon : {&polygon_a_, &polygon_b_})
    if (!polygon->isDegenerate()) innerDiscsOf(*polygon);
  a_ = verticesOf(polygon_a_, pose_a_, Vec2::Zero());
  b_ = verticesOf(polygon_b_, pose_b_, between_);
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
  const Vec2 &of_a = a_[i].outgoing, of_b = -b_[j].outgoing;
  Vec2 up_a = Vec2(-of_a.y(), of_a.x()).stableNormalized(), up_b = Vec2(of_b.y(), -of_b.x()).stableNormalized();
  if (up_a.dot(of_b) < 0) {
    up_a = -up_a;
    up_b = -up_b;
  }
  return {
      a_[i].at - b_[j].at,          up_a, up_b, up_a.dot(of_b), std::abs(up_b.dot(of_a)), static_cast<std::uint32_t>(i),
      static_cast<std::uint32_t>(j)};
}

}  // namespace tricover::detail
