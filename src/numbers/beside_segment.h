// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/double2.h"

namespace tricover::detail {

/// Points, one a lane, beside the segment from the origin to u.
template <class T>
struct BesideSegment {
  T along;   ///< the segment, times its length
  T part;    ///< where on it the nearest point is, from 0 to 1
  T square;  ///< of the distance
};

/// A point's distance D from a segment is known in five ways, each written once:
///   exactly         withinExact(), distanceExact()
///   to 2^-47        PosedVertices::foot(), and in two-fold numbers twofoldDistance() where that isn't certain
///   within a bound  here, for doubles and floats
///   in motion       EdgeInUnits::beside(), with how far the point's path may bend
///   rounded         nearestOnSegment()
/// The bound, with d from the segment's start to the point, |d| <= |u| + D wherever rounding decides where the foot s u
/// is; in units of the roundoff:
///   u, d            rounded differences                                                   1 |u|, 1 |d|
///   s |u|           d.u: 4 |d|; u.u, its inverse and the product: (4 + 2) |u|             10 |u| + 4 D
///   d - s u         d 1 |d|, u and the product 2 |u|, difference 1 D                      3 |u| + 2 D
///   the root        squares and sum, halved, and the root                                 2 D
/// 13 |u| + 8 D, because a distance changes by at most what the foot moves by.
constexpr int kBesideOfLength = 13, kBesideOfDistance = 8;

/// `inverse_square` is 1 / |u|^2, or 0 of a segment that is taken for its start. T is Double2 or SIMD lanes.
template <class T, class Scalar>
[[gnu::always_inline]] inline BesideSegment<T> besideSegment(T x, T y, Scalar ux, Scalar uy, Scalar inverse_square) {
  const T along = x * ux + y * uy, zero{}, part = smaller(larger(along * inverse_square, zero), zero + Scalar{1});
  const T dx = x - part * ux, dy = y - part * uy;
  return {along, part, dx * dx + dy * dy};
}

}  // namespace tricover::detail
