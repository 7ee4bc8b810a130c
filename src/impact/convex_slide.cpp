// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "convex/posed_ring.h"
#include "impact/impact_solvers.h"
#include "numbers/cubic.h"
#include "numbers/rounding.h"
#include "numbers/segment.h"
#include "pair/posed_pair.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double lengthOne(Double2 v) {
  const Double2 lengths = absolute(v);
  return lengths[0] + lengths[1];
}

/// The vertex that is least far along a direction.
std::uint32_t lowestVertex(const ConvexRing& ring, Double2 along) {
  std::uint32_t lowest = 0;
  double least = dot(along, ring.vertex(0));
  for (std::uint32_t k = 1; k < ring.size(); ++k) {
    const double height = dot(along, ring.vertex(k));
    lowest = height < least ? k : lowest;
    least = std::min(height, least);
  }
  return lowest;
}

// Along a normal n as long as the edge's image u, the gap is that of the other polygon's lowest vertex, and linear in
// time. With M the size, no less than any vertex' length, and S = |s|_1 of the path s of the other polygon, in units of
// U |u|:
//   the way to the lowest vertex   PosedPair::kWayError                               16 M
//   u, and n turned back           difference 1, products sqrt2, sum 1; 2.42 more,    3.42 M, 2 * 2.42 M
//                                  which vertex is the lowest
//   products and sums              2 of the way, 2 of either height                   6 M
//   the speed                      s 1, normal 3.42, product, sum                     6.42 S
//   less the slack; that at time 1                                                    M; M + S
//   a quotient, and 1 less that                                                       2 S
// in all below 34 M + 10 S: 48 of either are kept.
static_assert(3 * PosedPair::kWayError >= kUnitRows * errorOf(16 + 4 + 5 + 6 + 2) &&
              3 * PosedPair::kWayError >= kUnitRows * errorOf(10));

/// The line of an edge, and the other polygon beyond it, which moves along a straight path as the edge's polygon sees
/// it. Lengths are the world's; along normals they are as many times as long as the edge.
struct MovingBesideEdge {
  MovingBesideEdge(const PosedPair& placement, bool of_a_, EdgePosition edge_, Double2 path_of_b, double margin)
      : of_a(of_a_),
        edge(edge_),
        other(convexRing(of_a ? placement.b : placement.a)),
        path(of_a ? path_of_b : -path_of_b) {
    const PosedRing own(convexRing(of_a ? placement.a : placement.b), of_a ? placement.pose_a : placement.pose_b);
    along = own.edge(edge);
    outwards = own.normal(edge);
    in_other = PosedRing(other, of_a ? placement.pose_b : placement.pose_a).inFrame(outwards);
    lowest = lowestVertex(other, in_other);
    to_lowest = wayTo(placement, lowest);
    error = 3 * (placement.error() + PosedPair::kWayError * lengthOne(path)) * lengthOne(along);
    speed = dot(outwards, path);
    beyond = dot(outwards, to_lowest) - error;
    if (margin > 0) beyond -= margin * std::sqrt(dot(outwards, outwards)) * (1 + 16 * kUnitRoundoff);
  }

  /// The path from the edge's begin to a vertex of the other polygon, at time 0.
  Double2 wayTo(const PosedPair& placement, std::uint32_t vertex) const {
    return of_a ? placement.way(placement.a.path[edge], placement.b.path[vertex])
                : -placement.way(placement.a.path[vertex], placement.b.path[edge]);
  }

  /// For how much of the time they are certainly apart, from time 0 on.
  double sinceBegin() const { return shareOf(beyond, -speed); }
  /// Until time 1.
  double untilEnd() const { return shareOf(beyond + speed, speed); }

  bool of_a;
  EdgePosition edge;  ///< its number, which is its position in the path
  ConvexRing other;
  Double2 path, along, outwards;  ///< of the other polygon; the edge, in the world; its outer normal, as long
  Double2 in_other;               ///< that in the other polygon's frame
  std::uint32_t lowest;           ///< the other's vertex that is least far beyond
  Double2 to_lowest;
  double error, speed, beyond;  ///< by how much the gap is certainly more than the margin, at time 0

 private:
  double shareOf(double beyond_there, double approach) const {
    // Products that err by so much neither overflow nor lose what matters to underflow.
    if (!(error > 0x1p-900 && error < 0x1p900 && beyond_there > 0)) return 0;
    return approach > 0 ? beyond_there / approach : kInfinity;
  }
};

// Rounding moves the nearest point along the path, by so little that the distance differs in the second order only;
// otherwise as above, with a way's 16 M, and 5 of M and S each for the point and its norm.
bool discsStayApart(const PosedPair& at, Double2 path, double margin) {
  const Double2 from = at.way();
  const double reach = (at.a.radius + at.b.radius + margin) * (1 + kLargestDefect);
  const Vec2 start(from[0], from[1]);
  const Vec2 nearest = start + nearestOnSegment(-start, Vec2::Zero(), Vec2(path[0], path[1]));
  return nearest.norm() > reach + 2 * (at.error() + PosedPair::kWayError * lengthOne(path));
}

/// The edge that separates them longest, as floats see it: from time 0 on, or backwards from time 1.
bool guessEdge(const PosedPair& at, Double2 path, double margin, bool backwards, ConvexGap& guess) {
  const SmallPolygon *a = topOf(at.a).small_convex, *b = topOf(at.b).small_convex;
  if (a == nullptr || b == nullptr) return false;
  UnitMap map = at.inUnits(0);  // a guess needs no bounds
  Double2 in_units = at.inUnitsOfA(path);
  const double reach = margin * at.a.inverse_unit;
  if (!(std::abs(map.tx) + std::abs(map.ty) + lengthOne(in_units) + reach < 0x1p60))
    return false;  // floats may overflow
  if (backwards) {
    map.tx += in_units[0];
    map.ty += in_units[1];
    in_units = -in_units;
  }
  guess = convexEntry(*a, *b, map, in_units[0], in_units[1], reach);
  return true;
}

/// Two polygons as given, each with its motion.
struct Given {
  const PolygonData& polygon;
  const Motion& motion;
};

/// Whether the other polygon is beside the edge once it comes to its line, by its lowest vertex or by what lies in the
/// line of its edge there.
bool touches(const MovingBesideEdge& beside, const PosedPair& at, double time, double margin, const Given& a,
             const Given& b, Impact& impact) {
  const std::uint32_t lowest = beside.lowest, flatter = beside.other.flatterEdge(-beside.in_other, lowest);
  const bool is_forward = flatter == lowest;
  const std::uint32_t far = is_forward ? beside.other.next(lowest) : flatter;
  const double square = dot(beside.along, beside.along), slack = beside.error;
  const double part = dot(beside.along, beside.to_lowest + time * beside.path);
  double share = 0;  // of the edge that climbs less, from the lowest vertex on
  if (!(part >= -slack && part <= square + slack)) {
    const double part_far = dot(beside.along, beside.wayTo(at, far) + time * beside.path);
    const bool reaches = part < 0 ? part_far >= -slack : part_far <= square + slack;
    if (!reaches || !((is_forward ? 1 : -1) * dot(beside.in_other, beside.other.edge(flatter)) <= slack)) return false;
    share = std::clamp(((part < 0 ? 0 : square) - part) / (part_far - part), 0.0, 1.0);
  }
  const Given &own = beside.of_a ? a : b, &other = beside.of_a ? b : a;
  const PolygonData &own_corners = beside.of_a ? at.a : at.b, &corners = beside.of_a ? at.b : at.a;
  const Vec2 on_other = corners.path[lowest] + share * (corners.path[far] - corners.path[lowest]);
  const Double2 outwards = beside.outwards * (1 / std::sqrt(square));
  const Vec2 normal(outwards[0], outwards[1]);
  const EdgeIndex own_edge = givenEdge(own.polygon, own_corners, beside.edge, std::clamp(part / square, 0.0, 1.0));
  const EdgeIndex other_edge = givenEdge(other.polygon, corners, flatter, is_forward ? share : 1 - share);
  impact.time = std::max(time, std::numeric_limits<double>::denorm_min());
  impact.point = other.motion.start * on_other + time * other.motion.shift - 0.5 * margin * normal;
  impact.normal = beside.of_a ? normal : Vec2(-normal);
  impact.edge_a = beside.of_a ? own_edge : other_edge;
  impact.edge_b = beside.of_a ? other_edge : own_edge;
  return true;
}

}  // namespace

FirstContact slideConvex(const PolygonData& a, const Motion& motion_a, const PolygonData& b, const Motion& motion_b,
                         double margin, Impact& impact) {
  for (const Motion* motion : {&motion_a, &motion_b})
    if (!rotationOf(*motion).isZero() || !pathOf(*motion).isStraight()) return FirstContact::unknown(0);
  const PolygonData *corners_a = cornersOf(a), *corners_b = cornersOf(b);
  if (corners_a == nullptr || corners_b == nullptr) return FirstContact::unknown(0);
  const PosedPair at(*corners_a, motion_a.start, *corners_b, motion_b.start);
  const Double2 path = load2(motion_b.shift.data()) - load2(motion_a.shift.data());
  if (!squarable(at.error() / PosedPair::kWayError + lengthOne(path) + margin)) return FirstContact::unknown(0);
  if (discsStayApart(at, path, margin)) return FirstContact::never();
  ConvexGap guess;
  if (!guessEdge(at, path, margin, false, guess)) return FirstContact::unknown(0);
  const MovingBesideEdge beside(at, guess.of_a, guess.edge, path, margin);
  const double time = beside.sinceBegin();
  if (time > 1) return FirstContact::never();
  if (!(time > 0)) return FirstContact::unknown(0);

  if (touches(beside, at, time, margin, {a, motion_a}, {b, motion_b}, impact)) return FirstContact::touch(time, 0, 0);
  // Beside that edge they pass by each other, if another one separates them from before then on.
  const bool passes = guessEdge(at, path, margin, true, guess) &&
                      1 - MovingBesideEdge(at, guess.of_a, guess.edge, path, margin).untilEnd() < time;
  return passes ? FirstContact::never() : FirstContact::unknown(time);
}

}  // namespace tricover::detail
