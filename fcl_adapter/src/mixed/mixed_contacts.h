// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "mixed/mixed_pair.h"
#include "mixed/stadium_pair.h"
#include "shape/fcl_results.h"

namespace tricover_fcl {

/// What a mixed pair shares, from the row's first geometry to its second. `plane` maps it to the world.
struct MixedContact {
  PlanarContact contact;
  Plane plane;
};

/// Of a pair that comes within the margin: at least one and at most `most` (not 0), deepest first. A single one is of
/// the whole overlap: its depth is the shortest way that parts the two. Where they don't overlap but for rounding, it
/// is between the nearest points.
template <typename S>
std::vector<MixedContact> contactsOf(const MixedPair<S>& pair, const Shadow& shadow, double margin, std::size_t most);

/// The same of a disc or stadium, of the whole overlap.
template <typename S>
MixedContact contactOf(const StadiumPair<S>& pair);

}  // namespace tricover_fcl
