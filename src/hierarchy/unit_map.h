// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tricover::detail {

/// p -> scale r p + t, from one hierarchy's units to the other's.
struct UnitMap {
  double r00, r01, r10, r11, tx, ty, scale;
  double error;  ///< a mapped point is no farther than this from the true one
};

/// The way back. Entries of R are wrong by 9U, those of its inverse by 13U.
UnitMap inverse(const UnitMap& map);

}  // namespace tricover::detail
