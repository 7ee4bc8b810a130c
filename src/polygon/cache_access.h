// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tricover::detail {

/// Caches are opaque to their users; the kernel reads and renews the facts in them.
struct CacheAccess {
  template <typename Cache>
  static auto& factsIn(Cache& cache) {
    return cache.facts_;
  }
};

template <typename Cache>
auto& factsIn(Cache& cache) {
  return CacheAccess::factsIn(cache);
}

}  // namespace tricover::detail
