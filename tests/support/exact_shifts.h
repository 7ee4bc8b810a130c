// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <vector>

#include "tricover/motion.h"
#include "tricover/polygon.h"

namespace tricover::exact {

struct TimeInterval {
  mpq_class begin, end;
};

/// When polygons that are only shifted are within the margin, from time 0 to 1, in order: two edges are so for an
/// interval whose ends are roots of linear functions, or of quadratic ones around their ends. Exact but for square
/// roots, which are right to 1e-80.
std::vector<TimeInterval> contactsOfShifts(const Polygon& a, const Motion& motion_a, const Polygon& b,
                                           const Motion& motion_b, const mpq_class& margin = 0);

}  // namespace tricover::exact
