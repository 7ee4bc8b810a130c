// SPDX-License-Identifier: BSD-3-Clause
// A polygon with heights is a prism, which FCL's own GJK knows as an fcl::Convex: the same questions to both, with the
// prism and the other body in any pose. What is flat is between thin prisms.
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mixed_scene.h"
#include "prism.h"
#include "tricover/distance.h"

namespace tricover_fcl::test {
namespace {

using Vec3 = fcl::Vector3<double>;

Geometry<double> randomBody(Random& random) {
  const auto length = [&random] { return random.real(0.2, 2); };
  switch (random.integer(0, 6)) {
    case 0:
      return std::make_shared<fcl::Boxd>(length(), length(), length());
    case 1:
      return std::make_shared<fcl::Sphered>(length());
    case 2:
      return std::make_shared<fcl::Ellipsoidd>(length(), length(), length());
    case 3:
      return std::make_shared<fcl::Capsuled>(length(), length());
    case 4:
      return std::make_shared<fcl::Coned>(length(), length());
    case 5:
      return std::make_shared<fcl::Cylinderd>(length(), length());
    default:
      return tetrahedron<double>(length(), length(), length());
  }
}

fcl::Transform3d anywhere(Random& random, double reach) {
  const Vec3 axis(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
  const Vec3 at(random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach));
  return placed<double>(at, turned(random.real(0, 6), axis));
}

struct Tally {
  int cases = 0, hits = 0, misses = 0, alarms = 0;
  double widest = 0;  ///< of what GJK takes for the distance in an alarm
};

/// One pair, asked at random and then close to where it touches.
class CrossCheck {
 public:
  explicit CrossCheck(Random& random)
      : ring_(regular(random.integer(3, 9), random.real(0.3, 2))),
        half_height_(random.real(0.05, 1)),
        shape_(tricover::Polygon({ring_}), heights(half_height_)),
        prism_(tricover::support::makePrism(ring_, half_height_)),
        body_(randomBody(random)),
        tf_shape_(anywhere(random, 1.5)),
        tf_body_(anywhere(random, 1.5)) {}

  void ask(Tally& tally) const {
    fcl::DistanceResultd found;
    if (!count(tally, tf_body_, found)) return;
    const Vec3 way = found.nearest_points[0] - found.nearest_points[1];
    for (const double step : {-1e-3, -1e-5, 1e-5, 1e-3}) {
      fcl::Transform3d nearer = tf_body_;
      nearer.translation() += (1 + step / found.min_distance) * way;
      fcl::DistanceResultd again;
      count(tally, nearer, again);
    }
  }

 private:
  static PolygonOptions heights(double half_height) {
    PolygonOptions options;
    options.z_low = -half_height;
    options.z_high = half_height;
    return options;
  }

  /// Whether GJK calls them apart.
  bool count(Tally& tally, const fcl::Transform3d& tf_body, fcl::DistanceResultd& found) const {
    fcl::DistanceRequestd request;
    request.enable_nearest_points = true;
    request.distance_tolerance = 1e-9;
    const bool apart = fcl::distance<double>(prism_.get(), tf_shape_, body_.get(), tf_body, request, found) > 0;
    fcl::CollisionResultd result;
    const bool hit =
        fcl::collide<double>(&shape_, tf_shape_, body_.get(), tf_body, fcl::CollisionRequestd(), result) > 0;
    ++tally.cases;
    tally.hits += hit;
    tally.misses += !hit && !apart;
    if (hit && apart) {
      ++tally.alarms;
      tally.widest = std::max(tally.widest, found.min_distance);
    }
    return apart;
  }

  tricover::Ring ring_;
  double half_height_;
  PolygonShaped shape_;
  std::shared_ptr<fcl::Convexd> prism_;
  Geometry<double> body_;
  fcl::Transform3d tf_shape_, tf_body_;
};

TEST(MixedPrism, agreesWithGjk) {
  registerNarrowphase();
  Tally tally;
  for (int i = 0; i < scaledCount(20000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    CrossCheck(random).ask(tally);
  }
  std::printf(
      "%d cases, %d hits; misses that GJK calls collisions: %d; hits that it calls apart: %d (by %.1e at most)\n",
      tally.cases, tally.hits, tally.misses, tally.alarms, tally.widest);
  EXPECT_GT(tally.hits, tally.cases * 3 / 10);
  EXPECT_LT(tally.hits, tally.cases * 7 / 10);
  EXPECT_EQ(tally.misses, 0);
  EXPECT_LT(tally.widest, 3e-4);  // a round body's outline stands at most 1e-4 of its size off
}

/// Level balls are placed without a look at their whole pose, which the kernel sees a part of.
TEST(MixedPrism, posesOfBallsAreCheckedAndNamed) {
  registerNarrowphase();
  const PolygonShaped shape(tricover::Polygon({{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}), {0, -1, 1});
  const fcl::Sphered ball(1);
  const fcl::Transform3d good = fcl::Transform3d::Identity();
  const auto refusals = [&](const fcl::Transform3d& of_shape, const fcl::Transform3d& of_ball) {
    int named = 0;
    const fcl::CollisionRequestd request;
    for (const bool swapped : {false, true}) {
      const bool is_shape_bad = &of_shape != &good;
      const auto refused = [&](auto ask) {
        const std::string name = is_shape_bad == swapped ? "pose_b" : "pose_a";
        named += thrownBy<std::invalid_argument>(ask).find(name) != std::string::npos;
      };
      refused([&] {
        fcl::CollisionResultd result;
        swapped ? fcl::collide<double>(&ball, of_ball, &shape, of_shape, request, result)
                : fcl::collide<double>(&shape, of_shape, &ball, of_ball, request, result);
      });
      refused([&] {
        fcl::DistanceResultd result;
        swapped ? fcl::distance<double>(&ball, of_ball, &shape, of_shape, fcl::DistanceRequestd(), result)
                : fcl::distance<double>(&shape, of_shape, &ball, of_ball, fcl::DistanceRequestd(), result);
      });
    }
    return named;
  };
  EXPECT_EQ(refusals(good, good), 0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      fcl::Transform3d bad = good;
      bad.matrix()(row, column) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_EQ(refusals(good, bad), 4) << row << column;
      EXPECT_EQ(refusals(bad, good), 4) << row << column;
      if (column == 3) continue;
      for (const double off : {1.1 * tricover::kRigidTolerance, 0.5}) {
        bad = good;
        bad.matrix()(row, column) += off;
        EXPECT_EQ(refusals(good, bad), 4) << row << column;
        EXPECT_EQ(refusals(bad, good), 4) << row << column;
      }
    }
  }
}

TEST(MixedPrism, spheresMeetItAsTheirCentresDistanceSays) {
  registerNarrowphase();
  int hits = 0, cases = 0;
  for (int i = 0; i < scaledCount(2000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const tricover::Polygon polygon = randomPolygon(random, 1);
    PolygonOptions options;
    options.z_low = -0.3;
    options.z_high = 0.5;
    const PolygonShaped shape(polygon, options);
    const Vec3 center(random.real(-2, 2), random.real(-2, 2), random.real(-1, 1));
    const tricover::Vec2 below = center.head<2>();
    const double planar = tricover::distance(polygon, tricover::Pose::Identity(),
                                             tricover::Polygon({{below, below, below}}), tricover::Pose::Identity())
                              .distance;
    const double distance =
        std::hypot(planar, std::max({options.z_low - center.z(), center.z() - options.z_high, 0.0}));
    if (distance < 0.1) continue;
    const fcl::Transform3d moved = anywhere(random, 5);
    for (const double step : {-1e-3, -3e-9, 3e-9, 1e-3}) {
      const fcl::Sphered sphere(distance + step);
      const fcl::Transform3d at = moved * shifted<double>(center.x(), center.y(), center.z());
      const bool hit = meet<double>(sphere, at, shape, moved);
      EXPECT_EQ(hit, step > 0) << i << " " << step;
      hits += hit;
      ++cases;
    }
  }
  EXPECT_EQ(2 * hits, cases);
  EXPECT_GT(cases, scaledCount(2000));
}

TEST(MixedPrism, heightsReachAboveAndBelow) {
  PolygonOptions options;
  options.z_low = 1;
  options.z_high = 3;
  const PolygonShaped shape(tricover::Polygon({rectangle(-1, -1, 1, 1)}), options);
  const fcl::Sphered sphere(0.5);
  const auto meets = [&](const fcl::CollisionGeometryd& other, double x, double z) {
    return meet<double>(shape, fcl::Transform3d::Identity(), other, shifted<double>(x, 0, z));
  };
  for (const double x : {0.0, 1.0}) {
    EXPECT_FALSE(meets(sphere, x, 0.5 - 1e-8));
    EXPECT_TRUE(meets(sphere, x, 0.5 + 1e-8));
    EXPECT_TRUE(meets(sphere, x, 3.5 - 1e-8));
    EXPECT_FALSE(meets(sphere, x, 3.5 + 1e-8));
  }
  EXPECT_TRUE(meets(sphere, 1.5 - 1e-8, 2));
  EXPECT_FALSE(meets(sphere, 1.5 + 1e-8, 2));
  // Beside the upper edge the nearest is on the rim.
  const double reach = 1 + std::sqrt(0.25 - 0.09);
  EXPECT_TRUE(meets(sphere, reach - 1e-8, 3.3));
  EXPECT_FALSE(meets(sphere, reach + 1e-8, 3.3));
  EXPECT_FALSE(meets(fcl::Halfspaced(0, 0, 1, 1 - 1e-9), 0, 0));
  EXPECT_TRUE(meets(fcl::Halfspaced(0, 0, 1, 1), 0, 0));
  EXPECT_TRUE(meets(fcl::Planed(0, 0, 1, 2), 0, 0));
  EXPECT_FALSE(meets(fcl::Planed(0, 0, 1, 3 + 1e-9), 0, 0));
  EXPECT_TRUE(meets(*octree<double>(), -1.2, 0.6));
  EXPECT_FALSE(meets(*octree<double>(), -1.2, 0.4));
  EXPECT_TRUE(meets(*boxMesh<fcl::RSSd>({0.5, 0.5, 5}), 0, 0));  // its sides pass through
}

}  // namespace
}  // namespace tricover_fcl::test
