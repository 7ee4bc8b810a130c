// SPDX-License-Identifier: BSD-3-Clause
// Eight floats side by side. Part of wide_body.h.

typedef float Native __attribute__((vector_size(TRICOVER_VECTOR)));
typedef std::int32_t NativeBits __attribute__((vector_size(TRICOVER_VECTOR)));
typedef float Loose __attribute__((vector_size(TRICOVER_VECTOR), aligned(4), may_alias));  // anywhere in an array

#define TRICOVER_INLINE TRICOVER_TARGET __attribute__((always_inline)) inline

TRICOVER_INLINE Native absolute(Native p) { return (Native)((NativeBits)p & 0x7fffffff); }
TRICOVER_INLINE Native root(Native p) {
#if TRICOVER_VECTOR == 32
  return __builtin_ia32_sqrtps256(p);
#elif defined(__SSE2__)
  return __builtin_ia32_sqrtps(p);
#else
  for (int i = 0; i < 4; ++i) p[i] = __builtin_sqrtf(p[i]);
  return p;
#endif
}
TRICOVER_INLINE Native larger(Native p, Native q) { return p > q ? p : q; }
TRICOVER_INLINE Native smaller(Native p, Native q) { return p < q ? p : q; }
/// p where it is above q, elsewhere something large.
TRICOVER_INLINE Native whereAbove(Native p, Native q) { return p > q ? p : 1e30f - Native{}; }
/// Bit i: lane i of p is above that of q.
TRICOVER_INLINE unsigned above(Native p, Native q) {
  const NativeBits greater = p > q;
#if TRICOVER_VECTOR == 32
  return static_cast<unsigned>(__builtin_ia32_movmskps256((Native)greater));
#elif defined(__SSE2__)
  return static_cast<unsigned>(__builtin_ia32_movmskps((Native)greater));
#else
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) bits |= (greater[i] != 0 ? 1u : 0u) << i;
  return bits;
#endif
}

#if TRICOVER_VECTOR == 32
typedef Native Lanes;
TRICOVER_INLINE Lanes load(const float* p) { return *reinterpret_cast<const Loose*>(p); }
TRICOVER_INLINE void store(float* p, Lanes lanes) { *reinterpret_cast<Loose*>(p) = lanes; }
TRICOVER_INLINE Lanes all(float value) { return value - Native{}; }
#else
struct Lanes {
  Native low, high;
};
TRICOVER_INLINE Lanes load(const float* p) {
  return {*reinterpret_cast<const Loose*>(p), *reinterpret_cast<const Loose*>(p + 4)};
}
TRICOVER_INLINE void store(float* p, Lanes lanes) {
  *reinterpret_cast<Loose*>(p) = lanes.low;
  *reinterpret_cast<Loose*>(p + 4) = lanes.high;
}
TRICOVER_INLINE Lanes all(float value) { return {value - Native{}, value - Native{}}; }
TRICOVER_INLINE Lanes operator+(Lanes p, Lanes q) { return {p.low + q.low, p.high + q.high}; }
TRICOVER_INLINE Lanes operator-(Lanes p, Lanes q) { return {p.low - q.low, p.high - q.high}; }
TRICOVER_INLINE Lanes operator*(Lanes p, Lanes q) { return {p.low * q.low, p.high * q.high}; }
TRICOVER_INLINE Lanes operator+(Lanes p, float q) { return {p.low + q, p.high + q}; }
TRICOVER_INLINE Lanes operator-(Lanes p, float q) { return {p.low - q, p.high - q}; }
TRICOVER_INLINE Lanes operator*(Lanes p, float q) { return {p.low * q, p.high * q}; }
TRICOVER_INLINE Lanes operator/(Lanes p, Lanes q) { return {p.low / q.low, p.high / q.high}; }
TRICOVER_INLINE Lanes root(Lanes p) { return {root(p.low), root(p.high)}; }
TRICOVER_INLINE Lanes absolute(Lanes p) { return {absolute(p.low), absolute(p.high)}; }
TRICOVER_INLINE Lanes larger(Lanes p, Lanes q) { return {larger(p.low, q.low), larger(p.high, q.high)}; }
TRICOVER_INLINE Lanes smaller(Lanes p, Lanes q) { return {smaller(p.low, q.low), smaller(p.high, q.high)}; }
TRICOVER_INLINE Lanes whereAbove(Lanes p, Lanes q) { return {whereAbove(p.low, q.low), whereAbove(p.high, q.high)}; }
TRICOVER_INLINE unsigned above(Lanes p, Lanes q) { return above(p.low, q.low) | above(p.high, q.high) << 4; }
#endif

TRICOVER_INLINE double magnitude(double x) { return __builtin_fabs(x); }
