// SPDX-License-Identifier: BSD-3-Clause
#include "numbers/predicates.h"

#include <algorithm>

#include "numbers/double_double.h"
#include "numbers/dyadic.h"

namespace tricover::detail {
namespace {

#ifdef TRICOVER_TEST_SWITCHES
thread_local std::uint64_t exact_calls = 0;
void countExactCall() { ++exact_calls; }
#else
void countExactCall() {}
#endif

#ifdef TRICOVER_PLAIN_SIGNS
struct Number {
  using Real = TRICOVER_PLAIN_SIGNS;
  Real value;
  explicit Number(double v) : value(static_cast<Real>(v)) {}
  int sign() const { return (value > 0) - (value < 0); }
  Dyadic::Scaled scaled() const { return {static_cast<double>(value), 0}; }
  friend Number operator+(Number p, Number q) { return Number(p.value + q.value); }
  friend Number operator-(Number p, Number q) { return Number(p.value - q.value); }
  friend Number operator*(Number p, Number q) { return Number(p.value * q.value); }
};
using LongNumber = Number;
#else
using Number = Dyadic;
using LongNumber = LongDyadic;
#endif

template <class Real>
struct ExactVectorOf {
  Real x, y;
};
using ExactVector = ExactVectorOf<Number>;

template <class Real = Number>
Real coordinate(const PosedPoint& p, int axis) {
  if (p.pose == nullptr) return Real(p.local[axis]);
  const auto& m = p.pose->matrix();
  return Real(m(axis, 0)) * Real(p.local.x()) + Real(m(axis, 1)) * Real(p.local.y()) + Real(m(axis, 2));
}

template <class Real = Number>
ExactVectorOf<Real> difference(const PosedPoint& p, const PosedPoint& q) {
  return {coordinate<Real>(p, 0) - coordinate<Real>(q, 0), coordinate<Real>(p, 1) - coordinate<Real>(q, 1)};
}

template <class Real>
Real cross(const ExactVectorOf<Real>& u, const ExactVectorOf<Real>& w) {
  return u.x * w.y - u.y * w.x;
}
template <class Real>
Real dot(const ExactVectorOf<Real>& u, const ExactVectorOf<Real>& w) {
  return u.x * w.x + u.y * w.y;
}

/// A fraction of a ray; the denominator is positive.
template <class Real>
struct Ratio {
  Real numerator, denominator;
};

template <class Real>
Ratio<Real> positive(const Real& numerator, const Real& denominator) {
  const Real sign(denominator.sign());
  return {numerator * sign, denominator * sign};
}

template <class Real>
int compare(const Ratio<Real>& p, const Ratio<Real>& q) {
  return (p.numerator * q.denominator - q.numerator * p.denominator).sign();
}

/// With d along the ray and u along the edge, from + s d is on the edge's line where s |d u| = |(v - from) u|. On one
/// line the edge's nearer end is met first.
template <class Real = Number>
Ratio<Real> fractionOf(const PosedSegment& ray, const PosedSegment& edge) {
  const ExactVectorOf<Real> d = difference<Real>(ray[1], ray[0]), u = difference<Real>(edge[1], edge[0]);
  const ExactVectorOf<Real> to_start = difference<Real>(edge[0], ray[0]);
  const Real slant = cross(d, u);
  if (slant.sign() != 0) return positive(cross(to_start, u), slant);
  const ExactVectorOf<Real> to_end = difference<Real>(edge[1], ray[0]);
  const bool along_x = d.x.sign() != 0;
  const Ratio<Real> start = positive(along_x ? to_start.x : to_start.y, along_x ? d.x : d.y);
  const Ratio<Real> end = positive(along_x ? to_end.x : to_end.y, along_x ? d.x : d.y);
  return compare(start, end) <= 0 ? start : end;
}

#ifdef TRICOVER_PLAIN_SIGNS
int orientTwofold(const PosedPoint&, const PosedPoint&, const PosedPoint&) { return kUncertain; }
#else
using Twofold2 = Twofold<Double2>;

/// A point or a vector of the world. `size`: at least what the terms of either coordinate sum to.
struct TwofoldVector {
  Twofold2 at;
  double size;

  double length() const {
    const Double2 a = absolute(at.high);
    return a[0] + a[1];
  }
};

double largerOf(Double2 v) { return v[0] > v[1] ? v[0] : v[1]; }

TwofoldVector twofold(const PosedPoint& p) {
  const Double2 local = load2(p.local.data());
  if (p.pose == nullptr) return {{local, Double2{}}, largerOf(absolute(local))};
  const double* m = p.pose->data();  // columns of three
  const Twofold2 x = twoProduct(load2(m), Double2{local[0], local[0]});
  const Twofold2 y = twoProduct(load2(m + 3), Double2{local[1], local[1]});
  const Double2 shift = load2(m + 6);
  return {x + y + Twofold2{shift, Double2{}}, largerOf(absolute(x.high) + absolute(y.high) + absolute(shift))};
}

TwofoldVector difference(const TwofoldVector& p, const TwofoldVector& q) { return {p.at - q.at, p.size + q.size}; }

/// The sign of the signed area, or kUncertain.
///
/// Bound. With sizes e, a coordinate's two sums err by 3.1 U^2 e each, and a difference u of two points of e_u together
/// by 6.2 U^2 e_u + 3.1 U^2 |u|, less than 9.4 U^2 e_u in either coordinate. Of the area:
///   9.4 (|u|_1 e_w + |w|_1 e_u) U^2      the products' factors
///   (5.1 + 3.1) |u|_1 e_w U^2            the products, which sum to |u|_1 e_w at most, and their difference
/// What is below 2^-900 is left to the exact stage: so rests that underflow are less than terms of second order, or
/// than kTiny.
constexpr double kTwofoldError = 32 * kUnitRoundoff * kUnitRoundoff;
static_assert(kTwofoldError >= (9.4 + 5.1 + 3.1 + 1) * kUnitRoundoff * kUnitRoundoff);
int orientTwofold(const PosedPoint& p, const PosedPoint& q, const PosedPoint& r) {
  const TwofoldVector at_p = twofold(p), u = difference(twofold(q), at_p), w = difference(twofold(r), at_p);
  const double least = u.size < w.size ? u.size : w.size, most = u.size < w.size ? w.size : u.size;
  if (!(least > 0x1p-900 && most < 0x1p400)) return kUncertain;
  const Twofold2 swapped_w{swapped(w.at.high), swapped(w.at.low)}, products = u.at * swapped_w;
  const Twofold2 other{swapped(products.high), swapped(products.low)};
  const double area = (products - other).high[0];
  const double bound = kTwofoldError * (u.length() * w.size + w.length() * u.size) + kTiny;
  return area > bound ? 1 : -area > bound ? -1 : kUncertain;
}
#endif

double rootOf(const Dyadic::Scaled& square) { return std::ldexp(std::sqrt(square.mantissa), square.exponent / 2); }

/// A point beside the segment from v to w, along u. Returns ofEnd(the way from that end to the point, 0 or 1) where an
/// end is nearest; otherwise ofInner(the area of u and from_v, their dot product).
template <class Real, class FromW, class OfEnd, class OfInner>
auto besideSegment(const ExactVectorOf<Real>& u, const ExactVectorOf<Real>& from_v, FromW fromW, OfEnd ofEnd,
                   OfInner ofInner) {
  const Real along = dot(from_v, u);
  if (along.sign() <= 0) return ofEnd(from_v, 0);
  const ExactVectorOf<Real> from_w = fromW();
  if (dot(from_w, u).sign() >= 0) return ofEnd(from_w, 1);
  return ofInner(cross(u, from_v), along);
}

/// The sign of the square of the distance minus `square`.
template <class Real, class FromW>
int compareDistance(const ExactVectorOf<Real>& u, const ExactVectorOf<Real>& from_v, FromW fromW, const Real& square) {
  return besideSegment(
      u, from_v, fromW, [&](const ExactVectorOf<Real>& way, int) { return (dot(way, way) - square).sign(); },
      [&](const Real& area, const Real&) { return (area * area - square * dot(u, u)).sign(); });
}

}  // namespace

int orientExact(const PosedPoint& p, const PosedPoint& q, const PosedPoint& r) {
  countExactCall();
  const int sign = orientTwofold(p, q, r);
  return sign != kUncertain ? sign : cross(difference(q, p), difference(r, p)).sign();
}

int compareExact(const PosedPoint& p, const PosedPoint& q, int axis) {
  countExactCall();
  return (coordinate(p, axis) - coordinate(q, axis)).sign();
}

bool betweenExact(const PosedPoint& p, const PosedPoint& v, const PosedPoint& w) {
  return compareExact(p, v, 0) * compareExact(p, w, 0) <= 0 && compareExact(p, v, 1) * compareExact(p, w, 1) <= 0;
}

bool withinExact(const PosedPoint& p, const PosedPoint& v, const PosedPoint& w, double length, bool strictly) {
  countExactCall();
  const auto fromW = [&] { return difference(p, w); };
  const int sign = compareDistance(difference(w, v), difference(p, v), fromW, Number(length) * Number(length));
  return sign < 0 || (sign == 0 && !strictly);
}

// A mantissa is right to 2U, the root of one to U + U, their quotient to 2U + 2U + U. The one scaling rounds again only
// where the result is denormal.
static_assert(kExactDistanceError >= errorOf(2 + 2 + 1));
ExactDistance distanceExact(const PosedPoint& p, const PosedPoint& v, const PosedPoint& w) {
  countExactCall();
  const ExactVector u = difference(w, v);
  const auto ofEnd = [](const ExactVector& way, int end) -> ExactDistance {
    return {rootOf(dot(way, way).scaled()), static_cast<double>(end)};
  };
  const auto ofInner = [&](const Number& area_u, const Number& along) -> ExactDistance {
    const Dyadic::Scaled area = area_u.scaled(), square = dot(u, u).scaled(), part = along.scaled();
    return {std::ldexp(std::abs(area.mantissa) / std::sqrt(square.mantissa), area.exponent - square.exponent / 2),
            std::min(std::ldexp(part.mantissa / square.mantissa, part.exponent - square.exponent), 1.0)};
  };
  return besideSegment(
      u, difference(p, v), [&] { return difference(p, w); }, ofEnd, ofInner);
}

// Both mantissas are right to 2U, and their quotient rounds once more.
static_assert(kExactFractionError >= errorOf(2 + 2 + 1));
double fractionExact(const PosedSegment& ray, const PosedSegment& edge) {
  countExactCall();
  const Ratio<Number> ratio = fractionOf(ray, edge);
  if (ratio.numerator.sign() == 0) return 0;
  const Dyadic::Scaled part = ratio.numerator.scaled(), whole = ratio.denominator.scaled();
  return std::ldexp(part.mantissa / whole.mantissa, part.exponent - whole.exponent);
}

int compareFractionsExact(const PosedSegment& ray, const PosedSegment& first, const PosedSegment& second) {
  countExactCall();
  return compare(fractionOf(ray, first), fractionOf(ray, second));
}

int compareFootExact(const PosedPoint& p, const PosedSegment& ray, const PosedSegment& edge) {
  countExactCall();
  const ExactVector d = difference(ray[1], ray[0]);
  return compare({dot(difference(p, ray[0]), d), dot(d, d)}, fractionOf(ray, edge));
}

/// All lengths times the fraction's denominator.
bool meetingWithinExact(const PosedSegment& ray, const PosedSegment& edge, const PosedSegment& other, double length) {
  countExactCall();
  using Vector = ExactVectorOf<LongNumber>;
  const Ratio<LongNumber> at = fractionOf<LongNumber>(ray, edge);
  const Vector d = difference<LongNumber>(ray[1], ray[0]), u = difference<LongNumber>(other[1], other[0]);
  const LongNumber reach = LongNumber(length) * at.denominator, square = reach * reach;
  const auto from = [&](const PosedPoint& p) -> Vector {
    const Vector way = difference<LongNumber>(ray[0], p);
    return {way.x * at.denominator + d.x * at.numerator, way.y * at.denominator + d.y * at.numerator};
  };
  return compareDistance(
             u, from(other[0]), [&] { return from(other[1]); }, square) < 0;
}

#ifdef TRICOVER_TEST_SWITCHES
std::uint64_t exactCalls() { return exact_calls; }
#endif

}  // namespace tricover::detail
