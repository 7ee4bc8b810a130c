// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tricover/export.h"
#include "tricover/polygon.h"

namespace tricover {

/// The deepest point of two overlapping regions, in the world. A point is as deep in a region as it is far from the
/// closure of what is outside of that region, which is the region of Polygon::complement(). Slits don't count.
struct Depth {
  double depth;  ///< A world length: 0 for regions that only touch or are apart, infinity for two complements.
  /// A unit vector along which moving b makes the depth smaller at first: from point_b to point_a.
  Vec2 normal;
  /// A point of a, `depth` away from point_b. One of the two is the deepest point, the other one is nearest to it
  /// outside of the other region, on that region's boundary. Both are 0 if the depth is 0 or infinite.
  Vec2 point_a;
  Vec2 point_b;  ///< A point of b; see point_a.
  /// The edge of a that point_a lies on; -1 for a deepest point in the interior, as in the middle of a hole that the
  /// other region fills, and if the depth is 0 or infinite.
  EdgeIndex edge_a;
  EdgeIndex edge_b;    ///< The edge of b that point_b lies on, or -1 likewise.
  bool is_point_of_a;  ///< Whether point_a is the deepest point, inside of b. Otherwise point_b is, inside of a.
  /// No point is deeper than this. It is above `depth` by more than the precision only if a budget ended.
  double upper_bound;
};

/// Returns the largest depth of a point of either region in the other one.
///
/// Depth and penetration() answer two questions: how deep do the regions reach into each other, and how far must b move
/// to be free? A crate that is 1 cm into both walls of a room's corner is 1.41 cm deep, however far away the door is.
/// Two crossing bars of width w are w / 2 deep. A thin wall through a robot is as deep as the robot, because the larger
/// of both depths counts. A complement is a region like any other: a car that leaves its lot is as deep in the lot's
/// complement as its farthest point is outside.
///
/// \image html depth.svg "0.2 into both walls of a corner: 0.28 deep; bars 1 wide: 0.5; a wall in a robot 2 wide: 1"
///
/// The depth is precise to 1e-14 of the coordinates, and changes by no more than the polygons move. It is 0 exactly
/// where collide() with Touching::Allowed is false. Swapping the operands turns the normal round and swaps the points.
///
/// A query searches the arcs of each outline inside the other region, best first. Cost: 2 to 13 us where outlines of 8
/// to 512 vertices overlap by little; 5 to 13 us for convex polygons of 8, and 40 to 300 us for others, where they are
/// deep in each other. It ends after 2^17 steps with what is proven by then.
///
/// \throws std::invalid_argument for a pose that is not finite or not rigid within kRigidTolerance.
///
/// \snippet depth.cpp depth
TRICOVER_EXPORT Depth depth(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// The point of a part that is farthest from an area, in the world.
struct Excess {
  double distance;  ///< A world length: 0 if the area covers the part, infinity for a complement beside a bounded area.
  Vec2 point;       ///< The farthest point of the part.
  Vec2 nearest;     ///< The point of the area nearest to it. Both are 0 if the distance is 0 or infinite.
  EdgeIndex edge;   ///< The edge of the part that `point` lies on, or -1 if it is in the part's interior, or as above.
  EdgeIndex nearest_edge;  ///< The edge of the area that `nearest` lies on, or -1 as above.
  /// No point is farther. It is above `distance` by more than the precision only if a budget ended.
  double upper_bound;
};

/// Returns how far a part sticks out of an area: the largest distance of a point of the part from the area. This is the
/// directed Hausdorff distance of the two regions, with their interiors and holes.
///
/// The distance is 0 exactly where covers() is true. It is precise to 1e-14 of the coordinates. It overlooks gaps of
/// the area that are narrower than twice the distance, and posts: to respect these, ask collide() with the area's
/// complement.
///
/// \throws std::invalid_argument as depth().
///
/// \snippet depth.cpp excess
TRICOVER_EXPORT Excess excess(const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area);

/// Returns the larger of excess(a, b) and excess(b, a): the Hausdorff distance of the two regions, a world length.
///
/// \throws std::invalid_argument as depth().
///
/// \snippet depth.cpp hausdorff distance
TRICOVER_EXPORT double hausdorffDistance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

}  // namespace tricover
