// SPDX-License-Identifier: BSD-3-Clause
#include "impact/point_impact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "hierarchy/simd.h"
#include "numbers/segment.h"

namespace tricover::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where a moving point comes within `reach` of an edge, as a share of its way; infinity if it doesn't. Each root is
/// that of a way moved aside by a few roundings of the coordinates, however flat it is.
struct Entry {
  double share = kInfinity;
  double start = kInfinity;  ///< its distance from the edge at the start
  double approach = 0;       ///< how fast it comes nearer at the entry: a length for the whole way

  bool operator<(const Entry& other) const { return share != other.share ? share < other.share : start < other.start; }
};

void enterDisc(const Vec2& from_center, const Vec2& way, double reach, Entry& entry) {
  const double length = way.norm(), along = -from_center.dot(way);
  if (!(along > 0 && length > 0)) return;
  const double aside = std::abs(cross(from_center, way)) / length;
  if (!(aside < reach)) return;
  const double half = std::sqrt((reach - aside) * (reach + aside));
  const double share = std::max((along / length - half) / length, 0.0);
  if (share < entry.share) entry = {share, entry.start, length * half / reach};
}

Entry entryOf(const Vec2& p, const Vec2& way, const Vec2& v, const Vec2& w, double reach) {
  Entry entry;
  entry.start = (nearestOnSegment(p, v, w) - p).norm();
  if (!(entry.start > reach)) {
    entry.share = 0;
    entry.approach = way.norm();
    return entry;
  }
  const Vec2 u = w - v, from_v = p - v;
  enterDisc(from_v, way, reach, entry);
  const double square = u.squaredNorm();
  if (!(square > 0)) return entry;
  enterDisc(p - w, way, reach, entry);
  const double length = std::sqrt(square), aside = cross(u, from_v) / length, by = cross(u, way) / length;
  if (!(aside * by < 0 && std::abs(aside) > reach)) return entry;
  const double share = (std::abs(aside) - reach) / std::abs(by);
  const double at = (from_v + share * way).dot(u);
  if (share < entry.share && at >= 0 && at <= square) entry = {share, entry.start, std::abs(by)};
  return entry;
}

/// A point's way in the frame of a's hierarchy, in units, window by window.
class PointCast {
 public:
  explicit PointCast(const MovingPair& pair)
      : pair_(pair),
        a_(*pair.a.polygon),
        inverse_(a_.isPoint() ? 1 : 1 / pair.a.scale),  // a point has no units
        mirror_(pair.a.linear.determinant() < 0 ? -1 : 1),
        error_(pair.error * inverse_) {}

  /// b's point at a time: from a's pivot, turned back, and then from S.
  Vec2 at(double time) const {
    const Vec2 arm = turned(pair_.b.arm, pair_.b.turn, time, 1);
    const Vec2 p = turned(pair_.b.base + pair_.b.way.at(time) + arm, pair_.a.turn, time, -1) - pair_.a.arm;
    const Eigen::Matrix2d& m = pair_.a.linear;
    return mirror_ * inverse_ * Vec2(m(1, 1) * p.x() - m(0, 1) * p.y(), m(0, 0) * p.y() - m(1, 0) * p.x());
  }

  /// An upper bound of the acceleration in a's turning frame over a window: see WindowCutter. With D from pivot to
  /// pivot and V its velocity, r the point's lever, alpha and beta the rates of turn,
  ///   (|beta' - alpha'| + (beta - alpha)^2) r + (|alpha'| + alpha^2) |D| + 2 |alpha| |V| + |W|,
  /// or, by D = p - r, with (|beta'| + |beta| |beta - 2 alpha|) r + (|alpha'| + alpha^2) |p| for the first two terms.
  double acceleration(double begin, double end) const {
    const Rates rates = pair_.rates(begin, end);
    if (!rates.turns()) return (1 + 0x1p-10) * rates.pull * inverse_;
    const double lever = pair_.b.arm.norm(), h = end - begin;
    const double apart = (pair_.b.base + pair_.b.way.at(begin)).norm() + h * rates.speed;
    const double turning = std::min(rates.relative_bend * lever + rates.bend_a * apart,
                                    rates.mixed_b * lever + rates.bend_a * (apart + lever));
    return (1 + 0x1p-10) * (turning + 2 * rates.a * rates.speed + rates.pull) * inverse_;
  }

  /// The first edge that a point on the way from p comes within `reach` of.
  Entry cast(const Vec2& p, const Vec2& way, double reach, std::size_t& edge) const {
    struct Call {
      static double visit(void* context, std::uint32_t position) {
        Call& c = *static_cast<Call*>(context);
        const Entry entry = c.self.entryAt(c.p, c.way, c.reach, position);
        if (entry < c.first) {
          c.first = entry;
          c.edge = position;
        }
        return std::min(c.first.share, 1.0);
      }
      const PointCast& self;
      const Vec2 &p, &way;
      double reach;
      Entry first;
      std::size_t& edge;
    } call{*this, p, way, reach, {}, edge};
    if (a_.isDegenerate())
      Call::visit(&call, static_cast<std::uint32_t>(a_.degenerate_edge));
    else
      visitEdgesOnWay(*pair_.a.tree, {{p.x(), p.y(), 0}, way.x(), way.y(), reach}, &Call::visit, &call);
    return call.first;
  }

  Entry entryAt(const Vec2& p, const Vec2& way, double reach, std::size_t position) const {
    return entryOf(p, way, a_.inUnits(a_.path[position]), a_.inUnits(a_.path[position + 1]), reach);
  }
  double distance(const Vec2& p, std::size_t position) const {
    return entryAt(p, Vec2::Zero(), kInfinity, position).start;
  }

  /// In units: the margin, and what a distance may be wrong by.
  double margin() const { return pair_.margin * inverse_; }
  double error() const { return error_; }

 private:
  static Vec2 turned(const Vec2& p, const Cubic<double>& turn, double time, double sign) {
    if (turn.isZero()) return p;
    const double angle = turn.at(time), c = std::cos(angle), s = sign * std::sin(angle);
    return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
  }

  const MovingPair& pair_;
  const PolygonData& a_;
  double inverse_, mirror_, error_;
};

}  // namespace

bool isPointCast(const MovingPair& pair) {
  return pair.b.polygon->isPoint() && pair.a.polygon->fitsUnit() &&
         (pair.a.polygon->isPoint() || pair.a.scale > 0x1p-200) &&  // squares don't overflow
         pair.a.keepsLengths() && pair.error < 1;
}

// Over a window of length h a way of acceleration A leaves its chord by at most A h^2 / 8, its share of time being that
// of the chord. What the chord comes no nearer to than that and the margin, the point doesn't meet. So the first entry
// is a lower bound of the time of impact; the next window begins there and is as long as it takes, roughly, for the
// chord to tell: the bound's error falls with its square.
std::optional<PointImpact> findPointImpact(const MovingPair& pair, double time_error) {
  const PointCast cast(pair);
  const double touch = cast.margin() + 4 * cast.error();
  double time = 0, length = 1;
  Vec2 from = cast.at(0);
  std::size_t edge = 0;
  while (true) {
    const double end = std::min(time + length, 1.0);
    length = end - time;
    const Vec2 to = cast.at(end), way = to - from;
    const double acceleration = cast.acceleration(time, end), bend = acceleration * length * length / 8;
    const Entry entry = cast.cast(from, way, cast.margin() + bend + 2 * cast.error(), edge);
    if (!(entry.share <= 1)) {
      if (end == 1) return std::nullopt;
      time = end;
      from = to;
      length *= 4;
      continue;
    }
    const double lower = std::min(time + entry.share * length, end);
    const Vec2 there = lower == time ? from : cast.at(lower);
    const double apart = cast.distance(there, edge);
    // Written so that NaN is a touch; and there is an end where time can't be divided.
    if (!(apart > touch) || !(time + length / 2 > time)) return PointImpact{lower, edge};
    if (cast.distance(cast.at(std::min(lower + time_error, 1.0)), edge) <= touch) return PointImpact{lower, edge};
    const double gap = apart - cast.margin(), expected = gap * length / entry.approach;
    const double next = std::min(2 * expected, std::sqrt(4 * gap / acceleration));
    time = lower;
    from = there;
    length = next < length / 2 ? next : length / 2;  // NaN halves
  }
}

}  // namespace tricover::detail
