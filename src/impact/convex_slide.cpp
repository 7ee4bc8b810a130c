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

bool slides(const Motion& motion) { return turnOf(motion).isZero() && wayOf(motion).isStraight(); }

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

/// An edge's line, beyond which the other polygon is for a part of the time.
struct PartingEdge : BesideEdge {
  PartingEdge(const Placement& placement, Double2 way, double margin, const ConvexGap& guess)
      : BesideEdge(placement, guess.of_a, static_cast<std::uint32_t>(guess.edge)),
        of_a(guess.of_a),
        edge(static_cast<std::uint32_t>(guess.edge)),
        way_of_other(of_a ? way : -way),
        speed(dot(outwards, way_of_other)) {
    error += 3 * Placement::kWayError * lengthOne(way) * lengthOne(along);
    beyond = gap - error;
    if (margin > 0) beyond -= margin * std::sqrt(dot(along, along)) * (1 + 16 * kUnitRoundoff);
  }

  /// For how much of the time they are certainly apart, from time 0 on.
  double sinceBegin() const { return shareOf(beyond, -speed); }
  /// Until time 1.
  double untilEnd() const { return shareOf(beyond + speed, speed); }

  bool of_a;
  std::uint32_t edge;
  Double2 way_of_other;  ///< as the edge's polygon sees it
  double speed;          ///< of the gap
  double beyond;         ///< by how much that is certainly more than the margin, at time 0

 private:
  double shareOf(double beyond_there, double approach) const {
    if (!isKnown() || !(beyond_there > 0)) return 0;
    return approach > 0 ? beyond_there / approach : std::numeric_limits<double>::infinity();
  }
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
    if (!squarable(at_.error() / Placement::kWayError + lengthOne(way_) + margin_)) return FirstContact::unknown(0);
    if (discsStayApart()) return FirstContact::never();
    ConvexGap guess;
    if (!guessEdge(false, guess)) return FirstContact::unknown(0);
    const PartingEdge first(at_, way_, margin_, guess);
    const double time = first.sinceBegin();
    if (time > 1) return FirstContact::never();
    if (time == 0) return FirstContact::unknown(0);
    if (touches(first, time, impact)) return FirstContact::touch(time, 0, 0);
    // Beside that edge they pass by each other, if another one parts them from before then on.
    const bool passes = guessEdge(true, guess) && 1 - PartingEdge(at_, way_, margin_, guess).untilEnd() < time;
    return passes ? FirstContact::never() : FirstContact::unknown(time);
  }

 private:
  // Rounding moves the nearest point along the way, by so little that the distance differs in the second order only;
  // otherwise as for PartingEdge, with a way's 16 M, and 5 of M and S each for the point and its norm.
  bool discsStayApart() const {
    const Double2 from = at_.way();
    const Vec2 start(from[0], from[1]), way(way_[0], way_[1]);
    const double reach = (at_.a.radius + at_.b.radius + margin_) * (1 + kLargestDefect);
    const Vec2 nearest = start + nearestOnSegment(-start, Vec2::Zero(), way);
    return nearest.norm() > reach + 2 * (at_.error() + Placement::kWayError * lengthOne(way_));
  }

  /// The edge that parts them longest, as floats see it: from time 0 on, or backwards from time 1.
  bool guessEdge(bool backwards, ConvexGap& guess) const {
    const SmallPolygon *a = hierarchyOf(at_.a).small_convex, *b = hierarchyOf(at_.b).small_convex;
    if (a == nullptr || b == nullptr) return false;
    UnitMap map = at_.inUnits(0).map;  // a guess needs no bounds
    Double2 way = at_.inUnitsOfA(way_);
    if (!(std::abs(map.tx) + std::abs(map.ty) + lengthOne(way) < 0x1p60)) return false;  // floats may overflow
    if (backwards) {
      map.tx += way[0];
      map.ty += way[1];
      way = -way;
    }
    guess = convexEntry(*a, *b, map, way[0], way[1]);
    return true;
  }

  /// Whether the other polygon's lowest vertex is beside the edge once it comes to its line, or what lies in the line
  /// of an edge there.
  bool touches(const PartingEdge& parting, double time, Impact& impact) const {
    const bool of_a = parting.of_a;
    const PolygonData &own = of_a ? at_.a : at_.b, &other = of_a ? at_.b : at_.a;
    const double square = dot(parting.along, parting.along), slack = parting.error;
    const auto place = [&](std::uint32_t vertex) {
      const Double2 from = of_a ? at_.way(own.path[parting.edge], other.path[vertex])
                                : -at_.way(other.path[vertex], own.path[parting.edge]);
      return dot(parting.along, from + time * parting.way_of_other);
    };
    const auto isBeside = [&](double at) { return at >= -slack && at <= square + slack; };
    const ConvexRing ring = convexRing(other);
    const std::uint32_t lowest = parting.lowest, before = ring.previous(lowest);
    const double climb = dot(parting.turned, ring.edge(lowest)), climb_before = -dot(parting.turned, ring.edge(before));
    const bool forward = climb <= climb_before;  // is the flatter one of the edges there
    const std::uint32_t edge = forward ? lowest : before, far = forward ? ring.next(lowest) : before;
    const double at = place(lowest);
    double share = 0;  // of that edge, from the lowest vertex on
    if (!isBeside(at)) {
      const double at_far = place(far), end = at < 0 ? 0 : square;
      const bool reaches = at < 0 ? at_far >= -slack : at_far <= square + slack;
      if (!reaches || !(std::min(climb, climb_before) <= slack)) return false;
      share = std::clamp((end - at) / (at_far - at), 0.0, 1.0);
    }
    const Vec2 on_other = other.path[lowest] + share * (other.path[far] - other.path[lowest]);
    const Motion& motion = of_a ? motion_b_ : motion_a_;
    const Double2 outwards = parting.outwards * (1 / std::sqrt(square));
    const Vec2 normal(outwards[0], outwards[1]);
    const EdgeIndex own_edge =
        givenEdge(of_a ? given_a_ : given_b_, own, parting.edge, std::clamp(at / square, 0.0, 1.0));
    const EdgeIndex other_edge = givenEdge(of_a ? given_b_ : given_a_, other, edge, forward ? share : 1 - share);
    impact.time = std::max(time, std::numeric_limits<double>::denorm_min());
    impact.point = motion.start * on_other + time * motion.shift - 0.5 * margin_ * normal;
    impact.normal = of_a ? normal : Vec2(-normal);
    impact.edge_a = of_a ? own_edge : other_edge;
    impact.edge_b = of_a ? other_edge : own_edge;
    return true;
  }

  const PolygonData &given_a_, &given_b_;
  const Motion &motion_a_, &motion_b_;
  double margin_;
  Double2 way_;
  Placement at_;  ///< at time 0
};

}  // namespace

FirstContact slideConvex(const PolygonData& a, const Motion& motion_a, const PolygonData& b, const Motion& motion_b,
                         double margin, Impact& impact) {
  if (!slides(motion_a) || !slides(motion_b)) return FirstContact::unknown(0);
  const PolygonData *corners_a = cornersOf(a), *corners_b = cornersOf(b);
  const auto isSmall = [](const PolygonData* corners) {
    return corners != nullptr && corners->path.size() <= SmallPolygon::kMost + 1;
  };
  if (!isSmall(corners_a) || !isSmall(corners_b)) return FirstContact::unknown(0);
  return Slide(a, *corners_a, motion_a, b, *corners_b, motion_b, margin).run(impact);
}

}  // namespace tricover::detail
