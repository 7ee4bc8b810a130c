// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/penetration.h"

#include <gtest/gtest.h>

#include <optional>

#include "tricover/collide.h"

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

}  // namespace
