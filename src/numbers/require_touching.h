// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/errors.h"
#include "tricover/touching.h"

namespace tricover::detail {

inline void requireTouching(Touching touching) {
  if (touching != Touching::Collides && touching != Touching::Allowed)
    refuse("touching", "it must be Touching::Collides or Touching::Allowed");
}

}  // namespace tricover::detail
