// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "pair/posed_pair.h"

namespace tricover::detail {

/// A line between two convex polygons.
struct ConvexApart {
  double gap;                     ///< a proven lower bound of their distance, in a's frame; positive
  std::ptrdiff_t near_a, near_b;  ///< vertices (positions in the paths) about as near to the line as any
};

/// Looks for one across the edges at the given vertices, -1 for any, and from vertex to vertex on. Nothing where there
/// is none there, or `enough` is far from what it finds, or rounding leaves it in doubt. Both hierarchies must say
/// that the polygons are convex.
std::optional<ConvexApart> findConvexApart(const PosedPair& pair, std::ptrdiff_t near_a, std::ptrdiff_t near_b,
                                           double enough);

}  // namespace tricover::detail
