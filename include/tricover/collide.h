// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"
#include "tricover/touching.h"

namespace tricover {

/// The options of collide(). By default regions collide if they share a point.
struct CollideOptions {
  /// A world length, finite. Regions collide if their distance is at most the margin. Exact, equality included.
  ///
  /// A negative margin allows an overlap. Regions collide with a margin of -e if they are at least e deep in each
  /// other, by depth(): some point of one is at least e away from all that is outside of the other. With
  /// Touching::Allowed it must be more than e away. The answer is as precise as depth(): allow a little more than what
  /// exactly e deep is. For any margin m the answer says whether signedDistance() is at most m.
  double margin = 0;
  /// A world length, at least 0. A tolerance makes queries faster: the answer is true up to a distance of margin, false
  /// above margin + tolerance, and either one in between.
  double tolerance = 0;
  /// If Allowed, regions collide if their interiors meet or, with a margin, if their distance is below the margin.
  /// Exact, too. With a tolerance the answer for regions that touch may be either.
  Touching touching = Touching::Collides;
};

/// Returns whether the two closed regions share a point or, with a margin, are no farther apart than the margin.
///
/// Exact for every finite input. The answer depends neither on the order of the arguments nor on earlier calls nor on
/// the thread. Typical cost: O(log n + log m + k), where k counts pairs of edges in reach and rings that begin near.
///
/// \throws std::invalid_argument for a pose that is not finite or not rigid within kRigidTolerance, for a margin that
/// is not finite, for a tolerance that is negative or not finite, and for a value that Touching doesn't have
///
/// \snippet collide.cpp collide
/// \snippet collide.cpp touching
/// \snippet collide.cpp allowed overlap
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             const CollideOptions& options = {});

/// Returns the same answer, and uses and renews the certificate in `cache`. O(1) while the certificate pays for the
/// motion since.
///
/// \snippet collide.cpp collide with cache
TRICOVER_EXPORT bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b,
                             PairCache& cache, const CollideOptions& options = {});

}  // namespace tricover
