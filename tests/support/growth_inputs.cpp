// SPDX-License-Identifier: BSD-3-Clause
#include "growth_inputs.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace tricover::growth {
namespace {

constexpr double kPi = 3.14159265358979323846;

Ring square(const Vec2& low, double side) {
  return {low, low + Vec2(side, 0), low + Vec2(side, side), low + Vec2(0, side)};
}

std::vector<Ring> islands(std::size_t n) {
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < n; ++i)
    rings.push_back(square(2.0 * Vec2(static_cast<double>(i % row), static_cast<double>(i / row)), 1));
  return rings;
}

Pose shiftedBy(const Vec2& by) {
  Pose pose = Pose::Identity();
  pose.translation() = by;
  return pose;
}

/// A fan of n edges through the origin, open towards `sign` along x by `opening` in all.
Ring fan(std::size_t n, double sign, double opening = 2.5) {
  Ring ring;
  const std::size_t spokes = std::max<std::size_t>(n / 2, 2);
  for (std::size_t i = 0; i < spokes; ++i) {
    const double angle = (static_cast<double>(i) / static_cast<double>(spokes - 1) - 0.5) * opening;
    ring.push_back(Vec2::Zero());
    ring.push_back(sign * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// A bar from (0, 0) to (10, 1) or, with sign -1, to (10, -1), whose side at y = 0 is cut into n edges.
Ring bar(std::size_t n, double sign) {
  Ring ring;
  for (std::size_t i = 0; i <= n; ++i) ring.push_back({10 * static_cast<double>(i) / static_cast<double>(n), 0});
  ring.push_back({10, sign});
  ring.push_back({0, sign});
  return ring;
}

Ring circle(std::size_t n, double radius) {
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(n);
    ring.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Radii between 0.5 and 1, no two alike, spread as multiples of the golden ratio are.
Ring jagged(std::size_t n, double turn) {
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = static_cast<double>(i), angle = 2 * kPi * at / static_cast<double>(n) + turn;
    const double radius = 0.5 + 0.5 * std::fmod(0.61803398874989485 * at, 1.0);
    ring.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// A band of width 1, its sides n / 2 edges each, along a spiral that grows by 4 a turn. step(radius) is the angle from
/// vertex to vertex.
template <class Step>
Ring spiral(std::size_t n, Step step) {
  const std::size_t steps = std::max<std::size_t>(n / 2, 8);
  Ring ring, outer;
  double angle = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double radius = 4 + angle * 2 / kPi;
    const Vec2 along(std::cos(angle), std::sin(angle));
    ring.push_back(radius * along);
    outer.push_back((radius + 1) * along);
    angle += step(radius);
  }
  ring.insert(ring.end(), outer.rbegin(), outer.rend());
  return ring;
}

/// Two of them.
template <class Step>
Input woundSpirals(std::size_t n, Step step) {
  Pose turned = Pose::Identity();
  turned.linear() << -1, 0, 0, -1;
  return {Polygon({spiral(n, step)}), Polygon({spiral(n, step)}), Motion::translation(turned, Vec2(0.9, 0))};
}

/// Two triangles.
void addSquare(std::vector<Ring>& rings, const Vec2& low) {
  const Ring s = square(low, 1);
  rings.push_back({s[0], s[1], s[2]});
  rings.push_back({s[0], s[2], s[3]});
}

/// n islands, each a small square, above a plate that holds them all.
Input islandsOnPlate(std::size_t n) {
  const double side = 2 * std::ceil(std::sqrt(static_cast<double>(n))) + 1;
  return {Polygon({square(Vec2(-1, -1), side)}), Polygon(islands(n)), Motion::still(Pose::Identity())};
}

/// The same islands, and themselves shifted by a quarter of an island.
Input islandsOnIslands(std::size_t n) {
  return {Polygon(islands(n)), Polygon(islands(n)), Motion::still(shiftedBy({0.25, 0.25}))};
}

/// A diagonal row of them upon itself, likewise shifted.
Input islandsInRow(std::size_t n) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < n; ++i) rings.push_back(square(2.0 * static_cast<double>(i) * Vec2(1, 1), 1));
  return {Polygon(rings), Polygon(rings), Motion::still(shiftedBy({0.25, 0.25}))};
}

/// Two outlines of n vertices that are as jagged as they are fine, half a radius off each other's middle.
Input jaggedOutlines(std::size_t n) {
  return {Polygon({jagged(n, 0)}), Polygon({jagged(n, 1)}), Motion::still(shiftedBy({0.4, 0.3}))};
}

/// Two triangles that point at each other, 1 apart, with the nearest corner of either given k times.
Input repeatedCorners(std::size_t k) {
  Ring left(k, Vec2(0, 0)), right(k, Vec2(0, 0));
  left.insert(left.end(), {Vec2(-2, 1), Vec2(-2, -1)});
  right.insert(right.end(), {Vec2(2, -1), Vec2(2, 1)});
  return {Polygon({left}), Polygon({right}), Motion::translation(shiftedBy({1, 0}), Vec2(-2, 0))};
}

/// Two rings of n equal points each, 1 apart.
Input equalPoints(std::size_t n) {
  const Polygon points({Ring(n, Vec2(0, 0))});
  return {points, Polygon({Ring(n, Vec2(0, 0))}), Motion::translation(shiftedBy({1, 0}), Vec2(-2, 0))};
}

/// Two fans of n edges through one point each, which face each other and are 1 apart: b comes to touch a.
Input fans(std::size_t n) {
  return {Polygon({fan(n, -1)}), Polygon({fan(n, 1)}), Motion::translation(shiftedBy({1, 0}), Vec2(-2, 0))};
}

/// The same fans where their two points are one.
Input touchingFans(std::size_t n) {
  return {Polygon({fan(n, -1)}), Polygon({fan(n, 1)}), Motion::still(Pose::Identity())};
}

/// Two bars whose facing sides are cut into n edges each: b slides along a by half its length, at a distance of `gap`.
Input slidingBars(std::size_t n, double gap) {
  return {Polygon({bar(n, -1)}), Polygon({bar(n, 1)}), Motion::translation(shiftedBy({-5, gap}), Vec2(5, 0))};
}

/// A regular n-gon that makes half a turn in a hole of as many edges, `gap` larger in radius.
Input discInHole(std::size_t n, double gap) {
  Motion motion = Motion::still(Pose::Identity());
  motion.angle = kPi;
  return {Polygon({circle(n, 2), circle(n, 1 + gap)}), Polygon({circle(n, std::cos(kPi / static_cast<double>(n)))}),
          motion};
}

/// Two spirals of n edges wound into each other, a gap of 1 between them; b moves by nine tenths of what it may. Edges
/// are as long as the gap is wide.
Input spirals(std::size_t n) {
  return woundSpirals(n, [](double radius) { return std::min(1 / radius, 2 * kPi / 64); });
}

/// A maze of about n cells, its walls cut into triangles, each of them a ring (FillRule::NonZero); and a robot of 31
/// rings that overlap, in one of its corridors.
Input ringsInMaze(std::size_t n) {
  // Cells and walls of a grid of squares: walls stand on even columns or rows but for openings.
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n)))) * 2 + 1;
  std::mt19937_64 random(1);
  std::vector<Ring> maze;
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) {
      const bool post = row % 2 == 0 && column % 2 == 0, cell = row % 2 == 1 && column % 2 == 1;
      const bool border = row == 0 || column == 0 || row == side - 1 || column == side - 1;
      if (post || border || (!cell && random() % 2 == 0))
        addSquare(maze, Vec2(static_cast<double>(column), static_cast<double>(row)));
    }
  constexpr int kRings = 31;
  std::vector<Ring> robot;
  for (int i = 0; i < kRings; ++i) {
    const double angle = 2 * kPi * i / kRings;
    const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
    robot.push_back({-0.3 * along, 0.4 * along - 0.1 * across, 0.4 * along + 0.1 * across});
  }
  const double middle = static_cast<double>(side / 4) * 2 + 1.5;  // of a cell
  return {Polygon(maze, FillRule::NonZero), Polygon(robot, FillRule::NonZero),
          Motion::still(shiftedBy({middle, middle}))};
}

}  // namespace

Input passingFans(std::size_t n, double gap, double angle) {
  Motion motion = Motion::translation(shiftedBy({gap - 0.7, -0.7}), Vec2(1.4, 1.4));
  motion.angle = angle;
  return {Polygon({fan(n, -1, 1.3)}), Polygon({fan(n, 1, 1.3)}), motion};
}

Input coarseSpirals(std::size_t n) {
  return woundSpirals(n, [](double) { return 2 * kPi / 64; });
}

const std::vector<Kind>& allKinds() {
  static const std::vector<Kind> kinds = {
      {"islands on a plate", islandsOnPlate},
      {"islands on islands", islandsOnIslands},
      {"islands in a row", islandsInRow},
      {"jagged outlines", jaggedOutlines},
      {"repeated corners", repeatedCorners},
      {"equal points", equalPoints},
      {"fans", fans},
      {"touching fans", touchingFans},
      {"fans passing", [](std::size_t n) { return passingFans(n, 5e-4, 0); }},
      {"fans passing, turning", [](std::size_t n) { return passingFans(n, 5e-4, 0.1); }},
      {"bars sliding at 1e-3", [](std::size_t n) { return slidingBars(n, 1e-3); }},
      {"bars sliding at 1e-8", [](std::size_t n) { return slidingBars(n, 1e-8); }},
      {"disc in a hole, 1e-4", [](std::size_t n) { return discInHole(n, 1e-4); }},
      {"spirals", spirals},
      {"coarse spirals", coarseSpirals},
      {"rings in a maze", ringsInMaze},
  };
  return kinds;
}

}  // namespace tricover::growth
