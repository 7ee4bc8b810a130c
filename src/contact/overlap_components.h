// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/boundary_point.h"
#include "contact/crossings.h"
#include "contact/slice.h"
#include "contact/world_frame.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// Of two edges, by its index, and those of their ends that are known to be among the part's points.
struct PartCrossing {
  std::size_t index;
  EdgeEnds ends;
};

/// A connected part of the overlap.
struct OverlapComponent {
  Slice<BoundaryPoint> points;    ///< crossings, and vertices inside the other region
  Slice<PartCrossing> crossings;  ///< none in a containment
  bool inner = false;             ///< it has an inside, but for rounding: they do more than touch
  Vec2 facing = Vec2::Zero();     ///< where they touch along edges: the sum of these, turned to point from a to b
};

/// The components, and what they have slices of.
struct Overlap {
  std::vector<OverlapComponent> components;
  std::unique_ptr<BoundaryPoint[]> points;
  std::unique_ptr<PartCrossing[]> crossings;
};

/// The components of the overlap; none exactly if the regions are apart. What is nearer than the frame's error counts
/// as connected. For points alone they have their crossings, or their vertices where there are none, and nothing else.
Overlap findComponents(const PosedPair& pair, const WorldFrame& frame, const std::vector<EdgeCrossing>& crossings,
                       ContactDetail detail);

}  // namespace tricover::detail
