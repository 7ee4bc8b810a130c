// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "tricover/polygon.h"

namespace tricover {

/// A point common to two regions.
struct Contact {
  /// World frame, rounded: where the two edges meet, or, in a containment, a vertex of the contained ring.
  Vec2 point;
  /// The edges that meet there (numbered as in Polygon::edgeStart); in a containment, the edge that starts at the
  /// contained vertex, and -1 for the polygon whose inside holds it.
  std::ptrdiff_t edge_a, edge_b;
};

/// One contact if the regions collide, none otherwise: engaged exactly when collide() is true.
std::optional<Contact> contact(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

}  // namespace tricover
