// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "polygon/derived.h"
#include "tricover/polygon.h"

namespace tricover::support {

/// While one lives, queries derive nothing beyond this stage, and everything up to it at once. Otherwise tests derive
/// all (all_stages.cpp). Where the kernel is hidden, tests derive what has been paid for, as users do.
struct UpTo {
#ifdef TRICOVER_KERNEL_IS_HIDDEN
  explicit UpTo(detail::Stages) {}
#else
  explicit UpTo(detail::Stages stages) { detail::useStages(stages); }
  ~UpTo() { detail::useStages(detail::Stages::All); }
#endif
};

/// The same from which nothing has been derived yet.
inline Polygon afresh(const Polygon& polygon) {
  const Polygon bounded(polygon.rings(), polygon.fillRule());
  return polygon.isComplement() ? bounded.complement() : bounded;
}

}  // namespace tricover::support
