// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <type_traits>

#include "tricover/export.h"

namespace tricover {
namespace detail {

struct CacheAccess;

}  // namespace detail

/// Remembers certificates and hints of one pair of polygons between calls of collide(), distance(), distanceWithin(),
/// contacts() and penetration(), in any order. Each stays true whatever happens in between, because it names the
/// polygons and poses that it is about. A cache may therefore be copied, used for other pairs, lost or stale: no answer
/// changes, only its cost.
///
/// A value of 184 bytes that is copied like any other. PairCache{} is empty. Two threads must not use one at once. A
/// cache means nothing in another process, nor to this program when it runs again, because Polygon::id() starts anew
/// there: don't write caches to files.
///
/// \snippet collide.cpp collide with cache
class TRICOVER_EXPORT PairCache {
 public:
  PairCache();

 private:
  friend struct detail::CacheAccess;
  alignas(8) unsigned char bytes_[184];
};

static_assert(std::is_trivially_copyable_v<PairCache> && sizeof(PairCache) <= 320);

}  // namespace tricover
