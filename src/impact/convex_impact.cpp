// SPDX-License-Identifier: BSD-3-Clause
#include "impact/convex_impact.h"

#include <algorithm>
#include <cmath>

#include "hierarchy/simd.h"
#include "impact/window_cutter.h"

namespace tricover::detail {
namespace {

/// As a rule a few are enough.
constexpr int kMostSteps = 64;

/// One of the two polygons: its vertices from S, in the pair's length and in its own frame.
class Body {
 public:
  explicit Body(const Mover& mover) : mover_(mover), convex_(*mover.tree->small_convex) {
    for (int i = 0; i < convex_.count; ++i) {
      const Vec2 p = mover.scale * mover.polygon->inUnits(mover.polygon->path[static_cast<std::size_t>(i)]);
      x_[i] = p.x();
      y_[i] = p.y();
    }
  }

  const SmallPolygon& convex() const { return convex_; }

  /// The farthest that it reaches along an axis from S, at both ends of a window.
  Double2 reach(const Places& p, Double2 nx, Double2 ny) const {
    const Double2 mx = p.m00 * nx + p.m10 * ny, my = p.m01 * nx + p.m11 * ny;
    Double2 most = mx * x_[0] + my * y_[0];
    for (int i = 1; i < convex_.count; ++i) most = larger(most, mx * x_[i] + my * y_[i]);
    return most;
  }

  /// The outer normal of an edge, at the window's begin.
  Vec2 normal(const Places& p, int edge) const {
    const int next = edge + 1 < convex_.count ? edge + 1 : 0;
    const Vec2 along(x_[next] - x_[edge], y_[next] - y_[edge]);
    const Vec2 side = Vec2(along.y(), -along.x()).normalized();
    const Vec2 outer = side.x() * convex_.nx[edge] + side.y() * convex_.ny[edge] < 0 ? Vec2(-side) : side;
    return {p.m00[0] * outer.x() + p.m01[0] * outer.y(), p.m10[0] * outer.x() + p.m11[0] * outer.y()};
  }

  /// The foremost edge along an axis, at the window's begin: of the foremost vertex the flatter one.
  int foremostEdge(const Places& p, const Vec2& n) const {
    const double mx = p.m00[0] * n.x() + p.m10[0] * n.y(), my = p.m01[0] * n.x() + p.m11[0] * n.y();
    const auto height = [&](int i) { return mx * x_[i] + my * y_[i]; };
    int foremost = 0;
    double highest = height(0);
    for (int i = 1; i < convex_.count; ++i) {
      const double h = height(i);
      if (h > highest) highest = h, foremost = i;
    }
    const int before = foremost > 0 ? foremost - 1 : convex_.count - 1;
    const int after = foremost + 1 < convex_.count ? foremost + 1 : 0;
    return height(after) >= height(before) ? foremost : before;
  }

  /// A box around all of it, as WindowCutter asks for levers.
  MovingBox box(const Places& p) const { return {p.x, p.y, p.m00, p.m10, p.m01, p.m11, mover_.scale, 0}; }

 private:
  const Mover& mover_;
  const SmallPolygon& convex_;
  double x_[SmallPolygon::kMost], y_[SmallPolygon::kMost];
};

class ConvexAdvancement {
 public:
  ConvexAdvancement(const MovingPair& pair, double time_error)
      : pair_(pair), a_(pair.a), b_(pair.b), time_error_(time_error), touch_distance_(pair.margin + 4 * pair.error) {}

  FirstContact run(double begin) {
    double time = begin;
    Places at_a = pair_.a.places(time, time), at_b = pair_.b.places(time, time);
    bool stale = true;  // whether the features are to be guessed anew
    if (slides() && guess(at_a, at_b, true)) {
      const Window window(pair_, time, 1, at_a, at_b);
      const MovingBox box_a = a_.box(window.a), box_b = b_.box(window.b);
      WindowCutter cutter(window, box_a, box_b);
      if (cutBy(cutter, window, face_)) return FirstContact::never();
      time = std::min(time + cutter.rest().low * window.length, 1.0);
      at_a = pair_.a.places(time, time);
      at_b = pair_.b.places(time, time);
      // Nearly always the features are the right ones; where that isn't certain, it goes on from there.
      stale = !(time > begin);
    }
    for (int step = 0; step < kMostSteps; ++step) {
      const bool fresh = stale;
      if (stale && !guess(at_a, at_b, false)) break;
      const MovingBox on_a = pair_.a.edge(at_a, edge_a_), on_b = pair_.b.edge(at_b, edge_b_);
      const NearestPoints points(on_a, on_b, 0, pair_.error);
      // Written so that NaN is a touch.
      if (!(points.distance > touch_distance_)) {
        if (time == 0) break;
        return FirstContact::touch(time, edge_a_, edge_b_);
      }
      const Vec2 axis = (points.on_b - points.on_a) / points.distance;
      const double end = std::min(1.0, time + windowFor(at_a, at_b, time, points, axis));
      const Window window(pair_, time, end, at_a, at_b);
      const MovingBox box_a = a_.box(window.a), box_b = b_.box(window.b);
      WindowCutter cutter(window, box_a, box_b);
      bool apart = cutBy(cutter, window, axis);
      stale = !(gap_ >= 0.5 * points.distance);
      if (!apart && stale && fresh) apart = cutBy(cutter, window, face_);
      if (apart && end == 1) return FirstContact::never();
      const double low = apart ? 1 : cutter.rest().low;
      if (!(low > 0)) {
        if (fresh) break;
        continue;
      }
      const double before = time;
      time = apart ? end : std::min(time + low * window.length, end);
      if (!apart && end - time <= time_error_) {
        const NearestPoints at_end(pair_.a.edge(window.a, edge_a_), pair_.b.edge(window.b, edge_b_), 1, pair_.error);
        if (!(at_end.distance > touch_distance_)) return FirstContact::touch(time, edge_a_, edge_b_);
      }
      if (!(time > before)) break;
      at_a = pair_.a.places(time, time);
      at_b = pair_.b.places(time, time);
    }
    return FirstContact::unknown(time);
  }

 private:
  bool slides() const { return pair_.is_steady && !pair_.steady.turns(); }

  /// The edge that has all of the other polygon farthest beyond it, as floats see it, and that one's foremost edge. Or
  /// the edge that parts the two longest, if they slide from now on until time 1.
  bool guess(const Places& at_a, const Places& at_b, bool by_entry) {
    const double inverse = 1 / pair_.a.scale, dx = (at_b.x[0] - at_a.x[0]) * inverse,
                 dy = (at_b.y[0] - at_a.y[0]) * inverse;
    const auto fromPair = [&](double x, double y) {
      return Vec2(at_a.m00[0] * x + at_a.m10[0] * y, at_a.m01[0] * x + at_a.m11[0] * y);
    };
    const Vec2 column_0 = fromPair(at_b.m00[0], at_b.m10[0]), column_1 = fromPair(at_b.m01[0], at_b.m11[0]);
    const Vec2 shift = fromPair(dx, dy), way = fromPair(pair_.b.way.first.x(), pair_.b.way.first.y()) * inverse;
    if (!(shift.lpNorm<1>() + way.lpNorm<1>() < 0x1p60)) return false;  // floats may overflow
    const UnitMap map = {
        column_0.x(), column_1.x(), column_0.y(), column_1.y(), shift.x(), shift.y(), pair_.b.scale * inverse, 0};
    const ConvexGap gap = by_entry ? convexEntry(a_.convex(), b_.convex(), map, way.x(), way.y())
                                   : convexGap(a_.convex(), b_.convex(), map);
    int edge_a = gap.edge, edge_b = gap.edge;
    face_ = gap.of_a ? a_.normal(at_a, edge_a) : Vec2(-b_.normal(at_b, edge_b));
    (gap.of_a ? edge_b : edge_a) = gap.of_a ? b_.foremostEdge(at_b, -face_) : a_.foremostEdge(at_a, face_);
    edge_a_ = static_cast<std::size_t>(edge_a);
    edge_b_ = static_cast<std::size_t>(edge_b);
    return true;
  }

  /// About how long it may take the nearest points to meet: by how fast they approach now, and how that may change.
  double windowFor(const Places& at_a, const Places& at_b, double time, const NearestPoints& points,
                   const Vec2& axis) const {
    const Rates rates = pair_.rates(time, 1);
    const double bend = rates.bend_a * pair_.a.reach + rates.bend_b * pair_.b.reach + rates.pull;
    if (bend == 0) return 1;
    const auto turning = [&](const Mover& mover, const Places& at, const Vec2& p) {
      return mover.turn.rateAt(time) * ((p.x() - at.pivot_x[0]) * axis.y() - (p.y() - at.pivot_y[0]) * axis.x());
    };
    const double speed =
        turning(pair_.a, at_a, points.on_a) - turning(pair_.b, at_b, points.on_b) - axis.dot(pair_.b.way.rateAt(time));
    const double gap = points.distance - pair_.margin;
    // The bounds of the acceleration push them together, and apart.
    const double square = speed * speed, push = 2 * bend * gap, root = std::sqrt(std::max(square + push, 0.0));
    const double soonest = speed > 0 ? 2 * gap / (speed + root) : (root - speed) / bend;
    const double latest = speed > 0 && square > push ? 2 * gap / (speed + std::sqrt(square - push)) : 2;
    return std::min(1.25 * soonest, latest) + 0.25 * time_error_;
  }

  /// Along an axis of length 1 from a to b. The gap of the regions is that of their foremost vertices.
  bool cutBy(WindowCutter& cutter, const Window& window, const Vec2& axis) {
    const WindowCutter::Axis n = cutter.turning(axis);
    const Double2 gap = n.x * (window.b.x - window.a.x) + n.y * (window.b.y - window.a.y) -
                        a_.reach(window.a, n.x, n.y) - b_.reach(window.b, -n.x, -n.y);
    gap_ = gap[0];
    return cutter.cutByGap(n, gap);
  }

  const MovingPair& pair_;
  Body a_, b_;
  double time_error_, touch_distance_;
  std::size_t edge_a_ = 0, edge_b_ = 0;  ///< that may be nearest
  Vec2 face_;                            ///< the normal of the one that was guessed, from a to b
  double gap_ = 0;                       ///< along the last axis, at the window's begin
};

}  // namespace

bool isSmallConvexPair(const MovingPair& pair) {
  // Axes turn with the polygons: off rigid, they wouldn't part what touches to its precision. Squares don't overflow.
  const auto fits = [](const Mover& mover) {
    return mover.tree->small_convex && mover.scale > 0x1p-200 && mover.keepsLengths();
  };
  return fits(pair.a) && fits(pair.b) && pair.error < 1;
}

FirstContact findConvexImpact(const MovingPair& pair, double begin, double time_error) {
  return ConvexAdvancement(pair, time_error).run(begin);
}

}  // namespace tricover::detail
