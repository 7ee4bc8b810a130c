// SPDX-License-Identifier: BSD-3-Clause
#include <new>

#include "polygon/cache_contents.h"

namespace tricover {

PairCache::PairCache() { new (bytes_) detail::PairCacheContents; }

}  // namespace tricover
