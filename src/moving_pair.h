// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "double2.h"
#include "polygon_data.h"
#include "tricover/motion.h"

namespace tricover::detail {

/// A box (or an edge, as a box without width) of a moving polygon at both ends of a window of time, one a lane: its
/// centre, the images of its axes, near unit length, and its half extents along them.
struct MovingBox {
  Double2 x, y, ux, uy, vx, vy;
  double along, across;
  double bend;  ///< no point of it is accelerated by more; in the pair's lengths per squared time
};

/// Where a mover's hierarchy is at both ends of a window: p -> scale M p + (x, y).
struct Places {
  Double2 m00, m10, m01, m11, x, y;
};

/// One box of a hierarchy or, where that is a single edge, the edge.
struct Node {
  double x, y, ux, uy, along, across;  ///< in units
  std::uint32_t child;                 ///< the block below; of an edge, its position in the path
  bool edge;
};

/// The node that is around everything; all others are block * kLanes + lane.
constexpr std::uint32_t kRootNode = 0xffffffff;

/// A polygon that moves, in the pair's frame.
struct Mover {
  Places places(double begin, double end) const;
  Node node(std::uint32_t index) const;
  MovingBox box(const Places& places, const Node& node) const;
  MovingBox edge(const Places& places, std::size_t position) const;

  const PolygonData* polygon;
  const Hierarchy* tree;
  Vec2 pivot;                 ///< in the polygon's frame
  Eigen::Matrix2d linear;     ///< the start's
  Vec2 base, drift;           ///< of the pivot: at time 0, and from there to time 1
  Vec2 arm;                   ///< from the pivot to S, at time 0
  double turn, scale, reach;  ///< radians; a unit; no point is farther from the pivot

 private:
  double bendAt(double lever_x, double lever_y, double extent) const;
};

/// Two moving polygons in a frame that goes with a's pivot without turning, so that only differences of positions
/// enter, and in a length, a power of two, in which none of them is much above 1.
struct MovingPair {
  MovingPair(const PolygonData& polygon_a, const Motion& motion_a, const PolygonData& polygon_b,
             const Motion& motion_b);

  /// Whether the discs around the pivots stay apart for all of the time.
  bool discsStayApart() const;

  Mover a, b;
  double error;              ///< of a gap: see the constructor
  double still_error;        ///< of one between the pivots' places
  double length, expansion;  ///< two powers of two: a length of 1 is their product in the world
};

/// The share [low, high] of a window that contact may lie in: cut by one axis after the other.
struct Rest {
  bool empty() const { return low > high; }

  /// Along a fixed axis, not longer than 1, two boxes keep the gap |distance| - radius - error where that is positive,
  /// given at the window's ends; `sag` is half the bound of the points' relative acceleration times the squared length
  /// of the window.
  void cut(Double2 distance, Double2 radius, double error, double sag);

  double low = 0, high = 1;
  double aim = 0;  ///< where points that aren't accelerated would meet along the axis that `low` is due to
};

/// Cuts by the axis (nx, ny).
void cutBy(double nx, double ny, const MovingBox& a, const MovingBox& b, double error, double sag, Rest& rest);

/// Cuts by the axes that a box has in the middle of the window.
void cutByAxesOf(const MovingBox& box, const MovingBox& a, const MovingBox& b, double error, double sag, Rest& rest);

/// The nearest points of two edges at one end of the window; distance 0 where they cross.
struct Nearest {
  Nearest(const MovingBox& edge_a, const MovingBox& edge_b, int lane);
  Vec2 on_a, on_b;
  double distance;
};

}  // namespace tricover::detail
