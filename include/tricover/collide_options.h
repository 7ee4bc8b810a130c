// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/touching.h"

namespace tricover {

/// The options of collide(). By default regions collide if they share a point.
struct CollideOptions {
  /// A world length, finite. Regions collide if their distance is at most the margin. Exact, equality included.
  ///
  /// A negative margin allows an overlap. Regions collide with a margin of -e if they are at least e deep in each
  /// other, by depth(): some point of one is at least e away from all that is outside of the other. With
  /// Touching::Allowed it must be more than e away. The answer is as precise as depth(): allow a little more than what
  /// exactly e deep is. For any margin m the answer says whether signedDistance() is at most m.
  double margin = 0;
  /// A world length, at least 0. A tolerance makes queries faster: the answer is true up to a distance of margin, false
  /// above margin + tolerance, and either one in between.
  double tolerance = 0;
  /// If Allowed, regions collide if their interiors meet or, with a margin, if their distance is below the margin.
  /// Exact, too. With a tolerance the answer for regions that touch may be either.
  Touching touching = Touching::Collides;
};

}  // namespace tricover
