// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/narrowphase/collision_object.h>

#include <optional>

#include "tricover/polygon.h"

namespace tricover_fcl {

/// A posed polygon and all that is within `margin` of it. A polygon that is there already is not copied: threads that
/// count a polygon's copies wait for each other.
struct Region {
  Region(const tricover::Polygon* known_, const tricover::Pose& pose_, double margin_)
      : known(known_), pose(pose_), margin(margin_) {}

  const tricover::Polygon* known;
  std::optional<tricover::Polygon> made;  ///< in place of `known`
  tricover::Pose pose;
  double margin;

  const tricover::Polygon& polygon() const { return made ? *made : *known; }
};

/// Where an object is: seen along z, and between which heights. It holds all that a query may find of it.
struct Footprint {
  std::optional<Region> region;  ///< none: nobody knows where, or everywhere
  double z_low, z_high;

  bool sharesHeights(double other_low, double other_high) const { return z_low <= other_high && other_low <= z_high; }
};

/// A polygon in the plane is its own region. Of anything else it is the object's box: for one that moves, `last` is the
/// box's polygon so far (or null), which is used again if it fits, so that certificates about it last.
template <typename S>
Footprint footprintOf(const fcl::CollisionObject<S>& object, const tricover::Polygon* last);

}  // namespace tricover_fcl
