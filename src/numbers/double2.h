// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace tricover::detail {

/// Two doubles side by side (GCC's and Clang's vectors): the columns of a pose are handled as one number each, every
/// operation rounding as it would alone.
typedef double Double2 __attribute__((vector_size(16)));
typedef std::int64_t Bits2 __attribute__((vector_size(16)));

inline Double2 load2(const double* p) {
  typedef double Loose __attribute__((vector_size(16), aligned(8), may_alias));
  return *reinterpret_cast<const Loose*>(p);
}
inline void store2(double* p, Double2 v) {
  typedef double Loose __attribute__((vector_size(16), aligned(8), may_alias));
  *reinterpret_cast<Loose*>(p) = v;
}
inline Double2 swapped(Double2 v) { return Double2{v[1], v[0]}; }
inline Double2 larger(Double2 v, Double2 w) { return v > w ? v : w; }
inline Double2 smaller(Double2 v, Double2 w) { return v < w ? v : w; }
inline Double2 absolute(Double2 v) { return (Double2)((Bits2)v & INT64_MAX); }
inline double dot(Double2 v, Double2 w) {
  const Double2 products = v * w;
  return products[0] + products[1];
}
inline double cross(Double2 v, Double2 w) {
  const Double2 products = v * swapped(w);
  return products[0] - products[1];
}
/// Bit per lane of a comparison.
inline unsigned bitsOf(Bits2 lanes) {
#ifdef __SSE2__
  return static_cast<unsigned>(__builtin_ia32_movmskpd((Double2)lanes));
#else
  return (lanes[0] != 0 ? 1u : 0u) | (lanes[1] != 0 ? 2u : 0u);
#endif
}

}  // namespace tricover::detail
