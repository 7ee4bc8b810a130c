// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tricover/locate.h"
#include "tricover/polygon.h"
#include "tricover/pose.h"

/// The truth by brute force on exact numbers. Shares nothing with the kernel but the types: inclusion is a winding
/// number counted along a ray, not a covering, and no edge is left out for any reason but its exact bounding box.
namespace tricover::exact {

/// Where `point` (in the polygon's own frame) lies.
Location locate(const Polygon& polygon, const Vec2& point);

/// Whether the posed regions share a point; each pose is the affine map that its doubles define.
bool collide(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// Whether the posed regions' interiors share a point: by the areas between the edges over strips of x in which no two
/// edges cross.
bool interiorsMeet(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// Tells of each edge (numbered as in Polygon::edgeStart) whether it is one that can cross another: in a ring of more
/// than three vertices that without length, before a repeated vertex, is none, but for the first one of a point.
std::vector<bool> edgesOfCrossings(const Polygon& polygon);

/// Every pair of such edges that share a point, in order.
std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> meetingEdges(const Polygon& a, const Pose& pose_a,
                                                                    const Polygon& b, const Pose& pose_b);

/// The squared distance of the posed regions, 0 where they collide.
mpq_class distanceSquared(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b);

/// The squared distance from `point` to the segment v w.
mpq_class distanceSquared(const Vec2& point, const Vec2& v, const Vec2& w);

/// The first point of the posed region on the way from `from` to `to`: the fraction of the way, and of the edges there
/// the lowest one; 0 and -1 where the way starts in the region.
struct FirstHit {
  mpq_class fraction;
  std::ptrdiff_t edge;
};
std::optional<FirstHit> castRay(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to);

/// All of the way in the region, in order: each interval's begin as above, and its end as seen on the way back, but
/// with the fraction from `from` on. Between two fractions at which edges are met, a midpoint is inside or not.
struct RayPart {
  FirstHit begin, end;
};
std::vector<RayPart> castRayAll(const Polygon& polygon, const Pose& pose, const Vec2& from, const Vec2& to);

/// Whether the square root of `distance_squared` is at most `length` >= 0.
bool within(const mpq_class& distance_squared, const mpq_class& length);

/// The square root of `distance_squared`, rounded down to a double (infinity beyond the largest).
double distanceBelow(const mpq_class& distance_squared);

}  // namespace tricover::exact
