// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"

namespace tricover {

/// Whether regions that only touch collide.
///
/// With Allowed regions collide if a point of either one is in the interior of the other one: two parts that share an
/// edge, or a peg in a slot that it fits exactly, don't collide, and they do as soon as they overlap by anything. The
/// interior of a region is every point with a disc around it that is in the region. An edge with the region on both
/// sides is interior. A point, a segment and a ring that goes back along itself have no interior, but collide where
/// they lead through that of the other region.
///
/// With a margin, regions that are exactly the margin apart touch.
///
/// \snippet collide.cpp touching
enum class Touching {
  Collides,  ///< Yes: the regions are closed.
  Allowed    ///< No.
};

}  // namespace tricover
