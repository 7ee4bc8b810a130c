// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tricover_fcl {

/// Makes fcl::collide, fcl::distance and fcl::continuousCollide answer for PolygonShape: geometries and
/// CollisionObjects, float and double, both GJK solver types, both orders, and so every broadphase manager. Call it
/// once before the first query, from any thread; more calls cost nothing. It asks FCL's public entry points about known
/// polygons and throws std::logic_error, which says how to link, if they don't reach tricover. (tricover_fcl::collide,
/// distance and continuousCollide work regardless.)
///
/// What isn't there yet throws std::logic_error naming both types: a polygon against any other geometry. So does
/// fcl::TriangleP, which shares the node type, where FCL would print and answer "free".
void registerNarrowphase();

}  // namespace tricover_fcl
