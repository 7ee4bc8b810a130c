// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pair/outcome.h"
#include "pair/posed_pair.h"

namespace tricover::detail {

/// Whether, no edges meeting, one region holds a ring of the other (repair 2): by one vertex of every ring. Leaves
/// clearance 0.
Outcome findContainment(const PosedPair& pair);

/// The first edge of the first ring of b that starts inside of a, and not on its boundary; kNoEdge if none
/// does. Of rings that are connected only one may be asked, which stands for them where they don't meet a's edges.
EdgePosition ringInside(const PosedPair& pair);

}  // namespace tricover::detail
