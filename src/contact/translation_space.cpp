// SPDX-License-Identifier: BSD-3-Clause
#include "contact/translation_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numbers/double_double.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// Grows with a direction's angle, from -2 to 2 as that does from -pi to pi; four make a full turn.
double turnOf(const Vec2& way) {
  const double length = way.lpNorm<1>(), across = length > 0 ? way.y() / length : 0;  // a point has no direction
  return way.x() >= 0 ? across : (way.y() < 0 ? -2 : 2) - across;
}
constexpr double kFullTurn = 4;

}  // namespace

TranslationSpace::TranslationSpace(const PolygonData& a, const Pose& pose_a, const PolygonData& b, const Pose& pose_b)
    : polygon_a_(a),
      polygon_b_(b),
      pose_a_(pose_a),
      pose_b_(pose_b),
      unit_(std::max(a.unit, b.unit)),
      inverse_unit_(std::min(a.inverse_unit, b.inverse_unit)),
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
  noise_ = kVertexError * (radii + between_.norm()) + kShiftError * (shift_.lpNorm<1>() * inverse_unit_) +
           0x1p-1073 * inverse_unit_;
}

void TranslationSpace::prepareSearch(double farthest) {
  // How far discs overlap steers a search of this plane: so they are there, whatever has been paid for.
  for (const PolygonData* polygon : {&polygon_a_, &polygon_b_})
    if (!polygon->isDegenerate()) innerDiscsOf(*polygon);
  // Of a shallow overlap the trees show few pairs of edges.
  const double smaller = std::min(polygon_a_.radius, polygon_b_.radius) * inverse_unit_;
  const RegionSides *a = nullptr, *b = nullptr;
  if (farthest > 0.25 * smaller) {
    a = &regionSidesOf(polygon_a_), b = &regionSidesOf(polygon_b_);
    const auto edges_a = static_cast<double>(polygon_a_.path.size()),
               edges_b = static_cast<double>(polygon_b_.path.size());
    const double segments = a->corners * edges_b + b->corners * edges_a;
    // Measured: the fewer they are beside all pairs of edges, the more of them pay.
    are_few_ = segments < 20 * std::pow(edges_a * edges_b / segments, 3);
  }
  // Where all pairs of edges are shown, the sides of rings cost more than they save.
  if (!are_few_) a = b = nullptr;
  a_ = PlacedVertices(polygon_a_, pose_a_, Vec2::Zero(), inverse_unit_, a);
  b_ = PlacedVertices(polygon_b_, pose_b_, between_, inverse_unit_, b);
}

std::vector<TranslationSpace::Direction> TranslationSpace::directionsOf(const PlacedVertices& vertices, double radius) {
  std::vector<Direction> directions;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!vertices[k].is_edge) continue;
    for (const int side : {1, -1}) {
      const Vec2 along = vertices[k].outgoing * side;
      if (side * vertices[k].side < 0) continue;
      const double reach = (radius + along.norm()) * (1 + 0x1p-20);
      directions.push_back({turnOf(along), vertices[k].at, reach * reach, static_cast<std::uint32_t>(k)});
    }
  }
  std::sort(directions.begin(), directions.end(),
            [](const Direction& c, const Direction& d) { return c.turn < d.turn; });
  return directions;
}

/// Of edges with regions on their left those that go back between the two edges of a vertex, and beside these; others
/// cut its region off. All where it isn't known on which side that is. But none that is out of its reach.
template <typename Visit>
void TranslationSpace::forEachEdgeBeside(const PlacedVertex& vertex, const std::vector<Direction>& directions,
                                         Visit visit) {
  constexpr double kBeside = 1e-6;
  if (!vertex.is_edge || vertex.is_reflex) return;
  const Vec2 in = vertex.side < 0 ? vertex.outgoing : Vec2(-vertex.incoming),
             out = vertex.side < 0 ? vertex.incoming : Vec2(-vertex.outgoing);
  double from = turnOf(in), wide = turnOf(out) - from;
  if (wide < -kFullTurn / 2) wide += kFullTurn;
  if (wide > kFullTurn / 2) wide -= kFullTurn;
  // A vertex that turns back may seem to be reflex.
  wide = vertex.side == 0 ? kFullTurn : wide < -0.5 ? kFullTurn / 2 : std::max(wide, 0.0);
  from -= kBeside;
  if (from < -kFullTurn / 2) from += kFullTurn;
  auto at = std::lower_bound(directions.begin(), directions.end(), from,
                             [](const Direction& d, double turn) { return d.turn < turn; });
  double around = 0;
  for (std::size_t left = directions.size(); left > 0; --left, ++at) {
    if (at == directions.end()) {
      at = directions.begin();
      around = kFullTurn;
    }
    if (at->turn + around > from + wide + 2 * kBeside) return;
    if (!((vertex.at - at->start).squaredNorm() > at->reach_square)) visit(at->edge);
  }
}

std::vector<TranslationSpace::Segment> TranslationSpace::segmentsWithin(double radius) const {
  std::vector<Segment> segments;
  // What lies in a disc bounds nothing, if it is farther from its edge than both of what ends and centres are off by.
  const DiscSums sums = sumsOf(largestDiscsOf(polygon_a_), largestDiscsOf(polygon_b_), -8 * noise_, kFewSums);
  const auto add = [&](const Segment& segment) {
    if (!sums.holdSegment(segment.v, segment.w)) segments.push_back(segment);
    return true;
  };
  const double farthest = radius + noise_;
  const std::vector<Direction> along_a = directionsOf(a_, farthest), along_b = directionsOf(b_, farthest);
  for (std::size_t i = 0; i < a_.size(); ++i)
    forEachEdgeBeside(a_[i], along_b,
                      [&](std::size_t j) { show<true>(a_[i], b_[j], i, j, Vec2::Zero(), radius, add); });
  for (std::size_t j = 0; j < b_.size(); ++j)
    forEachEdgeBeside(b_[j], along_a,
                      [&](std::size_t i) { show<false>(a_[i], b_[j], i, j, Vec2::Zero(), radius, add); });
  return segments;
}

DiscSums TranslationSpace::discSums() const {
  // A centre is no less precise than a vertex, and so is t; the fourth is for the roundings where they are compared.
  return sumsOf(discCoverOf(polygon_a_), discCoverOf(polygon_b_), -4 * noise_,
                (polygon_a_.path.size() + polygon_b_.path.size()) / 2);
}

DiscSums TranslationSpace::sumsOf(std::vector<Disc> of_a, std::vector<Disc> of_b, double grown,
                                  std::size_t most) const {
  const auto place = [&](const PolygonData& polygon, const Pose& pose, const Vec2& origin, std::vector<Disc>& discs) {
    const double scale = polygon.unit * inverse_unit_;
    for (Disc& disc : discs)
      disc = {origin + pose.linear() * (disc.center * scale), disc.radius * scale * (1 - kLargestDefect)};
  };
  place(polygon_a_, pose_a_, Vec2::Zero(), of_a);
  place(polygon_b_, pose_b_, between_, of_b);
  return DiscSums(of_a, of_b, grown, most);
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
