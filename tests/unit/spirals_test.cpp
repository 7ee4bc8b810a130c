// SPDX-License-Identifier: BSD-3-Clause
// Rings whose long edges lie beside each other, but far apart along the ring, so that boxes around chains overlap much.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "growth_inputs.h"
#include "numbers/segment.h"
#include "random.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/time_of_impact.h"

namespace tricover::support {
namespace {

double signOfTurn(const Vec2& p, const Vec2& q, const Vec2& r) { return detail::cross(q - p, r - p); }

/// In plain doubles, all pairs: the least distance of two edges, 0 where they cross.
double leastDistance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const Pose to_a = pose_a.inverse() * pose_b;
  double least = std::numeric_limits<double>::infinity();
  for (EdgeIndex j = 0; j < b.edgeCount(); ++j) {
    const Vec2 r = to_a * b.edgeStart(j), s = to_a * b.edgeEnd(j);
    for (EdgeIndex i = 0; i < a.edgeCount(); ++i) {
      const Vec2 p = a.edgeStart(i), q = a.edgeEnd(i);
      const Vec2 gap = p.cwiseMin(q).cwiseMax(r.cwiseMin(s)) - p.cwiseMax(q).cwiseMin(r.cwiseMax(s));  // of their boxes
      if (gap.maxCoeff() > least) continue;
      if (signOfTurn(p, q, r) * signOfTurn(p, q, s) < 0 && signOfTurn(r, s, p) * signOfTurn(r, s, q) < 0) return 0;
      for (const Vec2& end : {r, s}) least = std::min(least, (end - detail::nearestOnSegment(end, p, q)).norm());
      for (const Vec2& end : {p, q}) least = std::min(least, (end - detail::nearestOnSegment(end, r, s)).norm());
    }
  }
  return least;
}

/// Whether they collide. None of them contains the other.
bool expectAllQueriesRight(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const double truth = leastDistance(a, pose_a, b, pose_b);
  EXPECT_TRUE(truth == 0 || truth > 1e-9) << "too near for plain doubles";
  const bool hit = truth == 0;
  EXPECT_EQ(collide(a, pose_a, b, pose_b), hit);
  EXPECT_EQ(collide(b, pose_b, a, pose_a), hit);
  EXPECT_EQ(!contacts(a, pose_a, b, pose_b, {0, 1}).empty(), hit);
  EXPECT_NEAR(distance(a, pose_a, b, pose_b).distance, truth, 1e-10);
  for (const double share : {0.9, 1.1}) {
    EXPECT_EQ(collide(a, pose_a, b, pose_b, CollideOptions{share * truth, 0}), hit || share > 1) << share;
    if (hit) continue;
    EXPECT_FALSE(collide(a, pose_a, b, pose_b, CollideOptions{0.5 * truth, 0.1 * truth})) << "near isn't within that";
  }
  return hit;
}

TEST(Spirals, AnswerAsAllPairsDo) {
  const growth::Input in = growth::coarseSpirals(2 * static_cast<std::size_t>(scaledCount(2500, 250)));
  int hits = 0, asked = 0;
  for (const double x : {0.0, 0.7, 1.1})
    for (const double angle : {0.0, 0.001}) {
      Pose turned = in.motion.start;
      turned.translation().x() += x;
      hits += expectAllQueriesRight(in.a, Pose::Identity(), in.b, turned * turnedAndMoved(angle, 0, 0)) ? 1 : 0;
      ++asked;
    }
  EXPECT_GT(hits, 0);
  EXPECT_LT(hits, asked);
  const auto impact =
      timeOfImpact(in.a, Motion::still(Pose::Identity()), in.b, Motion::translation(in.motion.start, Vec2(2, 0)));
  ASSERT_TRUE(impact);
  EXPECT_GT(impact->time, 0.4);
  EXPECT_LT(impact->time, 0.6);
  EXPECT_NEAR(
      leastDistance(in.a, Pose::Identity(), in.b, Motion::translation(in.motion.start, Vec2(2, 0)).at(impact->time)), 0,
      2e-6 * 2);
}

/// Robots wider than a band, so that no spiral contains them, at places between the turns and on them.
TEST(Spirals, AnswerForWhatIsAmongTheirTurns) {
  const Polygon spiral = growth::coarseSpirals(5000).a;
  Random random(32);
  int hits = 0;
  const int asked = scaledCount(40, 12);
  for (int i = 0; i < asked; ++i) {
    const Polygon robot({star(random, 12, 0.7, 1.2)});
    const Pose somewhere = turnedAndMoved(random.real(0, 6), random.real(-100, 100), random.real(-100, 100));
    hits += expectAllQueriesRight(spiral, Pose::Identity(), robot, somewhere) ? 1 : 0;
  }
  EXPECT_GT(hits, asked / 4);
  EXPECT_LT(hits, asked);
}

}  // namespace
}  // namespace tricover::support
