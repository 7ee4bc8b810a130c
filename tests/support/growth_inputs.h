// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "tricover/motion.h"
#include "tricover/polygon.h"

/// Inputs whose cost once grew faster than they do, as functions of their size.
namespace tricover::growth {

/// Two polygons: a at the identity, b at motion.start or moving.
struct Input {
  Polygon a, b;
  Motion motion;
};

/// n islands, each a small square, above a plate that holds them all.
Input islandsOnPlate(std::size_t n);
/// The same islands, and themselves shifted by a quarter of an island.
Input islandsOnIslands(std::size_t n);
/// A diagonal row of them upon itself, likewise shifted.
Input islandsInRow(std::size_t n);

/// Two outlines of n vertices that are as jagged as they are fine, half a radius off each other's middle.
Input jaggedOutlines(std::size_t n);

/// Two triangles that point at each other, 1 apart, with the nearest corner of either given k times.
Input repeatedCorners(std::size_t k);
/// Two rings of n equal points each, 1 apart.
Input equalPoints(std::size_t n);
/// Two fans of n edges through one point each, which face each other and are 1 apart: b comes to touch a.
Input fans(std::size_t n);
/// The same fans where their two points are one.
Input touchingFans(std::size_t n);

/// Fans of n edges as above: b's point comes past a's obliquely, beside it by `gap`, while b turns by `angle`. All
/// edges of one come about as near to those of the other. With a gap below 0, the two meet.
Input passingFans(std::size_t n, double gap, double angle);

/// Two bars whose facing sides are cut into n edges each: b slides along a by half its length, at a distance of `gap`.
Input slidingBars(std::size_t n, double gap);
/// A regular n-gon that makes half a turn in a hole of as many edges, `gap` larger in radius.
Input discInHole(std::size_t n, double gap);
/// Two spirals of n edges wound into each other, a gap of 1 between them; b moves by nine tenths of what it may. Edges
/// are as long as the gap is wide.
Input spirals(std::size_t n);
/// The same with 64 edges to each turn, however large: outer edges lie beside many turns.
Input coarseSpirals(std::size_t n);

/// A maze of about n cells, its walls cut into triangles, each of them a ring (FillRule::NonZero); and a robot of 31
/// rings that overlap, in one of its corridors.
Input ringsInMaze(std::size_t n);

/// Every kind above by its name, for tables.
struct Kind {
  const char* name;
  Input (*make)(std::size_t n);
};
const std::vector<Kind>& allKinds();

}  // namespace tricover::growth
