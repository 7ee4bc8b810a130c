// SPDX-License-Identifier: BSD-3-Clause
#include "polygon/cache_access.h"

namespace tricover {

PairCache::PairCache() { detail::CacheAccess::begin(*this); }
PointCache::PointCache() { detail::CacheAccess::begin(*this); }

}  // namespace tricover
