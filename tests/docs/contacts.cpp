// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

TEST(Documentation, Contacts) {
  //! [contacts]
  const tricover::Polygon floor({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}});
  const tricover::Polygon table({{{0, 0}, {1, 0}, {1, 2}, {5, 2}, {5, 0}, {6, 0}, {6, 3}, {0, 3}}});  // two legs
  tricover::Pose sunk = tricover::Pose::Identity();
  sunk.translation() << 1, 0.5;
  const std::vector<tricover::Contact> found = tricover::contacts(floor, tricover::Pose::Identity(), table, sunk);
  ASSERT_EQ(found.size(), 2u);  // one for each part of the overlap
  for (const tricover::Contact& leg : found) {
    EXPECT_NEAR(leg.depth, 0.5, 1e-12);
    EXPECT_NEAR(leg.normal.y(), 1, 1e-12);  // up: from the floor towards where the table leaves it
  }
  //! [contacts]
}

TEST(Documentation, ContactsWithCache) {
  //! [contacts with cache]
  const tricover::Polygon floor({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}}), box({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::PairCache cache;  // one for each pair
  for (int step = 0; step < 100; ++step) {
    tricover::Pose sliding = tricover::Pose::Identity();
    sliding.translation() << 0.05 * step, 0.99;
    const std::vector<tricover::Contact> found =
        tricover::contacts(floor, tricover::Pose::Identity(), box, sliding, cache);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].depth, 0.01, 1e-12);
  }
  //! [contacts with cache]
}

TEST(Documentation, ContactsWithMargin) {
  //! [contacts with margin]
  const tricover::Polygon floor({{{0, 0}, {9, 0}, {9, 1}, {0, 1}}}), box({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  tricover::Pose above = tricover::Pose::Identity();
  above.translation() << 4, 1.25;
  const tricover::Pose still = tricover::Pose::Identity();
  EXPECT_TRUE(tricover::contacts(floor, still, box, above).empty());
  // Half a length of safety, of which a quarter is left.
  const std::vector<tricover::Contact> found = tricover::contacts(floor, still, box, above, {/*margin*/ 0.5});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.25, 1e-12);
  EXPECT_NEAR(found[0].normal.y(), 1, 1e-12);
  EXPECT_NEAR(found[0].point.y(), 1.125, 1e-12);  // in the middle of the gap
  //! [contacts with margin]
}

TEST(Documentation, Crossings) {
  //! [crossings]
  const tricover::Polygon square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  tricover::Pose shifted = tricover::Pose::Identity();
  shifted.translation() << 1, 1;
  const std::vector<tricover::Crossing> found =
      tricover::crossings(square, tricover::Pose::Identity(), square, shifted);
  ASSERT_EQ(found.size(), 2u);
  for (const tricover::Crossing& crossing : found) EXPECT_NEAR(crossing.point.sum(), 5, 1e-12);  // (4, 1) and (1, 4)

  shifted.translation() << 4, 1;  // beside it: edges meet, but not the interiors
  tricover::CrossingOptions inner;
  inner.touching = tricover::Touching::Allowed;
  EXPECT_FALSE(tricover::crossings(square, tricover::Pose::Identity(), square, shifted).empty());
  EXPECT_TRUE(tricover::crossings(square, tricover::Pose::Identity(), square, shifted, inner).empty());
  //! [crossings]
}

}  // namespace
