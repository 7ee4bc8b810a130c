// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/validity.h"

#include <gtest/gtest.h>

#include "tricover/polygon.h"

namespace {

TEST(Documentation, SelfCrossings) {
  //! [self crossings]
  const tricover::Polygon bow_tie({tricover::Ring{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
  const std::vector<tricover::SelfCrossing> found = tricover::selfCrossings(bow_tie);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, tricover::SelfCrossingKind::Crossing);
  EXPECT_EQ(found[0].point, tricover::Vec2(1, 1));
  EXPECT_EQ(found[0].edge_a, 0);  // from (0, 0) to (2, 2)
  EXPECT_EQ(found[0].edge_b, 2);  // from (2, 0) to (0, 2)
  EXPECT_FALSE(found[0].text.empty());

  const bool is_valid = tricover::selfCrossings(tricover::Polygon::box(2, 1), 1).empty();  // ends at the first one
  EXPECT_TRUE(is_valid);
  //! [self crossings]
}

}  // namespace
