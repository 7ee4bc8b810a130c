// SPDX-License-Identifier: BSD-3-Clause
// The SIMD functions in vectors of eight floats, for processors that have AVX2 and fused operations. Only what stands
// between push and pop may use it: what is included before them (Eigen, the standard library) is compiled as everywhere
// else, so that no inline function that other files share needs such a processor. Whatever simd_templates.h includes is
// therefore included before it, too.
#include <cassert>

#include "hierarchy/axis_boxes.h"
#include "hierarchy/inner_discs.h"
#include "hierarchy/simd.h"
#include "numbers/double2.h"
#include "numbers/double_double.h"

#ifdef __x86_64__

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif

#include "hierarchy/simd_templates.h"

namespace tricover::detail {
namespace simd {
namespace {

typedef float Eight __attribute__((vector_size(32)));
typedef std::int32_t EightBits __attribute__((vector_size(32)));
typedef float EightAnywhere __attribute__((vector_size(32), aligned(4), may_alias));

typedef double FourDoubles __attribute__((vector_size(32)));
typedef std::int64_t FourBits __attribute__((vector_size(32)));

/// See simd_gaps.h.
struct Avx2Lanes {
  using Doubles = DoublesOf<FourDoubles>;
  Eight v;

  [[gnu::always_inline]] static unsigned bitsOf(FourBits bits) {
    return static_cast<unsigned>(__builtin_ia32_movmskpd256((FourDoubles)bits));
  }

  [[gnu::always_inline]] static Double2 productRest(Double2 p, Double2 q, Double2 product) {
    return Double2{__builtin_fma(p[0], q[0], -product[0]), __builtin_fma(p[1], q[1], -product[1])};
  }

  [[gnu::always_inline]] static Avx2Lanes load(const float* p) { return {*reinterpret_cast<const EightAnywhere*>(p)}; }
  [[gnu::always_inline]] static Avx2Lanes all(float value) { return {value - Eight{}}; }
  [[gnu::always_inline]] void store(float* p) const { *reinterpret_cast<EightAnywhere*>(p) = v; }

  using L = Avx2Lanes;
  [[gnu::always_inline]] friend L operator+(L p, L q) { return {p.v + q.v}; }
  [[gnu::always_inline]] friend L operator-(L p, L q) { return {p.v - q.v}; }
  [[gnu::always_inline]] friend L operator*(L p, L q) { return {p.v * q.v}; }
  [[gnu::always_inline]] friend L operator/(L p, L q) { return {p.v / q.v}; }
  [[gnu::always_inline]] friend L operator+(L p, float q) { return {p.v + q}; }
  [[gnu::always_inline]] friend L operator-(L p, float q) { return {p.v - q}; }
  [[gnu::always_inline]] friend L operator*(L p, float q) { return {p.v * q}; }
  [[gnu::always_inline]] friend L absolute(L p) { return {(Eight)((EightBits)p.v & 0x7fffffff)}; }
  [[gnu::always_inline]] friend L flipped(L p, L q) { return {(Eight)((EightBits)p.v ^ ((EightBits)q.v & INT32_MIN))}; }
  [[gnu::always_inline]] friend L root(L p) { return {__builtin_ia32_sqrtps256(p.v)}; }
  [[gnu::always_inline]] friend L larger(L p, L q) { return {__builtin_ia32_maxps256(p.v, q.v)}; }
  [[gnu::always_inline]] friend L smaller(L p, L q) { return {__builtin_ia32_minps256(p.v, q.v)}; }
  [[gnu::always_inline]] friend L whereAbove(L p, L q) { return {p.v > q.v ? p.v : 1e30f - Eight{}}; }
  [[gnu::always_inline]] friend unsigned above(L p, L q) {
    const EightBits greater = p.v > q.v;
    return static_cast<unsigned>(__builtin_ia32_movmskps256((Eight)greater));
  }
};

}  // namespace
}  // namespace simd

#define TRICOVER_USE(function) function = &simd::function<simd::Avx2Lanes>;
void useAvx2() { TRICOVER_SIMD_FUNCTIONS(TRICOVER_USE) }

}  // namespace tricover::detail

#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#endif
