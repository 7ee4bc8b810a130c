// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"

namespace tricover {

/// The options of covers() and Scene::covers().
struct CoverOptions {
  /// A world length, finite. Inflates the part: all points within the margin of the part must lie in the area, too.
  /// A boundary of the area exactly that far from the part is far enough.
  ///
  /// With a negative margin of -e the part may stick out of the area by e: no point of the part is farther than e from
  /// the area, by excess() and as precisely. Gaps and posts thinner than 2 e are overlooked: to respect these, ask
  /// collide() with the area's complement.
  double margin = 0;
};

/// Returns whether a posed area holds all of a posed part: a vehicle in a lane, a part in a sheet. The part may touch
/// the area's boundary. Exact.
///
/// Regions are closed. A part without an interior (a point, a segment, an edge that goes back the way it came) is
/// covered where the area has its inside on one side at least, or an edge. An area without an interior covers only what
/// lies along its edges, and nothing with a margin.
///
/// The time is O((n + k) log n) for n edges near the part and k pairs of them that meet.
///
/// \throws std::invalid_argument if a pose is not rigid, as collide() does, or the margin is not finite.
///
/// \snippet covers.cpp covers
TRICOVER_EXPORT bool covers(const Polygon& area, const Pose& pose_area, const Polygon& part, const Pose& pose_part,
                            const CoverOptions& options = {});

}  // namespace tricover
