// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <vector>

#include "tricover/polygon.h"

/// The paper's workloads (Figures 10 and 11, Table 2), near misses, random poses, and the reader of real outlines: what
/// is timed and drawn is what workloads_test verifies.
namespace tricover::workloads {

/// Figure 11. All are about 100 units long, and all but the first are oblong.
enum class Kind {
  Convex,     ///< round
  Slim,       ///< convex, 100 x 15
  Starred,    ///< spikes: long and short radii in turn
  Contour,    ///< a random contour map's line: smooth radii of many frequencies
  Irregular,  ///< a closed walk through random points that never crosses itself
  WithHole,   ///< a contour around a starred hole, half of the vertices each
};

const std::vector<Kind>& allKinds();
std::string name(Kind kind);

/// Coordinates are multiples of kGrid below 128 in size, so that the orientation of any three vertices is exact in
/// plain doubles (differences below 2^25 grid steps, products below 2^50).
constexpr double kGrid = 1.0 / (1 << 17);

/// A simple polygon (its rings cross neither themselves nor each other) with exactly that many vertices; the outer ring
/// is counter-clockwise, the hole clockwise. Equal arguments give equal polygons wherever <cmath> agrees.
/// Throws std::invalid_argument for fewer than 8 or more than 1024 vertices, or an odd number of them.
Polygon makePolygon(Kind kind, std::size_t vertices, std::uint64_t seed);

/// The union of that many rings which overlap each other, of so many corners each: triangles are a soup. Each is
/// counter-clockwise, `squeeze` times as wide as long in a direction of its own, and on the grid; together they are
/// about 100 units long, and oblong. Equal arguments give equal polygons wherever <cmath> agrees.
/// Throws std::invalid_argument for fewer than 2 rings or 3 corners, or a squeeze that isn't in [0.05, 1].
Polygon makeOverlapping(std::size_t rings, std::size_t corners, double squeeze, std::uint64_t seed);

/// Table 2: "the smallest gap is 9 units", 90,000 and 9,000 positions.
constexpr double kGap = 9;
constexpr std::size_t kCircularPositions = 90000;
constexpr std::size_t kLinearPositions = 9000;

/// Poses of `moving` while `fixed` stays at the identity. The moving polygon is carried around the fixed one's
/// coveringOrigin() and turns with the orbit, like a body fixed to an arm, with the side towards the pivot (of 360)
/// that brings it nearest. The smallest gap of the whole turn, which is also the first one, is `gap`: fixed's farthest
/// vertex sweeps a circle that the arm keeps that far away. Bounding discs meet all the way unless the polygons are
/// round.
std::vector<Pose> circularTrajectory(const Polygon& fixed, const Polygon& moving, double gap = kGap,
                                     std::size_t positions = kCircularPositions);

/// Poses of `moving` on a straight line towards the fixed one's coveringOrigin(): from a distance of `gap` to first
/// contact in the first nine tenths, then on at the same speed.
std::vector<Pose> linearTrajectory(const Polygon& fixed, const Polygon& moving, double gap = kGap,
                                   std::size_t positions = kLinearPositions);

/// A pose of each random workload below is independent of the one before: no coherence. `fixed` stays at the identity,
/// the direction from its coveringOrigin() to that of `moving` and the turn of `moving` are any. Equal seeds give equal
/// poses.
constexpr std::size_t kRandomPositions = 1000;

/// The moving polygon comes along the direction from outside and stops at 0.98 .. 1.02 times the distance between the
/// origins at first contact: about half of the poses collide, none by much.
std::vector<Pose> contactPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed,
                               std::size_t positions = kRandomPositions);

/// Origins 1.3 .. 2 radii apart, where a radius is the mean of both radius(): bounding discs meet, regions often don't.
std::vector<Pose> nearPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed,
                            std::size_t positions = kRandomPositions);

/// Origins at most one such radius apart, uniformly in that disc.
std::vector<Pose> overlapPoses(const Polygon& fixed, const Polygon& moving, std::uint64_t seed,
                               std::size_t positions = kRandomPositions);

struct NamedPolygon {
  std::string name;
  Polygon polygon;
};

/// Reads `polygon <name> <rings>`, then for each ring `ring <n>` and n lines `x y`. Throws std::runtime_error naming
/// the polygon where the text departs from that.
std::vector<NamedPolygon> readPolygons(std::istream& in);

}  // namespace tricover::workloads
