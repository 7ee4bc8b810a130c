// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"

namespace tricover {

/// Where a point is. A point of an edge is Boundary even where the region lies on both of the edge's sides.
enum class Location { Outside, Boundary, Inside };

}  // namespace tricover
