// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tricover/polygon.h"
#include "workloads.h"

/// Poses around first contact, whose answer and gap are known from exact arithmetic.
namespace tricover::bench {

/// A pose of the moving polygon.
struct KnownPose {
  Pose pose;
  bool collides;  ///< exact::collide on these very doubles
  /// Apart: the exact distance, rounded down. Touching: 0. Else minus the way back along the direction of approach to
  /// first contact.
  double gap;
  std::size_t offset;  ///< index into offsetNames()
};

/// A scene whose answers are known.
struct KnownScene {
  std::string group, name;
  Polygon fixed;
  Pose fixed_pose;
  Polygon moving;
  double size;  ///< the larger bounding disc's diameter: what offsets and tolerances are parts of
  std::vector<KnownPose> poses;
};

/// Offsets along the direction of approach, from -1e-1 of the size through -1 ulp, 0 and +1 ulp to +1e-1. An ulp is a
/// step from the last double of one coordinate that collides to the first one that doesn't.
const std::vector<std::string>& offsetNames();

/// Poses by `contacts` random turns and directions of approach: first contact by bisection on exact::collide, then
/// every offset but 0. `decades` thins them out: the offsets are 1e-1, 1e-(1 + decades) and so on.
std::vector<KnownPose> placementsAroundContact(const KnownScene& scene, std::size_t contacts, std::size_t decades,
                                               std::uint64_t seed);

/// Exact touches at offset 0: quarter turns with the moving polygon's vertex on a vertex of the fixed one or on the
/// middle of an edge. Coordinates must be multiples of workloads::kGrid below 128, so that the poses are exact; the
/// fixed polygon is at the identity.
std::vector<KnownPose> touchingPlacements(const KnownScene& scene, std::size_t touches, std::uint64_t seed);

/// The scene of two polygons, its placements yet to be found.
KnownScene makeScene(std::string group, std::string name, Polygon fixed, Polygon moving);

/// The trade-off's scenes: the kinds with 8 vertices each and with more, and pairs of countries.
std::vector<KnownScene> tradeoffScenes(bool full);

/// A scene of two polygons of a kind, likewise without poses.
KnownScene makeScene(workloads::Kind kind, std::size_t vertices);

}  // namespace tricover::bench
