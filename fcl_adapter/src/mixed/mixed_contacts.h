// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
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

/// Of a pair that meets: at least one and at most `most` (not 0), deepest first. A single one is of the whole overlap:
/// its depth is the shortest way that parts the two. Where they don't overlap but for rounding or a margin, it is
/// between the nearest points.
template <typename S>
std::vector<MixedContact> contactsOf(const MixedPair<S>& pair, const Shadow& shadow, std::size_t most);

/// The same of a disc or stadium, of the whole overlap; nothing where its section has to be asked.
template <typename S>
std::optional<MixedContact> contactOf(const StadiumPair<S>& pair);

}  // namespace tricover_fcl
