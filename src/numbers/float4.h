// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "numbers/double2.h"

namespace tricover::detail {

/// Two and four floats side by side, as Double2.
typedef float Float2 __attribute__((vector_size(8)));
typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Bits4 __attribute__((vector_size(16)));

/// A float and the one after it.
inline Float2 load2(const float* p) {
  typedef float Loose __attribute__((vector_size(8), aligned(4), may_alias));
  return *reinterpret_cast<const Loose*>(p);
}
inline Double2 widened(Float2 v) { return __builtin_convertvector(v, Double2); }
inline Float2 narrowed(Double2 v) { return __builtin_convertvector(v, Float2); }
inline Float4 joined(Float2 v, Float2 w) { return Float4{v[0], v[1], w[0], w[1]}; }

template <int i, int j, int k, int l>
inline Float4 shuffled(Float4 v) {
#ifdef __clang__
  return __builtin_shufflevector(v, v, i, j, k, l);
#else
  return __builtin_shuffle(v, Bits4{i, j, k, l});
#endif
}
inline Float4 absolute(Float4 v) { return (Float4)((Bits4)v & INT32_MAX); }
inline Float4 larger(Float4 v, Float4 w) { return v > w ? v : w; }

}  // namespace tricover::detail
