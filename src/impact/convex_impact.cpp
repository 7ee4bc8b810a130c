// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "convex/walk_to_nearest.h"
#include "hierarchy/simd.h"
#include "impact/impact_solvers.h"
#include "impact/interval_cutter.h"
#include "numbers/march.h"
#include "numbers/rounding.h"
#include "polygon/convexity.h"

namespace tricover::detail {
namespace {

/// As a rule fewer than ten are enough.
constexpr int kMostAdvances = 64;

/// Intervals are as long as a distance lasts, or a little longer: that much of it shortens a step by about as much.
constexpr double kLittle = 0x1p-4;

/// One of the two polygons, or a point or a segment. Its vertices and edges are known by their numbers; axes are in the
/// pair's frame.
class Body {
 public:
  explicit Body(const Mover& mover_)
      : mover(mover_),
        lever(lengthAbove(mover.arm.x(), mover.arm.y()) + radiusOf(mover)),
        doubt_(mover.polygon->radius * 0x1p-47 + kTiny) {
    const PolygonData& polygon = *mover.polygon;
    const std::size_t size = polygon.isPoint() ? 1 : polygon.isDegenerate() ? 2 : polygon.path.size() - 1;
    is_small_ = size <= SmallPolygon::kMost;
    if (is_small_) {
      const EdgePosition first = position(0);
      for (EdgePosition k = 0; k < size; ++k) vertices_[k] = mover.vertex(first + k);
      vertices_[size] = vertices_[0];
    }
    ring_ = ConvexRing(is_small_ ? vertices_ : polygon.path.data(), size,
                       polygon.isDegenerate() ? 1 : convexityOf(polygon).direction);
  }
  Body(const Body&) = delete;

  /// The farthest that it reaches along an axis from S, at both ends of an interval: of at most 16 vertices by all, of
  /// others by those between an edge that certainly leads ahead at both ends and one that certainly leads back, looked
  /// for from vertex `near` on.
  Double2 reach(const Places& p, Double2 nx, Double2 ny, EdgePosition near) const {
    const Double2 mx = p.m00 * nx + p.m10 * ny, my = p.m01 * nx + p.m11 * ny;
    if (is_small_) {
      Double2 most = height(vertices_[0], mx, my);
      for (std::uint32_t k = 1; k < ring_.size(); ++k) most = larger(most, height(vertices_[k], mx, my));
      return most;
    }
    RingRange range{near, 0};
    const bool is_certain = ring_.supportVertex(
        [&](EdgePosition edge) {
          const Double2 e = stretched(ring_.edge(edge));
          return mx * e[0] + my * e[1];
        },
        [&](Double2 up) { return up[0] > doubt_ && up[1] > doubt_; },
        [&](Double2 up) { return up[0] < -doubt_ && up[1] < -doubt_; }, range);
    if (!is_certain) range.count = ring_.size();
    std::uint32_t v = range.first;
    Double2 most = height(mover.vertex(v), mx, my);
    while (--range.count > 0) most = larger(most, height(mover.vertex(v = ring_.next(v)), mx, my));
    return most;
  }

  /// The directions of its ring at the interval's begin, in the pair's length.
  PosedRing posed(const Places& p) const {
    const Double2 x{p.m00[0], p.m10[0]}, y{p.m01[0], p.m11[0]};
    if (is_small_) return {ring_, x, y, Double2{}};
    const Eigen::Matrix2d m = mover.scale * mover.polygon->inverse_unit * mover.stretch;
    return {ring_, m(0, 0) * x + m(1, 0) * y, m(0, 1) * x + m(1, 1) * y, Double2{}};
  }
  /// The outer normal of an edge, at the interval's begin.
  Vec2 normal(const Places& p, EdgePosition edge) const {
    const Double2 n = posed(p).normal(edge);
    return Vec2(n[0], n[1]).normalized();
  }
  /// The flatter edge at the support vertex along an axis, at the interval's begin.
  EdgePosition flatterEdge(const Places& p, const Vec2& n, std::uint32_t vertex) const {
    return ring_.flatterEdge(posed(p).inFrame(load2(n.data())), vertex);
  }

  MovingEdge edge(const Places& p, int lane, std::uint32_t k) const {
    return is_small_ ? MovingEdge(p, lane, vertices_[k], vertices_[k + 1]) : mover.ends(p, lane, k);
  }

  /// How far it reaches from the other one's pivot, at the interval's begin.
  double leverFrom(const Places& other, const Places& p) const {
    return lengthAbove(p.x[0] - other.pivot_x[0], p.y[0] - other.pivot_y[0]) + radiusOf(mover);
  }

  /// An edge's position in the path.
  EdgePosition position(EdgePosition edge) const {
    return mover.polygon->isDegenerate() ? mover.polygon->degenerate_edge : edge;
  }

  const Mover& mover;
  const double lever;  ///< how far it reaches from its own pivot

 private:
  /// The stretch is its own transpose.
  Double2 stretched(Double2 v) const {
    if (mover.stretched == 0) return v;
    const Vec2 at = mover.stretch * Vec2(v[0], v[1]);
    return Double2{at.x(), at.y()};
  }
  static Double2 height(const Vec2& p, Double2 mx, Double2 my) { return mx * p.x() + my * p.y(); }
  static double radiusOf(const Mover& mover) {
    return mover.polygon->radius * mover.polygon->inverse_unit * mover.scale * (1 + kLargestDefect);
  }
  ConvexRing ring_{nullptr, 0, 1};  ///< of at most 16 vertices, around the copies
  double doubt_;  ///< an edge's climb is wrong by less than 5 U of its length, which is at most twice the radius
  bool is_small_;
  Vec2 vertices_[SmallPolygon::kMost + 1];  ///< of at most 16, all, and the first once more
};

class ConvexAdvancement {
 public:
  ConvexAdvancement(const MovingPair& pair, double begin, double time_error)
      : pair_(pair),
        a_(pair.a),
        b_(pair.b),
        begin_(begin),
        time_(begin),
        at_a_(pair.a.places(begin, begin)),
        at_b_(pair.b.places(begin, begin)),
        time_error_(time_error),
        touch_distance_(pair.margin + 4 * pair.error),
        face_(at_a_.originTo(at_b_)) {}

  FirstContact run() {
    return march(FirstContact::unknown(begin_), kMostAdvances, [&](double) { return step(); });
  }

 private:
  /// By the features of the last step or, where these proved nothing, by new ones.
  std::optional<FirstContact> step() {
    const bool is_fresh = is_stale_;
    if (is_stale_ && !(areSmall() && guess())) walk();
    const NearestPoints points = nearest(at_a_, at_b_, 0);
    // Written so that NaN is a touch.
    if (!(points.distance > touch_distance_)) {
      if (time_ == 0) return std::nullopt;
      return touch();
    }
    const Vec2 axis = (points.on_b - points.on_a) / points.distance;
    const double before = time_, end = std::min(1.0, time_ + intervalFor(points, axis));
    const TimeInterval interval(pair_, time_, end, placesUntil(end, pair_.a, at_a_), placesUntil(end, pair_.b, at_b_));
    distance_ = points.distance - pair_.margin;
    bool apart = advance(interval, axis);
    is_stale_ = !(gap_ >= 0.5 * points.distance);
    if (!apart && is_stale_ && is_fresh) apart = advance(interval, face_);
    if (apart && end == 1) return FirstContact::never();
    if (time_ > before) {
      if (!apart && end - time_ <= time_error_ && !(nearest(interval.a, interval.b, 1).distance > touch_distance_))
        return touch();
      place(interval);
    } else {
      if (is_fresh) return std::nullopt;
      is_stale_ = true;
    }
    return FirstContact::unknown(time_);
  }

  FirstContact touch() const { return FirstContact::touch(time_, a_.position(edge_a_), b_.position(edge_b_)); }
  bool areSmall() const { return pair_.a.tree->small_convex && pair_.b.tree->small_convex; }

  /// a's pivot stays.
  Places placesUntil(double end, const Mover& mover, const Places& at) const {
    return mover.rotates || &mover == &pair_.b ? at.to(mover.places(end, end)) : at;
  }
  void place(const TimeInterval& interval) {
    const bool at_end = time_ == interval.end;
    if (pair_.a.rotates) at_a_ = at_end ? interval.a.atEnd() : pair_.a.places(time_, time_);
    at_b_ = at_end ? interval.b.atEnd() : pair_.b.places(time_, time_);
  }
  NearestPoints nearest(const Places& a, const Places& b, int lane) const {
    return NearestPoints(a_.edge(a, lane, edge_a_), b_.edge(b, lane, edge_b_), pair_.error);
  }

  /// Of small polygons: the edge that has all of the other polygon farthest beyond it, as floats see it, and the
  /// flatter edge of that one's vertex that is the farthest back.
  bool guess() {
    const double inverse = 1 / pair_.a.scale;
    const UnitMap map = at_a_.seen(at_b_, inverse).unitMap(pair_.b.scale * inverse);
    if (!(std::abs(map.tx) + std::abs(map.ty) < 0x1p60)) return false;  // floats may overflow
    const ConvexGap gap = convexGap(*pair_.a.tree->small_convex, *pair_.b.tree->small_convex, map);
    take(gap.of_a ? FeaturePair{FeaturePair::kEdgeOfA, gap.edge, gap.vertex}
                  : FeaturePair{FeaturePair::kEdgeOfB, gap.vertex, gap.edge});
    return true;
  }

  /// Where floats have no guess, both outlines are walked around.
  void walk() {
    take(walkToNearest(a_.posed(at_a_), b_.posed(at_b_), load2(at_a_.originTo(at_b_).data()),
                       [&](std::uint32_t v, std::uint32_t w) { return load2(way(v, w).data()); }));
  }

  /// From a's vertex to b's.
  Vec2 way(std::uint32_t v, std::uint32_t w) const { return b_.edge(at_b_, 0, w).from() - a_.edge(at_a_, 0, v).from(); }

  /// The axis that features face along, and an edge of either there. Where none were found, the last ones stay.
  void take(const FeaturePair& found) {
    if (found.kind == FeaturePair::kNone) return;
    const bool is_edge_a = found.kind == FeaturePair::kEdgeOfA, is_edge_b = found.kind == FeaturePair::kEdgeOfB;
    face_ = is_edge_a   ? a_.normal(at_a_, found.edge_a)
            : is_edge_b ? Vec2(-b_.normal(at_b_, found.edge_b))
                        : way(found.edge_a, found.edge_b).normalized();
    edge_a_ = is_edge_a ? found.edge_a : a_.flatterEdge(at_a_, face_, found.edge_a);
    edge_b_ = is_edge_b ? found.edge_b : b_.flatterEdge(at_b_, -face_, found.edge_b);
  }

  /// About how long it may take the nearest points to meet: by how fast they approach now, and how that may change.
  double intervalFor(const NearestPoints& points, const Vec2& axis) const {
    const auto pullAt = [&](double time) { return std::abs(axis.dot(pair_.b.path.accelerationAt(time))); };
    const double bend = pair_.is_steady
                            ? pair_.steady.bend(a_.lever, b_.lever)
                            : pair_.ratesOf(time_, 1).bend(a_.lever, b_.lever) + std::max(pullAt(time_), pullAt(1));
    if (bend == 0) return 1;
    const auto speedOf = [&](const Mover& mover, const Places& at, const Vec2& p) {
      if (!mover.rotates) return 0.0;
      const double rate = mover.is_straight ? mover.rotation.first : mover.rotation.rateAt(time_);
      return rate * ((p.x() - at.pivot_x[0]) * axis.y() - (p.y() - at.pivot_y[0]) * axis.x());
    };
    const double speed = speedOf(pair_.a, at_a_, points.on_a) - speedOf(pair_.b, at_b_, points.on_b) -
                         axis.dot(pair_.is_steady ? pair_.b.path.first : pair_.b.path.rateAt(time_));
    const double gap = points.distance - pair_.margin;
    // The bounds of the acceleration push them together, and apart.
    const double square = speed * speed, push = 2 * bend * gap, root = std::sqrt(std::max(square + push, 0.0));
    const double soonest = speed > 0 ? 2 * gap / (speed + root) : (root - speed) / bend;
    const double latest = speed > 0 && square > push ? 2 * gap / (speed + std::sqrt(square - push)) : 2;
    // Somewhat past contact, as the error allows, but no farther: paths bend by more in a longer interval.
    constexpr double kMostPast = 0x1p-12;
    return std::min(1.25 * soonest, latest) + std::min(0.25 * time_error_, kMostPast);
  }

  /// On to where contact may be, as an axis of length 1 from a to b has it, if anywhere in the interval. Whether it
  /// separates the two throughout. The gap of the regions is that of their support vertices.
  bool advance(const TimeInterval& interval, const Vec2& axis) {
    GapCutter cutter(pair_);
    const GapCutter::Axis n = axisOver(interval, axis);
    const Double2 gap = n.x * (interval.b.x - interval.a.x) + n.y * (interval.b.y - interval.a.y) -
                        a_.reach(interval.a, n.x, n.y, edge_a_) - b_.reach(interval.b, -n.x, -n.y, edge_b_);
    gap_ = gap[0];
    const bool apart = cutter.cutByGap(n, gap);
    const double time =
        apart ? interval.end : std::min(interval.begin + cutter.restLow() * interval.length, interval.end);
    time_ = std::max(time, time_);
    return apart;
  }

  /// One that stands still or, where paths bend by more than little of the distance, rotates with a or b if that is
  /// less.
  GapCutter::Axis axisOver(const TimeInterval& interval, const Vec2& axis) const {
    const double still = interval.fixedChordError(a_.lever, b_.lever) - interval.pull.sparedAlong(axis.x(), axis.y());
    if (!(still > kLittle * distance_)) return GapCutter::standing(axis, still);
    const double with_a = interval.with_a.of(b_.lever, b_.leverFrom(interval.a, interval.b)),
                 with_b = interval.with_b.of(a_.lever, a_.leverFrom(interval.b, interval.a));
    if (still <= std::min(with_a, with_b)) return GapCutter::standing(axis, still);
    const Places& p = with_a <= with_b ? interval.a : interval.b;
    return GapCutter::rotating(axis, p.m00, p.m10, p.m01, p.m11, std::min(with_a, with_b));
  }

  const MovingPair& pair_;
  Body a_, b_;
  double begin_, time_;  ///< until which they are apart
  Places at_a_, at_b_;   ///< then
  double time_error_, touch_distance_;
  std::uint32_t edge_a_ = 0, edge_b_ = 0;  ///< that may be nearest
  bool is_stale_ = true;                   ///< the features are to be guessed anew
  Vec2 face_;                              ///< an axis from a to b: the last that they were looked for by
  double distance_ = 0;                    ///< of the nearest points that are known, beyond the margin
  double gap_ = 0;                         ///< along the last axis, at the interval's begin
};

}  // namespace

bool isConvexPair(const MovingPair& pair) {
  const auto isConvex = [](const PolygonData& p) { return p.isDegenerate() || cornersOf(p) != nullptr; };
  if (!isConvex(*pair.a.polygon) || !isConvex(*pair.b.polygon)) return false;
  // A point is followed for less.
  return pair.isInRange() ? !pair.b.polygon->isPoint() : pair.slides() && pair.error < 1;
}

FirstContact advanceAlongAxis(const MovingPair& pair, double begin, double time_error) {
  return ConvexAdvancement(pair, begin, time_error).run();
}

}  // namespace tricover::detail
