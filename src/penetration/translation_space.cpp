// SPDX-License-Identifier: BSD-3-Clause
#include "penetration/translation_space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hierarchy/inner_discs.h"
#include "numbers/double_double.h"
#include "numbers/rigidity.h"
#include "polygon/edge_walk.h"

namespace tricover::detail {
namespace {

/// Grows with a direction's angle, from -2 to 2 as that does from -pi to pi; four make a full turn.
double turnOf(const Vec2& way) {
  const double length = way.lpNorm<1>(), across = length > 0 ? way.y() / length : 0;  // a point has no direction
  return way.x() >= 0 ? across : (way.y() < 0 ? -2 : 2) - across;
}
constexpr double kFullTurn = 4;

}  // namespace

void PlacedPolygon::prepare(const RegionSides* sides) {
  sides_ = sides;
  is_placed_.assign(polygon.path.size(), 0);
  vertices_.reset(new PlacedVertex[polygon.path.size()]);
}

void PlacedPolygon::place(EdgePosition i) const {
  const std::size_t ring = polygon.ringOf(i);
  PlacedVertex& placed = vertices_[i];
  is_placed_[i] = 1;
  placed = {vertex(i), Vec2::Zero(), Vec2::Zero(), false, false, 0};
  if (i == polygon.edgeEnd(ring) || polygon.path[i] == polygon.path[i + 1]) {
    placed.is_edge = beginsPoint(polygon, i);  // one edge without a length
    return;
  }
  const EdgePosition before = edgesAt(polygon, i).before;
  placed.is_edge = true;
  placed.incoming = way(before, before + 1);
  placed.outgoing = way(i, i + 1);
  if (sides_ == nullptr) return;
  placed.side = static_cast<std::int8_t>((frame_.mirrors(side_) ? -1 : 1) * sides_->rings[ring]);
  const double error = kVertexError * placed.incoming.lpNorm<1>() * placed.outgoing.lpNorm<1>();
  placed.is_reflex = placed.side * cross(placed.incoming, placed.outgoing) < -error;
}

TranslationSpace::TranslationSpace(const PosedPair& pair)
    : frame(pair), a_(pair, frame, 0), b_(pair, frame, 1), pose_a_(pair.pose_a), pose_b_(pair.pose_b) {
  for (int row = 0; row < 2; ++row) {
    const DoubleDouble shift = twoSum(pose_b_.translation()[row], -pose_a_.translation()[row]);
    shift_[row] = shift.high;
    shift_rest_[row] = shift.low;
  }
  pose_a_.translation().setZero();
  const double radii = (pair.a.radius / frame.unit() + pair.b.radius / frame.unit()) * (1 + kLargestDefect);
  noise_ =
      kVertexError * (radii + frame.originOfA().norm()) + (kShiftError * shift_.lpNorm<1>() + 0x1p-1073) / frame.unit();
}

void TranslationSpace::prepareSearch(double farthest) {
  const PolygonData &a = a_.polygon, &b = b_.polygon;
  // The kernel's depths, and so the search, depend on inner discs: they are there, whatever has been paid for.
  for (const PolygonData* polygon : {&a, &b})
    if (!polygon->isDegenerate()) innerDiscsOf(*polygon);
  const RegionSides *of_a = nullptr, *of_b = nullptr;
  // Of a shallow overlap the trees show few pairs of edges.
  if (farthest > 0.25 * std::min(a.radius, b.radius) / frame.unit()) {
    of_a = &regionSidesOf(a), of_b = &regionSidesOf(b);
    const auto edges_a = static_cast<double>(a.path.size()), edges_b = static_cast<double>(b.path.size());
    const double segments = of_a->corners * edges_b + of_b->corners * edges_a;
    // Measured: the fewer they are beside all pairs of edges, the more of them pay.
    are_few_ = segments < 20 * std::pow(edges_a * edges_b / segments, 3);
  }
  // Where all pairs of edges are shown, the sides of rings cost more than they save.
  a_.prepare(are_few_ ? of_a : nullptr);
  b_.prepare(are_few_ ? of_b : nullptr);
}

std::vector<TranslationSpace::Direction> TranslationSpace::directionsOf(const PlacedPolygon& vertices, double radius) {
  std::vector<Direction> directions;
  for (EdgePosition k = 0; k < vertices.size(); ++k) {
    if (!vertices[k].is_edge) continue;
    for (const int side : {1, -1}) {
      const Vec2 along = vertices[k].outgoing * side;
      if (side * vertices[k].side < 0) continue;
      const double reach = (radius + along.norm()) * (1 + 0x1p-20);
      directions.push_back({turnOf(along), vertices[k].at, reach * reach, k});
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
  const std::vector<Disc> discs = overlappingDiscs();
  // What lies in a disc bounds nothing.
  const auto add = [&](const Segment& s) {
    if (std::none_of(discs.begin(), discs.end(), [&](const Disc& disc) { return disc.holds(s.v) && disc.holds(s.w); }))
      segments.push_back(s);
    return true;
  };
  const double farthest = radius + noise_;
  const std::vector<Direction> along_a = directionsOf(a_, farthest), along_b = directionsOf(b_, farthest);
  for (EdgePosition i = 0; i < a_.size(); ++i)
    forEachEdgeBeside(a_[i], along_b, [&](EdgePosition j) { show<true>(i, j, Vec2::Zero(), radius, add); });
  for (EdgePosition j = 0; j < b_.size(); ++j)
    forEachEdgeBeside(b_[j], along_a, [&](EdgePosition i) { show<false>(i, j, Vec2::Zero(), radius, add); });
  return segments;
}

/// Smaller by more than what ends of segments and centres are off by.
std::vector<TranslationSpace::Disc> TranslationSpace::overlappingDiscs() const {
  constexpr int kMost = 16;  // the largest with so many: small ones of both hold less than either with a large one
  std::vector<Disc> discs;
  if (a_.polygon.isDegenerate() || b_.polygon.isDegenerate()) return discs;
  const InnerDiscs &of_a = innerDiscsOf(a_.polygon), &of_b = innerDiscsOf(b_.polygon);
  const auto placed = [&](int side, const InnerDiscs& inner, int k) {
    return Disc{frame.turned(side, {inner.x[k], inner.y[k]}),
                inner.radius[k] * frame.scale(side) * (1 - kLargestDefect)};
  };
  for (int i = 0; i < of_a.count; ++i)
    for (int j = 0; j < of_b.count && (i + 1) * (j + 1) <= kMost; ++j) {
      const Disc a = placed(0, of_a, i), b = placed(1, of_b, j);
      discs.push_back({frame.originOfA() + a.center - b.center, a.radius + b.radius - 8 * noise_});
    }
  return discs;
}

PosedPair TranslationSpace::at(Vec2& t) {
  const Vec2 translation = shift_ + (shift_rest_ + t * frame.unit());
  t = ((translation - shift_) - shift_rest_) / frame.unit();
  pose_b_.translation() = translation;
  return PosedPair(a_.polygon, pose_a_, b_.polygon, pose_b_);
}

TranslationSpace::NearestSegment TranslationSpace::nearestSegment(const Vec2& t) {
  Vec2 at_t = t;
  const PosedPair pair = at(at_t);
  NearestSegment nearest{{}, std::numeric_limits<double>::infinity()};
  for (double radius = 64 * noise_; !std::isfinite(nearest.apart) && std::isfinite(radius); radius *= 16)
    forEachSegment(
        pair, at_t, radius, [](const MeetingEdges&) { return true; },
        [&](const Segment& segment) {
          const double apart = (nearestOnSegment(t, segment.v, segment.w) - t).norm();
          if (apart < nearest.apart) nearest = {segment, apart};
          return true;
        });
  return nearest;
}

TranslationSpace::MeetingEdges TranslationSpace::meetingOf(EdgePosition i, EdgePosition j) const {
  const Vec2 &of_a = a_[i].outgoing, of_b = -b_[j].outgoing;
  Vec2 up_a = Vec2(-of_a.y(), of_a.x()).stableNormalized(), up_b = Vec2(of_b.y(), -of_b.x()).stableNormalized();
  if (up_a.dot(of_b) < 0) {
    up_a = -up_a;
    up_b = -up_b;
  }
  return {a_[i].at - b_[j].at, up_a, up_b, up_a.dot(of_b), std::abs(up_b.dot(of_a))};
}

}  // namespace tricover::detail
