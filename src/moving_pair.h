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

/// The share [low, high] of a window that contact may lie in.
struct Rest {
  double low, high;
  double aim;  ///< where points that aren't accelerated would meet along the axis that `low` is due to
};

/// Cuts a window down to where contact may lie, by one fixed axis after the other. `sag` is half the bound of the
/// points' relative acceleration times the squared length of the window.
class WindowCutter {
 public:
  WindowCutter(const MovingBox& a, const MovingBox& b, double error, double sag)
      : a_(a), b_(b), error_(error), sag_(sag) {}

  /// By an axis that isn't longer than 1. Returns whether it parts the boxes throughout.
  bool cut(double nx, double ny);
  /// By the axes that a box has in the middle of the window.
  bool cutByAxesOf(const MovingBox& box) {
    return cut(0.5 * (box.ux[0] + box.ux[1]), 0.5 * (box.uy[0] + box.uy[1])) ||
           cut(0.5 * (box.vx[0] + box.vx[1]), 0.5 * (box.vy[0] + box.vy[1]));
  }
  /// What no axis has cut off; nothing, low > high, is possible, too.
  Rest rest() const;

 private:
  /// A gap `from` at one end of the window, which the line to `to` at the other and the sag leave positive for a share
  /// of about from / slope.
  struct Side {
    double from = 0, to = 0, slope = 1;
  };
  bool offer(double from, double to, Side& side) const;
  double share(const Side& side) const;

  const MovingBox &a_, &b_;
  double error_, sag_;
  Side first_, last_;
};

/// The nearest points of two edges at one end of the window; distance 0 where they cross.
struct Nearest {
  Nearest(const MovingBox& edge_a, const MovingBox& edge_b, int lane);
  Vec2 on_a, on_b;
  double distance;
};

}  // namespace tricover::detail
