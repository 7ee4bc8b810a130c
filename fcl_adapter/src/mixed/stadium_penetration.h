// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "mixed/stadium_pair.h"
#include "tricover/polygon.h"

namespace tricover_fcl {

/// The shortest way that parts a polygon from a disc or stadium that it meets, in the plane of the pair's poses.
struct StadiumPenetration {
  tricover::Vec2 normal;   ///< a unit vector, from the polygon towards where the stadium leaves it
  double depth;            ///< not positive where only margins meet
  tricover::Vec2 point_a;  ///< where the polygon's outline parts last, at the stadium's place now
  std::ptrdiff_t edge_a;

  /// The same of the stadium's outline.
  tricover::Vec2 point_b() const { return point_a - depth * normal; }
};

/// Right to 1e-9 of the radius. Nothing where the way isn't that by the polygon's nearest point, as in notches too
/// narrow for the stadium: there it has to be searched for.
template <typename S>
std::optional<StadiumPenetration> penetrationOf(const StadiumPair<S>& pair);

}  // namespace tricover_fcl
