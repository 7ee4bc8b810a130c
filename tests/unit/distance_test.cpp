// SPDX-License-Identifier: BSD-3-Clause
// Distances worked out by hand, at every size; holes, containment, options, refusals, and what a cache keeps; and
// least distances on the way.
#include "tricover/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "limited_distance.h"
#include "polygon/cache_access.h"
#include "refusal.h"
#include "shapes.h"
#include "tricover/conflicts.h"
#include "tricover/least_distance.h"
#include "tricover/polygon.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Polygon square(double size) { return Polygon({scaled(rectangle(0, 0, 1, 1), size)}); }

Pose at(double x, double y) { return turnedAndMoved(0, x, y); }

/// Between the corners (1, 1) and (4, 5).
TEST(Distance, ThreeFourFiveAtEverySize) {
  for (const int exponent : {-1070, -1000, -498, -30, 0, 30, 498, 1000, 1020}) {
    const double unit = std::ldexp(1, exponent);
    const Polygon a = square(unit);
    const DistanceResult r = distance(a, at(0, 0), a, at(4 * unit, 5 * unit));
    EXPECT_EQ(r.distance, 5 * unit) << exponent;
    EXPECT_EQ(r.point_a, Vec2(unit, unit)) << exponent;
    EXPECT_EQ(r.point_b, Vec2(4 * unit, 5 * unit)) << exponent;
  }
}

TEST(Distance, EdgeToVertexAndEdgeToEdge) {
  const Polygon a = square(1), diamond({{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}});
  const DistanceResult r = distance(a, at(0, 0), diamond, at(0.25, 5));
  EXPECT_EQ(r.distance, 3);
  EXPECT_EQ(r.point_a, Vec2(0.25, 1));
  EXPECT_EQ(r.point_b, Vec2(0.25, 4));
  EXPECT_EQ(r.edge_a, 2);
  EXPECT_TRUE(r.edge_b == 0 || r.edge_b == 3);
  const DistanceResult parallel = distance(a, at(0, 0), a, at(3, 0.5));
  EXPECT_EQ(parallel.distance, 2);
  EXPECT_EQ(parallel.point_a.x(), 1);
  EXPECT_EQ(parallel.point_b.x(), 3);
  EXPECT_EQ(parallel.point_a.y(), parallel.point_b.y());
}

/// Two regions that are one point each, the same one: there is no edge to divide by. Far off, too, where what is scaled
/// by their size would overflow.
TEST(Distance, OfTwoPolygonsThatAreOnePoint) {
  const Polygon a = Polygon::point({0, 0}), b = Polygon::point({0, 0});
  for (const Pose& there : {at(0, 0), at(0x1p354, -0x1p353)})
    for (const Polygon* other : {&a, &b}) {
      const DistanceResult r = distance(a, there, *other, there);
      EXPECT_EQ(r.distance, 0);
      EXPECT_EQ(r.point_a, there.translation());
      EXPECT_EQ(r.point_b, there.translation());
    }
  EXPECT_EQ(distance(a, at(0, 0), b, at(3, 4)).distance, 5);
}

/// A gap of one unit in the last place, and of far less than that of any coordinate.
TEST(Distance, GapsBelowRounding) {
  const Polygon a = square(1);
  EXPECT_EQ(distance(a, at(0, 0), a, at(nudged(1, 1), 0)).distance, 0x1p-52);
  EXPECT_EQ(distance(a, at(0, 0), a, at(1, 0)).distance, 0);
  // The right edge of `left` is at 1 - 2^-60 in the world, which no double is.
  const Polygon left({rectangle(-1, 0, -0x1p-60, 1)});
  EXPECT_EQ(distance(left, at(1, 0), a, at(1, 0)).distance, 0x1p-60);
  // y = 2^-70 x, against the axis: a shear that is far below what rounding would show.
  Pose sheared = at(0, 0);
  sheared.linear()(1, 0) = 0x1p-70;
  const Polygon above({rectangle(1, 0, 2, 1)}), below({rectangle(1, -1, 2, 0)});
  EXPECT_EQ(distance(above, sheared, below, at(0, 0)).distance, 0x1p-70);
}

TEST(Distance, FarFromTheOriginAndOverflow) {
  const Polygon a = square(1);
  EXPECT_EQ(distance(a, at(1e15, -1e15), a, at(1e15 + 4, -1e15 + 5)).distance, 5);
  const Polygon huge = square(1e308);
  const DistanceResult r = distance(huge, at(-1.7e308, 0), huge, at(1.7e308, 0));
  EXPECT_EQ(r.distance, kInfinity);
  EXPECT_EQ(r.edge_a, 1);
  EXPECT_EQ(r.edge_b, 3);
  EXPECT_EQ(distance(huge, at(-1.2e308, 0), huge, at(1.2e308, 0)).distance, 1.2e308 + (1.2e308 - 1e308));
}

TEST(Distance, OverlapAndContainmentHaveOneCommonPoint) {
  const Polygon a = square(10), b = square(1);
  const DistanceResult inside = distance(a, at(0, 0), b, at(4, 5)), turned = distance(b, at(4, 5), a, at(0, 0));
  EXPECT_TRUE(inside.distance == 0 && inside.point_a == Vec2(4, 5) && inside.point_b == Vec2(4, 5));
  EXPECT_TRUE(inside.edge_a == -1 && inside.edge_b == 0 && turned.edge_a == 0 && turned.edge_b == -1);
  const DistanceResult crossing = distance(a, at(0, 0), b, at(9.5, 5));
  EXPECT_TRUE(crossing.distance == 0 && crossing.point_a == crossing.point_b && crossing.point_a.x() == 10);
  EXPECT_EQ(crossing.edge_a, 1);
}

TEST(Distance, RefusesAndNamesTheField) {
  const Polygon a = square(1);
  const std::pair<const char*, double LimitedOptions::*> fields[] = {
      {"relative_error", &LimitedOptions::relative_error},
      {"absolute_error", &LimitedOptions::absolute_error},
      {"limit", &LimitedOptions::limit}};
  for (const auto& [name, field] : fields)
    for (const double bad : {-1.0, kNaN, -kInfinity}) {
      LimitedOptions options;
      options.*field = bad;
      const std::string said = refusal([&] { distance(a, at(0, 0), a, at(3, 0), options); });
      EXPECT_NE(said.find(std::string("tricover: ") + name + ": "), std::string::npos) << said;
    }
  Pose bad = at(0, 0);
  bad.linear() *= 1.001;
  PairCache cache;
  distance(a, at(0, 0), a, at(3, 0), cache);
  EXPECT_NE(refusal([&] { distance(a, bad, a, at(3, 0), cache); }).find("pose_a"), std::string::npos);
  EXPECT_NE(refusal([&] { distance(a, at(3, 0), a, bad, cache); }).find("pose_b"), std::string::npos);
  EXPECT_EQ(distance(a, at(0, 0), a, at(3, 0), cache).distance, 2) << "a refusal changes nothing";
}

const detail::DistanceHint& hintOf(PairCache& cache) { return detail::contentsOf(cache).distance; }

/// A small polygon that jumps through an edge lies as near to the same edges as before, and yet inside.
TEST(DistanceCache, SeesAJumpThroughAnEdge) {
  const Polygon a = square(100), b({scaled(regular(3, 1), 0.01)});
  PairCache cache;
  for (const double x : {-0.04, -0.03, -0.02, -0.015})
    EXPECT_GT(distance(a, at(0, 0), b, at(x, 50), cache).distance, 0);
  EXPECT_EQ(distance(a, at(0, 0), b, at(0.015, 50), cache).distance, 0);
  EXPECT_EQ(distance(a, at(0, 0), b, at(0.02, 50), cache).distance, 0);
  EXPECT_EQ(distance(a, at(0, 0), b, at(-0.02, 50), cache).distance, distance(a, at(0, 0), b, at(-0.02, 50)).distance);
}

/// The hint is of one pair, and of the edges that were nearest or met.
TEST(DistanceCache, KeepsTheHintOfOnePair) {
  const Polygon a({regular(40, 3), regular(5, 1)}), b({regular(30, 1)}), c({regular(30, 1)});
  PairCache cache;
  for (int i = 0; i < 1000; ++i) {
    const Pose pose_b = turnedAndMoved(0.001 * i, 6 * std::cos(0.001 * i), 6 * std::sin(0.001 * i));
    ASSERT_EQ(distance(a, at(0, 0), b, pose_b, cache).distance, distance(a, at(0, 0), b, pose_b).distance);
    EXPECT_FALSE(hintOf(cache).back_off.isOn()) << i;
  }
  EXPECT_NE(hintOf(cache).kind, 0);
  EXPECT_EQ(distance(a, at(0, 0), c, at(10, 0), cache).distance, distance(a, at(0, 0), c, at(10, 0)).distance);
  EXPECT_EQ(hintOf(cache).second_id, c.id());
}

/// A hint that does not help backs off, and is tried again after that.
TEST(DistanceCache, BacksOffWhileHintsDoNotHelp) {
  const Polygon a({scaled(regular(40, 1), 3), regular(5, 1)}), b({regular(30, 1)});
  PairCache cache;
  const auto asks = [&](double angle) {
    const Pose pose_b = turnedAndMoved(angle, 4.1 * std::cos(angle), 4.1 * std::sin(angle));
    EXPECT_EQ(distance(a, at(0, 0), b, pose_b, cache).distance, distance(a, at(0, 0), b, pose_b).distance);
  };
  int rests = 0;
  for (int i = 0; i < 100; ++i) {
    asks(2.4 * i);
    rests += hintOf(cache).back_off.isOn();
  }
  EXPECT_GT(rests, 80) << "jumps";
  for (int i = 0; i < 300; ++i) asks(1e-5 * i);
  EXPECT_FALSE(hintOf(cache).back_off.isOn());
}

/// Sides of a convex polygon may be divided: the edges that are named are the given ones.
TEST(Distance, NamesTheEdgesOfDividedSides) {
  const Ring square = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {1, 2}, {0.25, 2}, {0, 2}, {0, 1}};
  const Polygon wedge({{{-1, 1}, {0, 0}, {0.5, 0.5}, {1, 1}, {0, 1}}}), plain({square}), back({reversed(square)});
  const struct {
    const Polygon& a;
    double x;
    EdgeIndex edge;
  } table[] = {{plain, 1.5, 4}, {plain, 0.5, 6}, {plain, 0.125, 7}, {back, 1.5, 4}, {back, 0.5, 2}};
  for (const Pose& pose_a : {Pose(Pose::Identity()), mirrored(turnedAndMoved(1, 3, -2))})
    for (const auto& [a, x, edge] : table) {
      const Pose pose_b = pose_a * turnedAndMoved(0, x, 2.5);
      const DistanceResult found = distance(a, pose_a, wedge, pose_b);
      EXPECT_EQ(found.edge_a, edge) << x;
      EXPECT_TRUE(found.edge_b == 0 || found.edge_b == 1);
      EXPECT_EQ(distance(wedge, pose_b, a, pose_a).edge_b, edge);
    }
}

/// As every ring of WKT and GeoJSON is closed.
TEST(Distance, NamesEdgesWithLengthOfAClosedRing) {
  const Polygon l({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}}});
  const DistanceResult nearest = distance(l, at(0, 0), l, at(-2, -2.5));
  EXPECT_DOUBLE_EQ(nearest.distance, std::hypot(1, 0.5));
  EXPECT_NE(nearest.edge_a, 6);
  EXPECT_NE(nearest.edge_b, 6);
  EXPECT_EQ(nearest.point_a, Vec2(0, 0));
  const DistanceResult of_point =
      distance(Polygon::point({1, 2}), at(0, 0), Polygon({rectangle(3, 1, 4, 3)}), at(0, 0));
  EXPECT_EQ(of_point.distance, 2);
  EXPECT_GE(of_point.edge_a, 0);
  EXPECT_LT(of_point.edge_a, 3);
}

constexpr double kErrors[] = {1e-2, 1e-6, 1e-9, 1e-12};

Motion still(double x, double y) { return Motion::still(at(x, y)); }
Motion slide(double x, double y, const Vec2& shift) { return Motion::translation(at(x, y), shift); }

LeastDistanceOptions within(double error, double margin = 0) {
  LeastDistanceOptions options;
  options.absolute_error = error;
  options.margin = margin;
  return options;
}

void expectLeast(const LeastDistance& found, double truth, double error) {
  EXPECT_FALSE(found.budget_ended);
  EXPECT_LE(found.lower_bound, truth + 1e-12);
  EXPECT_GE(found.distance, truth - 1e-14);
  EXPECT_LE(found.distance, truth + error + 1e-12);
  EXPECT_LE(found.distance - found.lower_bound, error + 1e-12);
}

TEST(LeastDistance, OfABodyThatPasses) {
  const Polygon shelf = Polygon::box(2, 2), robot = Polygon::box(1, 1);
  const Motion passes = slide(-3, 3, {6, -1});
  for (const double error : kErrors) {
    SCOPED_TRACE(error);
    const LeastDistance found = leastDistance(shelf, still(0, 0), robot, passes, within(error));
    expectLeast(found, 4.5 / std::sqrt(37), error);
    const auto there = distance(shelf, tricover::poseAt(0, 0), robot, passes.at(found.time));
    EXPECT_EQ(std::tie(found.distance, found.edge_a, found.edge_b),
              std::tie(there.distance, there.edge_a, there.edge_b));
    EXPECT_TRUE(found.point_a == there.point_a && found.point_b == there.point_b);
    expectLeast(leastDistance(robot, passes, shelf, still(0, 0), within(error, 0.5)), 4.5 / std::sqrt(37) - 0.5, error);
  }
}

TEST(LeastDistance, IsNothingWhereTheyMeet) {
  const Polygon square = Polygon::box(1, 1);
  for (const Vec2& way : {Vec2(9, 0), Vec2(4, 0), Vec2(1, 0.75)}) {
    const LeastDistance found = leastDistance(square, still(0, 0), square, slide(-5, 0, way), within(1e-9, 3));
    EXPECT_EQ(found.distance, 0);
    EXPECT_EQ(found.lower_bound, 0);
    EXPECT_LE(distance(square, tricover::poseAt(0, 0), square, slide(-5, 0, way).at(found.time)).distance, 3 + 1e-12);
  }
  // Found by `soak impact --seed 77 --case 776`: at the end they are nearer to each other than the error.
  EXPECT_EQ(leastDistance(square, still(0, 0), square, slide(-5, 0, {6.125, 0}), within(0.5)).distance, 0);
  // They only touch, in passing.
  EXPECT_EQ(leastDistance(square, still(0, 0), square, slide(-5, 1, {10, 0})).distance, 0);
  EXPECT_EQ(leastDistance(square, still(0, 0), square, slide(-2, 0, {2, 2}), within(1e-9)).distance, 0);
}

/// Bodies that stay as far apart for all of the time.
TEST(LeastDistance, OfConstantGaps) {
  const Polygon floor = Polygon::box(20, 1), crate = Polygon::box(1, 1);
  Motion a = still(0, 0), b = still(-2, 1.25);
  a.angle = b.angle = 3;
  b.pivot = Vec2(2, -1.25);
  std::vector<TimedPose> waypoints;
  for (int i = 0; i <= 60; ++i) waypoints.push_back({static_cast<double>(i), tricover::poseAt(-9 + 0.3 * i, 1.25)});
  const Trajectory rests({{0, 60, still(0, 0)}}), slides = Trajectory::through(waypoints);
  const std::pair<Motion, Motion> motions[] = {
      {still(0, 0), slide(-5, 1.25, {10, 0})},
      {slide(0, 0, {3, 1}), slide(-2, 1.25, {3, 1})},
      {a, b},
      {still(0, 0), Motion::spline({{-5, 1.25}, 0, {6, 0}, 0}, {{5, 1.25}, 0, {8, 0}, 0})}};
  for (const double error : kErrors)
    for (const double margin : {0.0, 0.125}) {
      SCOPED_TRACE(error);
      const LeastDistanceOptions options = within(error, margin);
      for (const auto& [of_floor, of_crate] : motions)
        expectLeast(leastDistance(floor, of_floor, crate, of_crate, options), 0.25 - margin, error);
      expectLeast(leastDistance(floor, rests, crate, slides, options), 0.25 - margin, error);
    }
}

TEST(LeastDistance, ErrorsBelowRoundingEnd) {
  const Polygon shelf = Polygon::box(2, 2), robot = Polygon::box(1, 1);
  Motion turns = slide(-3, 3, {6, -1});
  turns.angle = 2;
  for (const double error : {1e-15, 1e-18, 1e-300, 5e-324}) {
    const LeastDistance found = leastDistance(shelf, still(0, 0), robot, turns, within(error));
    expectLeast(found, leastDistance(shelf, still(0, 0), robot, turns, within(1e-12)).distance, 1e-12);
  }
}

TEST(LeastDistance, TimesAreTheTrajectorys) {
  const Polygon post = Polygon::box(1, 1), robot = Polygon::box(1, 1);
  const Trajectory rests({{0, 100, still(0, 0)}});
  const Trajectory passes = Trajectory::through({{10, tricover::poseAt(-8, 2)}, {20, tricover::poseAt(8, 2)}});
  const LeastDistance found = leastDistance(post, rests, robot, passes);
  expectLeast(found, 1, 1e-6);
  EXPECT_GE(found.time, 14.3);
  EXPECT_LE(found.time, 15.7);
  // It rests where it begins: at times that the other one begins earlier, too.
  const Trajectory comes({{10, 20, slide(3, 0, {5, 0})}});
  EXPECT_EQ(leastDistance(post, rests, robot, comes).distance, 2);
  // Both are there from 12 to 15, when the second is farther away.
  const Trajectory later({{12, 15, still(0, 0)}});
  const Trajectory appears = later.appearing().vanishing();
  const LeastDistance there = leastDistance(post, appears, robot, comes);
  EXPECT_EQ(there.distance, distance(post, tricover::poseAt(0, 0), robot, comes.at(12)).distance);
  EXPECT_EQ(there.time, 12);
  const Trajectory never({{30, 40, still(0, 0)}});
  EXPECT_NE(refusal([&] { leastDistance(post, never.appearing(), robot, comes.vanishing()); }).find("never there"),
            std::string::npos);
  // They are there together for an instant.
  const Trajectory at_once({{20, 30, still(0, 0)}});
  EXPECT_EQ(leastDistance(post, at_once.appearing(), robot, comes.vanishing()).distance, 7);
}

/// As timeOfImpact() and conflicts() say at the one instant at which both are there.
TEST(LeastDistance, AgreesAtAnInstant) {
  const Polygon body = Polygon::box(1, 1);
  for (const double apart : {0.0, 1.0, 1.5}) {
    const Trajectory first({{0, 10, slide(0, 0, {10, 0})}}), then({{10, 20, slide(10 + apart, 0, {5, 0})}});
    const Trajectory leaves = first.vanishing(), appears = then.appearing();
    const double least = leastDistance(body, leaves, body, appears).distance;
    EXPECT_EQ(least, std::max(apart - 1, 0.0));
    for (const double time_error : {0.0, 1e-6})
      for (const bool ignores : {false, true}) {
        const ImpactOptions options{0, time_error, ignores};
        const auto impact = timeOfImpact(body, leaves, body, appears, options);
        const auto all = conflicts(body, leaves, body, appears, options);
        ASSERT_EQ(impact.has_value(), least == 0 && !ignores);
        ASSERT_EQ(all.size(), impact.has_value() ? 1u : 0u);
        if (!impact) continue;
        EXPECT_EQ(impact->time, 10);
        EXPECT_EQ(all[0].impact.time, 10);
        EXPECT_EQ(all[0].end, 10);
        EXPECT_FALSE(all[0].budget_ended);
      }
  }
}

TEST(LeastDistance, LengthsThatOverflowEnd) {
  const Polygon post = Polygon::box(1e307, 1e307);
  const LeastDistance found = leastDistance(post, still(-1.2e308, 0), post, slide(1.2e308, 0, {0, 1e307}));
  EXPECT_GT(found.distance, 1e308);
  EXPECT_LE(found.lower_bound, found.distance);
}

TEST(LeastDistance, RefusesBadOptions) {
  const Polygon square = Polygon::box(1, 1);
  const auto refused = [&](const LeastDistanceOptions& options) {
    return refusal([&] { leastDistance(square, still(0, 0), square, still(3, 0), options); });
  };
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(refused(within(1e-6, bad)).find("margin"), std::string::npos);
    EXPECT_NE(refused(within(bad)).find("absolute_error"), std::string::npos);
  }
  EXPECT_NE(refused(within(0)).find("absolute_error"), std::string::npos);
  Motion far = still(0, 0);
  far.shift.x() = std::nan("");
  EXPECT_NE(refusal([&] { leastDistance(square, far, square, still(0, 0)); }).find("motion_a"), std::string::npos);
}

}  // namespace
}  // namespace tricover::support
