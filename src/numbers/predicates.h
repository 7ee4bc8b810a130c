// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include "numbers/rounding.h"
#include "tricover/pose.h"

namespace tricover::detail {

/// The exact point pose * local; no pose means the identity.
struct PosedPoint {
  const Pose* pose;
  Vec2 local;
};

/// A point known to within `error` in each coordinate.
struct ApproxPoint {
  double x, y, error;
};

constexpr int kUncertain = 2;

/// See approxArea(). The bound's own roundings: two sums, two products, three more sums.
constexpr double kAreaError = 5 * kUnitRoundoff;
static_assert(kAreaError >= errorOf(2 + 1 + 1) * (1 + errorOf(7)));

/// A signed area as doubles see it, and by how much it may be wrong at most.
struct ApproxArea {
  double area, bound;
};

/// The signed area |p q r|, twice that of the triangle.
///
/// Bound. Write u = q - p, w = r - p, ^ for the computed values, e_u = e_p + e_q, e_w = e_p + e_r, and P = |^u_x ^w_y|
/// +
/// |^u_y ^w_x|. Each coordinate of u errs by U |^u| + e_u, each of w by U |^w| + e_w, so that the area errs by
///   2U P                                  the products' factors, by their rounding,
///   e_w |^u|_1 + e_u |^w|_1 + 2 e_u e_w   the same, by what the points are known to,
///   U P                                   the products' own rounding,
///   U P                                   that of their difference,
/// and by terms of second order. kAreaError, 1 + 2^-20 and kTiny, for underflow, leave room for those and for rounding
/// in the bound itself. Fused operations only drop roundings. Infinities and NaN end in a bound that is infinite or
/// NaN, too.
inline ApproxArea approxArea(const ApproxPoint& p, const ApproxPoint& q, const ApproxPoint& r) {
  const double ux = q.x - p.x, uy = q.y - p.y, wx = r.x - p.x, wy = r.y - p.y;
  const double left = ux * wy, right = uy * wx;
  const double det = left - right;
  const double eu = p.error + q.error, ew = p.error + r.error;
  const double bound =
      kAreaError * (std::abs(left) + std::abs(right)) +
      (1 + 0x1p-20) * (ew * (std::abs(ux) + std::abs(uy)) + eu * (std::abs(wx) + std::abs(wy) + 2 * ew)) + kTiny;
  return {det, bound};
}

/// The sign of the signed area |p q r|: 1 counter-clockwise, -1 clockwise, kUncertain where rounding could matter.
///
/// TRICOVER_PLAIN_SIGNS, a type, is for benches that ask what exactness costs: every sign is as that type rounds it.
inline int orientFilter(const ApproxPoint& p, const ApproxPoint& q, const ApproxPoint& r) {
#ifdef TRICOVER_PLAIN_SIGNS
  using Real = TRICOVER_PLAIN_SIGNS;
  const Real px = static_cast<Real>(p.x), py = static_cast<Real>(p.y);
  const Real sign = (static_cast<Real>(q.x) - px) * (static_cast<Real>(r.y) - py) -
                    (static_cast<Real>(q.y) - py) * (static_cast<Real>(r.x) - px);
  return (sign > 0) - (sign < 0);
#else
  const auto [det, bound] = approxArea(p, q, r);
  if (det > bound) return 1;
  if (-det > bound) return -1;
  return kUncertain;
#endif
}

/// The sign of the signed area |p q r| of the exact points, in the world.
int orientExact(const PosedPoint& p, const PosedPoint& q, const PosedPoint& r);

/// The sign of the signed area of three points of one frame: filter, then exact stage.
inline int orientation(const Vec2& p, const Vec2& q, const Vec2& r) {
  const int sign = orientFilter({p.x(), p.y(), 0}, {q.x(), q.y(), 0}, {r.x(), r.y(), 0});
  return sign != kUncertain ? sign : orientExact({nullptr, p}, {nullptr, q}, {nullptr, r});
}

/// The sign of p's world coordinate minus q's; axis 0 is x, 1 is y.
int compareExact(const PosedPoint& p, const PosedPoint& q, int axis);

/// Whether p, known to be on the line of v and w, is between them or on one of them.
bool betweenExact(const PosedPoint& p, const PosedPoint& v, const PosedPoint& w);

/// Whether p is at most `length` >= 0 away from the closed segment (v, w), in the world; strictly: less than that.
bool withinExact(const PosedPoint& p, const PosedPoint& v, const PosedPoint& w, double length, bool strictly = false);

/// The distance of p from the closed segment (v, w), in the world: right to kExactDistanceError of itself, and
/// to the smallest double; infinity where it is above the largest. `along`: where the nearest point is, from 0 at v to
/// 1 at w.
constexpr double kExactDistanceError = 8 * kUnitRoundoff;
struct ExactDistance {
  double distance, along;
};
ExactDistance distanceExact(const PosedPoint& p, const PosedPoint& v, const PosedPoint& w);

/// A segment or a ray between two points that stand side by side; no pose means the identity.
struct PosedSegment {
  PosedPoint operator[](int end) const { return {pose, ends[end]}; }

  const Pose* pose;
  const Vec2* ends;
};

/// Where a ray first meets an edge, from 0 at its start to 1 at its end. The two share a point, and the ray's start is
/// not on the edge. Right to kExactFractionError of itself.
constexpr double kExactFractionError = 8 * kUnitRoundoff;
double fractionExact(const PosedSegment& ray, const PosedSegment& edge);

/// The sign of one such fraction minus another edge's.
int compareFractionsExact(const PosedSegment& ray, const PosedSegment& first, const PosedSegment& second);

/// The sign of the fraction at the foot of p on the ray's line, minus that where the ray meets an edge.
int compareFootExact(const PosedPoint& p, const PosedSegment& ray, const PosedSegment& edge);

/// Whether the place where a ray meets an edge is nearer than `length` to the closed segment `other`.
bool meetingWithinExact(const PosedSegment& ray, const PosedSegment& edge, const PosedSegment& other, double length);

#ifdef TRICOVER_TEST_SWITCHES
/// How often this thread has called an exact predicate: tells tests the filter's share.
std::uint64_t exactCalls();
#endif

}  // namespace tricover::detail
