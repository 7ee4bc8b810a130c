// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/collide_options.h"
#include "tricover/export.h"
#include "tricover/pair_cache.h"
#include "tricover/polygon.h"

namespace tricover {

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
