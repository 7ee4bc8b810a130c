// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/line_sweep.h"

#include <algorithm>

namespace tricover::detail {
namespace {

/// The same point of equal frames: so of areas that abut.
bool areOne(const PosedPoint& p, const PosedPoint& q) {
  if (p.local != q.local) return false;
  return p.pose == q.pose || (p.pose != nullptr && q.pose != nullptr && p.pose->matrix() == q.pose->matrix());
}

bool areOne(const PosedSegment& p, const PosedSegment& q) {
  return (areOne(p[0], q[0]) && areOne(p[1], q[1])) || (areOne(p[0], q[1]) && areOne(p[1], q[0]));
}

}  // namespace

int orientation(const SeenPoint& p, const SeenPoint& q, const SeenPoint& r) {
  const int sign = orientFilter(p.approx, q.approx, r.approx);
  if (sign != kUncertain) return sign;
  const PosedPoint &x = p.exact, &y = q.exact, &z = r.exact;
  return areOne(x, y) || areOne(y, z) || areOne(x, z) ? 0 : orientExact(x, y, z);
}

bool isBetween(const SeenPoint& p, const SeenPoint& q, const SeenPoint& r) {
  const ApproxPoint &x = p.approx, &y = q.approx, &z = r.approx;
  const double error = 2 * (x.error + std::max(y.error, z.error));
  const auto tell = [&](double to_q, double to_r) {
    if (std::max(to_q, to_r) < -error || std::min(to_q, to_r) > error) return -1;
    return std::min(to_q, to_r) < -error && std::max(to_q, to_r) > error ? 1 : 0;
  };
  const int in_x = tell(y.x - x.x, z.x - x.x), in_y = tell(y.y - x.y, z.y - x.y);
  if (in_x != 0 || in_y != 0) return in_x >= 0 && in_y >= 0;
  return areOne(p.exact, q.exact) || areOne(p.exact, r.exact) || betweenExact(p.exact, q.exact, r.exact);
}

/// With u from v to w, d along the edge from q to r, and D = |u d|, the edge's line meets this one at
///   s     = |q r v| / D,
///   s - 1 = |q r w| / D,
/// and D has the sign of what r is to the left of q by.
LineMeeting meetLine(const SeenPoint& v, const SeenPoint& w, std::size_t polygon, EdgePosition position,
                     const SeenPoint& q, const SeenPoint& r) {
  LineMeeting meeting{LineMeeting::None, 0, 0, orientation(v, w, q), orientation(v, w, r), {}};
  const int of_q = meeting.of_q, of_r = meeting.of_r;
  if (of_q * of_r > 0) return meeting;
  meeting.kind = of_q == of_r ? LineMeeting::Along : LineMeeting::Point;
  meeting.event = {q.exact.pose,
                   {q.exact.local, r.exact.local},
                   polygon,
                   position,
                   static_cast<std::int8_t>((of_q > 0) - (of_r > 0)),
                   static_cast<std::int8_t>((of_r < 0) - (of_q < 0))};
  if (of_q == of_r) return meeting;
  const int slant = of_r > of_q ? 1 : -1;
  meeting.at_v = slant * orientation(q, r, v);
  meeting.at_w = meeting.at_v <= 0 ? -1 : slant * orientation(q, r, w);
  return meeting;
}

std::array<LineMeeting, 2> LineSweep::meetAlong(std::size_t polygon, EdgePosition position, const PosedPoint& q,
                                                const PosedPoint& r) const {
  const int direction = -compare(q, r);
  const auto meeting = [&](const PosedPoint& end, int along) -> LineMeeting {
    const int at_v = compare(end, v.exact), at_w = at_v <= 0 ? -1 : compare(end, w.exact);
    return {LineMeeting::Point, at_v, at_w, 0, 0, pointEvent(polygon, position, end, along)};
  };
  return {meeting(q, direction), meeting(r, -direction)};
}

int LineSweep::compare(const PosedPoint& p, const PosedPoint& q) const {
  for (const int axis : {0, 1})
    if (const int sign = compareExact(w.exact, v.exact, axis)) return compareExact(p, q, axis) * sign;
  return 0;
}

int LineSweep::compare(const SweepEvent& p, const SweepEvent& q) const {
  if (p.place + p.error < q.place - q.error) return -1;
  if (q.place + q.error < p.place - p.error) return 1;
  return areOne(p.edge(), q.edge()) ? 0 : compareFractionsExact(segment_, p.edge(), q.edge());
}

}  // namespace tricover::detail
