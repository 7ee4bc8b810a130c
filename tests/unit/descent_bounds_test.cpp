// SPDX-License-Identifier: BSD-3-Clause
// The bounds of the descents where they are tightest: pairs that touch, seen in floats of few digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact_reference.h"
#include "random.h"
#include "shapes.h"
#include "strategy.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "wide.h"

namespace tricover::support {
namespace {

using detail::InnerDiscs;
using detail::kLanes;
using detail::Outcome;
using detail::PosedPair;
using detail::Wanted;

Outcome descend(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b, double lookahead) {
  return collideByHierarchy({a.data(), pose_a, b.data(), pose_b}, {}, lookahead, Wanted::Clearance);
}

/// b's lowest vertex, once turned, `depth` below the height 0 of the frame `ground`, at x.
Pose standing(const Ring& b, const Pose& ground, double angle, double x, double depth) {
  Pose result = pose(angle, 0, 0);
  Vec2 lowest = result * b[0];
  for (const Vec2& p : b) lowest = (result * p).y() < lowest.y() ? Vec2(result * p) : lowest;
  result.translation() = Vec2(x, -depth) - lowest;
  return ground * result;
}

/// A vertex a hair into an edge that is up to a million times as long as its polygon: x is known to few digits there.
TEST(Touching, AShortPolygonOnALongEdge) {
  Random random(31);
  int hits = 0;
  const int cases = scaledCount(3000);
  for (int i = 0; i < cases; ++i) {
    const double length = std::pow(10, random.real(0, i % 4 == 0 ? 6 : 2.6));
    const Polygon a({rectangle(-length, -20, length, 0)});
    const Ring ring = star(random, random.integer(9, 40), 0.6, 1);
    const Pose ground = pose(random.real(0, 6.28), 0, 0);
    const double x = random.real(-0.95, 0.95) * length, depth = std::pow(10, random.real(-12, -7)) * (1 + length);
    const Pose pose_b = standing(ring, ground, random.real(0, 6.28), x, std::min(depth, 1e-6));
    const Polygon b({ring});
    const bool truth = exact::collide(a, ground, b, pose_b);
    ASSERT_EQ(descend(a, ground, b, pose_b, 0).collides, truth);
    ASSERT_EQ(descend(b, pose_b, a, ground, 0).collides, truth);
    hits += truth;
  }
  EXPECT_GT(hits, cases / 2);
}

/// A small rectangle between walls parallel to its sides, so that their gap is their distance.
TEST(Clearance, IsNoMoreThanTheDistanceToAParallelWall) {
  Random random(32);
  const int cases = scaledCount(1000);
  int tight = 0;
  for (int i = 0; i < cases; ++i) {
    const double length = std::pow(10, random.real(0.5, 2.8)), gap = random.real(0.01, 2);
    const Polygon a({rectangle(-length - 5, -length - 5, length + 5, length + 5), rectangle(-length, -length, length, length)});
    const Polygon b({rectangle(-1, -0.5, 1, 0.5)});
    const Pose frame = pose(random.real(0, 6.28), 0, 0);
    const Pose pose_b = frame * pose(0, random.real(-0.6, 0.6) * length, 0.5 + gap - length);
    const double lookahead = i % 3 == 0 ? 0 : random.real(0, 2 * length);
    for (const bool swapped : {false, true}) {
      const Outcome outcome = swapped ? descend(b, pose_b, a, frame, lookahead) : descend(a, frame, b, pose_b, lookahead);
      ASSERT_FALSE(outcome.collides);
      const mpq_class clearance(outcome.clearance * (1 - 1e-12));  // poses aren't quite rigid
      ASSERT_TRUE(clearance * clearance <= exact::distanceSquared(a, frame, b, pose_b)) << outcome.clearance - gap;
      tight += outcome.clearance > 0.9 * gap;
    }
  }
  EXPECT_GT(tight, cases / 2);
}

/// Half planes decide only what they can tell in floats.
TEST(Touching, ConvexPolygonsFaceToFace) {
  Random random(33);
  int hits = 0;
  const int cases = scaledCount(4000);
  for (int i = 0; i < cases; ++i) {
    const Ring ring = regular(random.integer(3, 16), 1);
    const Polygon a({rectangle(-1, -0.2, 1, 0)}), b({ring});
    const Pose ground = i % 2 == 0 ? pose(random.real(0, 6.28), 0, 0) : pose(random.real(0, 6.28), 3e11, -2e11);
    const double depth = (random.coin() ? 1e-3 : -1e-3) * std::pow(10, random.real(-7, 0)), half = 0.5 * M_PI;
    const double angle = random.coin() ? half : random.real(0, 6.28);
    const Pose pose_b = standing(ring, ground, angle, random.real(-0.9, 0.9), depth);
    const bool truth = exact::collide(a, ground, b, pose_b);
    ASSERT_EQ(collide(a, ground, b, pose_b), truth) << depth;
    hits += truth;
  }
  EXPECT_GT(hits, cases / 4);
  EXPECT_LT(hits, 3 * cases / 4);
}

/// Discs that overlap by little or not at all: a depth that is claimed is there.
TEST(InnerDepth, IsNoMoreThanTheDiscsOverlap) {
  Random random(34);
  int claimed = 0;
  const int cases = scaledCount(20000);
  for (int i = 0; i < cases; ++i) {
    InnerDiscs a{}, b{};
    for (InnerDiscs* discs : {&a, &b}) {
      discs->count = random.integer(1, kLanes);
      discs->reach = 2;
      for (int k = 0; k < kLanes; ++k) {
        discs->x[k] = static_cast<float>(random.real(-0.1, 0.1));
        discs->y[k] = static_cast<float>(random.real(-0.1, 0.1));
        const double most = k == 0 ? 0.6 : discs->radius[0];  // the first is the largest
        discs->radius[k] = k < discs->count ? static_cast<float>(random.real(0.3, 1) * most) : -1e15f;
      }
    }
    const double angle = random.real(0, 6.28), c = std::cos(angle), s = std::sin(angle);
    const double towards = random.real(0, 6.28), error = i % 2 == 0 ? 0 : 1e-4;
    // Far enough away that the two that come nearest overlap by `depth`.
    const double depth = random.coin() ? random.real(-1e-6, 1e-6) : random.real(-1e-3, 3e-3);
    const auto overlap = [&](double tx, double ty) {
      double most = -1;
      for (int j = 0; j < a.count; ++j)
        for (int k = 0; k < b.count; ++k) {
          const double x = c * b.x[k] - s * b.y[k] + tx - a.x[j], y = s * b.x[k] + c * b.y[k] + ty - a.y[j];
          most = std::max(most, static_cast<double>(a.radius[j]) + b.radius[k] - std::hypot(x, y));
        }
      return most;
    };
    double low = 0, high = 2;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (low + high);
      (overlap(middle * std::cos(towards), middle * std::sin(towards)) > depth ? low : high) = middle;
    }
    const double tx = high * std::cos(towards), ty = high * std::sin(towards);
    const double claim = innerDepth(a, b, {c, -s, s, c, tx, ty, 1, error}, 0x1p-19);
    if (claim <= 0) continue;
    ++claimed;
    // The map may be wrong by `error`: b may be that much farther away.
    ASSERT_LE(claim, overlap(tx + error * std::cos(towards), ty + error * std::sin(towards)) + 1e-12);
  }
  EXPECT_GT(claimed, cases / 20);
}

/// Sixteen edges, the upper eight along the x axis from 10 to 0 but for a spike at 1: a box that is `height` thick, and empty at
/// its far end.
Ring spiked(double height) {
  return {{0, 0},  {1, -1}, {3, -1}, {4, -1}, {5, -1}, {6, -1},      {8, -1},   {9, -1},
          {10, 0}, {8, 0},  {6, 0},  {4, 0},  {1.1, 0}, {1, height}, {0.9, 0}, {0.1, 0}};
}

/// Two of these against each other, their boxes overlapping at the empty ends: the chains are both boxes' thickness
/// apart.
TEST(Tolerance, IsLessThanWhatTwoBoxesMayHide) {
  const Polygon a({spiked(0.5)}), b({spiked(0.5)});
  const auto apart = [&](double dx, double dy, double margin, double tolerance) {
    Pose pose_b = pose(0, 20 + dx, 1 + dy);
    pose_b.linear() << -1, 0, 0, -1;
    return collide(a, Pose::Identity(), b, pose_b, CollideOptions{margin, tolerance});
  };
  EXPECT_FALSE(apart(-0.01, -0.01, 0, 0.9)) << "overlapping boxes, chains 0.99 apart";
  EXPECT_FALSE(apart(0, 0.5, 0.6, 0.8)) << "boxes half apart, chains 1.5";
  EXPECT_FALSE(apart(0.5, -1 + 0.5, 0.6, 0)) << "a corner from a corner, 0.71 apart";
  EXPECT_TRUE(apart(0.5, -1 + 0.5, 0.71, 0));
}

/// Many small rings in either polygon, so that boxes hold several: what is between them is nobody's.
TEST(Tolerance, LeavesTheSpaceBetweenRingsFree) {
  std::vector<Ring> dots, grid;
  for (int i = 0; i < 12; ++i) dots.push_back(rectangle(10 * i, 0, 10 * i + 0.01, 0.01));
  for (int i = 0; i < 12; ++i) grid.push_back(rectangle(10 * i + 4, 0, 10 * i + 4.01, 0.01));
  const Polygon a(dots), b(grid), one({rectangle(4, 0, 4.01, 0.01)});
  const CollideOptions options{0, 0.1};
  EXPECT_FALSE(collide(a, Pose::Identity(), b, Pose::Identity(), options));
  EXPECT_FALSE(collide(b, Pose::Identity(), a, Pose::Identity(), options));
  EXPECT_FALSE(collide(a, Pose::Identity(), one, Pose::Identity(), options));
  EXPECT_FALSE(collide(a, Pose::Identity(), one, pose(0, 50, 0), options));
  EXPECT_TRUE(collide(a, Pose::Identity(), one, pose(0, 6, 0), options));
}

/// A million million away, positions are known to a ten-thousandth: a ring that is contained by less than that.
TEST(Containment, IsFoundWhereRoundingPutsTheRingOutside) {
  Random random(35);
  int contained = 0;
  const int cases = scaledCount(1000);
  for (int i = 0; i < cases; ++i) {
    const Polygon block({rectangle(-1, -1, 1, 1)}), disc({regular(60, 1)});
    const Ring dot = rectangle(-1e-5, -1e-5, 1e-5, 1e-5);
    const Pose frame = pose(random.real(0, 6.28), 1e12, -7e11);
    const double at = 1 - std::pow(10, random.real(-4.5, -2));
    const Pose pose_dot = frame * pose(random.real(0, 6.28), at, random.real(-0.5, 0.5));
    const Polygon alone({dot}), in_disc({dot, rectangle(-20, 30, 20, 40)});
    const bool truth = exact::collide(block, frame, alone, pose_dot);
    ASSERT_EQ(collide(block, frame, alone, pose_dot), truth);
    const Pose at_disc = frame * pose(random.real(0, 6.28), at, 0);
    ASSERT_EQ(collide(in_disc, at_disc, disc, frame), exact::collide(in_disc, at_disc, disc, frame));
    contained += truth;
  }
  EXPECT_GT(contained, cases / 4);
}

}  // namespace
}  // namespace tricover::support
