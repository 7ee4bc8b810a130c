// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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
  double place = 0.5, error = 0.5;  ///< 0 at the segment's start, 1 at its end; anywhere between, until it is known
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

/// Exact, but for the event's place, which is not known.
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

  /// How the ends q and r of an edge along the line meet it: from its first end on there is one more edge along the
  /// line, from its last end on one less. Exact.
  std::array<LineMeeting, 2> meetAlong(std::size_t polygon, EdgePosition position, const PosedPoint& q,
                                       const PosedPoint& r) const;

  /// The order in which the sweep comes to two events, whose places are known to within their errors: -1 if p is first.
  /// Exact.
  int compare(const SweepEvent& p, const SweepEvent& q) const;

  /// Sorts events from v to w, and adds one at v and one at w, of an edge that the segment stands for. Calls
  /// visit(begin, end) for the events [begin, end) at each place.
  template <typename Visit>
  void forEachPlace(std::vector<SweepEvent>& events, std::size_t polygon, EdgePosition position, Visit visit) const {
    std::sort(events.begin(), events.end(),
              [&](const SweepEvent& p, const SweepEvent& q) { return compare(p, q) < 0; });
    events.insert(events.begin(), pointEvent(polygon, position, v.exact, 0));
    events.push_back(pointEvent(polygon, position, w.exact, 0));
    events.front().place = events.front().error = events.back().error = 0;
    events.back().place = 1;
    for (std::size_t begin = 0, end; begin < events.size(); begin = end) {
      for (end = begin + 1; end < events.size() && compare(events[begin], events[end]) == 0;) ++end;
      visit(begin, end);
    }
  }

  const SeenPoint v, w;

 private:
  static SweepEvent pointEvent(std::size_t polygon, EdgePosition position, const PosedPoint& point, int along) {
    return {point.pose, {point.local, point.local}, polygon, position, 0, 0, static_cast<std::int8_t>(along)};
  }
  /// The order of two points on the line.
  int compare(const PosedPoint& p, const PosedPoint& q) const;

  const PosedSegment segment_;
};

}  // namespace tricover::detail
