// SPDX-License-Identifier: BSD-3-Clause
#include "impact/convex_slide.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "convex/convex_ring.h"
#include "convex/separating_edge.h"
#include "hierarchy/placement.h"
#include "impact/cubic.h"
#include "numbers/rigidity.h"
#include "numbers/rounding.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

/// A point that turns about itself slides.
bool slides(const PolygonData& polygon, const Motion& motion) {
  const bool turns = !turnOf(motion).isZero() && !(polygon.isPoint() && motion.pivot == polygon.origin);
  return !turns && wayOf(motion).isStraight();
}

/// A point or a segment as convexEntry() takes it, and all that it reads: lanes that are all one of the ends, and the
/// two sides, if any.
class SmallDegenerate {
 public:
  const SmallPolygon* of(const PolygonData& polygon) {
    const std::size_t edge = polygon.degenerate_edge;
    const Vec2 start = polygon.inUnits(polygon.path[edge]), end = polygon.inUnits(polygon.path[edge + 1]);
    std::fill_n(small_.x = x_, kLanes, static_cast<float>(end.x()));
    std::fill_n(small_.y = y_, kLanes, static_cast<float>(end.y()));
    std::fill_n(small_.nx = nx_, kLanes, 0.0f);
    std::fill_n(small_.ny = ny_, kLanes, 0.0f);
    std::fill_n(small_.d = d_, kLanes, 1e30f);  // without an edge: never the best
    small_.lanes = kLanes;
    small_.count = polygon.isPoint() ? 1 : 2;
    if (polygon.isPoint()) return &small_;
    x_[0] = static_cast<float>(start.x());
    y_[0] = static_cast<float>(start.y());
    const Vec2 along = (end - start).normalized(), left(-along.y(), along.x());
    setSide(0, left, start);
    setSide(1, -left, start);
    return &small_;
  }

 private:
  void setSide(int side, const Vec2& out, const Vec2& start) {
    nx_[side] = static_cast<float>(out.x());
    ny_[side] = static_cast<float>(out.y());
    d_[side] = static_cast<float>(out.dot(start));
  }

  SmallPolygon small_;
  float x_[kLanes], y_[kLanes], nx_[kLanes], ny_[kLanes], d_[kLanes];
};

/// The position in the path of a small polygon's edge. A segment's lead there and back, and have what is outside on
/// their left (BesideEdge).
std::uint32_t positionOf(const PolygonData& polygon, int edge) {
  const auto position = static_cast<std::uint32_t>(edge);
  if (!polygon.isDegenerate()) return position;
  const std::uint32_t there = polygon.degenerate_edge;
  const bool is_next_back = polygon.path[there + 1] != polygon.path[there + 2];
  return edge == 0 ? there : there + (is_next_back ? 1 : 2);
}

/// The number of the edge that is met.
EdgeIndex edgeMet(const PolygonData& given, const PolygonData& taken, std::uint32_t position, double part) {
  return givenEdge(given, taken, taken.isDegenerate() ? taken.degenerate_edge : position, part);
}

double lengthOne(Double2 v) {
  const Double2 lengths = absolute(v);
  return lengths[0] + lengths[1];
}

// The gap along a normal as long as the edge's image u is linear in time. With M as in BesideEdge and S = |s|_1 of the
// way s that b moves as a sees it, in units of U |u|:
//   the gap at time 0                              36 M, for which 48 M are kept
//   the speed     s 1, normal 3.42, product, sum   6.42 S
//   less the slack; that at time 1                 M; M + S
//   a quotient, and 1 less that                    2 S
// in all 38 M + 10 S: 48 of either are kept.

/// The gap along a normal while b moves, less the margin: linear in time.
struct MovingGap {
  /// All but the margin as many times as long as they are as the normal is.
  MovingGap(double gap, double error_of_gap, Double2 normal, Double2 way_of_other, double margin)
      : error(error_of_gap + 3 * PosedPair::kWayError * lengthOne(way_of_other) * lengthOne(normal)),
        speed(dot(normal, way_of_other)),
        beyond(gap - error) {
    if (margin > 0) beyond -= margin * std::sqrt(dot(normal, normal)) * (1 + 16 * kUnitRoundoff);
  }

  /// For how much of the time they are certainly apart, from time 0 on.
  double sinceBegin() const { return shareOf(beyond, -speed); }
  /// Until time 1.
  double untilEnd() const { return shareOf(beyond + speed, speed); }

  double error;
  double speed;
  double beyond;  ///< by how much the gap is certainly more than the margin, at time 0

 private:
  double shareOf(double beyond_there, double approach) const {
    if (!isKnownBy(error) || !(beyond_there > 0)) return 0;
    return approach > 0 ? beyond_there / approach : std::numeric_limits<double>::infinity();
  }
};

/// An edge's line, beyond which the other polygon is for a part of the time.
struct PartingEdge : BesideEdge {
  PartingEdge(const PosedPair& placement, Double2 way, double margin, const ConvexGap& guess)
      : BesideEdge(placement, guess.of_a, positionOf(guess.of_a ? placement.a : placement.b, guess.edge)),
        of_a(guess.of_a),
        edge(positionOf(guess.of_a ? placement.a : placement.b, guess.edge)),
        way_of_other(of_a ? way : -way),
        moving(gap, error, outwards, way_of_other, margin) {}

  bool of_a;
  std::uint32_t edge;
  Double2 way_of_other;  ///< as the edge's polygon sees it
  MovingGap moving;
};

/// Of the edges at a polygon's lowest vertex along a normal, that which climbs less.
struct FlatterEdge {
  FlatterEdge(const PolygonData& polygon, std::uint32_t lowest, Double2 normal) {
    if (polygon.isDegenerate()) {
      edge = polygon.degenerate_edge;
      is_forward = polygon.path[lowest] == polygon.path[edge];
      far = is_forward ? edge + 1 : edge;
      climb = dot(normal, load2(polygon.path[far].data()) - load2(polygon.path[lowest].data()));
      return;
    }
    const ConvexRing ring = convexRing(polygon);
    const std::uint32_t before = ring.previous(lowest);
    const double climb_after = dot(normal, ring.edge(lowest)), climb_before = -dot(normal, ring.edge(before));
    is_forward = climb_after <= climb_before;
    edge = is_forward ? lowest : before;
    far = is_forward ? ring.next(lowest) : before;
    climb = std::min(climb_after, climb_before);
  }

  std::uint32_t edge, far;  ///< the edge's other end
  double climb;
  bool is_forward;  ///< it begins at the lowest vertex
};

/// A vertex of a and one of b, by their positions in the paths.
struct Corners {
  std::uint32_t of_a = 0, of_b = 0;
};

class Slide {
 public:
  Slide(const PolygonData& a, const PolygonData& corners_a, const Motion& motion_a, const PolygonData& b,
        const PolygonData& corners_b, const Motion& motion_b, double margin)
      : given_a_(a),
        given_b_(b),
        motion_a_(motion_a),
        motion_b_(motion_b),
        margin_(margin),
        way_(load2(motion_b.shift.data()) - load2(motion_a.shift.data())),
        at_(corners_a, motion_a.start, corners_b, motion_b.start) {}

  FirstContact run(Impact& impact) const {
    if (!squarable(at_.error() / PosedPair::kWayError + lengthOne(way_) + margin_)) return FirstContact::unknown(0);
    if (discsStayApart()) return FirstContact::never();
    if (at_.a.isPoint()) return meetCorners({}, 0, impact);
    ConvexGap guess;
    if (!guessEdge(false, guess)) return FirstContact::unknown(0);
    const PartingEdge first(at_, way_, margin_, guess);
    FirstContact found = FirstContact::unknown(first.moving.sinceBegin());
    if (found.time > 1) return FirstContact::never();
    if (found.time > 0 && touches(first, found.time, impact)) return FirstContact::touch(found.time, 0, 0);
    if (margin_ > 0) found = meetCorners(cornersBeside(first), found.time, impact);
    if (found.verdict != FirstContact::Verdict::Unknown || found.time == 0) return found;
    // Beside that edge they pass by each other, if another one parts them from before then on.
    const bool passes =
        guessEdge(true, guess) && 1 - PartingEdge(at_, way_, margin_, guess).moving.untilEnd() < found.time;
    return passes ? FirstContact::never() : found;
  }

 private:
  // Rounding moves the nearest point along the way, by so little that the distance differs in the second order only;
  // otherwise as for PartingEdge, with a way's 16 M, and 5 of M and S each for the point and its norm.
  bool discsStayApart() const {
    const Double2 from = at_.way();
    const Vec2 start(from[0], from[1]), way(way_[0], way_[1]);
    const double reach = (at_.a.radius + at_.b.radius + margin_) * (1 + kLargestDefect);
    const Vec2 nearest = start + nearestOnSegment(-start, Vec2::Zero(), way);
    return nearest.norm() > reach + 2 * (at_.error() + PosedPair::kWayError * lengthOne(way_));
  }

  /// The edge that parts them longest, as floats see it: from time 0 on, or backwards from time 1.
  bool guessEdge(bool backwards, ConvexGap& guess) const {
    SmallDegenerate own_a, own_b;
    const SmallPolygon *a = smallOf(at_.a, own_a), *b = smallOf(at_.b, own_b);
    if (a == nullptr || b == nullptr) return false;
    UnitMap map = at_.inUnits(0).map;  // a guess needs no bounds
    Double2 way = at_.inUnitsOfA(way_);
    const double reach = margin_ * at_.a.inverse_unit;
    if (!(std::abs(map.tx) + std::abs(map.ty) + lengthOne(way) + reach < 0x1p60)) return false;  // floats may overflow
    if (backwards) {
      map.tx += way[0];
      map.ty += way[1];
      way = -way;
    }
    guess = convexEntry(*a, *b, map, way[0], way[1], reach);
    return true;
  }

  static const SmallPolygon* smallOf(const PolygonData& polygon, SmallDegenerate& own) {
    return polygon.isDegenerate() ? own.of(polygon) : topOf(polygon).small_convex;
  }

  /// Where along the edge a vertex of the other polygon is at a time, times the edge's length.
  double along(const PartingEdge& parting, std::uint32_t vertex, double time) const {
    const Double2 from = parting.of_a ? at_.way(at_.a.path[parting.edge], at_.b.path[vertex])
                                      : -at_.way(at_.a.path[vertex], at_.b.path[parting.edge]);
    return dot(parting.along, from + time * parting.way_of_other);
  }

  /// Whether the other polygon's lowest vertex is beside the edge once it comes to its line, or what lies in the line
  /// of an edge there.
  bool touches(const PartingEdge& parting, double time, Impact& impact) const {
    const bool of_a = parting.of_a;
    const PolygonData &own = of_a ? at_.a : at_.b, &other = of_a ? at_.b : at_.a;
    const double square = dot(parting.along, parting.along), slack = parting.moving.error;
    const auto isBeside = [&](double at) { return at >= -slack && at <= square + slack; };
    const std::uint32_t lowest = parting.lowest;
    const FlatterEdge flatter(other, lowest, parting.turned);
    const double at = along(parting, lowest, time);
    double share = 0;  // of that edge, from the lowest vertex on
    if (!isBeside(at)) {
      const double at_far = along(parting, flatter.far, time), end = at < 0 ? 0 : square;
      const bool reaches = at < 0 ? at_far >= -slack : at_far <= square + slack;
      if (!reaches || !(flatter.climb <= slack)) return false;
      share = std::clamp((end - at) / (at_far - at), 0.0, 1.0);
    }
    const Vec2 on_other = other.path[lowest] + share * (other.path[flatter.far] - other.path[lowest]);
    const Motion& motion = of_a ? motion_b_ : motion_a_;
    const Double2 outwards = parting.outwards * (1 / std::sqrt(square));
    const Vec2 normal(outwards[0], outwards[1]);
    const EdgeIndex own_edge =
        edgeMet(of_a ? given_a_ : given_b_, own, parting.edge, std::clamp(at / square, 0.0, 1.0));
    const EdgeIndex other_edge =
        edgeMet(of_a ? given_b_ : given_a_, other, flatter.edge, flatter.is_forward ? share : 1 - share);
    impact.time = std::max(time, std::numeric_limits<double>::denorm_min());
    impact.point = motion.start * on_other + time * motion.shift - 0.5 * margin_ * normal;
    impact.normal = of_a ? normal : Vec2(-normal);
    impact.edge_a = of_a ? own_edge : other_edge;
    impact.edge_b = of_a ? other_edge : own_edge;
    return true;
  }

  /// The end of the edge that the other polygon's lowest vertex is nearer to when it comes to the edge's line, and that
  /// vertex: around one of the ends the round corner is that they meet, if not the edge.
  Corners cornersBeside(const PartingEdge& parting) const {
    const MovingGap& gap = parting.moving;
    const double time = gap.speed < 0 ? gap.beyond / -gap.speed : 0, square = dot(parting.along, parting.along);
    const std::uint32_t end = parting.edge + (2 * along(parting, parting.lowest, time) > square ? 1 : 0);
    return parting.of_a ? Corners{end, parting.lowest} : Corners{parting.lowest, end};
  }

  /// As run(), from a vertex of a on: the disc around it, as large as the margin, is what the one of b comes to, where
  /// no other ones are farther along the normal there. Those that are, are next.
  FirstContact meetCorners(Corners corners, double time, Impact& impact) const {
    constexpr int kMostTries = 4;
    for (int tries = 0; tries < kMostTries; ++tries) {
      const Double2 from = at_.way(at_.a.path[corners.of_a], at_.b.path[corners.of_b]);
      const Double2 normal = from + timeToDisc(from) * way_;
      const GapAlong parting(at_, normal);
      const MovingGap gap(parting.gap, parting.error, normal, way_, margin_);
      time = std::max(time, gap.sinceBegin());
      if (time > 1) return FirstContact::never();
      const Double2 between = from + time * way_;
      const double length = std::sqrt(dot(between, between)), slack = 2 * gap.error / std::sqrt(dot(normal, normal));
      if (time > 0 && length <= margin_ + slack) {
        describeCorners(corners, time, between * (1 / length), impact);
        return FirstContact::touch(time, 0, 0);
      }
      if (parting.support_a == corners.of_a && parting.lowest_b == corners.of_b) break;
      corners = {parting.support_a, parting.lowest_b};
    }
    return FirstContact::unknown(time);
  }

  /// When the way from one point to another is as short as the margin, or shortest: of the time, 0 to 1.
  double timeToDisc(Double2 from) const {
    const double square = dot(way_, way_), ahead = -dot(from, way_), outside = dot(from, from) - margin_ * margin_;
    const double root_square = ahead * ahead - square * outside;
    const double time = root_square > 0 ? outside / (ahead + std::sqrt(root_square)) : ahead / square;
    return time > 0 ? std::min(time, 1.0) : 0;
  }

  void describeCorners(Corners corners, double time, Double2 normal, Impact& impact) const {
    const auto edgeAt = [](const PolygonData& given, const PolygonData& taken, std::uint32_t vertex) {
      return edgeMet(given, taken, vertex + 1 < taken.path.size() ? vertex : 0, 0);
    };
    const Vec2 on_b = at_.b.path[corners.of_b];
    impact.time = std::max(time, std::numeric_limits<double>::denorm_min());
    impact.normal = Vec2(normal[0], normal[1]);
    impact.point = motion_b_.start * on_b + time * motion_b_.shift - 0.5 * margin_ * impact.normal;
    impact.edge_a = edgeAt(given_a_, at_.a, corners.of_a);
    impact.edge_b = edgeAt(given_b_, at_.b, corners.of_b);
  }

  const PolygonData &given_a_, &given_b_;
  const Motion &motion_a_, &motion_b_;
  double margin_;
  Double2 way_;
  PosedPair at_;  ///< at time 0
};

}  // namespace

FirstContact slideConvex(const PolygonData& a, const Motion& motion_a, const PolygonData& b, const Motion& motion_b,
                         double margin, Impact& impact) {
  if (!slides(a, motion_a) || !slides(b, motion_b)) return FirstContact::unknown(0);
  const auto taken = [](const PolygonData& polygon) { return polygon.isDegenerate() ? &polygon : cornersOf(polygon); };
  const PolygonData *corners_a = taken(a), *corners_b = taken(b);
  const auto isSmall = [](const PolygonData* corners) {
    return corners != nullptr && corners->path.size() <= SmallPolygon::kMost + 1;
  };
  if (!isSmall(corners_a) || !isSmall(corners_b)) return FirstContact::unknown(0);
  return Slide(a, *corners_a, motion_a, b, *corners_b, motion_b, margin).run(impact);
}

}  // namespace tricover::detail
