// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "numbers/predicates.h"

namespace tricover::detail {

/// Whether p may be within `length` of the line through v and w: the extended influence area. Rounded outwards.
bool inExtendedArea(const Vec2& v, const Vec2& w, const ApproxPoint& p, double length);

/// The same, cut by the two axis-parallel lines at distance `length` beyond the vertices (Figure 9b).
bool inBoundedArea(const Vec2& v, const Vec2& w, const ApproxPoint& p, double length);

}  // namespace tricover::detail
