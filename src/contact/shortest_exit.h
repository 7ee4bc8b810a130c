// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "contact/exit_length.h"

namespace tricover::detail {

/// A translation of b out of a in one component of the overlap.
struct OutlineExit {
  Vec2 normal = Vec2::UnitX();
  double length = std::numeric_limits<double>::infinity();
  ExitLength::Result found;
  bool is_across = false;  ///< it leads across an edge
  bool of_a = true;        ///< ... of a, rather than of b
  /// The component is much thinner somewhere, or a region's end isn't known: more edges may tell of a shorter one.
  bool is_doubtful = false;
};

/// The shortest one that is found from the normals of the edges and their sum, and where two edges are passed at once.
/// Among those that are equally long but for rounding, the one that leads b's centre away from a's.
OutlineExit shortestExit(const std::vector<OutlinePiece>& pieces, const ExitLength::Disc& a, const ExitLength::Disc& b,
                         double error);

}  // namespace tricover::detail
