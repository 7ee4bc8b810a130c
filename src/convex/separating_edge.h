// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hierarchy/placement.h"

namespace tricover::detail {

/// Whether products that err by so much neither overflow nor lose what matters to underflow; otherwise nothing is
/// known.
inline bool isKnownBy(double error) { return error > 0x1p-900 && error < 0x1p900; }

/// One polygon beside the line of the other's edge, a convex one's, in doubles, where floats can't tell.
struct BesideEdge {
  BesideEdge(const PosedPair& placement, bool of_a, std::uint32_t edge);

  bool isKnown() const { return isKnownBy(error); }

  Double2 along;         ///< the edge, in the world
  Double2 outwards;      ///< its outer normal, as long
  Double2 turned;        ///< that in the other polygon's frame
  double gap;            ///< how far all of the other polygon is beyond the line, times the edge's length
  double error;          ///< of that
  std::uint32_t lowest;  ///< the other's vertex that is least far beyond
};

/// Two polygons along any normal from a to b, likewise.
struct GapAlong {
  GapAlong(const PosedPair& placement, Double2 normal);

  double gap;    ///< how far all of b is beyond all of a, times the normal's length
  double error;  ///< of that
  std::uint32_t support_a, lowest_b;
};

}  // namespace tricover::detail
