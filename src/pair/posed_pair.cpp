// SPDX-License-Identifier: BSD-3-Clause
#include "pair/posed_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hierarchy/inclusion.h"
#include "numbers/beside_segment.h"
#include "pair/four_ends.h"

namespace tricover::detail {

namespace {

FourEnds endsOf(const PosedPair& pair, EdgePosition i, EdgePosition j) {
  const Vec2 *p = &pair.a.path[i], *q = &pair.b.path[j];
  return {
      {pair.fromA(p[0]), pair.fromA(p[1]), pair.fromB(q[0]), pair.fromB(q[1])}, {&pair.pose_a, p}, {&pair.pose_b, q}};
}

/// What besideSegment() errs by, of |u| + D. What its squares lose by underflow, 2^-510 of D, is less than U |u| where
/// the square of u is above kLeastSquare.
constexpr double kSegmentDistanceError = 16 * kUnitRoundoff, kLeastSquare = 0x1p-900;
static_assert(kSegmentDistanceError >= errorOf(kBesideOfLength) && kSegmentDistanceError >= errorOf(kBesideOfDistance));

/// The least distance of an end of either edge from the other edge; NaN where squares leave the range of doubles.
double leastOfEnds(const ApproxPoint (&e)[4]) {
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](double distance) { least = std::isnan(distance) || distance < least ? distance : least; };
  const auto offerBeside = [&](const ApproxPoint& v, const ApproxPoint& w, const ApproxPoint& p, const ApproxPoint& q) {
    const double ux = w.x - v.x, uy = w.y - v.y, square = ux * ux + uy * uy;
    const Double2 x = Double2{p.x, q.x} - v.x, y = Double2{p.y, q.y} - v.y;
    if (ux == 0 && uy == 0) return offer(std::hypot(x[0], y[0])), offer(std::hypot(x[1], y[1]));
    if (!(square > kLeastSquare && square < 0x1p1000)) return offer(std::numeric_limits<double>::quiet_NaN());
    const Double2 squares = besideSegment(x, y, ux, uy, 1 / square).square;
    offer(std::sqrt(squares[0]));
    offer(std::sqrt(squares[1]));
  };
  offerBeside(e[2], e[3], e[0], e[1]);
  offerBeside(e[0], e[1], e[2], e[3]);
  return least;
}

/// See crossingDirection().
int crossingOf(const FourEnds& ends) {
  const int p = ends.filter(0, 1, 2), q = ends.filter(0, 1, 3), v = ends.filter(2, 3, 0), w = ends.filter(2, 3, 1);
  return p * q == -1 && v * w == -1 ? q : 0;
}

/// What a distance is off by because both edges' ends are, in any direction.
double endsError(const PosedPair& pair) {
  static_assert(1.5 > kRoot2 * (1 + errorOf(8)));
  return 1.5 * (pair.errorOfA() + pair.errorOfB());
}

}  // namespace

bool edgesMeet(const PosedPair& pair, EdgePosition i, EdgePosition j) { return endsOf(pair, i, j).meet(); }

bool edgesWithin(const PosedPair& pair, EdgePosition i, EdgePosition j, double reach, double tolerance, bool strictly) {
  const FourEnds ends = endsOf(pair, i, j);
  if (reach == 0 && tolerance == 0) return ends.meet();
  // The rounded distance d between an end and the other edge. An upper bound always holds, and is above the truth, for
  // kTiny and what else is left of its bound; as a lower bound it holds unless the edges cross, so that is asked first.
  // NaN decides nothing.
  const ApproxPoint* e = ends.approx;
  const double d = leastOfEnds(ends.approx);
  const double length =
      std::max(std::hypot(e[1].x - e[0].x, e[1].y - e[0].y), std::hypot(e[3].x - e[2].x, e[3].y - e[2].y));
  const double err = endsError(pair) + kSegmentDistanceError * (length + d) + kTiny;
  if (d + err <= reach + tolerance) return true;
  const bool apart = d - err > reach;
  // A point crosses nothing: the lower bound holds.
  if (apart && (pair.a.path[i] == pair.a.path[i + 1] || pair.b.path[j] == pair.b.path[j + 1])) return false;
  if (ends.meet()) return true;
  if (apart) return false;
  const auto within = [&](int p, int v, int w) {
    return withinExact(ends.exact(p), ends.exact(v), ends.exact(w), reach, strictly);
  };
  return within(0, 2, 3) || within(1, 2, 3) || within(2, 0, 1) || within(3, 0, 1);
}

int crossingDirection(const PosedPair& pair, EdgePosition i, EdgePosition j) { return crossingOf(endsOf(pair, i, j)); }

double crossingDepth(const PosedPair& pair, EdgePosition i, EdgePosition j) {
  const FourEnds ends = endsOf(pair, i, j);
  if (crossingOf(ends) == 0) return 0;
  // They cross until an end of one is on the other.
  const ApproxPoint* e = ends.approx;
  const double d = leastOfEnds(ends.approx);
  const double length =
      std::abs(e[1].x - e[0].x) + std::abs(e[1].y - e[0].y) + std::abs(e[3].x - e[2].x) + std::abs(e[3].y - e[2].y);
  // D is at most the length of either edge, the sum of which is rounded.
  const double below = d - endsError(pair) - 2 * kSegmentDistanceError * length;
  return below > 0 ? below : 0;  // NaN is 0
}

Location locateInA(const PosedPair& pair, const Vec2& of_b) { return locateInPolygon(pair.a, seenFromA(pair, of_b)); }

}  // namespace tricover::detail
