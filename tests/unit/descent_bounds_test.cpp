// SPDX-License-Identifier: BSD-3-Clause
// The bounds of the descents where they are tightest: pairs that touch, seen in floats of few digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "exact_reference.h"
#include "families.h"
#include "hierarchy/simd.h"
#include "hierarchy/unit_map.h"
#include "laws.h"
#include "pair/collide_by_hierarchy.h"
#include "pair/root_box.h"
#include "portable_lanes.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "stages.h"
#include "test_scale.h"
#include "tricover/collide.h"

namespace tricover::support {
namespace {

using detail::InnerDiscs;
using detail::kLanes;
using detail::Outcome;
using detail::PosedPair;
using detail::Wanted;

Ring turned(Ring ring, double angle) {
  for (Vec2& p : ring) p = turnedAndMoved(angle, 0, 0) * p;
  return ring;
}

/// The ring alone, or as part of the larger of two polygons: far away, there is another ring.
Polygon oneOrLarge(Random& random, const Ring& ring, double length) {
  if (random.coin()) return Polygon({ring});
  const double far = 4 * length + 100;
  return Polygon({ring, shifted(rectangle(-1, -1, 1, 1), {far, far})});
}

/// b's lowest vertex, once turned, `depth` below the height 0 of the frame `ground`, at x.
Pose standing(const Ring& b, const Pose& ground, double angle, double x, double depth) {
  Pose result = turnedAndMoved(angle, 0, 0);
  Vec2 lowest = result * b[0];
  for (const Vec2& p : b) lowest = (result * p).y() < lowest.y() ? Vec2(result * p) : lowest;
  result.translation() = Vec2(x, -depth) - lowest;
  return ground * result;
}

/// A vertex a hair into an edge that is up to a million times as long as its polygon: x is known to few digits there.
Case shortOnALongEdge(Random& random) {
  const double length = std::pow(10, random.real(0, random.oneIn(4) ? 6 : 2.6));
  const Ring ring = star(random, random.integer(9, 40), 0.6, 1);
  const Pose ground = turnedAndMoved(random.real(0, 6.28), 0, 0);
  const double x = random.real(-0.95, 0.95) * length, depth = std::pow(10, random.real(-12, -7)) * (1 + length);
  const Pose pose_b = standing(ring, ground, random.real(0, 6.28), x, std::min(depth, 1e-6));
  return {Polygon({rectangle(-length, -20, length, 0)}), ground, oneOrLarge(random, ring, length), pose_b};
}

/// Nearly parallel to it, and near its end: the edge is cut to 64 times the polygon, whose tilt is below a float's last
/// digit.
Case flatNearTheEndOfALongEdge(Random& random) {
  const double length = std::pow(10, random.real(3, 5)), own = random.real(0, 6.28);  // a level box's axis is exact
  const Ring ring = turned(rectangle(-1, 0, 1, 1), own);
  const Pose ground = turnedAndMoved(random.real(0, 6.28), 0, 0);
  const double tilt = (random.coin() ? 1 : -1) * std::pow(10, random.real(-8, -6)), x = length - random.real(2, 60);
  const double depth = random.oneIn(3) ? -random.real(0.001, 0.1) : std::pow(10, random.real(-10, -7));
  const Pose pose_b = standing(ring, ground, tilt - own, random.coin() ? x : -x, depth);
  return {Polygon({rectangle(-length, -20, length, 0)}), ground, oneOrLarge(random, ring, length), pose_b};
}

/// A small rectangle between walls parallel to its sides, so that their gap is their distance.
Case besideAParallelWall(Random& random) {
  const double length = std::pow(10, random.real(0.5, 2.8)), gap = random.real(0.01, 2), own = random.real(0, 6.28);
  const Ring ring = turned(rectangle(-1, -0.5, 1, 0.5), own);
  const Pose frame = turnedAndMoved(random.real(0, 6.28), 0, 0);
  return {Polygon({rectangle(-length - 5, -length - 5, length + 5, length + 5),
                   rectangle(-length, -length, length, length)}),
          frame, oneOrLarge(random, ring, length),
          frame * turnedAndMoved(-own, random.real(-0.6, 0.6) * length, 0.5 + gap - length)};
}

double anyDepth(Random& random) { return (random.coin() ? 1e-3 : -1e-3) * std::pow(10, random.real(-7, 0)); }

/// Half planes decide only what they can tell in floats.
Case convexFaceToFace(Random& random) {
  const Ring ring = regular(random.integer(3, 16), 1);
  const Pose ground =
      random.coin() ? turnedAndMoved(random.real(0, 6.28), 0, 0) : turnedAndMoved(random.real(0, 6.28), 3e11, -2e11);
  const double angle = random.coin() ? 0.5 * M_PI : random.real(0, 6.28);
  return {Polygon({rectangle(-1, -0.2, 1, 0)}), ground, Polygon({ring}),
          standing(ring, ground, angle, random.real(-0.9, 0.9), anyDepth(random))};
}

/// The same for the edges of the larger one, of which there are up to sixteen.
Case convexByATip(Random& random) {
  const int n = random.integer(3, 16);
  const double up = 0.5 * M_PI - (random.integer(0, n - 1) + 0.5) * 2 * M_PI / n;
  const Ring ring = regular(3, 1);
  const Pose ground = turnedAndMoved(random.real(0, 6.28), 0, 0);
  return {Polygon({shifted(turned(regular(n, 2), up), {0, -2 * std::cos(M_PI / n)})}), ground, Polygon({ring}),
          standing(ring, ground, random.real(0, 6.28), 0, anyDepth(random))};
}

template <Case (*maker)(Random&)>
Case seeded(std::uint64_t seed) {
  Random random(seed);
  return maker(random);
}

const std::vector<Family>& tightFamilies() {
  static const std::vector<Family> all = {{"short_on_a_long_edge", seeded<shortOnALongEdge>},
                                          {"flat_near_the_end_of_a_long_edge", seeded<flatNearTheEndOfALongEdge>},
                                          {"beside_a_parallel_wall", seeded<besideAParallelWall>},
                                          {"convex_face_to_face", seeded<convexFaceToFace>},
                                          {"convex_by_a_tip", seeded<convexByATip>}};
  return all;
}

PosedPair largerFirst(const Case& c) {
  if (c.a.radius() >= c.b.radius()) return {detail::dataOf(c.a), c.pose_a, detail::dataOf(c.b), c.pose_b};
  return {detail::dataOf(c.b), c.pose_b, detail::dataOf(c.a), c.pose_a};
}

class Descents : public testing::TestWithParam<Family> {};

/// The answer is exact, and the one without a reason is the one with a reason; a clearance is a lower bound of the
/// distance. On all lanes they are the same bits.
TEST_P(Descents, AreAlikeAndProveWhatTheySay) {
  const std::string name = GetParam().name;
  const bool is_wall = name == "beside_a_parallel_wall";
  const bool is_tight = std::any_of(tightFamilies().begin(), tightFamilies().end(),
                                    [&](const Family& family) { return family.name == name; });
  int hits = 0, clear = 0, tight = 0;
  const int cases = scaledCount(is_tight ? 2000 : 400);
  for (int i = 0; i < cases && !HasFailure(); ++i) {
    const Case c = GetParam().make(static_cast<std::uint64_t>(i) + 5000000);
    SCOPED_TRACE(i);
    const PosedPair pair = largerFirst(c);
    CollideOptions options;
    if (i % 4 == 1 && !is_tight) options.tolerance = 1e-3 * pair.b.radius;
    if (i % 4 == 2 && !is_tight) options.margin = 1e-3 * pair.b.radius;
    if (!std::isfinite(options.margin) || !std::isfinite(options.tolerance)) options = {};
    const double lookahead = i % 3 == 0 && std::isfinite(pair.b.radius) ? 0.5 * pair.b.radius : 0;
    const auto find = [&] { return collideByHierarchy(pair, options, lookahead, Wanted::Clearance); };
    const auto answer = [&] { return collideByHierarchy(pair, options, lookahead, Wanted::Answer).collides; };
    const Outcome found = find(), on_portable = onPortableLanes(find);
    const auto all = [](const Outcome& o) { return std::tuple(o.collides, o.clearance, o.edge_a, o.edge_b); };
    ASSERT_EQ(all(on_portable), all(found));
    const bool unexplained = answer();
    ASSERT_EQ(onPortableLanes(answer), unexplained);
    hits += found.collides;
    if (options.tolerance == 0) {
      ASSERT_EQ(unexplained, found.collides);
      ASSERT_EQ(found.collides, areWithin(c, options.margin, Touching::Collides)) << reproduction(c);
    }
    if (found.collides || found.clearance == 0) continue;
    ++clear;
    const mpq_class distance_squared = exact::distanceSquared(c.a, c.pose_a, c.b, c.pose_b);
    const mpq_class clearance(found.clearance * (is_wall ? 1 - 1e-12 : 1));  // poses aren't quite rigid
    ASSERT_TRUE(clearance * clearance <= distance_squared) << found.clearance << "\n" << reproduction(c);
    tight += 9 * clearance * clearance >= distance_squared;
  }
  EXPECT_EQ(hits > 0, !is_wall);
  if (is_tight) {
    EXPECT_GT(is_wall ? tight : hits, cases / 4);
  }
  if (name == "large_outlines") {
    EXPECT_GT(tight, clear / 4) << "clearances that are worthless";
  }
}

std::vector<Family> allFamilies() {
  std::vector<Family> all = familiesOfAllSizes();
  all.insert(all.end(), tightFamilies().begin(), tightFamilies().end());
  return all;
}

INSTANTIATE_TEST_SUITE_P(Families, Descents, testing::ValuesIn(allFamilies()),
                         [](const auto& family) { return family.param.name; });

/// By the corners of both boxes, along the axes of both.
double separation(const detail::Box& a, const detail::Box& b, const detail::UnitMap& map) {
  Eigen::Matrix2d turn;
  turn << map.r00, map.r01, map.r10, map.r11;
  const auto corner = [&](const detail::Box& box, double s, double t) -> Vec2 {
    const Vec2 p = Vec2(box.x, box.y) + s * box.along * Vec2(box.ux, box.uy) + t * box.across * Vec2(-box.uy, box.ux);
    return &box == &a ? p : Vec2(map.scale * turn * p + Vec2(map.tx, map.ty));
  };
  double most = -1e9;
  for (const detail::Box* own : {&a, &b})
    for (const bool along : {false, true}) {
      const Vec2 axis = (corner(*own, along ? 1 : -1, along ? -1 : 1) - corner(*own, -1, -1)).normalized();
      double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
      for (const int k : {0, 1})
        for (const double s : {-1, 1})
          for (const double t : {-1, 1}) {
            const double at = axis.dot(corner(k == 0 ? a : b, s, t));
            low[k] = std::min(low[k], at), high[k] = std::max(high[k], at);
          }
      most = std::max({most, low[0] - high[1], low[1] - high[0]});
    }
  return most;
}

TEST(RootGap, IsTheBoxesSeparationButForRounding) {
  Random random(17);
  int apart = 0;
  const int asked = scaledCount(2000);
  for (int i = 0; i < asked; ++i) {
    const auto polygon = [&](double size) {
      return Polygon({star(random, random.integer(3, 9), 0.5 * size, size, {random.real(-0.3, 0.3), 0.2})});
    };
    const Polygon a = polygon(1), b = polygon(i % 2 ? 0.3 : 0.01);
    const Pose pose_a = randomPose(random, 0.9), pose_b = mirrored(randomPose(random, 0.9));
    const PosedPair pair(detail::dataOf(a), pose_a, detail::dataOf(b), pose_b);
    const detail::UnitMap map = pair.inUnits();
    const detail::Box &box_a = hierarchyOf(pair.a).root, &box_b = hierarchyOf(pair.b).root;
    const double gap = detail::rootGap(box_a, box_b, map);
    const double truth = separation(box_a, box_b, map);
    ASSERT_LE(gap, truth) << i;
    ASSERT_GE(gap, truth - 1e-4) << i;
    apart += truth > 0;
  }
  EXPECT_GE(apart, asked / 5);
  EXPECT_LE(apart, 4 * asked / 5);
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
    const Pose turn = turnedAndMoved(random.real(0, 6.28), 0, 0);
    const Vec2 towards = direction(random.real(0, 6.28));
    const double error = i % 2 == 0 ? 0 : 1e-4;
    const double depth = random.coin() ? random.real(-1e-6, 1e-6) : random.real(-1e-3, 3e-3);
    const auto overlap = [&](double away) {
      double most = -1;
      for (int j = 0; j < a.count; ++j)
        for (int k = 0; k < b.count; ++k)
          most = std::max(most, static_cast<double>(a.radius[j]) + b.radius[k] -
                                    (turn * Vec2(b.x[k], b.y[k]) + away * towards - Vec2(a.x[j], a.y[j])).norm());
      return most;
    };
    // So far away that the two that come nearest overlap by the depth.
    double low = 0, high = 2;
    for (int step = 0; step < 60; ++step) (overlap(0.5 * (low + high)) > depth ? low : high) = 0.5 * (low + high);
    const auto r = turn.linear();
    const double claim = detail::innerDepth(
        a, b, {r(0, 0), r(0, 1), r(1, 0), r(1, 1), high * towards.x(), high * towards.y(), 1, error});
    if (claim <= 0) continue;
    ++claimed;
    // The map may be wrong by `error`: b may be that much farther away.
    ASSERT_LE(claim, overlap(high + error) + 1e-12);
  }
  EXPECT_GT(claimed, cases / 20);
}

/// No disc fits into an angle of two bars that thin: its S, outside of it, is no point of its region.
TEST(InnerDiscs, OfARegionThatHasNoneMeetNothing) {
  const Polygon angle({{{-8, -8}, {8, -8}, {8, -8 + 1e-9}, {-8 + 1e-9, -8 + 1e-9}, {-8 + 1e-9, 8}, {-8, 8}}});
  ASSERT_EQ(innerDiscsOf(detail::dataOf(angle)).largest, 0);
  const Polygon block({rectangle(-2, -2, 2, 2)});
  for (const Vec2& at : {angle.coveringOrigin(), Vec2(angle.coveringOrigin() + Vec2(0.5, 0.5))}) {
    const Pose pose_b = turnedAndMoved(0, at.x(), at.y());
    ASSERT_FALSE(exact::collide(angle, Pose::Identity(), block, pose_b));
    EXPECT_FALSE(collide(angle, Pose::Identity(), block, pose_b));
    EXPECT_FALSE(collide(block, pose_b, angle, Pose::Identity()));
  }
}

/// Whatever overlap is claimed, moving apart by that much doesn't end it.
TEST(Clearance, OfOverlappingRegionsIsThere) {
  const Polygon a({regular(40, 1)}), b({regular(30, 0.8)});
  int claims = 0;
  for (double x = 0; x < 1.8; x += 0.05) {
    const Pose here = Pose::Identity(), there = turnedAndMoved(0, x, 0);
    const Outcome outcome =
        collideByHierarchy({detail::dataOf(a), here, detail::dataOf(b), there}, {}, 0, Wanted::Clearance);
    ASSERT_TRUE(outcome.collides);
    if (outcome.clearance == 0) continue;
    ++claims;
    ASSERT_TRUE(exact::collide(a, Pose::Identity(), b, turnedAndMoved(0, x + outcome.clearance, 0))) << x;
  }
  EXPECT_GT(claims, 5);
}

/// Sixteen edges, the upper eight along the x axis from 10 to 0 but for a spike at 1: a box that is `height` thick, and
/// empty at its far end.
Ring spiked(double height) {
  return {{0, 0},  {1, -1}, {3, -1}, {4, -1}, {5, -1},  {6, -1},     {8, -1},  {9, -1},
          {10, 0}, {8, 0},  {6, 0},  {4, 0},  {1.1, 0}, {1, height}, {0.9, 0}, {0.1, 0}};
}

/// Two of these against each other, their boxes overlapping at the empty ends: the chains are both boxes' thickness
/// apart.
TEST(Tolerance, IsLessThanWhatTwoBoxesMayHide) {
  const Polygon a({spiked(0.5)}), b({spiked(0.5)});
  const auto apart = [&](double dx, double dy, double margin, double tolerance) {
    Pose pose_b = turnedAndMoved(0, 20 + dx, 1 + dy);
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
  const Pose here = Pose::Identity();
  std::vector<Ring> dots, grid;
  for (int i = 0; i < 12; ++i) dots.push_back(rectangle(10 * i, 0, 10 * i + 0.01, 0.01));
  for (int i = 0; i < 12; ++i) grid.push_back(rectangle(10 * i + 4, 0, 10 * i + 4.01, 0.01));
  const Polygon a(dots), b(grid), one({rectangle(4, 0, 4.01, 0.01)});
  const CollideOptions options{0, 0.1}, tolerant{0, 1};
  EXPECT_FALSE(collide(a, here, b, here, options));
  EXPECT_FALSE(collide(b, here, a, here, options));
  for (const double x : {0, 6, 50}) EXPECT_EQ(collide(a, here, one, turnedAndMoved(0, x, 0), options), x == 6);

  // A mast between two dots, and between two of four: about as long as they are apart, and longer by far.
  const auto dot = [](double x, double y) { return rectangle(x, y, x + 0.01, y + 0.01); };
  const Polygon two({dot(-10, 0), dot(10, 0)}), four({dot(-10, 0), dot(10, 0), dot(-10, 100), dot(10, 100)});
  for (const double length : {80.0, 160.0, 5000.0}) {
    const Polygon mast({rectangle(-0.001, -length, 0.001, length)});
    EXPECT_FALSE(collide(mast, here, two, here, tolerant)) << length;
    EXPECT_FALSE(collide(mast, here, four, here, tolerant)) << length;
    EXPECT_TRUE(collide(mast, here, two, turnedAndMoved(0, 10, 0), tolerant)) << length;
  }
}

/// Rays through the vertices of an outline so fine that a block is some thousand times smaller than its distance:
/// whatever rounding does to the ray, both edges that share the vertex are visited. Here, and where a pose hides some
/// digits.
TEST(Ray, ThroughVerticesFarAway) {
  Random random(37);
  const Polygon scanned({regular(40000, 1)}), built({regular(40000, 1)});
  const Vec2 far(5e7, -7e7);
  const Polygon dot({shifted(rectangle(0, 0, 1, 1), far)});
  hierarchyOf(detail::dataOf(built));
  const UpTo only(detail::Stages::Edges);
  for (int i = 0; i < scaledCount(1000); ++i) {
    const Vec2 v = built.edgeStart(anyEdge(random, built));
    const double t = i % 2 == 0 ? random.real(0.01, 0.99) : 1 - std::pow(10, random.real(-5, -2));
    const Vec2 point = built.coveringOrigin() + t * (v - built.coveringOrigin());
    ASSERT_EQ(locate(built, point), Location::Inside);
    const Pose frame = turnedAndMoved(random.real(0, 6.28), 0, 0);
    Pose pose_dot = turnedAndMoved(random.real(0, 6.28), 0, 0);
    pose_dot.translation() = frame * point - pose_dot * far;
    const PosedPair by_tree(detail::dataOf(built), frame, detail::dataOf(dot), pose_dot),
        by_scan(detail::dataOf(scanned), frame, detail::dataOf(dot), pose_dot);
    ASSERT_EQ(detail::locateInA(by_tree, far), detail::locateInA(by_scan, far));
  }
  ASSERT_EQ(hierarchyIfBuilt(detail::dataOf(scanned)), nullptr) << "so it was scanned";
}

#ifndef NDEBUG
/// What is rounded in a's units was proven for a b that isn't the larger.
TEST(DescentDeathTest, APairOutOfOrderIsStopped) {
  const Polygon small({regular(5, 1)}), large({regular(5, 100)});
  const Pose here = Pose::Identity();
  const PosedPair in_order(detail::dataOf(large), here, detail::dataOf(small), here),
      swapped(detail::dataOf(small), here, detail::dataOf(large), here);
  EXPECT_LE(in_order.inUnits().scale, 1);
  EXPECT_DEATH(swapped.inUnits(), "unit");
}
#endif

}  // namespace
}  // namespace tricover::support
