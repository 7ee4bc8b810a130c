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
        shape_(Polygon({ring_}), {0, -half_height_, half_height_}),
        prism_(tricover::support::makePrism(ring_, half_height_)),
        body_(solid<double>(random.integer(0, 6), [&random] { return random.real(0.2, 2); })),
        tf_shape_(anywhere(random, 1.5)),
        tf_body_(anywhere(random, 1.5)) {}

  void ask(Tally& tally) const {
    fcl::DistanceResultd found;
    if (!count(tally, tf_body_, found)) return;
    const Vec3 way = found.nearest_points[0] - found.nearest_points[1];
    for (const double step : {-1e-3, -1e-5, 1e-5, 1e-3}) {
      Transform nearer = tf_body_;
      nearer.translation() += (1 + step / found.min_distance) * way;
      fcl::DistanceResultd again;
      count(tally, nearer, again);
    }
  }

 private:
  /// Whether GJK calls them apart.
  bool count(Tally& tally, const Transform& tf_body, fcl::DistanceResultd& found) const {
    fcl::DistanceRequestd request;
    request.enable_nearest_points = true;
    request.distance_tolerance = 1e-9;
    const bool apart = fcl::distance<double>(prism_.get(), tf_shape_, body_.get(), tf_body, request, found) > 0;
    const bool hit = collides(shape_, tf_shape_, body_, tf_body);
    ++tally.cases;
    tally.hits += hit;
    tally.misses += !hit && !apart;
    if (hit && apart) {
      ++tally.alarms;
      tally.widest = std::max(tally.widest, found.min_distance);
    }
    return apart;
  }

  Ring ring_;
  double half_height_;
  PolygonShaped shape_;
  std::shared_ptr<fcl::Convexd> prism_;
  Geometry<double> body_;
  Transform tf_shape_, tf_body_;
};

TEST(MixedPrism, agreesWithGjk) {
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

TEST(MixedPrism, spheresMeetItAsTheirCentresDistanceSays) {
  int hits = 0, cases = 0;
  for (int i = 0; i < scaledCount(2000); ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon polygon = randomPolygon(random, 1);
    const PolygonOptions options{0, -0.3, 0.5};
    const Shape<double> shape = shapeOf(polygon, options);
    const Vec3 center(random.real(-2, 2), random.real(-2, 2), random.real(-1, 1));
    const Vec2 below = center.head<2>();
    const double planar =
        tricover::distance(polygon, Pose::Identity(), Polygon({{below, below, below}}), Pose::Identity()).distance;
    const double distance =
        std::hypot(planar, std::max({options.z_low - center.z(), center.z() - options.z_high, 0.0}));
    if (distance < 0.1) continue;
    const Transform moved = anywhere(random, 5);
    for (const double step : {-1e-3, -3e-9, 3e-9, 1e-3}) {
      const fcl::Sphered sphere(distance + step);
      const Transform at = moved * shifted(center.x(), center.y(), center.z());
      const bool hit = meet(sphere, at, shape, moved);
      EXPECT_EQ(hit, step > 0) << i << " " << step;
      hits += hit;
      ++cases;
    }
  }
  EXPECT_EQ(2 * hits, cases);
  EXPECT_GT(cases, scaledCount(2000));
}

}  // namespace
}  // namespace tricover_fcl::test
