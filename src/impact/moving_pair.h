// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hierarchy/hierarchy.h"
#include "hierarchy/simd.h"
#include "hierarchy/simd_gaps.h"
#include "numbers/cubic.h"
#include "numbers/double2.h"
#include "polygon/polygon_data.h"
#include "tricover/motion.h"

namespace tricover::detail {

/// Where a mover's hierarchy is at both ends of an interval: p -> scale M p + (x, y); and its pivot.
struct Places {
  Double2 m00, m10, m01, m11, x, y, pivot_x, pivot_y;

  /// Where a point of the hierarchy is, times its scale; and M alone, for directions.
  Double2 mappedX(double px, double py) const { return turnedX(px, py) + x; }
  Double2 mappedY(double px, double py) const { return turnedY(px, py) + y; }
  Double2 turnedX(double px, double py) const { return m00 * px + m01 * py; }
  Double2 turnedY(double px, double py) const { return m10 * px + m11 * py; }

  /// From S to another mover's, at the begin.
  Vec2 originTo(const Places& other) const { return {other.x[0] - x[0], other.y[0] - y[0]}; }
  /// At its end, in either lane.
  Places atEnd() const {
    const auto end = [](Double2 v) { return Double2{v[1], v[1]}; };
    return {end(m00), end(m10), end(m01), end(m11), end(x), end(y), end(pivot_x), end(pivot_y)};
  }
  /// From its begin to another's end.
  Places to(const Places& other) const {
    const auto ends = [](Double2 from, Double2 until) { return Double2{from[0], until[1]}; };
    return {ends(m00, other.m00), ends(m10, other.m10), ends(m01, other.m01),         ends(m11, other.m11),
            ends(x, other.x),     ends(y, other.y),     ends(pivot_x, other.pivot_x), ends(pivot_y, other.pivot_y)};
  }
  /// Another mover's, in lengths of 1 / `inverse`, in the frame that rotates with this one from its S: M^T rotates back
  /// what keeps lengths.
  Places seen(const Places& other, double inverse) const {
    const Double2 dx = (other.x - x) * inverse, dy = (other.y - y) * inverse;
    const Double2 px = (other.pivot_x - x) * inverse, py = (other.pivot_y - y) * inverse;
    return {m00 * other.m00 + m10 * other.m10,
            m01 * other.m00 + m11 * other.m10,
            m00 * other.m01 + m10 * other.m11,
            m01 * other.m01 + m11 * other.m11,
            m00 * dx + m10 * dy,
            m01 * dx + m11 * dy,
            m00 * px + m10 * py,
            m01 * px + m11 * py};
  }
  /// The map at their begin, for guesses in floats.
  UnitMap unitMap(double scale) const { return {m00[0], m01[0], m10[0], m11[0], x[0], y[0], scale, 0}; }
};

/// An edge's ends, one a lane, at one end of an interval.
struct MovingEdge {
  /// Of two vertices in the mover's frame, from S.
  MovingEdge(const Places& p, int lane, const Vec2& v, const Vec2& w) {
    const Double2 of_x{v.x(), w.x()}, of_y{v.y(), w.y()};
    x = p.m00[lane] * of_x + p.m01[lane] * of_y + p.x[lane];
    y = p.m10[lane] * of_x + p.m11[lane] * of_y + p.y[lane];
  }
  Vec2 end(int i) const { return {x[i], y[i]}; }
  Vec2 from() const { return end(0); }
  Vec2 to() const { return end(1); }
  Vec2 half() const { return 0.5 * (to() - from()); }
  Double2 x, y;
};

/// One box of a hierarchy or, where that is a single edge, the edge.
struct BoxOrEdge {
  double x, y, ux, uy, along, across;  ///< in units
  std::uint32_t child;                 ///< the block below; of an edge, its position in the path
  bool edge;
};

/// The node that is around everything; all others are block * kLanes + lane.
constexpr std::uint32_t kRootNode = simd::kRoot;

/// A polygon that moves, in the pair's frame. A pose that is off rigid is a rotation of a polygon that is stretched a
/// little: by the polar decomposition of its matrix, so that whatever moves keeps lengths.
struct Mover {
  Places places(double begin, double end) const;
  BoxOrEdge node(std::uint32_t index) const;
  MovingBox box(const Places& places, const BoxOrEdge& node) const { return box(places, node, 1); }
  /// By places in lengths of 1 / `inverse`.
  MovingBox box(const Places& places, const BoxOrEdge& node, double inverse) const;
  MovingBox edge(const Places& places, EdgePosition position) const;
  /// A vertex by its position, stretched, from S: in units, and in the pair's length.
  Vec2 inUnits(EdgePosition position) const {
    const Vec2 at = polygon->inUnits(polygon->path[position]);
    return stretched == 0 ? at : Vec2(stretch * at);
  }
  Vec2 vertex(EdgePosition position) const { return scale * inUnits(position); }
  /// The same in the unit that squares don't overflow in.
  Vec2 inView(EdgePosition position) const { return in_view * inUnits(position); }
  MovingEdge ends(const Places& places, int lane, EdgePosition position) const {
    return {places, lane, vertex(position), vertex(position + 1)};
  }

  const PolygonData* polygon;       ///< once MovingPair::prepare() was called by its corners alone, if it is convex
  const PolygonData* given;         ///< as it was given
  const Motion* motion;             ///< likewise
  const Hierarchy* tree = nullptr;  ///< once MovingPair::prepare() was called
  Vec2 pivot;                       ///< in the polygon's frame
  Eigen::Matrix2d linear;           ///< the start's, a rotation or a reflection
  Eigen::Matrix2d stretch;          ///< before that: symmetric
  double stretched = 0;             ///< by how much of a length that moves a point at most; 0 for the identity
  Vec2 base;                        ///< where the pivot is at time 0
  Cubic<Vec2> path;                 ///< of the pivot, from there
  Vec2 arm;                         ///< from the pivot to S, at time 0
  Cubic<double> rotation;           ///< radians
  double scale, reach;              ///< a unit; no point is farther from the pivot
  double view, in_view;             ///< the unit that edges are looked from, which is not too small; a unit in that
  bool rotates = false;             ///< it does, at all
  bool is_straight = false;         ///< neither rotation nor path is bent
};

/// Upper bounds, over an interval of time, of how fast movers rotate and pivots move: absolute values, a' the rate of
/// a's rotation and a" its acceleration; and what IntervalCutter makes of them.
struct Rates {
  double a, b;              ///< |a'|, |b'|
  double bend_a, bend_b;    ///< |a"| + a'^2, |b"| + b'^2
  double relative_bend;     ///< |b" - a"| + (b' - a')^2
  double mixed_a, mixed_b;  ///< |a"| + |a'| |a' - 2 b'|, |b"| + |b'| |b' - 2 a'|
  double speed, pull;       ///< of b's pivot, as seen from a's: velocity and acceleration

  bool rotates() const { return a != 0 || b != 0; }
  /// What rotating adds to the second derivative along an axis that stands still.
  double bend(double lever_a, double lever_b) const { return bend_a * lever_a + bend_b * lever_b; }
};

/// Two moving polygons in a frame that goes with a's pivot without rotating, so that only differences of positions
/// enter, and in a length, a power of two, in which none of them is much above 1.
struct MovingPair {
  MovingPair(const PolygonData& polygon_a, const Motion& motion_a, const PolygonData& polygon_b, const Motion& motion_b,
             double margin = 0);

  /// What all but discsStayApart() needs: trees, where they aren't built yet, and rates.
  void prepare();

  /// Whether the discs around the pivots stay farther apart than the margin for all of the time.
  bool discsStayApart() const;

  /// Whether no direction changes, nor any velocity.
  bool slides() const { return is_steady && !a.rotates && !b.rotates; }

  /// Whether paths may be followed in doubles. Either may be a speck.
  bool isInRange() const { return error < 1 && a.polygon->fitsUnit() && b.polygon->fitsUnit(); }

  Rates rates(double begin, double end) const { return is_steady ? steady : ratesOf(begin, end); }
  Rates ratesOf(double begin, double end) const;

  double expansion;  ///< two powers of two, `length` is the other: a length of 1 is their product in the world
  Mover a, b;
  bool is_steady;       ///< all velocities are constant
  Rates steady;         ///< then, at any time
  double given_margin;  ///< what counts as contact is coming this near
  double margin;        ///< the same in the pair's length
  double error;         ///< of a gap: see the constructor
  double still_error;   ///< of one between the pivots' places
  double length;

 private:
  /// To the size of what is moved, of which squares are taken. Returns 1 / length.
  double divideByLength();
};

inline BoxOrEdge Mover::node(std::uint32_t index) const {
  const simd::Item item = simd::itemAt(*tree, index, polygon->degenerate_edge);
  if (stretched == 0) return {item.x, item.y, item.ux, item.uy, item.along, item.across, item.child, item.leaf};
  // Around what the box becomes, along the same axes.
  const Vec2 center = stretch * Vec2(item.x, item.y);
  const double more = stretched * (item.along + item.across);
  return {center.x(), center.y(), item.ux, item.uy, item.along + more, item.across + more, item.child, item.leaf};
}

inline MovingBox Mover::box(const Places& p, const BoxOrEdge& node, double inverse) const {
  const Double2 ux = p.turnedX(node.ux, node.uy), uy = p.turnedY(node.ux, node.uy);
  const Double2 vx = p.turnedX(-node.uy, node.ux), vy = p.turnedY(-node.uy, node.ux);
  const double unit = scale * inverse, x = node.x * unit, y = node.y * unit;
  return {p.mappedX(x, y), p.mappedY(x, y), ux, uy, vx, vy, node.along * unit, node.across * unit};
}

/// What is known of the first contact.
struct FirstContact {
  enum class Verdict { Never, Touch, Unknown };
  Verdict verdict;
  double time;  ///< they are certainly apart before, from time 0 on; of a touch, it is at most `time_error` too early
  EdgePosition edge_a, edge_b;  ///< of a touch; one is kNoEdge where a ring is inside at time 0
  bool budget_ended = false;    ///< of a touch: it was not found, only that nothing touches before

  bool isOpen() const { return verdict == Verdict::Unknown; }

  static FirstContact never() { return {Verdict::Never, 1, kNoEdge, kNoEdge}; }
  static FirstContact unknown(double time) { return {Verdict::Unknown, time, kNoEdge, kNoEdge}; }
  /// Of two that are apart at time 0, though it may be by less than rounding.
  static FirstContact touch(double time, EdgePosition edge_a, EdgePosition edge_b) {
    return {Verdict::Touch, std::max(time, std::numeric_limits<double>::denorm_min()), edge_a, edge_b};
  }
};

/// The nearest points of two edges; distance 0 where they certainly cross.
struct NearestPoints {
  NearestPoints(const MovingEdge& a, const MovingEdge& b, double error);
  Vec2 on_a, on_b;
  double distance;
};

}  // namespace tricover::detail
