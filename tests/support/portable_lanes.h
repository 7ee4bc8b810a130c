// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hierarchy/simd.h"

namespace tricover::support {

/// While one lives, the eight-wide code is what machines without AVX2 run.
struct PortableLanes {
  PortableLanes() { detail::usePortableLanes(true); }
  ~PortableLanes() { detail::usePortableLanes(false); }
};

template <typename Answer>
auto onPortableLanes(const Answer& answer) {
  const PortableLanes portable;
  return answer();
}

}  // namespace tricover::support
