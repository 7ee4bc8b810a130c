// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "contact/boundary_point.h"
#include "contact/crossings.h"
#include "contact/exit_length.h"
#include "pair/world_frame.h"
#include "tricover/contacts.h"

namespace tricover::detail {

/// A connected component of the overlap.
struct OverlapComponent {
  std::vector<BoundaryPoint> points;   ///< crossings, and vertices inside the other region
  std::vector<std::size_t> crossings;  ///< by their indices; none in a containment
  std::vector<OutlinePiece> pieces;    ///< of its outline, where it has crossings
  std::vector<OutlinePiece> around;    ///< the edges before and after those: pieces without length
  bool inner = false;                  ///< it has an interior, but for rounding: they do more than touch
  Vec2 facing = Vec2::Zero();          ///< where they touch along edges: the sum of these, rotated to point from a to b
};

/// The components of the overlap; none exactly if the regions are apart. What is nearer than the frame's error counts
/// as connected. For points alone they have their crossings, or their vertices where there are none, and nothing else.
std::vector<OverlapComponent> findComponents(const PosedPair& pair, const WorldFrame& frame,
                                             const std::vector<EdgeCrossing>& crossings, ContactDetail detail);

}  // namespace tricover::detail
