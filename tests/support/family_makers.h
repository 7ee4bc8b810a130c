// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "families.h"
#include "random.h"

/// Every family's maker, and what they share.
namespace tricover::support {

// contact_families.cpp: where an edge or a vertex of one meets one of the other
Case vertexOnEdge(Random& random);
Case vertexOnVertex(Random& random);
Case collinearOverlap(Random& random);
Case collinearFarAway(Random& random);
Case gapOfUlps(Random& random);
Case rotatedContact(Random& random);
Case mirroredContact(Random& random);
Case floatPoseContact(Random& random);
Case distortedPoseContact(Random& random);
Case farFromOrigin(Random& random);
Case largeBesideSmall(Random& random);
Case hugeBesideTiny(Random& random);
Case slivers(Random& random);
Case facingWalls(Random& random);
Case interlockingCombs(Random& random);

// region_families.cpp: where rings, holes and the fill rule decide
Case insideHole(Random& random);
Case touchingHole(Random& random);
Case containment(Random& random);
Case pinched(Random& random);
Case bowTie(Random& random);
Case repeatedAndCollinear(Random& random);
Case straightVertices(Random& random);
Case ringDirections(Random& random);
Case overlappingRingsEvenOdd(Random& random);
Case overlappingRingsNonZero(Random& random);
Case smallGrid(Random& random);
Case flatRings(Random& random);
Case anyPair(Random& random);

/// Moves b along `motion` to the two adjacent positions between which the exact answer changes, then up to `most_ulps`
/// aside. Where the ends of the motion agree, b is left at its far end.
Case atFirstContact(Random& random, Case c, const Vec2& motion, int most_ulps);

/// b becomes a wedge whose apex lies, but for rounding and a nudge, on the given edge of a, and which points away from
/// the side that is inside if the ring runs counter-clockwise.
Case wedgeOnEdge(Random& random, const Polygon& a, const Pose& pose_a, EdgeIndex edge, double length);

/// A ring with few vertices, convex or not, of a size near 1.
Ring anyRing(Random& random);

/// Exact ones (identity, translations, quarter turns) and arbitrary ones.
Pose anyPose(Random& random);

}  // namespace tricover::support
