// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

#include "polygon/cache_contents.h"

namespace tricover::detail {

/// Caches are opaque to their users: bytes that hold a struct of the kernel's, or what a vector keeps.
struct CacheAccess {
  static PairCacheContents& contentsOf(PairCache& cache) { return in<PairCacheContents>(cache.bytes_); }
  static const PairCacheContents& contentsOf(const PairCache& cache) {
    return contentsOf(const_cast<PairCache&>(cache));
  }
  template <typename Cache>
  static auto& contentsOf(Cache& cache) {
    return cache.masks_;
  }

 private:
  template <typename Contents, std::size_t kBytes>
  static Contents& in(unsigned char (&bytes)[kBytes]) {
    static_assert(sizeof(Contents) <= kBytes && alignof(Contents) <= 8);
    static_assert(std::is_trivially_copyable_v<Contents>, "a cache is copied as bytes");
    return *std::launder(reinterpret_cast<Contents*>(bytes));
  }
};

template <typename Cache>
auto& contentsOf(Cache& cache) {
  return CacheAccess::contentsOf(cache);
}

}  // namespace tricover::detail
