// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// Builds all acceleration structures of a polygon, for all its copies and threads, in O(n log n): for programs that
/// have a deadline to meet later.
///
/// Without prepare(), a polygon builds its acceleration structures step by step, once enough queries have made them
/// worth their cost.
/// A polygon that is queried once builds none. They never change an answer.
///
/// \snippet prepare.cpp prepare
TRICOVER_EXPORT void prepare(const Polygon& polygon);

}  // namespace tricover
