// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/world_frame.h"

namespace tricover::detail {

/// A point of a part of the overlap, given `deepest`, one on its boundary: `wanted`, if no edge is between the two. Or
/// else the middle of what the part has of the line from `deepest` along the unit vector `up`; or else `deepest`. All
/// in the WorldFrame.
Vec2 pointOfPart(const PosedPair& pair, const WorldFrame& frame, const Vec2& deepest, const Vec2& up,
                 const Vec2& wanted);

}  // namespace tricover::detail
