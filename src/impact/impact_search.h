// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "impact/moving_pair.h"

namespace tricover::detail {

/// Branch and bound over both hierarchies and time: slower than what knows more of its polygons, and fit for all. They
/// are apart from time 0 to `begin`.
FirstContact searchBoxes(const MovingPair& pair, double begin, double time_error);

}  // namespace tricover::detail
