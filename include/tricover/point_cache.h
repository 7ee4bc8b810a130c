// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"

namespace tricover {

namespace detail {
struct CacheAccess;
}  // namespace detail

/// Remembers a certificate of a moving point between calls, by the rules of a PairCache. It may serve another polygon
/// from call to call.
///
/// \snippet locate.cpp locate with cache
class TRICOVER_EXPORT PointCache {
 public:
  PointCache();

 private:
  friend struct detail::CacheAccess;
  alignas(8) unsigned char bytes_[48];
};

}  // namespace tricover
