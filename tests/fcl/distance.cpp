// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/distance.h"

#include <algorithm>
#include <cmath>

#include "ask.h"
#include "tricover/penetration.h"
#include "tricover/polygon.h"

namespace tricover_fcl::test {
namespace {

fcl::DistanceRequestd requestFor(fcl::GJKSolverType solver) {
  fcl::DistanceRequestd request;
  request.gjk_solver_type = solver;
  return request;
}

/// At this x, the other way up.
Transform placedUpsideDown(double x) {
  Transform pose = lifted(0, x, 0);
  pose.matrix()(2, 2) = -1;
  return pose;
}

/// What isn't a number isn't looked at.
struct Row {
  const char* what;
  Shape<double> a;
  Transform tf_a;
  Shape<double> b;
  Transform tf_b;
  double distance, with_sign;
  Vec3 on_a = {kNaN, kNaN, kNaN}, on_b = on_a;  ///< of an overlap: the way out's ends
  double error = 0;                             ///< of points
};

void expectPoint(const Vec3& point, const Vec3& expected, double error) {
  EXPECT_TRUE(point.allFinite());
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isnan(expected[axis])) continue;
    EXPECT_NEAR(point[axis], expected[axis], error) << axis;
  }
}

void expectRow(const Row& row) {
  SCOPED_TRACE(row.what);
  for (const fcl::GJKSolverType solver : kSolvers) {
    for (const bool swapped : {false, true}) {
      const auto ask = [&](bool is_signed) {
        return swapped ? distanceOf(solver, is_signed, row.b, row.tf_b, row.a, row.tf_a)
                       : distanceOf(solver, is_signed, row.a, row.tf_a, row.b, row.tf_b);
      };
      const auto found = ask(false);
      EXPECT_EQ(found.min_distance, row.distance);
      const Vec3 &on_a = found.nearest_points[swapped], &on_b = found.nearest_points[!swapped];
      if (row.distance >= 0) {
        expectPoint(on_a, row.on_a, row.error);
        expectPoint(on_b, row.on_b, row.error);
        EXPECT_NEAR((on_a - on_b).stableNorm(), row.distance, row.error);
        EXPECT_TRUE(row.distance > 0 || on_a == on_b);
      } else {  // a point that both have
        EXPECT_EQ(on_a, on_b);
        EXPECT_FALSE(on_a.x() < row.on_b.x() - row.error || on_a.x() > row.on_a.x() + row.error) << on_a.x();
      }
      if (std::isnan(row.with_sign)) continue;
      const auto depth = ask(true);
      EXPECT_NEAR(depth.min_distance, row.with_sign, row.distance < 0 ? 1e-12 : 0);
      EXPECT_EQ(depth.min_distance < 0, row.distance < 0);
      EXPECT_TRUE(row.distance != 0 || depth.nearest_points[0] == depth.nearest_points[1]);
      if (row.distance < 0 && solver == fcl::GST_INDEP) continue;  // puts their middle in place of both
      expectPoint(depth.nearest_points[swapped], row.on_a, row.error);
      expectPoint(depth.nearest_points[!swapped], row.on_b, row.error);
    }
  }
}

TEST(Distance, andNearestPoints) {
  const Polygon unit({rectangle(0, 0, 1, 1)});
  const auto prism = [&](double low, double high) { return shapeOf(unit, {0, low, high}); };
  const auto disc = [](double margin, double low, double high) {
    return shapeOf(tricover::Polygon::point({0, 0}), {margin, low, high});
  };
  const auto at = [](double x, double z = 0) { return lifted(0, x, 0, z); };
  const auto x = [](double value) { return Vec3(value, kNaN, kNaN); };
  const auto z = [](double value) { return Vec3(kNaN, kNaN, value); };
  const Shape<double> square = shapeOf(unit), slab = prism(0, 1), half = withMargin(unit, 0.5),
                      one = withMargin(unit, 1), two = withMargin(unit, 2), less = withMargin(unit, -0.5),
                      more = withMargin(unit, 1.5);
  const Transform below = placedUpsideDown(5);
  const double up = nudged(1, 1), down = nudged(1, -1), sum = 0.1 + 0.2, tiny = sum - 0.2 - 0.1;
  std::vector<Row> rows = {
      {"touching", square, kHere, square, at(1), 0, 0, x(1), x(1), 1e-12},
      {"apart by a bit", square, kHere, square, at(up), up - 1, up - 1, x(1), x(1), 1e-12},
      {"overlapping by a bit", square, kHere, square, at(down), -1, down - 1, x(1), x(1), 1e-12},
      {"3 along x, 4 along z", slab, kHere, slab, at(4, 5), 5, 5, {1, kNaN, 1}, {4, kNaN, 5}},
      {"above", slab, at(0.5, 5), slab, kHere, 4, 4, z(5), z(1)},
      {"beside", slab, kHere, slab, at(4, 0.5), 3, 3, z(0.75), z(0.75)},
      {"a gap that only exact sums see", prism(0, 0.2), at(0, 0.1), square, at(0, sum), tiny, tiny, z(0.3), z(0.3),
       1e-15},
      {"margins apart", one, kHere, two, at(5), 1, 1, x(2), x(3)},
      {"margins touch", one, kHere, two, at(4), 0, 0, x(2), x(2), 1e-15},
      {"margins overlap", one, kHere, two, at(2.5), -1, -1.5, x(2), x(0.5), 1e-12},
      {"polygons overlap", one, kHere, two, at(0.75), -1, -3.25, x(2), x(-1.25), 1e-12},
      // Each margin's, though they add up to nothing; from 1 + 1.5 back to 1.5 + 0.5, where both are.
      {"margins of both signs", half, kHere, less, at(3), 2, 2, x(1.5), x(3.5)},
      {"they overlap", more, kHere, less, at(1.5), -1, -0.5, x(2.5), x(2), 1e-12},
      {"they touch", half, kHere, less, at(1), 0, 0, {kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}, 1e-15},
      {"discs", disc(2, -1, 1), kHere, disc(1, 1, 4), at(6, 4), 5, 5, {2, 0, 1}, {5, 0, 5}},
      {"upside down", disc(1, -9, -3), kHere, disc(1, 1, 4), below, 3, 3, {1, 0, -3.5}, {4, 0, -3.5}}};
  const Shape<double> planar = shapeOf(unit, PolygonOptions::atAllHeights());
  for (const double height : {0.0, 1e-9, -7.0, 1e300})
    rows.push_back({"all heights", planar, at(0, height), square, at(4, 3), 3, 3, z(3), z(3)});
  for (const Row& row : rows) expectRow(row);
}

/// Without margins, -1 says exactly that interiors meet: how little doesn't matter.
TEST(Distance, isMinusOneExactlyWhereInteriorsMeet) {
  const auto of = [](const Ring& ring) { return shapeOf(Polygon({ring})); };
  const Shape<double> left = of(rectangle(-1, -1, 0, 1)), right = of(rectangle(0, -1, 1, 1)),
                      diamond = of({{0, 0}, {1, 1}, {2, 0}, {1, -1}}), square = of(rectangle(-1, -1, 1, 1)),
                      frame = shapeOf(Polygon({rectangle(-3, -3, 3, 3), rectangle(-1, -1, 1, 1)})),
                      level = shapeOf(tricover::Polygon::segment({-1, 0}, {1, 0})),
                      upright = shapeOf(tricover::Polygon::segment({0, -1}, {0, 1})),
                      point = shapeOf(tricover::Polygon::point({0, 0}));
  const auto expect = [](const char* what, const Shape<double>& a, const Shape<double>& b, double x, double distance) {
    const Vec3 any = Vec3::Constant(kNaN);
    expectRow({what, a, kHere, b, lifted(0, x, 0), distance, kNaN, any, any, 1e-315});
  };
  for (const auto& beside : {right, diamond}) {
    expect("touch", left, beside, 0, 0);
    for (const double x : {-1e-17, -1e-300}) expect("overlap", left, beside, x, -1);
    expect("apart", left, beside, 1e-300, 1e-300);
  }
  expect("a square that fills a hole touches it all around", frame, square, 0, 0);
  expect("not there", frame, square, 1e-17, -1);
  // Segments and points have no interior. They overlap where they have a depth.
  expect("crossing segments", level, upright, 0, -1);
  expect("touching segments", shapeOf(tricover::Polygon::segment({-1, 0}, {0, 0})), upright, 0, 0);
  expect("a point within", left, point, -0.5, -1);
  expect("a point on an edge", left, point, 0, 0);
}

template <typename S>
void expectShortestWaysOut(std::uint64_t seed, int count, double reach, int least_hits, int most_hits) {
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    const Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const fcl::Transform3<S> tf_a = lifted<S>(randomPose(random, reach), 2),
                             tf_b = lifted<S>(randomPose(random, reach), 2);
    const Shape<S> shape_a = shapeOf<S>(a), shape_b = shapeOf<S>(b);
    const double truth = tricover::distance(a, flat(tf_a), b, flat(tf_b)).distance;
    const auto penetration = tricover::penetration(a, flat(tf_a), b, flat(tf_b));
    for (const fcl::GJKSolverType solver : kSolvers) {
      const auto result = distanceOf(solver, true, shape_a, tf_a, shape_b, tf_b);
      const S answer = result.min_distance;
      ASSERT_EQ(answer, static_cast<S>(penetration ? -penetration->depth : truth)) << i;
      ASSERT_EQ(distanceOf(solver, true, shape_b, tf_b, shape_a, tf_a).min_distance, answer) << i;
      fcl::DistanceRequest<S> request;
      request.gjk_solver_type = solver;
      request.enable_signed_distance = true;
      fcl::DistanceResult<S> ours;
      ASSERT_EQ(tricover_fcl::distance<S>(shape_b.get(), tf_b, shape_a.get(), tf_a, request, ours), answer) << i;
      if (!penetration || std::is_same_v<S, float>) continue;
      const Vec2 middle = (penetration->point_a + penetration->point_b) / 2;
      // INDEP asks collide again, and puts the contact's place in.
      const bool places = solver == fcl::GST_INDEP;
      const Vec3 on_a = result.nearest_points[0].template cast<double>(),
                 on_b = result.nearest_points[1].template cast<double>();
      ASSERT_NEAR((on_a.head<2>() - (places ? middle : penetration->point_a)).norm(), 0, 1e-15) << i;
      ASSERT_NEAR((on_b.head<2>() - (places ? middle : penetration->point_b)).norm(), 0, 1e-15) << i;
      ASSERT_EQ(on_a.z(), 2);
      const auto contacts = contactsOf(shapeOf(a), lifted(flat(tf_a)), shapeOf(b), lifted(flat(tf_b)), 1);
      ASSERT_EQ(contacts.at(0).penetration_depth, -answer);
    }
    hits += penetration.has_value();
  }
  EXPECT_GT(hits, least_hits);
  EXPECT_LT(hits, most_hits);
}

TEST(Distance, signedIsMinusTheShortestWayOut) {
  const int count = scaledCount(200), float_count = scaledCount(300);
  expectShortestWaysOut<double>(51, count, 1, count * 3 / 10, count);
  expectShortestWaysOut<float>(81, float_count, 2, float_count / 10, float_count * 9 / 10);
}

TEST(Distance, resultKeepsTheLeast) {
  const Shape<double> square = rectangular(0, 0, 1, 1);
  const Shape<double> other = shapeOf(Polygon({{{1, 1}, {0, 1}, {0, 0}, {1, 0}}}));  // other numbers of edges
  for (const fcl::GJKSolverType solver : kSolvers) {
    fcl::DistanceResultd result;
    const auto ask = [&](const Shape<double>& b, double x) {
      return fcl::distance(square.get(), kHere, b.get(), lifted(0, x, 0), requestFor(solver), result);
    };
    EXPECT_EQ(ask(square, 4), 3);
    const auto edge = result.b2;
    EXPECT_EQ(ask(other, 9), 3);
    EXPECT_EQ(ask(other, 4), 3);  // no nearer
    EXPECT_EQ(result.o2, square.get());
    EXPECT_EQ(result.b2, edge);
    EXPECT_EQ(ask(other, 3), 2);
    EXPECT_EQ(result.o2, other.get());
    EXPECT_EQ(result.nearest_points[1].x(), 3);
    expectOnEdge(*square, result.b1, result.nearest_points[0].head<2>());
    expectOnEdge(*other, result.b2, result.nearest_points[1].head<2>() - Vec2(3, 0));
    EXPECT_EQ(ask(square, 0.5), -1);
    EXPECT_EQ(result.o2, square.get());
    // Satisfied: not even the poses are looked at.
    Transform nowhere = kHere;
    nowhere.translation().x() = kNaN;
    EXPECT_EQ(fcl::distance(square.get(), nowhere, other.get(), nowhere, requestFor(solver), result), -1);
  }
}

TEST(Distance, errorsStayWithinWhatTheRequestAllows) {
  Random random(52);
  int inexact = 0, apart = 0;
  for (int i = 0; i < scaledCount(500); ++i) {
    const Polygon a = randomPolygon(random, 1), b = randomPolygon(random, 1);
    const Pose pose_a = randomPose(random, 1), pose_b = randomPose(random, 4);
    const double truth = tricover::distance(a, pose_a, b, pose_b).distance, z = random.coin() ? 0 : 1.5;
    fcl::DistanceRequestd request = requestFor(kSolvers[i % 2]);
    request.rel_err = 0.2;
    request.abs_err = 0.05;
    fcl::DistanceResultd result;
    const double answer =
        fcl::distance<double>(shapeOf(a).get(), lifted(pose_a), shapeOf(b).get(), lifted(pose_b, z), request, result);
    const double exact = std::hypot(truth, z);
    ASSERT_EQ(answer > 0, exact > 0);
    if (!(exact > 0)) continue;
    ASSERT_GE(answer, exact * (1 - 1e-14));
    ASSERT_LE(answer, exact * 1.2 + 0.05);
    inexact += answer > exact * (1 + 1e-12);
    ++apart;
  }
  EXPECT_GT(apart, 0);
  EXPECT_GT(inexact, 0);
}

TEST(Distance, signedOfWhatIsNotOccupiedDoesNotAbort) {
  const Shape<double> square = rectangular(0, 0, 1, 1);
  square->cost_density = 0.5;
  const auto ask = [&](fcl::GJKSolverType solver, double x) {
    return distanceOf(solver, true, *square, lifted(0, 0, 0), *square, lifted(0, x, 0)).min_distance;
  };
  EXPECT_NEAR(ask(fcl::GST_LIBCCD, 0.75), -0.25, 1e-12);
  EXPECT_THROW(ask(fcl::GST_INDEP, 0.75), std::logic_error);
  EXPECT_EQ(ask(fcl::GST_INDEP, 1.5), 0.5);
}

TEST(Distance, badPosesAndErrorsAreRefusedHoweverFarApart) {
  Transform scaled = lifted(0, 5, 0, 100), tilted(fcl::AngleAxis<double>(1, Vec3::UnitX()));
  scaled.matrix()(0, 0) = 2;
  for (const auto& shape : {rectangular(0, 0, 1, 1), shapeOf(tricover::Polygon::point({0, 0}), {1, -1, 1})}) {
    fcl::DistanceResultd result(1);  // nearer than these
    const auto ask = [&](const Transform& there, const fcl::DistanceRequestd& request) {
      fcl::distance(shape.get(), kHere, shape.get(), there, request, result);
    };
    for (const Transform& bad : {scaled, tilted}) expectRefused({"pose_b"}, [&] { ask(bad, fcl::DistanceRequestd()); });
    for (const auto& [relative, absolute] : {std::pair(-1.0, 0.0), {0.0, -1.0}, {kNaN, 0.0}, {0.0, kNaN}})
      expectRefused({}, [&, relative = relative, absolute = absolute] {
        ask(lifted(0, 5, 0), fcl::DistanceRequestd(false, false, relative, absolute));
      });
  }
}

}  // namespace
}  // namespace tricover_fcl::test
