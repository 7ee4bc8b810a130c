// SPDX-License-Identifier: BSD-3-Clause
// Penetrations that can be worked out by hand.
#include "tricover/penetration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "penetration_laws.h"
#include "random.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

const Pose kIdentity = Pose::Identity();
const Vec2 kAnyWay(0, 0);

Pose at(double x, double y) { return turnedAndMoved(0, x, y); }

/// Of a polygon in its own frame and another one.
struct Row {
  Polygon a, b;
  Pose pose_b;
  double depth;
  Vec2 normal = kAnyWay;  ///< where several are as short
};

/// What is expected, under turned, mirrored and shifted poses, in either order.
void expectPenetration(const Row& row) {
  for (const Pose& frame : {kIdentity, turnedAndMoved(0.7, 3, -2), mirrored(turnedAndMoved(-2.1, 0.1, 5)),
                            turnedAndMoved(1.1, 1e6, -1e6)}) {
    const Pose in_b = frame * row.pose_b;
    const double error = 1e-12 + 1e-14 * frame.translation().norm();
    const auto p = penetration(row.a, frame, row.b, in_b), q = penetration(row.b, in_b, row.a, frame);
    ASSERT_TRUE(p && q);
    EXPECT_TRUE(p->optimal);
    EXPECT_NEAR(p->depth, row.depth, error);
    EXPECT_NEAR(p->lower_bound, row.depth, error);
    EXPECT_LE(p->lower_bound, p->depth);
    EXPECT_NEAR(p->normal.norm(), 1, 1e-14);
    if (row.normal != kAnyWay) {
      EXPECT_LE((p->normal - frame.linear() * row.normal).norm(), error);
    }
    EXPECT_LE((p->point_b + p->depth * p->normal - p->point_a).norm(), error);
    EXPECT_NEAR(p->translation.norm(), p->depth, 4 * error);
    Pose moved = in_b;
    moved.translation() += p->translation;
    EXPECT_FALSE(collide(row.a, frame, row.b, moved));
    EXPECT_EQ(wrongSwapped({row.a, frame, row.b, in_b}, *p), "");
  }
}

void expectPenetrations(const std::vector<Row>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE("row " + std::to_string(i));
    expectPenetration(rows[i]);
  }
}

const Polygon& square() {
  static const Polygon polygon({rectangle(-1, -1, 1, 1)});
  return polygon;
}

/// Five wide and high, walls one thick, open at the top.
const Polygon& cup() {
  static const Polygon polygon({{{0, 0}, {5, 0}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}}});
  return polygon;
}

/// Ten wide, with a hole of six in the middle.
const Polygon& frame() {
  static const Polygon polygon({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8)});
  return polygon;
}

const Polygon kSegment({{{-1, 0}, {0, 0}, {1, 0}}}), kPoint({{{1, 1}, {1, 1}, {1, 1}}});

TEST(Convex, BoxesSegmentsAndPoints) {
  const Polygon box({rectangle(0, 0, 4, 4)});
  // Straight and repeated vertices, clockwise.
  const Polygon written({{{0, 4}, {2, 4}, {4, 4}, {4, 4}, {4, 1}, {4, 0}, {0, 0}, {0, 0}, {0, 2}}});
  expectPenetrations({
      {box, square(), at(4.5, 2), 0.5, {1, 0}},
      {box, square(), at(1, 1.5), 2, {-1, 0}},
      {box, square(), at(2, 2), 3},
      // By a corner: the box's normals count as much as the diamond's.
      {box, Polygon({{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}), at(4.25, 4.25), 0.5 * std::sqrt(0.5), direction(M_PI / 4)},
      {written, square(), at(4.5, 2), 0.5, {1, 0}},
      {square(), kSegment, at(0, 0.75), 0.25, {0, 1}},
      {square(), kPoint, at(-1, -0.5), 0.5, {0, 1}},
      {kSegment, kSegment, turnedAndMoved(1, 0, 0), std::sin(1)},
  });
  EXPECT_EQ(penetration(written, kIdentity, square(), at(4.5, 2.5))->edge_a, 3);  // the long one of the two there
  EXPECT_EQ(penetration(kSegment, kIdentity, kSegment, at(1, 0))->depth, 0);
  EXPECT_EQ(penetration(kPoint, kIdentity, kPoint, kIdentity)->depth, 0);
}

TEST(Convex, AShallowOneIsExact) {
  const auto p = penetration(square(), kIdentity, square(), at(2 - 0x1p-50, 0.3));
  EXPECT_EQ(p->depth, 0x1p-50);
  EXPECT_EQ(p->normal, Vec2(1, 0));
}

TEST(Convex, OfEdgesWhoseGapsPlainDoublesCannotTellApartTheLeastCounts) {
  // A wall that bends by little at each of its corners, and a tip beneath its middle edge.
  const double bend = 0x1p-52, below = 0x1p-39;
  Ring wall = {{92, -1}, {108, -1}};
  for (int k = 8; k >= -8; --k) wall.emplace_back(100 + k, -k * k * bend);
  const Polygon a({wall}), b({{{100.5, -below}, {101.5, 3}, {99.5, 3}}});
  for (int k = 0; k < 60; ++k) {
    const Pose both = turnedAndMoved(0.1 * k, 0, 0);
    const auto p = penetration(a, both, b, both);
    ASSERT_TRUE(p && p->optimal);
    EXPECT_NEAR(p->depth / (below - 0.5 * bend), 1, 4e-15) << k;
  }
}

TEST(NotConvex, OutOfACup) {
  const Polygon plug({rectangle(-1.6, -0.5, 1.6, 0.5)}), needle({rectangle(-10, -0.25, 10, 0.25)});
  expectPenetrations({
      {cup(), square(), at(2.5, 1.5), 0.5, {0, 1}},    // off its floor
      {cup(), square(), at(0.5, 3), 1.5},              // across the wall, as far as inwards
      {cup(), square(), at(0.75, 3), 1.25, {1, 0}},    // into the cup
      {cup(), square(), at(2.5, -0.3), 0.7, {0, -1}},  // out through the floor
      {cup(), plug, at(2.5, 4), 1.5, {0, 1}},          // too wide for the cup: out through the mouth
      {cup(), plug, at(2.5, 2), 2.5, {0, -1}},         // through the floor is shorter than 3.5
      {cup(), needle, at(2.5, 1.75), 2, {0, -1}},
      {cup(), Polygon({rectangle(-1.5, -1, 1.5, 1)}), at(2.5, 3), 3, {0, 1}},  // as wide as the cup it slides out
  });
}

TEST(NotConvex, IntoTheHoleOrOut) {
  const Polygon filled(frame().rings(), FillRule::NonZero), crumb({rectangle(-1e-3, -1e-3, 1e-3, 1e-3)});
  const Polygon plate({rectangle(-5, -5, 5, 5), rectangle(-1, -1, 1, 1)});
  const Ring large = rectangle(5.5, -1.5, 8.5, 1.5), small = rectangle(0.75, -0.25, 1.25, 0.25);
  const Polygon target({rectangle(2, -2.5, 8, 2.5), rectangle(2.5, -2, 7.5, 2), rectangle(3.95, -0.5, 4.95, 0.5)});
  expectPenetrations({
      {frame(), square(), at(1.5, 5), 1.5, {1, 0}},
      {frame(), square(), at(0.5, 5), 1.5, {-1, 0}},
      {frame(), square(), at(1, 1), 2},
      // From a hole's corner, where both coordinates have to change.
      {frame(), square(), at(2.5, 2.25), std::hypot(0.5, 0.75), Vec2(0.5, 0.75).normalized()},
      {filled, square(), at(1.5, 5), 2.5, {-1, 0}},  // under the non-zero rule there is no hole: all the way out
      {frame(), crumb, at(1.25, 5), 0.751, {1, 0}},  // small in the middle of a wall
      // Holes that one part fits.
      {plate, Polygon({large, small}), kIdentity, 0.25, {-1, 0}},
      {plate, Polygon({small, large}), kIdentity, 0.25, {-1, 0}},
      // An island in a hole is a part, too.
      {target, Polygon({rectangle(4.5, -1.5, 6, 1.5)}), kIdentity, 0.45, {1, 0}},
  });
}

/// A hole bounds free places for what is no larger than it; a rod fits along its diagonal.
TEST(NotConvex, HolesThatARodJustFits) {
  // Its sides bulge, so that its outermost vertices are nearer to each other than its corners are.
  const Ring hole = {{-2.01, 0}, {-2, -2}, {0, -2.01}, {2, -2}, {2.01, 0}, {2, 2}, {0, 2.01}, {-2, 2}};
  const Polygon plate({rectangle(-10, -10, 10, 10), hole});
  const auto rod = [](double length) {  // bent a little
    return Polygon({{{-length / 2, 0}, {0, 0.01}, {length / 2, 0}, {0, 0.2}}});
  };
  const double half = std::sqrt(0.5);
  const Pose along = turnedAndMoved(0.25 * static_cast<double>(EIGEN_PI), 0, 0);
  EXPECT_FALSE(collide(plate, kIdentity, rod(5.6), along));
  // Pushed by 0.3 along the diagonal its end is 0.3 - (2.828 - 2.8) beyond the corner: each coordinate comes back.
  Pose pushed = along;
  pushed.translation() = 0.3 * Vec2(half, half);
  const double beyond = half * (2.8 + 0.3) - 2;
  expectPenetration({plate, rod(5.6), pushed, beyond / half, Vec2(-half, -half)});
  // One that is too long has to leave the plate.
  const auto out = penetration(plate, kIdentity, rod(6), along);
  ASSERT_TRUE(out);
  EXPECT_TRUE(out->optimal);
  EXPECT_GT(out->depth, 10);
}

TEST(NotConvex, CombsInEachOther) {
  const auto teeth = [](double width, double y_low, double y_high, double bar) {
    std::vector<Ring> rings = {rectangle(0, bar, 6, bar + 1)};
    for (int i = 0; i < 6; ++i) rings.push_back(rectangle(i, y_low, i + width, y_high));
    return Polygon(rings, FillRule::NonZero);
  };
  const Polygon below = teeth(0.5, 1, 5, 0), above = teeth(0.25, -5, -1, -1);
  // The gaps are at [i + 0.5, i + 1], as deep as the teeth are long.
  expectPenetrations({
      {below, above, at(0.875, 6.5), 0.125, {-1, 0}},
      {below, above, at(0.625, 5.75), 0.25, {0, 1}},
      {below, above, at(0.875, 5.75), std::hypot(0.125, 0.25), Vec2(-0.125, 0.25).normalized()},
  });
}

TEST(NotConvex, OutlinesThatCrossOrTurnBackAndSeveralParts) {
  const Polygon angle({{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}}), bow({{{-4, -2}, {4, 2}, {4, -2}, {-4, 2}}});
  const Ring once = rectangle(-4, -4, 4, 4);
  Ring twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  const Polygon posts({rectangle(0, 0, 1, 8), rectangle(4, 0, 5, 8), rectangle(8, 0, 9, 8)});
  const Polygon rake({rectangle(-4.25, -1, -3.75, 1), rectangle(-0.25, -1, 0.25, 1), rectangle(3.75, -1, 4.25, 1)});
  const Polygon walls({rectangle(-4, -1, 1.5, 0), rectangle(2.5, 0, 8, 8), rectangle(-4, -8, 8, -7)});
  const Polygon house({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 8}, {2, 4}, {0, 4}}}), flat({{{2, 3}, {2, 7}, {2, 5}}});
  expectPenetrations({
      // Nested like chairs: off along the diagonal's cheaper coordinate.
      {angle, angle, at(0.25, 0.5), std::hypot(0.75, 0.5), Vec2(0.75, 0.5).normalized()},
      {angle, angle, at(0.75, 1), 0.25, {1, 0}},
      // A bow tie: two triangles, nothing between them.
      {bow, Polygon({rectangle(-0.5, -0.25, 0.5, 0.25)}), at(0, 0.25), 0.25, {0, 1}},
      // A ring that goes around twice: its region is all of the square by one rule, its outline alone by the other.
      {Polygon({twice}, FillRule::NonZero), square(), at(3.5, 0), 1.5, {1, 0}},
      {Polygon({twice}), square(), at(3.5, 0), 0.5, {-1, 0}},
      {posts, square(), at(1.5, 4), 0.5, {1, 0}},
      // Between posts that are too close: out of all of them.
      {posts, Polygon({rectangle(-1.6, -1.6, 1.6, 1.6)}), at(2.5, 6), 3.6, {0, 1}},
      {posts, rake, at(4.375, 4), 0.625, {-1, 0}},  // with the posts' spacing
      // Beyond the ledge from 2 on, and beyond the high wall up to 2; the floor is far below.
      {walls, Polygon({rectangle(-0.5, -0.5, 0.5, 0.5)}), at(1.8, -0.8), 0.2, {1, 0}},
      // Edges that turn back.
      {house, square(), at(2.5, 6), 0.5, {1, 0}},
      {house, square(), at(1.5, 6), 0.5, {-1, 0}},
      {frame(), flat, at(-0.25, 0), 0.25, {1, 0}},
  });
}

TEST(Margin, IsAddedToTheDepthOfConvexPolygons) {
  const auto p = penetration(square(), kIdentity, square(), at(1.5, 0.25), {0.5});
  EXPECT_EQ(p->depth, 1);
  EXPECT_EQ(p->normal, Vec2(1, 0));
  EXPECT_NEAR((p->point_b + (p->depth - 0.5) * p->normal - p->point_a).norm(), 0, 1e-15);
  // A corner beside a corner.
  const auto q = penetration(square(), kIdentity, square(), at(5, 6), {6});
  EXPECT_EQ(q->depth, 1);
  EXPECT_NEAR((q->normal - Vec2(0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_FALSE(penetration(square(), kIdentity, square(), at(5, 6), {nudged(5, -1)}));
  EXPECT_EQ(penetration(square(), kIdentity, square(), at(5, 6), {5})->depth, 0);
}

TEST(Margin, OutOfACup) {
  // A peg of two in a cup of three has half to either side, and one below: three above it are the way out, and the
  // margin.
  const Polygon peg({rectangle(0, 0, 2, 9)});
  const auto p = penetration(cup(), kIdentity, peg, at(1.5, 1.5), {0.75});
  ASSERT_TRUE(p);
  const double shortest = 3.5 + std::sqrt(0.75 * 0.75 - 0.5 * 0.5);
  EXPECT_LE(p->lower_bound, shortest);
  EXPECT_GE(p->depth, shortest - 1e-12);
  EXPECT_LE(p->depth, 3.5 + 0.75 + 1e-12) << "longer than the hulls need";
  Pose moved = at(1.5, 1.5);
  moved.translation() += p->translation;
  EXPECT_FALSE(collide(cup(), kIdentity, peg, moved, {0.75}));
  EXPECT_FALSE(penetration(cup(), kIdentity, peg, at(1.5, 1.5), {0.49}));
  // As wide as the margin: up along the wall.
  const auto q = penetration(cup(), kIdentity, peg, at(1.5, 1.5), {0.5});
  ASSERT_TRUE(q);
  EXPECT_LE(q->lower_bound, 3.5);
  EXPECT_GE(q->depth, 3.5 - 1e-12);
  EXPECT_LE(q->depth, 3.5 + 0.5 + 1e-12);
}

TEST(Touching, HasDepthZeroAndAWayOut) {
  for (const auto& [polygon, where, way] :
       {std::tuple{cup(), at(6, 2), Vec2(1, 0)}, {frame(), at(3, 5), Vec2(1, 0)}, {cup(), at(2.5, 2), Vec2(0, 1)}}) {
    const auto p = penetration(polygon, kIdentity, square(), where);
    ASSERT_TRUE(p);
    EXPECT_EQ(p->depth, 0);
    EXPECT_EQ(p->lower_bound, 0);
    EXPECT_TRUE(p->optimal);
    EXPECT_EQ(p->normal, way);
    EXPECT_LE((p->point_a - p->point_b).norm(), 1e-13);
  }
}

TEST(Apart, IsNothing) {
  EXPECT_FALSE(penetration(cup(), kIdentity, square(), at(2.5, 2.1)));
  EXPECT_FALSE(penetration(frame(), kIdentity, square(), at(5, 5)));
  EXPECT_FALSE(penetration(square(), kIdentity, square(), at(2 + 0x1p-50, 0)));
}

TEST(Sizes, FromTinyToHuge) {
  for (const int exponent : {-990, -300, 300, 990}) {
    const double scale = std::ldexp(1, exponent);
    const Polygon a({scaled(cup().rings()[0], scale)}), b({scaled(square().rings()[0], scale)});
    const auto p = penetration(a, kIdentity, b, at(2.5 * scale, 1.5 * scale));
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->depth / scale, 0.5, 1e-12);
    EXPECT_NEAR(p->lower_bound / scale, 0.5, 1e-12);
    EXPECT_EQ(p->normal, Vec2(0, 1));
    EXPECT_TRUE(p->optimal);
    const auto q = penetration(b, kIdentity, b, at(1.5 * scale, 0.25 * scale));
    EXPECT_EQ(q->depth, 0.5 * scale);
  }
}

/// Coordinates overflow, or no pose can take either one away: nothing is proven, so nothing is said.
TEST(Sizes, AtTheEndOfTheRangeThereIsNoWayOut) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const Polygon all({rectangle(-kMost, -kMost, kMost, kMost)}), box({rectangle(-1e300, -1e301, 1e300, 1e301)});
  const std::tuple<Polygon, Polygon, Pose> cases[] = {
      {all, cup(), kIdentity}, {box, box, at(kMost, kMost)}, {box, box, at(-kMost, -kMost)}};
  for (const auto& [a, b, both] : cases) {
    const auto p = penetration(a, both, b, both);
    ASSERT_TRUE(p);
    EXPECT_EQ(p->depth, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(p->optimal);
    EXPECT_EQ(p->lower_bound, 0);
    EXPECT_EQ(p->translation, Vec2(0, 0));
    EXPECT_EQ(p->edge_a, -1);
    EXPECT_EQ(p->edge_b, -1);
  }
}

/// Half of a, its middle, too, is beyond the largest double; where they overlap isn't.
TEST(Sizes, PointsAreFiniteWhereDoublesReach) {
  const Polygon a({rectangle(0.1e308, -1e307, 1.7e308, 1e307)}), b({rectangle(1.05e308, -1e306, 1.15e308, 1e306)});
  const auto p = penetration(a, at(1e308, 0), b, kIdentity);
  ASSERT_TRUE(p);
  EXPECT_TRUE(p->optimal);
  EXPECT_NEAR(p->depth, 0.05e308, 1e294);
  EXPECT_NEAR(p->point_a.x(), 1.1e308, 1e294);
  EXPECT_NEAR(p->point_b.x(), 1.15e308, 1e294);
}

/// Scaled by the largest coordinate, some of the hull's edges are as long as the smallest doubles.
TEST(Sizes, OfHugeAndTinyEdgesTheDirectionIsAUnitVector) {
  const Polygon a(
      {{{-3, 0x1.38d352e5096afp+498}, {1, -3}, {0, 3}}, {{-4, -2}, {1, -3}, {2, 0}, {3, 0x1p-1073}, {0, -2}, {1, 1}}},
      FillRule::NonZero);
  const Polygon b({{{0, 1}, {0, 1}, {-2, -0x1.0000000000001p+1}},
                   {{-0x1.ffffffffffffep-1, -1}, {0x1.7e43c8800759cp+996, 1}, {0x1.fffffffffffffp-1, -1}},
                   {{-0x1.0000000000002p+1, -2}, {1, 1}, {-2, 1}}},
                  FillRule::NonZero);
  const Pose pose_a =
      pose(0x1.e0261549b2ae3p-1, 0x1.6388ca40133abp-2, 2, -0x1.6388ca40133abp-2, 0x1.e0261549b2ae3p-1, -1);
  const Pose pose_b =
      pose(0x1.c0bb3ab786c7ep-2, 0x1.cc38c348d1356p-1, 0, -0x1.cc38c348d1356p-1, 0x1.c0bb3ab786c7ep-2, 0);
  const auto found = penetration(a, pose_a, b, pose_b);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->normal.norm(), 1, 1e-15);
}

TEST(FarAway, OnlyWhatTheirPosesShareIsLost) {
  const double far = 0x1p40;
  const auto p = penetration(cup(), at(far, -far), square(), at(far + 2.5, -far + 1.5));
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->depth, 0.5, 1e-12);
}

/// A polygon and itself, at places that differ by the sign of a zero only.
TEST(Arguments, SwappedTheyGiveTheOppositeDirection) {
  for (const Polygon& polygon :
       {Polygon({rectangle(-1, -1, 1, 1)}), Polygon({rectangle(-3, -3, 3, 3), rectangle(-1, -1, 1, 1)})})
    for (const int entry : {0, 1, 2}) {
      Pose with_zero = kIdentity, with_minus_zero = kIdentity;
      (entry == 0 ? with_minus_zero.linear()(0, 1) : with_minus_zero.translation()[entry - 1]) = -0.0;
      const auto p = penetration(polygon, with_zero, polygon, with_minus_zero);
      const auto q = penetration(polygon, with_minus_zero, polygon, with_zero);
      ASSERT_TRUE(p && q);
      EXPECT_EQ(p->depth, q->depth);
      EXPECT_EQ(p->normal, -q->normal);
      EXPECT_EQ(p->translation, -q->translation);
      EXPECT_EQ(p->point_a, q->point_b);
    }
}

TEST(Arguments, PosesAreChecked) {
  Pose tilted = kIdentity;
  tilted.linear() *= 2;
  EXPECT_THROW(penetration(square(), tilted, square(), kIdentity), std::invalid_argument);
  EXPECT_THROW(penetration(square(), kIdentity, square(), tilted), std::invalid_argument);
}

/// A margin so small that its product with a length underflows.
TEST(Margin, OfNextToNothingIsNone) {
  Random random(3);
  const Polygon ring({star(random, 12, 0.4, 1)}), dot = Polygon::point(ring.coveringOrigin());
  const auto without = penetration(ring, kIdentity, dot, kIdentity);
  ASSERT_TRUE(without);
  for (const double margin : {1e-200, 1e-300, 5e-324}) {
    const auto with = penetration(ring, kIdentity, dot, kIdentity, {margin});
    ASSERT_TRUE(with);
    EXPECT_NEAR(with->depth, without->depth, 1e-12);
  }
}

}  // namespace
}  // namespace tricover::support
