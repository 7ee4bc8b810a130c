// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

#include "polygon/cached_facts.h"

namespace tricover::detail {

/// Caches are opaque to their users: bytes that hold a struct of the kernel's, or what a vector keeps.
struct CacheAccess {
  static PairFacts& factsIn(PairCache& cache) { return in<PairFacts>(cache.bytes_); }
  static const PairFacts& factsIn(const PairCache& cache) { return factsIn(const_cast<PairCache&>(cache)); }
  static PointFact& factsIn(PointCache& cache) { return in<PointFact>(cache.bytes_); }
  template <typename Cache>
  static auto& factsIn(Cache& cache) {
    return cache.facts_;
  }

  /// Begins the life of what is kept there.
  static void begin(PairCache& cache) { new (cache.bytes_) PairFacts; }
  static void begin(PointCache& cache) { new (cache.bytes_) PointFact; }

 private:
  template <typename Facts, std::size_t kBytes>
  static Facts& in(unsigned char (&bytes)[kBytes]) {
    static_assert(sizeof(Facts) <= kBytes && alignof(Facts) <= 8);
    static_assert(std::is_trivially_copyable_v<Facts>, "a cache is copied as bytes");
    return *std::launder(reinterpret_cast<Facts*>(bytes));
  }
};

template <typename Cache>
auto& factsIn(Cache& cache) {
  return CacheAccess::factsIn(cache);
}

}  // namespace tricover::detail
