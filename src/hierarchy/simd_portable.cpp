// SPDX-License-Identifier: BSD-3-Clause
// The SIMD functions for every target, in vectors of four floats; and the choice of those that the processor has.
#include <algorithm>

#include "hierarchy/simd_templates.h"
#include "numbers/float4.h"

namespace tricover::detail {
namespace simd {
namespace {

typedef float FourAnywhere __attribute__((vector_size(16), aligned(4), may_alias));

[[gnu::always_inline]] inline Float4 root(Float4 p) {
#ifdef __SSE2__
  return __builtin_ia32_sqrtps(p);
#else
  for (int i = 0; i < 4; ++i) p[i] = __builtin_sqrtf(p[i]);
  return p;
#endif
}
[[gnu::always_inline]] inline unsigned above(Float4 p, Float4 q) {
  const Bits4 greater = p > q;
#ifdef __SSE2__
  return static_cast<unsigned>(__builtin_ia32_movmskps((Float4)greater));
#else
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) bits |= (greater[i] != 0 ? 1u : 0u) << i;
  return bits;
#endif
}

/// See simd_gaps.h.
struct PortableLanes {
  using Doubles = DoublesOf<Double2>;
  Float4 low, high;

  [[gnu::always_inline]] static unsigned bitsOf(Bits2 bits) { return detail::bitsOf(bits); }

  [[gnu::always_inline]] static Double2 productRest(Double2 p, Double2 q, Double2 product) {
    return detail::productRest(p, q, product);
  }

  [[gnu::always_inline]] static PortableLanes load(const float* p) {
    return {*reinterpret_cast<const FourAnywhere*>(p), *reinterpret_cast<const FourAnywhere*>(p + 4)};
  }
  [[gnu::always_inline]] static PortableLanes all(float value) { return {value - Float4{}, value - Float4{}}; }
  [[gnu::always_inline]] void store(float* p) const {
    *reinterpret_cast<FourAnywhere*>(p) = low;
    *reinterpret_cast<FourAnywhere*>(p + 4) = high;
  }

  using L = PortableLanes;
  [[gnu::always_inline]] friend L operator+(L p, L q) { return {p.low + q.low, p.high + q.high}; }
  [[gnu::always_inline]] friend L operator-(L p, L q) { return {p.low - q.low, p.high - q.high}; }
  [[gnu::always_inline]] friend L operator*(L p, L q) { return {p.low * q.low, p.high * q.high}; }
  [[gnu::always_inline]] friend L operator/(L p, L q) { return {p.low / q.low, p.high / q.high}; }
  [[gnu::always_inline]] friend L operator+(L p, float q) { return {p.low + q, p.high + q}; }
  [[gnu::always_inline]] friend L operator-(L p, float q) { return {p.low - q, p.high - q}; }
  [[gnu::always_inline]] friend L operator*(L p, float q) { return {p.low * q, p.high * q}; }
  [[gnu::always_inline]] friend L absolute(L p) { return {detail::absolute(p.low), detail::absolute(p.high)}; }
  [[gnu::always_inline]] friend L flipped(L p, L q) {
    return {(Float4)((Bits4)p.low ^ ((Bits4)q.low & INT32_MIN)), (Float4)((Bits4)p.high ^ ((Bits4)q.high & INT32_MIN))};
  }
  [[gnu::always_inline]] friend L root(L p) { return {simd::root(p.low), simd::root(p.high)}; }
  [[gnu::always_inline]] friend L larger(L p, L q) {
    return {detail::larger(p.low, q.low), detail::larger(p.high, q.high)};
  }
  [[gnu::always_inline]] friend L smaller(L p, L q) {
    return {p.low < q.low ? p.low : q.low, p.high < q.high ? p.high : q.high};
  }
  [[gnu::always_inline]] friend L whereAbove(L p, L q) {
    const Float4 far = 1e30f - Float4{};
    return {p.low > q.low ? p.low : far, p.high > q.high ? p.high : far};
  }
  [[gnu::always_inline]] friend unsigned above(L p, L q) {
    return simd::above(p.low, q.low) | simd::above(p.high, q.high) << 4;
  }
};

}  // namespace

void growVisits(Visits& visits) {
  Visit* grown = new Visit[2 * static_cast<std::size_t>(visits.room)];
  std::copy_n(visits.all, visits.top, grown);
  if (visits.all != visits.few) releaseVisits(visits.all);
  visits.all = grown;
  visits.room *= 2;
}
void releaseVisits(const Visit* visits) { delete[] visits; }

}  // namespace simd

#define TRICOVER_DEFINE(function) decltype(function) function{&simd::function<simd::PortableLanes>};
TRICOVER_SIMD_FUNCTIONS(TRICOVER_DEFINE)

namespace {

void useFastest() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) useAvx2();
#endif
}
// Here, beside the functions' definitions, so that a program that links one of them from an archive links this, too.
[[maybe_unused]] const bool initialised = (useFastest(), true);

}  // namespace

#ifdef TRICOVER_TEST_SWITCHES
#define TRICOVER_USE(function) function = &simd::function<simd::PortableLanes>;
void usePortableLanes(bool portable) {
  TRICOVER_SIMD_FUNCTIONS(TRICOVER_USE)
  if (!portable) useFastest();
}
#endif

}  // namespace tricover::detail
