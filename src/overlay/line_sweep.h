// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "numbers/predicates.h"
#include "polygon/edge_position.h"

namespace tricover::detail {

/// A point as filters see it, and as it is.
struct SeenPoint {
  ApproxPoint approx;
  PosedPoint exact;
};

/// The sign of the signed area |p q r|. Exact.
int orientation(const SeenPoint& p, const SeenPoint& q, const SeenPoint& r);

/// Whether p, on the line of q and r, is between them or one of them. Exact.
bool isBetween(const SeenPoint& p, const SeenPoint& q, const SeenPoint& r);

/// An event of a sweep along a line: from its place on, winding numbers beside the line differ.
struct SweepEvent {
  PosedSegment edge() const { return {pose, ends}; }

  const Pose* pose;
  Vec2 ends[2];                     ///< of the edge that meets the line there, or twice a point
  std::size_t polygon;              ///< whose winding numbers change
  EdgePosition position;            ///< of the edge
  std::int8_t left = 0, right = 0;  ///< by how much
  std::int8_t along = 0;            ///< how many edges more run along the line
  double place = 0, error = 0;      ///< 0 at the segment's start, 1 at its end
};

/// The winding numbers of a polygon on both sides of the line, and how many of its edges run along it.
struct Windings {
  void add(const SweepEvent& event) {
    left += event.left;
    right += event.right;
    along += event.along;
  }
  int left = 0, right = 0, along = 0;
};

/// How an edge from q to r meets the line of a segment from v to w.
struct LineMeeting {
  enum Kind { None, Point, Along } kind;
  int at_v, at_w;  ///< of a point: -1 before v, 0 at v, 1 after it; the same for w
  int of_q, of_r;  ///< the side of the line that q and r are on: 1 left, -1 right
  SweepEvent event;
};

/// Exact, but for the event's place, which is not set.
///
/// The left of the line is the line itself, moved to the left by next to nothing. An edge crosses that if one of its
/// ends is on the left and the other is not. The right is the same. An edge along the line crosses neither. An edge
/// that leads from right to left has one winding more on its left, which is behind the place: the sweep loses one.
LineMeeting meetLine(const SeenPoint& v, const SeenPoint& w, std::size_t polygon, EdgePosition position,
                     const SeenPoint& q, const SeenPoint& r);

/// A segment from v to w along which a sweep comes from event to event.
class LineSweep {
 public:
  LineSweep(const PosedSegment& segment, const ApproxPoint& begin, const ApproxPoint& end)
      : v{begin, segment[0]}, w{end, segment[1]}, segment_(segment) {}

  /// A point on the line, from which on more edges run along it.
  static SweepEvent pointEvent(std::size_t polygon, EdgePosition position, const PosedPoint& point, int along) {
    return {point.pose, {point.local, point.local}, polygon, position, 0, 0, static_cast<std::int8_t>(along)};
  }

  /// The order in which the sweep comes to two points on the line: -1 if p is first. Exact.
  int compare(const PosedPoint& p, const PosedPoint& q) const;
  /// The same of two events, whose places are known to within their errors. Exact.
  int compare(const SweepEvent& p, const SweepEvent& q) const;

  const SeenPoint v, w;

 private:
  const PosedSegment segment_;
};

}  // namespace tricover::detail
