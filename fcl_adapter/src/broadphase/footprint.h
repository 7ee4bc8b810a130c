// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>

#include <optional>

#include "shape/region.h"

namespace tricover_fcl {

/// Where an object is: seen along z, and between which heights. It holds all that a query may find of it.
struct Footprint {
  std::optional<Shadow> region;  ///< none: nobody knows where, or everywhere
  double z_low, z_high;

  bool sharesHeights(double other_low, double other_high) const { return z_low <= other_high && other_low <= z_high; }
};

/// A polygon in the plane is its own region. Of anything else it is the object's box: for one that moves, `last` is the
/// box's polygon so far (or null), which is used again if it fits, so that certificates about it last.
template <typename S>
Footprint footprintOf(const fcl::CollisionObject<S>& object, const tricover::Polygon* last);

}  // namespace tricover_fcl
