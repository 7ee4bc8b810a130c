// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair/posed_pair.h"
#include "tricover/collide.h"

namespace tricover::detail {

/// Algorithm 3 as printed, repaired; the cache's mask carries its coherence. The bounding discs may meet.
bool collideByPaper(const PosedPair& pair, PairCache* cache, const CollideOptions& options);

}  // namespace tricover::detail
