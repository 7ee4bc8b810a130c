// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// Builds all that queries may derive from a polygon, for all its copies and threads: O(n log n) for who has a deadline
/// to meet later.
///
/// Without it, what is derived is built in stages, each by a query that comes when the queries before it have paid,
/// without the stage, about what it costs: a polygon that is asked once builds nothing. Which stages are there never
/// changes an answer.
///
/// \snippet prepare.cpp prepare
TRICOVER_EXPORT void prepare(const Polygon& polygon);

}  // namespace tricover
