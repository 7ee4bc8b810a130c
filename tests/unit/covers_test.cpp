// SPDX-License-Identifier: BSD-3-Clause
// Containment by hand; tests/laws/covers.cpp compares with rationals.
#include "tricover/covers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();

bool covers(const Polygon& area, const Polygon& part, double margin = 0) {
  return tricover::covers(area, kHere, part, kHere, {margin});
}
bool together(const std::vector<Polygon>& areas, const Polygon& part, double margin = 0) {
  Scene scene;
  for (const Polygon& area : areas) scene.add(area, kHere);
  return scene.covers(part, kHere, {margin});
}

TEST(Covers, PlugsHolesAndItself) {
  const Polygon sheet({rectangle(0, 0, 9, 9), rectangle(3, 3, 6, 6)}), plug({rectangle(3, 3, 6, 6)});
  EXPECT_TRUE(covers(sheet, sheet));
  EXPECT_FALSE(covers(sheet, plug));
  EXPECT_TRUE(together({sheet, plug}, Polygon({rectangle(0, 0, 9, 9)})));
  EXPECT_TRUE(together({sheet, plug}, Polygon({rectangle(1, 1, 8, 8)}), 1));
  EXPECT_FALSE(together({sheet, Polygon({rectangle(3, 3, 6, 6 - 1e-15)})}, Polygon({rectangle(0, 0, 9, 9)})));
  EXPECT_FALSE(Scene().covers(Polygon::point({0, 0}), kHere));
  // The part holds a ring of the area, a hole that meets none of the part's edges.
  EXPECT_FALSE(covers(sheet, Polygon({rectangle(1, 1, 8, 8)})));
  EXPECT_TRUE(covers(sheet, Polygon({rectangle(1, 1, 8, 8), rectangle(2, 2, 7, 7)})));
  EXPECT_TRUE(covers(sheet, Polygon({rectangle(0, 0, 3, 3), rectangle(6, 3, 9, 9)})));
}

/// An inner ring that runs as the outer one does is a seam.
TEST(Covers, SeamsInsideOfThePart) {
  const std::vector<Ring> rings = {rectangle(-9, -9, 9, 9), rectangle(-1, -1, 1, 1)};
  const Polygon part({rectangle(-3, -3, 3, 3)});
  EXPECT_TRUE(covers(Polygon(rings, FillRule::NonZero), part));
  EXPECT_TRUE(covers(Polygon(rings, FillRule::NonZero), part, 6));
  EXPECT_FALSE(covers(Polygon(rings, FillRule::EvenOdd), part));
}

/// Three convex strips leave a triangle open, none of whose edges meets the part's.
TEST(Covers, HoleBetweenThreeStrips) {
  const double x = 2 * std::sqrt(3.0);
  const Polygon part({{{-x, 2}, {0, -4}, {x, 2}}});
  const auto leavesOpen = [&](double inner) {
    Scene scene;
    for (const double turn : {0.0, 2.0, 4.0}) {
      Pose pose = kHere;
      pose.linear() = Eigen::Rotation2Dd(turn * static_cast<double>(EIGEN_PI) / 3).toRotationMatrix();
      scene.add(Polygon({rectangle(-20, inner, 20, 8)}), pose);
    }
    return !scene.covers(part, kHere);
  };
  EXPECT_TRUE(leavesOpen(1));
  EXPECT_TRUE(leavesOpen(1e-3));
  EXPECT_FALSE(leavesOpen(-1e-3));
}

TEST(Covers, LargeAndSmall) {
  for (const double size : {0x1p-990, 0x1p-30, 0x1p30, 0x1p990}) {
    const Polygon area({rectangle(0, 0, 4 * size, 4 * size)}), part({rectangle(size, size, 3 * size, 3 * size)});
    EXPECT_TRUE(covers(area, part)) << size;
    EXPECT_TRUE(covers(area, area)) << size;
    EXPECT_FALSE(covers(part, area)) << size;
    EXPECT_TRUE(covers(area, part, size)) << size;
    EXPECT_FALSE(covers(area, part, size * (1 + 1e-15))) << size;
  }
  EXPECT_TRUE(covers(Polygon({rectangle(-1e9, -1e9, 1e9, 1e9)}), Polygon({rectangle(-1e-9, 0, 1e-9, 1)}), 1e8));
}

TEST(Covers, RefusesWhatItCannotTell) {
  const Polygon area({rectangle(0, 0, 4, 4)});
  Scene scene;
  for (const double margin : {-HUGE_VAL, HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(covers(area, area, margin), std::invalid_argument);
    EXPECT_THROW(together({area}, area, margin), std::invalid_argument);
  }
  Pose scaled = kHere;
  scaled.linear() *= 2;
  EXPECT_THROW(tricover::covers(area, scaled, area, kHere), std::invalid_argument);
  EXPECT_THROW(tricover::covers(area, kHere, area, scaled), std::invalid_argument);
  EXPECT_THROW(scene.covers(area, scaled), std::invalid_argument);
  BodyOptions wide;
  wide.margin = 1;
  const BodyHandle body = scene.add(area, kHere, wide);
  EXPECT_THROW(scene.covers(area, kHere), std::invalid_argument);
  EXPECT_FALSE(scene.covers(area, kHere, {}, BodyFilter::allBut(body)));
  EXPECT_FALSE(scene.covers(area, tricover::poseAt(100, 0)));
}

/// Two convex areas around the hole of what has no end.
TEST(Covers, WhatHasNoEndByNothingThatHas) {
  const Polygon outside = Polygon::box(1, 1).complement();
  const Polygon left({rectangle(-9, -9, 8, 9)}), right({rectangle(-8, -9, 9, 9)});
  EXPECT_FALSE(together({left, right}, outside));
  EXPECT_TRUE(together({left, Polygon::box(0.5, 0.5).complement()}, outside));
}

/// A border ends where edges cross: its distance is compared exactly, whatever the size.
TEST(Covers, BordersThatEndAtCrossings) {
  for (const double size : {1.0, 3.0, 0x1p-990, 0x1p990, 0x1.9p-400, 0x1.9p400}) {
    const auto bar = [&](double x, double y) { return rectangle(-x * size, -y * size, x * size, y * size); };
    const double five = 5 * size, above = std::nextafter(five, 6 * size);
    const Polygon cross({bar(3, 12), bar(12, 4)}, FillRule::NonZero);  // its corners are at (3, 4)
    EXPECT_TRUE(covers(cross, Polygon::point({0, 0}), five)) << size;
    EXPECT_FALSE(covers(cross, Polygon::point({0, 0}), above)) << size;
    EXPECT_TRUE(together({Polygon({bar(3, 12)}), Polygon({bar(12, 4)})}, Polygon::point({0, 0}), five)) << size;
    EXPECT_FALSE(together({Polygon({bar(3, 12)}), Polygon({bar(12, 4)})}, Polygon::point({0, 0}), above)) << size;
    // Beside a piece; and a piece's end beside an edge's end, and beside the edge.
    const double four = 4 * size, root = std::sqrt(20.0) * size;
    const Polygon flat({{{-size, 0}, {size, 0}, {0, size / 8}}}),
        beam = Polygon::segment({-7 * size, 0}, {7 * size, 0});
    EXPECT_TRUE(covers(cross, Polygon::point({7 * size, 0}), four)) << size;
    EXPECT_FALSE(covers(cross, Polygon::point({7 * size, 0}), std::nextafter(four, five))) << size;
    EXPECT_TRUE(covers(cross, flat, root * (1 - 1e-15))) << size;
    EXPECT_FALSE(covers(cross, flat, root * (1 + 1e-15))) << size;
    EXPECT_TRUE(covers(cross, beam, four)) << size;
    EXPECT_FALSE(covers(cross, beam, std::nextafter(four, five))) << size;
  }
  // Coordinates of all sizes at once: edges that cross are 2^1900 times as long as the distance.
  const double tiny = 0x1p-1000, huge = 0x1p900;
  const Polygon uneven({rectangle(-huge, -huge, tiny, huge), rectangle(-huge, -huge, huge, tiny)}, FillRule::NonZero);
  EXPECT_TRUE(covers(uneven, Polygon::point({-3 * tiny, -4 * tiny}), 4 * tiny));
  EXPECT_TRUE(covers(uneven, Polygon::point({-2 * tiny, -3 * tiny}), 5 * tiny));
  EXPECT_FALSE(covers(uneven, Polygon::point({-2 * tiny, -3 * tiny}), std::nextafter(5 * tiny, 1)));
}

/// A plain answer was hidden by an edge that ends at a crossing as far away as the margin.
TEST(Covers, VerticesThatAreBoundary) {
  EXPECT_FALSE(covers(Polygon({{{1, 1}, {0, -3}, {0, 2}, {1, 0}, {-1, 2}}}), Polygon::point({0, 2}), 1));
}

/// They reach farther than the power of two that is their unit.
TEST(Covers, LargestPolygons) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const Polygon all({rectangle(-kMost, -kMost, kMost, kMost)}), left({rectangle(-kMost, -kMost, 0, kMost)}),
      right({rectangle(0, -kMost, kMost, kMost)});
  EXPECT_TRUE(covers(all, left));
  EXPECT_FALSE(covers(left, all));
  EXPECT_FALSE(covers(left, right));
  const CollideOptions open{0, 0, Touching::Allowed};
  EXPECT_TRUE(collide(all, kHere, left, kHere, open));
  EXPECT_FALSE(collide(left, kHere, right, kHere, open));
}

}  // namespace
}  // namespace tricover::support
