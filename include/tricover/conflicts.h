// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tricover/export.h"
#include "tricover/time_of_impact.h"

namespace tricover {

/// A span of time in which two moving polygons meet.
struct Conflict {
  Impact impact;  ///< Its begin, as timeOfImpact() says it.
  /// At most ImpactOptions::time_error later than the last contact, and never earlier; 1 if that is where they meet
  /// last.
  double end;
};

/// All spans of time in which two moving polygons meet, from time 0 to 1: timeOfImpact(), and again after each end.
/// With a margin, in which they are no farther apart than that; with `ignore_initial`, but for a span that begins at 0.
///
/// - Whenever they meet, a span says so: they are apart, as collide() says of both poses, at each end below 1, and from
///   there as timeOfImpact() says, with what that says about coming within 1e-13 L.
/// - Whenever a span says so, they meet, or did or will by less than `time_error`: what parts them for less than that
///   may not be seen.
///
/// Spans are in order and don't overlap. A span costs some ten collide()s, but two for each `time_error` for as long as
/// polygons touch, or are within the margin, hardly deeper than they move meanwhile.
///
/// Throws as timeOfImpact() does. A `time_error` below 1e-9 is taken for that.
///
/// \snippet time_of_impact.cpp conflicts
TRICOVER_EXPORT std::vector<Conflict> conflicts(const Polygon& a, const Motion& motion_a, const Polygon& b,
                                                const Motion& motion_b, const ImpactOptions& options = {});

}  // namespace tricover
