// SPDX-License-Identifier: BSD-3-Clause
#include "impact/moving_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/beside_segment.h"
#include "numbers/power_of_two.h"
#include "numbers/predicates.h"
#include "numbers/rigidity.h"
#include "numbers/segment.h"
#include "numbers/sine.h"
#include "polygon/convexity.h"

namespace tricover::detail {

Places Mover::places(double begin, double end) const {
  const Double2 time{begin, end};
  Double2 x = base.x() + path.first.x() * time, y = base.y() + path.first.y() * time, angle = rotation.first * time;
  if (!is_straight) {
    const auto place = [&](int i) {
      return base[i] + ((path.third[i] * time + path.second[i]) * time + path.first[i]) * time;
    };
    x = place(0);
    y = place(1);
    angle = ((rotation.third * time + rotation.second) * time + rotation.first) * time;
  }
  const auto all = [](double value) { return value - Double2{}; };
  if (!rotates) return {all(linear(0, 0)), all(linear(1, 0)), all(linear(0, 1)), all(linear(1, 1)), x, y, x, y};
  const Double2 at_begin = sineAndCosine(angle[0]), at_end = begin == end ? at_begin : sineAndCosine(angle[1]);
  const Double2 s{at_begin[0], at_end[0]}, c{at_begin[1], at_end[1]};
  return {c * linear(0, 0) - s * linear(1, 0),
          s * linear(0, 0) + c * linear(1, 0),
          c * linear(0, 1) - s * linear(1, 1),
          s * linear(0, 1) + c * linear(1, 1),
          x + (c * arm.x() - s * arm.y()),
          y + (s * arm.x() + c * arm.y()),
          x,
          y};
}

MovingBox Mover::edge(const Places& p, EdgePosition position) const {
  const Vec2 v = inUnits(position), w = inUnits(position + 1);
  const Vec2 mid = 0.5 * (v + w), half = 0.5 * (w - v);
  const double length = half.norm();
  const Vec2 axis = length > 0 ? Vec2(half / length) : Vec2(1, 0);
  MovingBox edge = box(p, {mid.x(), mid.y(), axis.x(), axis.y(), length, 0, 0, true});
  edge.vx = -edge.uy;
  edge.vy = edge.ux;
  return edge;
}

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

// Error of a gap between computed points or boxes, all lengths in the pair's length; in units of U, with A = |angle|, r
// = reach, f the shifts, levers, the margin and the difference of the starts; |angle| and |shift| are the sums of all
// their terms' sizes:
//   rotation   the rotation's three products and two sums 5 A, sine and cosine an ulp 2        5 A + 2
//   M          those of two entries sqrt2 (5 A + 2), product 1, sum 1                      7.1 A + 4.9
//   a point    two entries of M, product 1, two sums 2, to units 1: (10.1 A + 11) r        in either coordinate
//   the arm    itself 4, two entries, product 1, two sums 2: (7.1 A + 12) r                the same
//   pivots     five products, and six sums or differences at most                          11 f
//   sqrt2 of these in any direction, of both movers together                               14.3 A r + 17 r + 15.6 f
//   a gap      the dot products with unit axes                                             8 r + 8 f
//   an interval's end, moved by some 8 of its share, costs that of what the points travel, at rates of three times the
//   terms' sizes at most                                                                   24 A r + 24 f
constexpr double kGapError = 64 * kUnitRoundoff;
static_assert(kGapError >= kUnitRows * (errorOf(12) * kRoot2 + errorOf(8)));         // of r
static_assert(kGapError >= kUnitRows * (errorOf(1) * 10.1 * kRoot2 + errorOf(24)));  // of A r
static_assert(kGapError >= kUnitRows * (errorOf(11) * kRoot2 + errorOf(8 + 24)));    // of f

/// A power of two. Times it, neither sums nor products of what is given overflow, and underflow loses the least.
double shrinkOf(const PolygonData& polygon_a, const Motion& motion_a, const PolygonData& polygon_b,
                const Motion& motion_b, double margin) {
  Double2 largest{std::max(polygon_a.extent, polygon_b.extent), margin};
  for (const Motion* motion : {&motion_a, &motion_b})
    for (const double* v : {motion->start.data() + 6, motion->shift.data(), motion->shift_2.data(),
                            motion->shift_3.data(), motion->pivot.data()})
      largest = larger(largest, absolute(load2(v)));
  const double given = std::min(std::max(largest[0], largest[1]), kLargest);
  return given > 0 ? powerOfTwo(std::min(1000 - exponentOf(given), 1000)) : 1;
}

/// L = Q S, with S the root of L^T L, unless L is off rigid by no more than rotations that were made of doubles: that
/// is less than what MovingPair::error allows for, and so is what S and Q are rounded by. S's eigenvalues are L's
/// singular values.
void decompose(const Eigen::Matrix2d& linear, Mover& mover) {
  constexpr double kMostDefect = 0x1p-47;
  const double defect = Gram(load2(linear.data()), load2(linear.data() + 2)).defect();
  mover.linear = linear;
  mover.stretch.setIdentity();
  if (defect <= kMostDefect) return;
  const Eigen::Matrix2d gram = linear.transpose() * linear;
  const double root = std::abs(linear.determinant());
  mover.stretch = (gram + root * Eigen::Matrix2d::Identity()) / std::sqrt(gram.trace() + 2 * root);
  mover.linear = linear * mover.stretch.inverse();
  mover.stretched = defect * (1 + 0x1p-20);
}

/// In the frame of the world but for its pose's translation, all lengths times `shrink`.
Mover moverOf(const PolygonData& polygon, const Motion& motion, double shrink) {
  Mover mover;
  mover.polygon = mover.given = &polygon;
  mover.motion = &motion;
  const Eigen::Matrix2d linear = motion.start.linear();
  decompose(linear, mover);
  // A point stays where it is if it rotates about itself.
  const bool rotates = !(polygon.isPoint() && motion.pivot == polygon.origin);
  mover.rotation = rotates ? rotationOf(motion) : Cubic<double>{0, 0, 0};
  mover.rotates = !mover.rotation.isZero();
  // Without a rotation any pivot will do, and S is the nearest.
  mover.pivot = mover.rotates ? motion.pivot : polygon.origin;
  const Vec2 pivot = shrink * mover.pivot;
  mover.base = linear * pivot;
  mover.path = shrink * pathOf(motion);
  mover.is_straight = mover.path.isStraight() && mover.rotation.isStraight();
  mover.arm = linear * (shrink * polygon.origin - pivot);
  mover.reach = mover.arm.lpNorm<1>() + shrink * polygon.radius * (1 + kLargestDefect);
  // Of the largest polygons the hierarchy knows nothing.
  if (!polygon.fitsUnit()) mover.reach = std::numeric_limits<double>::infinity();
  mover.scale = shrink * polygon.unit;
  return mover;
}

/// What f stands for above, of one mover; and its reach.
double roundedBy(const Mover& mover, double shrink) {
  return mover.reach + (shrink * mover.pivot).lpNorm<1>() + mover.path.first.lpNorm<1>() +
         mover.path.second.lpNorm<1>() + mover.path.third.lpNorm<1>();
}

}  // namespace

MovingPair::MovingPair(const PolygonData& polygon_a, const Motion& motion_a, const PolygonData& polygon_b,
                       const Motion& motion_b, double margin_)
    : expansion(1 / shrinkOf(polygon_a, motion_a, polygon_b, motion_b, margin_)),
      a(moverOf(polygon_a, motion_a, 1 / expansion)),
      b(moverOf(polygon_b, motion_b, 1 / expansion)),
      is_steady(a.is_straight && b.is_straight),
      given_margin(margin_),
      margin(margin_ / expansion) {
  const double shrink = 1 / expansion;
  const Vec2 apart = shrink * motion_b.start.translation() - shrink * motion_a.start.translation();
  const double rotated = a.rotation.size() * a.reach + b.rotation.size() * b.reach;
  const double others = roundedBy(a, shrink) + roundedBy(b, shrink) + (apart.lpNorm<1>() + margin);
  b.base = apart + (b.base - a.base);
  b.path = b.path - a.path;
  a.base = Vec2::Zero();
  a.path = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
  if (!is_steady) {  // one alone is, or both bend alike
    a.is_straight = a.rotation.isStraight();
    b.is_straight = b.rotation.isStraight() && b.path.isStraight();
    is_steady = a.is_straight && b.is_straight;
  }
  const double inverse = divideByLength();
  still_error = (kGapError * others + kTiny) * inverse;
  error = kGapError * rotated * inverse + still_error;
}

double MovingPair::divideByLength() {
  const double largest = std::max({a.reach, b.reach, b.base.lpNorm<1>(), b.path.first.lpNorm<1>(),
                                   b.path.second.lpNorm<1>(), b.path.third.lpNorm<1>(), margin});
  const int exponent = std::clamp(exponentOf(largest), -1000, 1020);
  const double inverse = powerOfTwo(-exponent);
  length = powerOfTwo(exponent);
  for (Mover* mover : {&a, &b}) {
    mover->base *= inverse;
    mover->path = inverse * mover->path;
    mover->arm *= inverse;
    mover->reach *= inverse;
    mover->scale *= inverse;
    // The smallest polygons, and points, are smaller than rounding by far.
    mover->view = std::max(mover->scale, 0x1p-200);
    mover->in_view = mover->scale / mover->view;
  }
  margin *= inverse;
  return inverse;
}

Rates MovingPair::ratesOf(double begin, double end) const {
  const Cubic<double> relative = b.rotation - a.rotation;
  const double rate_a = a.rotation.mostRate(begin, end), rate_b = b.rotation.mostRate(begin, end);
  const double of_a = a.rotation.mostAcceleration(begin, end), of_b = b.rotation.mostAcceleration(begin, end);
  const double between = relative.mostRate(begin, end);
  return {rate_a,
          rate_b,
          of_a + rate_a * rate_a,
          of_b + rate_b * rate_b,
          relative.mostAcceleration(begin, end) + between * between,
          of_a + rate_a * (relative + b.rotation).mostRate(begin, end),
          of_b + rate_b * (relative - a.rotation).mostRate(begin, end),
          b.path.mostRate(begin, end),
          b.path.mostAcceleration(begin, end)};
}

void MovingPair::prepare() {
  if (is_steady) steady = ratesOf(0, 1);
  for (Mover* mover : {&a, &b}) {
    if (const PolygonData* corners = cornersOf(*mover->given)) mover->polygon = corners;  // of the same S and unit
    mover->tree = &hierarchyOf(*mover->polygon);
  }
}

// A path of acceleration A or less leaves the line between its ends by at most A / 8.
bool MovingPair::discsStayApart() const {
  if (a.polygon->fill.is_complement || b.polygon->fill.is_complement) return false;
  const Vec2 chord = b.path.at(1);
  const double chord_error = b.path.mostAcceleration(0, 1) / 8 * (1 + 0x1p-20);
  // Rounding moves the nearest point along the path, by so little that the distance differs in the second order only.
  const Vec2 nearest = b.base + nearestOnSegment(-b.base, Vec2::Zero(), chord);
  return nearest.norm() - chord_error > a.reach + b.reach + margin + still_error;
}

namespace {

/// Two points, a lane each, beside a segment: on which side they are, times its length, and the squares of how far away
/// they are, but for rounding.
struct TwoBeside {
  TwoBeside(const MovingEdge& points, const MovingEdge& segment) {
    const double ux = segment.x[1] - segment.x[0], uy = segment.y[1] - segment.y[0];
    const Double2 dx = points.x - segment.x[0], dy = points.y - segment.y[0];
    side = ux * dy - uy * dx;
    square = besideSegment(dx, dy, ux, uy, 1 / (ux * ux + uy * uy)).square;  // NaN is its start: it is a point
  }
  /// Whether both are certainly on different sides; as long as that isn't known, of no doubt.
  bool areOpposite(double doubt) const {
    return std::min(side[0], side[1]) < -doubt && std::max(side[0], side[1]) > doubt;
  }
  Double2 side, square;
};

}  // namespace

NearestPoints::NearestPoints(const MovingEdge& a, const MovingEdge& b, double error) {
  const TwoBeside of_a(a, b), of_b(b, a);
  if (of_a.areOpposite(0) && of_b.areOpposite(0)) {
    // Where a sign isn't certain, an end of one is about as near to the other as rounding is large.
    const double doubt = error * ((a.to() - a.from()).lpNorm<1>() + (b.to() - b.from()).lpNorm<1>() +
                                  (b.from() - a.from()).lpNorm<1>() + std::numeric_limits<double>::min());
    if (of_b.areOpposite(doubt) && of_a.areOpposite(doubt)) {
      const double share = of_b.side[0] / (of_b.side[0] - of_b.side[1]);
      on_a = on_b = b.from() + share * (b.to() - b.from());
      distance = 0;
      return;
    }
  }
  // NaN ends as distance NaN.
  const int end_a = of_a.square[1] >= of_a.square[0] ? 0 : 1, end_b = of_b.square[1] >= of_b.square[0] ? 0 : 1;
  const bool is_of_a = of_b.square[end_b] >= of_a.square[end_a];
  on_a = is_of_a ? a.end(end_a) : nearestOnSegment(b.end(end_b), a.from(), a.to());
  on_b = is_of_a ? nearestOnSegment(on_a, b.from(), b.to()) : b.end(end_b);
  distance = (on_b - on_a).norm();
}

}  // namespace tricover::detail
