// SPDX-License-Identifier: BSD-3-Clause
#include "overlay/plain_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hierarchy/inclusion.h"
#include "hierarchy/simd.h"
#include "numbers/errors.h"
#include "numbers/rigidity.h"
#include "overlay/line_sweep.h"
#include "pair/four_ends.h"
#include "pair/posed_pair.h"
#include "pair/root_box.h"

namespace tricover::detail {
namespace {

/// From v to w and of length 1; zero if they are equal.
Vec2 unitVector(const Vec2& v, const Vec2& w) {
  Vec2 u = w - v;
  if (!u.allFinite()) u = 0.25 * w - 0.25 * v;
  const double largest = u.lpNorm<Eigen::Infinity>();
  return largest > 0 ? Vec2(u / largest).normalized() : Vec2(Vec2::Zero());
}

/// Seen from its nearer end, so that both ends are exact.
Vec2 pointAt(const Vec2& from, const Vec2& to, double fraction) {
  const Vec2 way = to - from;
  if (!way.allFinite()) return (1 - fraction) * from + fraction * to;
  return fraction < 0.5 ? Vec2(from + fraction * way) : Vec2(to - (1 - fraction) * way);
}

/// A fraction errs by at most this times RayCast::share_; further apart, two are in the order of the true ones.
constexpr double kFractionError = 1e-14, kFractionsApart = 4 * kFractionError;

class RayCast {
 public:
  RayCast(const PolygonData& polygon, const Pose& pose, const Vec2& from, const Vec2& to, double limit)
      : polygon_(polygon),
        pose_(pose),
        vertex_error_(pose.linear() == Eigen::Matrix2d::Identity() ? 0 : kVertexError),
        ends_{from, to},
        from_(fromTranslation(from)),
        to_(fromTranslation(to)),
        start_(turnedBack(pose, from_)),
        limit_(limit) {}

  std::optional<RayHit> first() {
    const bool in_units = bringToUnits();
    if (in_units && passesBy()) return std::nullopt;
    if (startsInside(in_units)) return start();
    if (from() == to()) return std::nullopt;
    forEachEdgeOn(polygon_, in_units ? &ray_ : nullptr, *this);
    if (!found_ || fraction_ > limit_) return std::nullopt;
    return hitAt(edge_, fraction_, 0);
  }

  /// Takes an edge that the ray may meet, and shortens the ray.
  bool operator()(EdgePosition edge) {
    const FourEnds ends = endsWith(edge);
    if (!ends.meet()) return true;
    const double fraction = fractionOf(ends);
    if (found_ && !isBefore(edge, fraction)) return true;
    found_ = true;
    edge_ = edge;
    fraction_ = fraction;
    shorten(std::min(fraction, limit_));
    return true;
  }

 protected:
  FourEnds endsWith(EdgePosition edge) const {
    return {{from_, to_, at(edge).approx, at(edge + 1).approx}, ray(), segment(edge)};
  }
  /// An end of the ray. What it errs by is known exactly, but for underflow.
  ApproxPoint fromTranslation(const Vec2& p) const {
    const Twofold<Double2> at = twoSum(load2(p.data()), -load2(pose_.data() + 6));
    const Double2 error = absolute(at.low);
    return {at.high[0], at.high[1], error[0] + error[1] + kTiny};
  }
  /// A vertex, by its position. R p in either coordinate: products 1U, sum 1U, of |p|_1. Nothing rounds where R is the
  /// identity.
  SeenPoint at(EdgePosition position) const {
    const Vec2& vertex = polygon_.path[position];
    const Double2 p = load2(vertex.data()), size = absolute(p);
    const double* m = pose_.data();  // columns of three
    const Double2 turned = load2(m) * p[0] + load2(m + 3) * p[1];
    return {{turned[0], turned[1], vertex_error_ * (size[0] + size[1]) + kTiny}, {&pose_, vertex}};
  }
  static constexpr double kVertexError = 2.1 * kUnitRoundoff;
  static_assert(kVertexError >= kUnitRows * errorOf(2) * (1 + errorOf(2)));
  PosedSegment ray() const { return {nullptr, ends_}; }
  PosedSegment segment(EdgePosition edge) const { return {&pose_, &polygon_.path[edge]}; }
  const Vec2& from() const { return ends_[0]; }
  const Vec2& to() const { return ends_[1]; }

  /// The ray as the hierarchy sees it. False where doubles don't know it that well, and of points and segments, which
  /// need no hierarchy.
  ///
  /// Error. With F and T the ray's ends, e_F and e_T what they err by, P = F + s (T - F) errs by (1 - s) e_F + s e_T.
  /// Where P is in the polygon, s |T - F| <= |F| + 1: so s is below the share 2 (|F| + 4) / |T - F|, since the ends err
  /// by little. A far end is so no reason for a large error. Beside that a few dozen U of coordinates below |F| + 4.
  bool bringToUnits() {
    const ApproxPoint to = turnedBack(pose_, to_);
    const Vec2 at = polygon_.inUnits({start_.x, start_.y}), way(to.x - start_.x, to.y - start_.y);
    const double square = way.squaredNorm(), away = at.lpNorm<1>() + 4;
    const double length = square > 0x1p-960 && square < 0x1p1000 ? std::sqrt(square) : std::hypot(way.x(), way.y());
    length_ = length * polygon_.inverse_unit;  // may overflow: nothing is left out by it then
    share_ = std::clamp(2 * away * polygon_.unit / length, kLeastFraction, 1.0);
    start_error_ = kAnyDirection * start_.error * polygon_.inverse_unit + 0x1p-46 * away;
    ray_ = {at.x(), at.y(), 1, 0, start_error_ + kAnyDirection * share_ * to.error * polygon_.inverse_unit};
    if (length > kLeastLength) {
      ray_.dx = way.x() / length;
      ray_.dy = way.y() / length;
    } else {
      ray_.error += length_;  // without a direction
    }
    shorten(limit_);
    known_ = polygon_.fitsUnit() && ray_.error < 0x1p-4 && length < kInfinity;
    return known_ && !polygon_.isDegenerate();
  }

  /// Beyond this fraction nothing needs to be seen. The hierarchy allows for the ray's error.
  void shorten(double fraction) { ray_.length = std::min(fraction + kFractionsApart * share_, 1.0) * length_; }

  /// Whether the ray is beside the bounding disc.
  bool passesBy() const {
    const double room = polygon_.reach * polygon_.inverse_unit + ray_.error;
    const double beside = std::abs(ray_.x * ray_.dy - ray_.y * ray_.dx), ahead = -(ray_.x * ray_.dx + ray_.y * ray_.dy);
    return beside > room || ahead < -room || ahead > ray_.length + room;
  }

  bool startsInside(bool in_units) const {
    if (in_units) {
      const Hierarchy& tree = hierarchyOf(polygon_);
      const Place place{ray_.x, ray_.y, start_error_};
      if (distanceFromRoot(tree.region, place) > 0) return false;
      const InnerDiscs* discs = innerDiscsIfPaid(polygon_);
      if (discs != nullptr && depthInDiscs(*discs, place) > 0) return true;
    }
    const IncludedPoint start{&pose_, start_, {nullptr, from()}};
    return locateInPolygon(polygon_, start) != Location::Outside;
  }

  RayHit hitAt(EdgePosition edge, double fraction, int seen_from) const {
    const EdgePosition named = polygon_.namedEdge(edge);
    return {fraction, pointAt(from(), to(), fraction), normal(named, seen_from), polygon_.edgeName(named)};
  }
  RayHit start() const { return {0, from(), -unitVector(from(), to()), -1}; }

  /// With A and B the areas that the edge spans with the ray's ends, the fraction is f = A / (A - B). Where they err by
  /// a and b it errs by ((1 - f) a + f b) / (A - B), and rounds twice; f is at most the share. It is the true A - B
  /// that divides: 0 along an edge, whatever rounding makes of it.
  double fractionOf(const FourEnds& ends) const {
    constexpr double kAreasError = 80 * kUnitRoundoff;
    static_assert(kFractionError >= kAreasError + 3 * kUnitRoundoff && kFractionError >= kExactFractionError);
    const auto& [from, to, v, w] = ends.approx;
    const ApproxArea a = approxArea(v, w, from), b = approxArea(v, w, to);
    const double whole = a.area - b.area, fraction = std::clamp(a.area / whole, 0.0, 1.0);
    const double error = (1 - fraction) * a.bound + fraction * b.bound;
    const double enough = kAreasError * share_ * (std::abs(whole) - 2 * (a.bound + b.bound));
    if (known_ && error < enough && enough < kInfinity) return fraction;
    return std::min(fractionExact(ends.first, ends.second), 1.0);
  }

  /// By the true fractions, so that the first edge is what it is in whatever order edges come.
  bool isBefore(EdgePosition edge, double fraction) const {
    if (std::abs(fraction - fraction_) > fractionsApart()) return fraction < fraction_;
    const int order = compareFractionsExact(ray(), segment(edge), segment(edge_));
    return order != 0 ? order < 0 : edge < edge_;
  }

  double fractionsApart() const { return kFractionsApart * (known_ ? share_ : 1); }

  /// Returns the normal of an edge that is hit, towards an end of the ray. That end is on the edge's line only where
  /// the ray runs along the edge or the edge has no length.
  Vec2 normal(EdgePosition edge, int seen_from) const {
    const int side = endsWith(edge).sign(2, 3, seen_from);
    if (side == 0) return seen_from == 0 ? Vec2(-unitVector(from(), to())) : unitVector(from(), to());
    const Vec2 along = pose_.linear() * unitVector(polygon_.path[edge], polygon_.path[edge + 1]);
    return side * Vec2(-along.y(), along.x()).normalized();
  }

  static constexpr double kAnyDirection = 1.5;       ///< above the root of 2
  static constexpr double kLeastLength = 0x1p-1000;  ///< of what has a direction
  static constexpr double kLeastFraction = 1e-300;   ///< far above what underflow takes from fractions
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  const PolygonData& polygon_;
  const Pose& pose_;
  const double vertex_error_;    ///< of |p|_1
  const Vec2 ends_[2];           ///< in the world
  const ApproxPoint from_, to_;  ///< in the world, from the pose's translation
  const ApproxPoint start_;      ///< the ray's, in the polygon's frame
  const double limit_;
  Ray ray_;
  double length_, start_error_;  ///< in units
  double share_;                 ///< no fraction of a hit is above, if known
  bool known_;                   ///< whether doubles know where the ray passes the polygon
  bool found_ = false;
  EdgePosition edge_ = 0;  ///< the first so far
  double fraction_ = 0;
};

/// All of the ray in the region, by a sweep along the ray's line from behind the region.
class RayCastAll : private RayCast {
 public:
  RayCastAll(const PolygonData& polygon, const Pose& pose, const Vec2& from, const Vec2& to)
      : RayCast(polygon, pose, from, to, 1), sweep_(ray(), from_, to_) {}

  std::vector<RayInterval> all() {
    const bool in_units = bringToUnits();
    if (in_units && passesBy()) return {};
    const RayHit last{1, to(), unitVector(from(), to()), -1};
    if (from() == to()) return std::vector<RayInterval>(startsInside(in_units) ? 1 : 0, {start(), last});
    Ray line = ray_;
    const bool is_known = in_units && bringBack(line);
    forEachEdgeOn(polygon_, is_known ? &line : nullptr, [this](EdgePosition edge) { return meet(edge), true; });

    std::vector<RayInterval> intervals;
    bool is_open = false;
    sweep_.forEachPlace(events_, 0, kRay, [&](std::size_t begin, std::size_t end) {
      const bool is_from = begin == 0, is_to = end == events_.size(), is_alone = (is_from || is_to) && end == begin + 1;
      if (!is_open && (isInside() || !is_alone)) {
        intervals.push_back({is_from ? start() : hitOf(begin, end, 0), last});
        is_open = true;
      }
      for (std::size_t i = begin; i < end; ++i) windings_.add(events_[i]);
      if (!is_open || is_to || isInside()) return;
      is_open = false;
      intervals.back().end = hitOf(begin, end, 1);
    });
    return intervals;
  }

 private:
  static constexpr EdgePosition kRay = kNoEdge;  ///< above all positions

  /// Begins the ray's line where it is behind all of the polygon. False if doubles don't know the line that well.
  ///
  /// Error. As above, with s from -S on, where S is the share before it is clamped: (1 + S) e_F + S e_T. The line
  /// begins |F| + 2 behind F, with its direction off by a few U: start_error_ holds as much for coordinates below
  /// |F| + 4.
  bool bringBack(Ray& line) const {
    const double back = Vec2(line.x, line.y).lpNorm<1>() + 2, share = 2 * (back + 2) / length_;
    line.error =
        start_error_ + kAnyDirection * share * (start_.error + turnedBack(pose_, to_).error) * polygon_.inverse_unit;
    line.x -= back * line.dx;
    line.y -= back * line.dy;
    line.length += back;
    return line.error < 0x1p-4 && length_ * polygon_.unit > kLeastLength;
  }

  /// The right side matters along edges alone, which are in the region anyway.
  bool isInside() const { return windings_.along > 0 || detail::isInside(polygon_.fill, windings_.left); }

  void meet(EdgePosition edge) {
    const SeenPoint q = at(edge), r = at(edge + 1);
    const LineMeeting meeting = meetLine(sweep_.v, sweep_.w, 0, edge, q, r);
    if (meeting.kind == LineMeeting::Point) add(meeting, q, r);
    if (meeting.kind != LineMeeting::Along) return;
    for (const LineMeeting& end : sweep_.meetAlong(0, edge, q.exact, r.exact)) add(end, q, r);
  }

  void add(const LineMeeting& meeting, const SeenPoint& q, const SeenPoint& r) {
    if (meeting.at_v < 0) return windings_.add(meeting.event);
    if (meeting.at_w > 0) return;
    SweepEvent& event = events_.emplace_back(meeting.event);
    event.place = fractionOf({{from_, to_, q.approx, r.approx}, ray(), event.edge()});
    event.error = 0.5 * fractionsApart();
  }

  /// The hit at events that are at one place, seen from one end of the ray. Fractions of different edges at nearly one
  /// place are rounded each on its own: none is before the last hit's.
  RayHit hitOf(std::size_t begin, std::size_t end, int seen_from) {
    const auto isLower = [](const SweepEvent& p, const SweepEvent& q) { return p.position < q.position; };
    const SweepEvent& lowest = *std::min_element(&events_[begin], &events_[begin] + (end - begin), isLower);
    reached_ = begin == 0 ? 0 : std::max(lowest.place, reached_);
    return hitAt(lowest.position, reached_, seen_from);
  }

  const LineSweep sweep_;
  std::vector<SweepEvent> events_;
  Windings windings_;  ///< before the next events
  double reached_ = 0;
};

}  // namespace

void requireFiniteRay(const Vec2& from, const Vec2& to) {
  requireFinite(from, "from");
  requireFinite(to, "to");
}

std::optional<RayHit> castPlainRay(const PolygonData& polygon, const Pose& pose, const Vec2& from, const Vec2& to,
                                   double limit) {
  return RayCast(polygon, pose, from, to, limit).first();
}

std::vector<RayInterval> castPlainRayAll(const PolygonData& polygon, const Pose& pose, const Vec2& from,
                                         const Vec2& to) {
  return RayCastAll(polygon, pose, from, to).all();
}

}  // namespace tricover::detail
