// SPDX-License-Identifier: BSD-3-Clause
// Depths, excesses and Hausdorff distances that are known by hand. tests/laws/depth.cpp has the laws of
// all families.
#include "tricover/depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "depth_laws.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/covers.h"
#include "tricover/distance.h"
#include "tricover/locate.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr EdgeIndex kMostEdges = 200;  // for the laws, which are exact
const Pose kHere = Pose::Identity();

Pose at(double x, double y, double heading = 0) { return tricover::poseAt(x, y, heading); }

/// Under every law, and of swapped operands.
double depthOf(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const Depth found = depth(a, pose_a, b, pose_b);
  const bool is_small = a.edgeCount() + b.edgeCount() < kMostEdges;
  EXPECT_EQ(is_small ? wrongDepth({a, pose_a, b, pose_b}, found) : "", "");
  return found.depth;
}
double depthOf(const Polygon& a, const Polygon& b, const Pose& pose_b) { return depthOf(a, kHere, b, pose_b); }

double excessOf(const Polygon& part, const Pose& pose, const Polygon& area) {
  const Excess found = excess(part, pose, area, kHere);
  EXPECT_EQ(area.edgeCount() < kMostEdges ? wrongExcess({part, pose, area, kHere}, found) : "", "");
  EXPECT_EQ(found.distance == 0, covers(area, kHere, part, pose));
  return found.distance;
}

/// t into both walls of a corner: t times the root of 2.
TEST(Depth, OfACrateInACorner) {
  const Polygon room = Polygon::box(10, 10).complement(), crate = Polygon::box(2, 2);
  for (const double t : {1e-12, 1e-9, 1e-6, 0.01, 0.5})
    EXPECT_NEAR(depthOf(room, crate, at(-4 - t, -4 - t)), std::sqrt(2) * t, 2e-14) << t;
}

TEST(Depth, NamesPointsEdgesAndANormal) {
  const Polygon corner({{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}}), crate = Polygon::box(2, 2);
  const Depth of_crate = depth(corner, kHere, crate, at(1.99, 1.99));
  EXPECT_FALSE(of_crate.is_point_of_a);
  EXPECT_NEAR((of_crate.point_b - Vec2(0.99, 0.99)).norm(), 0, 1e-14);
  EXPECT_NEAR((of_crate.point_a - Vec2(1, 1)).norm(), 0, 1e-14);
  EXPECT_NEAR((of_crate.normal - Vec2(1, 1).normalized()).norm(), 0, 1e-12);
  EXPECT_TRUE(of_crate.edge_a == 2 || of_crate.edge_a == 3) << of_crate.edge_a;
  EXPECT_TRUE(of_crate.edge_b == 3 || of_crate.edge_b == 0) << of_crate.edge_b;
  const Depth apart = depth(crate, kHere, crate, at(2, 0.5));
  EXPECT_TRUE(apart.depth == 0 && apart.edge_a == -1 && apart.edge_b == -1);
  // A hole's middle, where another region fills the hole.
  const Depth in_hole = depth(Polygon::box(20, 20), kHere, Polygon({regular(6, 8), regular(6, 2)}).complement(), kHere);
  EXPECT_TRUE(!in_hole.is_point_of_a && in_hole.edge_b == -1);
  EXPECT_NEAR(in_hole.depth, 10, 2e-14);
}

/// n edges at once are nearest, or n pieces of two lines.
TEST(Depth, OfWhatManyEdgesTieIn) {
  for (const int n : {3, 4, 5, 64, 1024, 4096}) {
    const Polygon peg({regular(n, 3)});
    EXPECT_NEAR(depthOf(peg, Polygon::box(1, 1), kHere), 3 * std::cos(M_PI / n), 1e-14) << n;
    EXPECT_NEAR(excessOf(Polygon::box(1, 1), kHere, Polygon({regular(n, 4), regular(n, 3)})), 3 * std::cos(M_PI / n),
                1e-14)
        << n;
  }
  Ring corridor;
  for (int i = 0; i <= 500; ++i) corridor.emplace_back(i, 0);
  for (int i = 500; i >= 0; --i) corridor.emplace_back(i, 1);
  const Polygon hall(corridor);
  EXPECT_NEAR(depthOf(hall, Polygon::box(100, 2), at(250, 0.5)), 1, 1e-13);
  EXPECT_NEAR(depthOf(hall, Polygon::box(100, 0.25), at(250, 0.5)), 0.5, 1e-13);
  EXPECT_NEAR(depthOf(hall.complement(), Polygon::box(100, 1.5), at(250, 0.5)), 0.25, 1e-13);
  EXPECT_NEAR(depthOf(hall, hall, kHere), 0.5, 1e-13);
}

/// Without an inside, and beside edges that don't count, since the region is on both sides of them.
TEST(Depth, OfSegmentsPointsAndSlits) {
  EXPECT_NEAR(depthOf(Polygon::box(4, 2), Polygon::segment({-9, 0.25}, {9, 0.25}), kHere), 0.75, 1e-14);
  EXPECT_NEAR(depthOf(Polygon::box(4, 2), Polygon::point({1, 0.5}), kHere), 0.5, 1e-14);
  EXPECT_EQ(depthOf(Polygon::box(4, 2), Polygon::segment({-2, 1}, {2, 1}), kHere), 0);
  EXPECT_EQ(depthOf(Polygon::segment({-1, 0}, {1, 0}), Polygon::segment({0, -1}, {0, 1}), kHere), 0);
  EXPECT_EQ(depthOf(Polygon::point({0, 0}), Polygon::point({0, 0}), kHere), 0);
  const Polygon slit({{{-2, -2}, {0, -2}, {0, 1}, {0, -2}, {2, -2}, {2, 2}, {-2, 2}}});
  EXPECT_NEAR(depthOf(slit, Polygon::box(1, 1), kHere), 2, 1e-14);
  EXPECT_NEAR(depthOf(Polygon({rectangle(-2, -2, 0, 2), rectangle(0, -2, 2, 2)}), Polygon::box(1, 1), kHere), 2, 1e-14);
}

TEST(Depth, OfAnySize) {
  for (const double size : {1e-300, 1e-200, 1e-10, 1e10, 1e150, 1e200}) {
    const Polygon square = Polygon::box(4, 4).scaled(size);
    EXPECT_NEAR(depthOf(square, square, at(3.5 * size, size)) / size, 0.5, 1e-13) << size;
    EXPECT_NEAR(depthOf(square.complement(), square, at(size, size)) / size, std::sqrt(2), 1e-13) << size;
    EXPECT_NEAR(depthOf(Polygon::box(1, 1), square, at(0.3, 0)), size < 1 ? 0.2 + 2 * size : 2 * size,
                (size < 1 ? 1 : size) * 1e-13)
        << size;
  }
}

TEST(Excess, OfRegionsWithHolesAndWithout) {
  const Polygon area = Polygon::box(10, 10), holed({rectangle(-5, -5, 5, 5), rectangle(-2, -2, 2, 2)});
  EXPECT_EQ(excessOf(Polygon::box(2, 2), at(4, 4), area), 0);
  EXPECT_NEAR(excessOf(Polygon::box(2, 2), at(4.5, 4.5), area), std::sqrt(0.5), 1e-14);
  // The middle of a hole.
  const Excess in_hole = excess(area, kHere, holed, kHere);
  EXPECT_NEAR(in_hole.distance, 2, 1e-14);
  EXPECT_EQ(in_hole.edge, -1);
  EXPECT_NEAR(in_hole.point.norm(), 0, 1e-13);
  // What has no area is far from hardly more than itself.
  EXPECT_NEAR(excessOf(area, kHere, Polygon::point({0, 0})), std::sqrt(50), 1e-14);
  EXPECT_NEAR(excessOf(area, kHere, Polygon::segment({-5, 0}, {5, 0})), 5, 1e-14);
  EXPECT_EQ(excessOf(Polygon::segment({-1, 0}, {1, 0}), kHere, Polygon::segment({-5, 0}, {5, 0})), 0);
  // Unbounded.
  EXPECT_EQ(excessOf(area.complement(), kHere, area), kInfinity);
  EXPECT_NEAR(excessOf(Polygon::box(4, 4).complement(), kHere, area.complement()), 3, 1e-14);
  EXPECT_EQ(depthOf(area.complement(), holed.complement(), kHere), kInfinity);
}

/// GEOS gives 910/19 for the lines, and for their vertices alone sqrt(500), which is right of the regions.
TEST(Excess, IsKnownInClosedForm) {
  const Polygon a({{{0, 0}, {100, 0}, {10, 100}}}), b({{{0, 100}, {0, 10}, {80, 10}}});
  const Polygon line_a({{{0, 0}, {100, 0}, {10, 100}, {100, 0}}}), line_b({{{0, 100}, {0, 10}, {80, 10}, {0, 10}}});
  EXPECT_NEAR(excessOf(line_a, kHere, line_b), 910 / 19.0, 2e-13);
  EXPECT_NE(excess(line_a, kHere, line_b, kHere).edge, -1);
  EXPECT_NEAR(excessOf(a, kHere, b), std::sqrt(500), 2e-13);
  EXPECT_NEAR(hausdorffDistance(line_a, kHere, line_b, kHere), 910 / 19.0, 2e-13);
}

TEST(HausdorffDistance, IsTheLargerExcess) {
  EXPECT_EQ(hausdorffDistance(Polygon::box(2, 2), kHere, Polygon::box(2, 2), kHere), 0);
  EXPECT_NEAR(hausdorffDistance(Polygon::box(2, 2), kHere, Polygon::box(6, 6), kHere), 2 * std::sqrt(2), 1e-14);
  EXPECT_EQ(hausdorffDistance(Polygon::box(2, 2), kHere, Polygon::box(2, 2).complement(), kHere), kInfinity);
  EXPECT_NEAR(hausdorffDistance(Polygon::box(2, 2).complement(), kHere, Polygon::box(6, 4).complement(), kHere), 2,
              1e-14);
}

/// One edge passes another one's end within rounding: where they cross is rounded once on either, and is one corner of
/// the border all the same.
TEST(Depth, BesideACrossingWithinRoundingOfAVertex) {
  const Ring grid = {{-8, 2}, {4, -2}, {4, -2}, {4, 2},  {6, 1},  {8, 0},  {8, 0}, {7, -3},
                     {6, -6}, {6, -6}, {2, -3}, {-2, 0}, {-2, 0}, {1, -2}, {4, -4}};
  const Polygon crossed({scaled(grid, 0x1.be6abf58e9523p-1)}, FillRule::NonZero);
  const Vec2 begin = crossed.edgeStart(14), way = crossed.edgeEnd(14) - begin,
             left = Vec2(-way.y(), way.x()).normalized();
  for (const double share : {0.3, 0.6, 0.9})
    for (const double side : {-1, 1}) {
      const Vec2 inside = begin + share * way + side * 0.05 * left;
      const double expected = locate(crossed, inside) == Location::Inside ? 0.05 : 0;
      EXPECT_NEAR(depth(crossed, kHere, Polygon::point(inside), kHere).depth, expected, 1e-13) << share << ", " << side;
    }
  EXPECT_EQ(locate(crossed, begin + 0.6 * way - 0.05 * left), Location::Inside);
}

/// Two vertices that a pose makes one don't shift the names of the edges behind them.
TEST(Excess, NamesEdgesBehindVerticesThatRoundingMakesOne) {
  const Ring ring_a = {{-0x1.8p-1, 0x1.8p-1}, {-0x1p-1, 0x0p+0}, {0x1.8p-1, 0x0p+0},
                       {-0x1p-1, -0x1.8p-1},  {0x1p-1, 0x0p+0},  {0x1p-1, 0x0p+0}};
  const Polygon a({ring_a}, FillRule::NonZero);
  const Ring ring_b = {{0x1.49e9b0e7c0d3bp-1, 0x1.7a9b279906139p-5},   {0x1.e0144e3de604bp-3, 0x1.bac18f61650c3p-4},
                       {0x1.e19d1222656ccp-5, 0x1.d3e69bbf8c601p-4},   {0x1.e19d1222656cbp-5, 0x1.d3e69bbf8c601p-4},
                       {-0x1.c2f61fb31d9a8p-2, 0x1.6e5dc290e560dp-4},  {-0x1.6874b25a7e9e2p-1, -0x1.05f17c183580ep-9},
                       {-0x1.006ae66ff1725p-1, -0x1.4a0d7169887f4p-4}, {-0x1.5738ab981eb8dp-2, -0x1.9cedff68a0714p-4},
                       {0x1.cc7695bd61feap-2, -0x1.6951bad9a215fp-4},  {0x1.37f1d94130419p-1, -0x1.d6bdc9627a8bcp-5}};
  const Polygon b({ring_b}, FillRule::NonZero);
  Pose pose_b = kHere;
  pose_b.matrix().topRows<2>() << 0x1.fe5814336f1ap-4, -0x1.fc02a233e1092p-1, -0x1.e47ec22d8f817p-3,
      -0x1.fc02a233e1092p-1, -0x1.fe5814336f1ap-4, 0x1.08fdfdeb0e173p-1;
  const Excess found = excess(a, kHere, b, pose_b);
  const Vec2 v = pose_b * b.edgeStart(found.nearest_edge), w = pose_b * b.edgeEnd(found.nearest_edge);
  EXPECT_EQ(found.nearest_edge, 8);
  EXPECT_NEAR(distance(Polygon::segment(v, w), kHere, Polygon::point(found.nearest), kHere).distance, 0, 1e-15);
}

/// A body that is much thinner than it is deep, along a wall: cells are as long as it is, and a border leads through
/// each.
TEST(Depth, OfAThinBodyAlongAWallEndsWithinTheBudget) {
  const Ring wedge_of_a = {{0x1.b40e69b241ef4p-1, 0x1.9b32722f44014p-2},
                           {0x1.2527861a9456dp-2, 0x1.9b3d7ad5f5152p-2},
                           {-0x1.87e56221fa56p-5, 0x1.9b34d2624256fp-2},
                           {0x1.df1fcc29a5b27p-3, 0x1.9b1ad5df66299p-2},
                           {0x1.496d08bc6d55ep-1, 0x1.9b1c8af7eaa2cp-2}};
  const Ring hexagon = {{-0x1.91fd7964e28e6p-3, -0x1.14e87a490d7e2p-2}, {-0x1.8a68456993299p-2, -0x1.61655e5cae153p-2},
                        {-0x1.90a574435edeep-1, -0x1.f281b3a1b0c28p-3}, {-0x1.7dfc183ed73eep-1, 0x1.213965d6c478dp-1},
                        {-0x1.4eb08f058acb7p-1, 0x1.39c6641ceffd6p-1},  {-0x1.2c913b7f0601p-5, 0x1.9525b97e770bfp-2}};
  const Ring triangle = {{-0x1.1ae0528e9e17fp-1, -0x1.aa6899a9e13p-9},
                         {-0x1.d3cb5f067a4acp-1, -0x1.8606cb439f972p-3},
                         {-0x1.fed5f438f1afbp-2, -0x1.0075df52d7448p+0}};
  const Ring block = {{-0x1.32c585920600cp-3, 0x1.6812356e0b458p-2},
                      {0x1.b34e9e9b7e7fdp-1, 0x1.6812356e0b458p-2},
                      {0x1.b34e9e9b7e7fdp-1, -0x1.4bf6e548fa5d4p-1},
                      {-0x1.32c585920600cp-3, -0x1.4bf6e548fa5d4p-1}};
  const Polygon a({wedge_of_a, hexagon, triangle, block}, FillRule::NonZero);
  const Ring needle = {{0x1.e9d084b750efep-2, 0x1.075021e5bd169p-19},   {0x1.e9d084b750efep-2, 0x1.075021e5bd169p-19},
                       {0x1.5922110a1d68bp-2, 0x1.59419df1e260ep-19},   {-0x1.2efbcda91cc42p-7, 0x1.110bc7481d8f4p-18},
                       {-0x1.16f688bbb9528p-1, -0x1.184b9109f87c6p-22}, {0x1.89e1539696115p-3, -0x1.ff29884224ff1p-19},
                       {0x1.89e1539696115p-3, -0x1.ff29884224ff1p-19},  {0x1.adc2f8545c315p-3, -0x1.cfb84de0e6a86p-19},
                       {0x1.21bcb1eab356fp-2, -0x1.09c53c75cff98p-19},  {0x1.6e560fa8f3812p-2, -0x1.f9b2d8224836fp-22},
                       {0x1.976a310564975p-2, 0x1.6b53731ceedf8p-22}};
  const Polygon b({needle}, FillRule::NonZero);
  const double time = 0.37651214374636885;
  const Vec2 there(0x1.e3069a0077c11p+0 - time * 0x1.bd8f7689f9624p+1,
                   -0x1.4ea968c708a22p+1 + time * 0x1.4e5c09f4b40ep+2);
  const Depth found = depth(a, kHere, b, tricover::poseAt(there.x(), there.y()));
  EXPECT_NEAR(found.depth, 0.000864994655546, 1e-14);
  EXPECT_NEAR(found.upper_bound, found.depth, 1e-14);
}

TEST(Depth, RefusesWhatIsNoPose) {
  const Polygon square = Polygon::box(1, 1);
  Pose skewed = kHere, absent = kHere;
  skewed.linear()(0, 0) = 2;
  absent.translation().x() = std::nan("");
  for (const Pose& bad : {skewed, absent}) {
    EXPECT_NE(refusal([&] { depth(square, bad, square, kHere); }).find("pose_a"), std::string::npos);
    EXPECT_NE(refusal([&] { depth(square, kHere, square, bad); }).find("pose_b"), std::string::npos);
    EXPECT_NE(refusal([&] { excess(square, bad, square, kHere); }).find("pose_part"), std::string::npos);
    EXPECT_NE(refusal([&] { excess(square, kHere, square, bad); }).find("pose_area"), std::string::npos);
    EXPECT_NE(refusal([&] { hausdorffDistance(square, kHere, square, bad); }).find("pose_b"), std::string::npos);
  }
}

}  // namespace
}  // namespace tricover::support
