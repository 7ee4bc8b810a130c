// SPDX-License-Identifier: BSD-3-Clause
// Bodies that start in contact, and contact that lasts: it is proven by the features that are in contact, not by steps
// of time_error. A step of these tests that took them would not end. A search that ends at its budget says what is
// proven, and that it does.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/least_distance.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"
#include "tricover/trajectory.h"

namespace tricover::support {
namespace {

constexpr double kErrors[] = {1e-2, 1e-6, 1e-9, 1e-12};

Motion still(double x, double y) { return Motion::still(tricover::poseAt(x, y)); }
Motion slide(double x, double y, const Vec2& shift) { return Motion::translation(tricover::poseAt(x, y), shift); }

ImpactOptions within(double time_error, bool ignore_initial = false, double margin = 0) {
  ImpactOptions options;
  options.time_error = time_error;
  options.ignore_initial = ignore_initial;
  options.margin = margin;
  return options;
}

void expectOne(const std::vector<Conflict>& found, double begin, double end, double error) {
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].budget_ended);
  EXPECT_LE(found[0].impact.time, begin + 1e-12);
  EXPECT_GE(found[0].impact.time, begin - error);
  EXPECT_GE(found[0].end, end - 1e-12);
  EXPECT_LE(found[0].end, end + error);
}

TEST(LastingContact, ACrateOnAFloor) {
  const Polygon floor = Polygon::box(20, 1), crate = Polygon::box(1, 1);
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    const Motion slides = slide(-2, 1, {4, 0}), leaves = slide(-2, 1, {40, 0});
    EXPECT_FALSE(timeOfImpact(floor, still(0, 0), crate, slides, within(error, true)));
    expectOne(conflicts(floor, still(0, 0), crate, slides, within(error)), 0, 1, error);
    EXPECT_TRUE(conflicts(floor, still(0, 0), crate, slides, within(error, true)).empty());
    // Its lower left corner leaves the floor's end at x = 10.
    expectOne(conflicts(floor, still(0, 0), crate, leaves, within(error)), 0, 12.5 / 40, std::max(error, 1e-9));
    EXPECT_FALSE(timeOfImpact(floor, still(0, 0), crate, leaves, within(error, true)));
    // Both move alike, and both rotate alike about one place.
    expectOne(conflicts(floor, slide(0, 0, {3, 1}), crate, slide(-2, 1, {3, 1}), within(error)), 0, 1, error);
    Motion a = still(0, 0), b = still(-2, 1);
    a.angle = b.angle = 1;
    b.pivot = Vec2(2, -1);
    expectOne(conflicts(floor, a, crate, b, within(error)), 0, 1, error);
    // Along a cubic at the same height.
    const Motion spline = Motion::spline({{-5, 1}, 0, {6, 0}, 0}, {{5, 1}, 0, {8, 0}, 0});
    expectOne(conflicts(floor, still(0, 0), crate, spline, within(error)), 0, 1, error);
  }
}

/// A vertex at exactly the margin along an edge, and on past its end. There the vertex comes nearer to the line of the
/// next edge while it goes farther beyond that edge's end.
TEST(LastingContact, PastTheEndOfAnEdgeAtTheMargin) {
  const Polygon square({{{0x0p+0, 0x0p+0}, {0x1p+2, 0x1.8p+1}, {0x1p+0, 0x1.cp+2}, {-0x1.8p+1, 0x1p+2}}});
  const Polygon kite({{{0x1p+1, 0x0p+0}, {-0x0p+0, 0x1p+0}, {-0x1.8p+1, -0x1p+0}, {0x1p+1, -0x1p+1}}});
  Motion along = slide(-0x1.cc8d2ab0a8bafp+0, -0x1.9fb0755cd2e9dp+2, {-0x1.ep+1, 0x1.8p-1});
  along.start.linear() << 0x1.3333333333333p-1, -0x1.999999999999ap-1, 0x1.999999999999ap-1, 0x1.3333333333333p-1;
  for (const double error : kErrors)
    expectOne(conflicts(square, along, kite, still(0, 0), within(error, false, 0.25)), 0, 1 / 3.0,
              std::max(error, 1e-6));
}

TEST(LastingContact, OverManyFeatures) {
  Ring flat, teeth;
  for (int i = 0; i <= 2000; ++i) {
    flat.emplace_back(-10 + 0.01 * i, 0);
    teeth.emplace_back(-10 + 0.01 * i, i % 7 == 3 ? 0 : -0.1 - 0.01 * (i % 5));
  }
  for (Ring* ring : {&flat, &teeth}) {
    ring->insert(ring->end(), {{10, -1}, {-10, -1}});
    const Polygon floor(*ring);
    expectOne(conflicts(floor, still(0, 0), Polygon::box(1, 1), slide(-8, 0.5, {16, 0}), within(1e-9)), 0, 1, 0);
  }
  std::vector<TimedPose> waypoints;
  for (int i = 0; i <= 60; ++i) waypoints.push_back({static_cast<double>(i), tricover::poseAt(-9 + 0.3 * i, 1)});
  const Trajectory rests({{0, 60, still(0, 0)}}), slides = Trajectory::through(waypoints);
  const Polygon floor = Polygon::box(20, 1), crate = Polygon::box(1, 1);
  EXPECT_FALSE(timeOfImpact(floor, rests, crate, slides, within(1e-6, true)));
  expectOne(conflicts(floor, rests, crate, slides, within(1e-6)), 0, 60, 0);
  EXPECT_TRUE(conflicts(floor, rests, crate, slides, within(1e-6, true)).empty());
}

/// A body that is sunk by a little, a rod through a floor, and what is held and leaves its edge slowly.
TEST(LastingContact, ThatIsHardlyDeep) {
  const Polygon floor = Polygon::box(20, 1), crate = Polygon::box(1, 1), rod = Polygon::segment({0, -1}, {0, 1});
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    for (const double sunk : {1e-3, 1e-6, 1e-9, 1e-11}) {
      SCOPED_TRACE(sunk);
      expectOne(conflicts(floor, still(0, 0), crate, slide(-5, 1 - sunk, {10, 0}), within(error)), 0, 1, 0);
      expectOne(conflicts(floor, still(0, 0), rod, slide(-5, 1.5 - sunk, {10, 0}), within(error)), 0, 1, 0);
      // Held, beside its edge.
      expectOne(conflicts(floor, still(0, 0), Polygon::point({0, 0}), slide(-5, 0.5 - sunk, {10, 0}), within(error)), 0,
                1, 0);
      expectOne(conflicts(floor, still(0, 0), Polygon::box(1, 0.25), slide(-5, 0.375 - sunk, {10, 0}), within(error)),
                0, 1, 0);
      expectOne(
          conflicts(Polygon::box(4, 4), still(0, 0), crate, slide(-1, 2.5 + 1 - sunk, {2, 0}), within(error, false, 1)),
          0, 1, 0);
    }
    Motion along = slide(-5, 0.5, {10, 0});
    along.shift_2 = Vec2(0, -0.75);
    expectOne(conflicts(floor, still(0, 0), Polygon::point({0, 0}), along, within(error)), 0, 1, 0);
    expectOne(conflicts(floor, still(0, 0), Polygon::box(1, 0.5), along, within(error)), 0, 1, 0);
    const Motion alike = slide(1e-15, 0, {-3.5, 0.5});
    EXPECT_LE(conflicts(Polygon::point({0, 0}), slide(0, 0, {-3.5, 0.5}), Polygon::point({0, 0}), alike, within(error))
                  .size(),
              1u);
  }
}

double inDecimals(double value) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2f", value);
  return std::atof(text);
}

/// Docks written in decimals, of which many are a rounding apart or in each other.
TEST(ContactAtTheStart, DocksAreLeftFreely) {
  int apart = 0, together = 0;
  for (int i = 1; i <= 20; ++i)
    for (int j = 1; j <= 40; ++j) {
      const double of_floor = inDecimals(0.05 * i), of_robot = inDecimals(0.05 * j),
                   at = inDecimals(of_floor + of_robot);
      SCOPED_TRACE(at);
      const Polygon floor({rectangle(-5, -of_floor, 5, of_floor)});
      const Polygon robot({rectangle(-0.5, -of_robot, 0.5, of_robot)});
      const bool touch = collide(floor, tricover::poseAt(0, 0), robot, tricover::poseAt(0, at));
      ++(touch ? together : apart);
      EXPECT_FALSE(timeOfImpact(floor, still(0, 0), robot, slide(0, at, {0, 1}), within(1e-6, true)));
      EXPECT_TRUE(conflicts(floor, still(0, 0), robot, slide(0, at, {0, 1}), within(1e-6, true)).empty());
      // Down into it: there is no end of contact. Away and back: that is an impact.
      EXPECT_FALSE(timeOfImpact(floor, still(0, 0), robot, slide(0, at, {0, -0.04}), within(1e-6, true)));
      Motion returns = slide(0, at, {0, 4});
      returns.shift_2 = Vec2(0, -8);
      const auto impact = timeOfImpact(floor, still(0, 0), robot, returns, within(1e-6, true));
      ASSERT_TRUE(impact);
      EXPECT_NEAR(impact->time, 0.5, 2e-6);
    }
  EXPECT_GT(apart, 30);
  EXPECT_GT(together, 100);
}

/// A pose off rigid costs what an exact one costs, and its impact is where that one's is.
TEST(ContactAtTheStart, PosesOffRigid) {
  const Polygon post({rectangle(-0.25, -1, 0.25, 0)}), triangle({{{0, 0}, {1, 0.5}, {0.5, 1}}});
  Motion tips = still(0, 1e-9);
  tips.angle = -M_PI;
  const double exactly = timeOfImpact(post, still(0, 0), triangle, tips)->time;
  for (const double off : {4e-15, 1e-13, 1e-10, 1e-7, 4e-5})
    for (const bool shear : {false, true}) {
      Motion from = still(0, 0), tipped = tips;
      for (Motion* motion : {&from, &tipped})
        shear ? motion->start.linear()(0, 1) += off : motion->start.linear()(0, 0) *= 1 + off;
      const auto impact = timeOfImpact(post, from, triangle, tipped);
      ASSERT_TRUE(impact && !impact->budget_ended);
      EXPECT_NEAR(impact->time, exactly, 2 * off + 1e-6) << off << shear;
    }
  for (int i = 0; i < 200; ++i) {
    const Pose at = throughFloat(support::turnedAndMoved(0.03 * i, 0, 0));
    Motion motion = Motion::still(at);
    motion.start.translation() += at.linear() * Vec2(0, 1e-9);
    motion.angle = -M_PI;
    const auto impact = timeOfImpact(post, Motion::still(at), triangle, motion);
    ASSERT_TRUE(impact && !impact->budget_ended);
    EXPECT_NEAR(impact->time, exactly, 1e-5) << i;
  }
}

/// Two segments that stay as near to each other as that, or tip from there.
TEST(ContactAtTheStart, SegmentsBesideEachOther) {
  const Polygon rod = Polygon::segment({0, 0}, {1, 0});
  for (const double gap : {0.0, 3.4e-9, 1e-12, 1e-15})
    for (const bool is_exact : {false, true})
      for (const double angle : {0.0, 0.3, 2.0, -M_PI}) {
        const Pose at = is_exact ? Pose(Pose::Identity()) : throughFloat(support::turnedAndMoved(0.7, 0, 0));
        Motion above = Motion::still(at), along = Motion::still(at);
        above.start.translation() += at.linear() * Vec2(0.25, gap);
        along.start.translation() = above.start.translation();
        above.angle = angle;
        along.shift = at.linear() * Vec2(0.5, 0);
        const auto tips = conflicts(rod, Motion::still(at), rod, above, within(1e-9));
        for (const Conflict& c : tips) EXPECT_FALSE(c.budget_ended);
        // It touches at the begin, or soon if it tips down, but for rounding.
        if (gap == 0 || angle < 0) {
          EXPECT_EQ(tips.size(), 1u) << gap << " " << angle;
        }
        if (gap > 1e-9 && angle >= 0) {
          EXPECT_TRUE(tips.empty()) << gap << " " << angle;
        }
        EXPECT_TRUE(conflicts(rod, Motion::still(at), rod, along, within(1e-9, true)).size() <= 1);
        if (gap == 0 && is_exact) expectOne(conflicts(rod, Motion::still(at), rod, along, within(1e-9)), 0, 1, 0);
        expectOne(conflicts(rod, Motion::still(at), rod, along, within(1e-9, false, gap + 1e-9)), 0, 1, 0);
        const auto closer = timeOfImpact(rod, Motion::still(at), rod, above, within(1e-12, false, gap + 1e-15));
        EXPECT_TRUE(!closer || !closer->budget_ended);
      }
}

/// One of a scene's bodies may be absent, or all of them.
TEST(AbsentOutside, OfBodiesInAScene) {
  const Trajectory first({{0, 10, still(0, 0)}}), second({{11, 20, still(0, 0)}}),
      passes({{0, 20, slide(-10, 0, {20, 0})}});
  Scene scene;
  const BodyHandle a = scene.add(Polygon::box(1, 1), still(0, 0).start),
                   b = scene.add(Polygon::box(1, 1), still(0, 0).start);
  const std::vector<BodyTrajectory> in_turn = {{a, first}, {b, second}},
                                    one_by_one = {{a, first.vanishing()}, {b, second.appearing()}};
  EXPECT_EQ(scene.impacts(in_turn).size(), 1u);
  EXPECT_TRUE(scene.impacts(one_by_one).empty());
  EXPECT_TRUE(scene.conflicts(one_by_one).empty());
  // The first one leaves while the second passes; otherwise it rests.
  std::vector<BodyTrajectory> both = {{a, first}, {b, passes}};
  ASSERT_EQ(scene.conflicts(both).size(), 1u);
  EXPECT_NEAR(scene.conflicts(both)[0].conflict.end, 11, 1e-5);
  both[0].trajectory = first.vanishing();
  ASSERT_EQ(scene.conflicts(both).size(), 1u);
  EXPECT_EQ(scene.conflicts(both)[0].conflict.end, 10);
  EXPECT_EQ(scene.impacts(both).size(), 1u);
  // A body without a trajectory is always there.
  EXPECT_EQ(scene.impacts({{b, passes.appearing().vanishing()}}).size(), 1u);
}

TEST(AbsentOutside, TheSamePlaceAtOtherTimes) {
  const Polygon robot = Polygon::box(1, 1);
  const Trajectory first({{0, 10, still(0, 0)}}), second({{11, 20, still(0, 0)}}), longer({{5, 15, still(0.5, 0)}});
  EXPECT_EQ(conflicts(robot, first, robot, second).size(), 1u);  // they rest
  EXPECT_TRUE(conflicts(robot, first.vanishing(), robot, second.appearing()).empty());
  EXPECT_FALSE(timeOfImpact(robot, first.vanishing(), robot, second.appearing()));
  expectOne(conflicts(robot, first.vanishing(), robot, longer.appearing()), 5, 10, 0);
  EXPECT_EQ(timeOfImpact(robot, first.vanishing(), robot, longer.appearing())->time, 5);
  // It appears, and parks where it ends.
  expectOne(conflicts(robot, first, robot, second.appearing()), 11, 20, 0);
  EXPECT_TRUE(second.appearing().isThere(20.5) && !second.appearing().isThere(10.5) && second.isThere(10.5));
}

/// A trajectory made of a pose has no time of its own.
TEST(AbsentOutside, ABodyThatAlwaysRestsIsThereAsLongAsTheOther) {
  const Polygon robot = Polygon::box(1, 1);
  const Pose there = still(0.5, 0).start;
  const Trajectory first({{0, 10, still(0, 0)}}), rests = there;
  expectOne(conflicts(robot, first, robot, there), 0, 10, 0);
  expectOne(conflicts(robot, rests, robot, first.appearing().vanishing()), 0, 10, 0);
  EXPECT_EQ(leastDistance(robot, Pose(still(3, 0).start), robot, first).distance, 2);
  EXPECT_TRUE(rests.rests() && rests.at(-7).isApprox(there) && rests.part(3, 4).at(1).isApprox(there));
  EXPECT_THROW(conflicts(robot, rests, robot, rests), std::invalid_argument);
  EXPECT_THROW(leastDistance(robot, rests, robot, rests), std::invalid_argument);
  // In a scene two of them rest by the clock of all.
  Scene scene;
  std::vector<BodyTrajectory> plans;
  for (const Trajectory& way : {rests, rests, first}) plans.push_back({scene.add(robot, there), way});
  ASSERT_EQ(scene.conflicts(plans).size(), 3u);
  for (const PairConflict& found : scene.conflicts(plans)) {
    EXPECT_EQ(found.conflict.impact.time, 0);
    EXPECT_TRUE(found.conflict.end == 10 && found.conflict.meets_at_end);
  }
  plans.pop_back();
  EXPECT_THROW(scene.impacts(plans), std::invalid_argument);
  EXPECT_THROW(scene.firstImpact(robot, rests), std::invalid_argument);
}

const Polygon kSquare = Polygon::box(2, 2), kNotched(Ring{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-0.5, 0}});
const Motion kStill;

/// Triangles side by side that share an apex at the origin, to the left or to the right of it.
Polygon fan(int triangles, double side) {
  Ring ring;
  for (int i = 0; i < triangles; ++i) {
    const double low = -1 + 2.0 * i / triangles, high = low + 1.0 / triangles;
    ring.push_back({0, 0});
    ring.push_back({side, side > 0 ? low : high});
    ring.push_back({side, side > 0 ? high : low});
  }
  return Polygon({ring});
}

/// The apexes pass by each other while one fan turns: a million pairs of edges are a hair apart, all the time.
TEST(ImpactBudget, EndsWithTheProvenTime) {
  const Polygon left = fan(400, -1), right = fan(400, 1);
  Motion up = slide(1e-9, -1e-4, {0, 1e-3});
  up.angle = 0.1;
  const auto impact = timeOfImpact(left, kStill, right, up);
  ASSERT_TRUE(impact.has_value());
  EXPECT_TRUE(impact->budget_ended);
  EXPECT_TRUE(impact->time > 0 && impact->time <= 1);
  EXPECT_TRUE(impact->edge_a >= 0 && impact->edge_a < left.edgeCount() && impact->edge_b < right.edgeCount());
  EXPECT_NEAR(impact->normal.norm(), 1, 1e-9);
  const auto all = conflicts(left, kStill, right, up);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].budget_ended && all[0].impact.budget_ended);
  EXPECT_EQ(all[0].end, 1);
  // Fewer edges are not too many.
  EXPECT_FALSE(timeOfImpact(fan(20, -1), kStill, fan(20, 1), up).has_value());
}

/// A square slides along the straight side of a polygon, convex or not, exactly as deep as is allowed: the deepest
/// points of both ends of a step tell that the contact lasts.
TEST(ImpactBudget, LastsWhereAnOverlapStaysExactlyAsDeepAsIsAllowed) {
  const Motion beside = slide(1.875, -0.5, {0, 1});
  for (const Polygon& a : {kNotched, kSquare}) {
    EXPECT_FALSE(timeOfImpact(a, kStill, kSquare, beside, {-0.125, 0, true}).has_value());
    expectOne(conflicts(a, kStill, kSquare, beside, {-0.125, 0}), 0, 1, 0);
  }
}

/// A box leaves the hole that it fills: it stays in what is around it, however far it goes. And one of a size that is
/// nothing beside its way slides along a wall.
TEST(ImpactBudget, LastsForExtremeRatios) {
  const Polygon hole = Polygon::box(1, 1).complement();
  for (const double far : {1e60, 1e100, 1e150, 1e300}) {
    SCOPED_TRACE(far);
    expectOne(conflicts(hole, kStill, Polygon::box(1, 1), slide(0, 0, {0, far})), 0, 1, 0);
  }
  for (const double size : {1e-30, 1e-70, 1e-150, 1e-300}) {
    const Polygon speck({{{0, 0}, {size, 0}, {size, size}, {0, size}}});
    SCOPED_TRACE(size);
    expectOne(conflicts(kSquare, kStill, speck, slide(-2, 1, {8, 0})), 0.125, 0.375, 1e-6);
  }
}

/// They touch at the start within rounding alone or not at all, and are never as deep as is allowed.
TEST(ImpactBudget, LeavesOutAContactThatIsNoImpact) {
  int without = 0;
  for (double off = 1e-13; off < 1e-10; off *= 1.5) {
    const Motion beside = slide(1.875 + off, -0.5, {0, 1});
    const ImpactOptions options{-0.125, 0, true};
    if (timeOfImpact(kNotched, kStill, kSquare, beside, {-0.125, 0})) continue;
    ++without;
    EXPECT_FALSE(timeOfImpact(kNotched, kStill, kSquare, beside, options)) << off;
    EXPECT_TRUE(conflicts(kNotched, kStill, kSquare, beside, options).empty()) << off;
  }
  EXPECT_GE(without, 2);
}

}  // namespace
}  // namespace tricover::support
