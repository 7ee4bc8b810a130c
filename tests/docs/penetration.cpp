// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/penetration.h"

#include <gtest/gtest.h>

#include <optional>

#include "tricover/collide.h"
#include "tricover/polygon.h"
#include "tricover/signed_distance.h"

namespace {

TEST(Documentation, Penetration) {
  //! [penetration]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const tricover::Pose still = tricover::Pose::Identity();
  tricover::Pose pose = still;
  pose.translation() << 3, 1;
  const std::optional<tricover::Penetration> way = tricover::penetration(square, still, square, pose);
  ASSERT_TRUE(way.has_value());
  EXPECT_NEAR(way->depth, 1, 1e-12);
  EXPECT_NEAR(way->normal.x(), 1, 1e-12);

  pose.translation() += way->translation;  // proven to part them
  EXPECT_FALSE(tricover::collide(square, still, square, pose));
  EXPECT_FALSE(tricover::penetration(square, still, square, pose).has_value());

  pose.translation() << 4, 1;  // beside it
  tricover::PenetrationOptions inner;
  inner.touching = tricover::Touching::Allowed;
  EXPECT_EQ(tricover::penetration(square, still, square, pose)->depth, 0);
  EXPECT_FALSE(tricover::penetration(square, still, square, pose, inner).has_value());
  //! [penetration]
}

TEST(Documentation, SignedDistance) {
  //! [signed distance]
  const tricover::Polygon square = tricover::Polygon::box(4, 4);
  const tricover::SignedDistance apart =
      tricover::signedDistance(square, tricover::poseAt(0, 0), square, tricover::poseAt(5, 0));
  EXPECT_EQ(apart.distance, 1);
  EXPECT_EQ(apart.normal, tricover::Vec2(1, 0));
  const tricover::SignedDistance deep =
      tricover::signedDistance(square, tricover::poseAt(0, 0), square, tricover::poseAt(3, 0));
  EXPECT_NEAR(deep.distance, -1, 1e-12);
  EXPECT_NEAR(deep.normal.x(), 1, 1e-12);
  //! [signed distance]
}

TEST(Documentation, PenetrationWithCache) {
  //! [penetration with cache]
  const tricover::Polygon angle({{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}});
  const tricover::Pose still = tricover::Pose::Identity();
  tricover::PairCache cache;  // one a pair
  for (int step = 0; step < 10; ++step) {
    tricover::Pose pose = still;
    pose.translation() << 0.25, 0.5 + 0.01 * step;
    const auto way = tricover::penetration(angle, still, angle, pose, cache);
    EXPECT_NEAR(way->depth, tricover::penetration(angle, still, angle, pose)->depth, 1e-12);
  }
  //! [penetration with cache]
}

}  // namespace
