// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/hull_faces.h"
#include "contact/world_frame.h"

namespace tricover::detail {

/// Of a part of the overlap, along a unit vector `up`, in the WorldFrame.
struct PartMiddle {
  Vec2 deepest;  ///< its lowest point
  Vec2 middle;   ///< of what its hull has of the line along `up` through the deepest point, or the middle of those
};

/// By its hull. What is less than `error` apart counts as equally deep.
PartMiddle partMiddle(const Hull& part, const Vec2& up, double error);

/// A point of a part of the overlap: its middle, if no edge is between that and the deepest point. Or else the middle
/// of what the part has of the line from `deepest` along the unit vector `up`; or else `deepest`. All in the
/// WorldFrame.
Vec2 pointOfPart(const PosedPair& pair, const WorldFrame& frame, const PartMiddle& part, const Vec2& up);

}  // namespace tricover::detail
